#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <string>

#include "interpolate/arc_steps.h"
#include "interpolate/letters.h"
#include "steps/grid_moves.h"
#include "steps/line3.h"
#include "steps/step_times.h"
#include "steps/timing.h"
#include "steps/words.h"

/// Programs to steps. docs/steps.md.
namespace unstep {
namespace {

using steps::GridMove;

/// Pulses of a part of a run, few enough that they and their waits stay in the
/// cache until they are written, and of lines that are drawn together.
constexpr std::size_t kPart = std::size_t{1} << 16;
constexpr std::size_t kBatch = std::size_t{1} << 13;

bool counts_steps(Method method) {
  return method == Method::evaluation8 || method == Method::evaluation ||
         method == Method::device || method == Method::gate_level;
}

class Maker {
 public:
  Maker(const StepMakeOptions& options, const StepSink& sink)
      : options_(options),
        // What does not move z is drawn as of 2 axes, by one method.
        method_(options.axes == 3 ? Method::evaluation8 : options.method),
        sink_(sink),
        left_(options.max_steps) {}

  Status run(const std::vector<GridMove>& moves) {
    std::vector<steps::MoveSpeed> speeds;
    if (options_.timed) speeds = steps::plan_speeds(moves, options_.timing);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const GridMove& move = moves[i];
      if (move.rapid != run_.rapid) {
        if (Status done = flush(true); !done) return done;
        run_.rapid = move.rapid;
      }
      Status done = draw(move);
      if (done && options_.timed) done = time(move, speeds[i]);
      if (done && run_.words.size() >= kPart) done = flush(false);
      if (!done) return done;
    }
    return flush(true);
  }

 private:
  /// Hands on the pulses of the run in parts, so that what a part is does not
  /// depend on where motions end. What is less than one waits if more may come.
  Status flush(bool whole) {
    if (Status done = draw_lines(); !done) return done;
    std::size_t at = 0;
    while (run_.words.size() - at >= (whole ? 1 : kPart)) {
      const std::size_t end = std::min(at + kPart, run_.words.size());
      const auto cut = [at, end](const auto& all, auto& out) {
        const auto begin = all.begin();
        out.assign(begin + static_cast<std::ptrdiff_t>(at),
                   begin + static_cast<std::ptrdiff_t>(end));
      };
      part_.rapid = run_.rapid;
      cut(run_.words, part_.words);
      if (options_.timed) cut(run_.waits, part_.waits);
      if (Status done = sink_(part_); !done) return done;
      at = end;
    }
    const auto drop = [at](auto& all) {
      all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(at));
    };
    drop(run_.words);
    if (options_.timed) drop(run_.waits);
    return {};
  }

  Status take(std::uint64_t count) {
    if (count > left_) {
      return Error{ErrorCode::limit_exceeded, "more steps than allowed"};
    }
    left_ -= count;
    return {};
  }

  Status draw(const GridMove& move) {
    if (move.delta[2] != 0) return draw_line3(move);
    if (move.is_arc) {
      if (Status done = draw_lines(); !done) return done;
      return draw_arc(move.arc);
    }
    const Segment line{move.delta[0], move.delta[1]};
    if (!counts_steps(method_)) {
      Result<Interpolator> drawn =
          Interpolator::line(method_, line, options_.interpolator);
      return drawn ? walk(*drawn) : drawn.error();
    }
    const std::uint64_t count = step_count(method_, line);
    if (Status done = take(count); !done) return done;
    lines_.push_back(line);
    pending_ += static_cast<std::size_t>(count);
    return pending_ >= kBatch ? draw_lines() : Status();
  }

  /// The lines that wait, together.
  Status draw_lines() {
    if (lines_.empty()) return {};
    const std::size_t before = run_.words.size();
    run_.words.resize(before + pending_);
    const std::span<Step> out = std::span(run_.words).subspan(before);
    if (interpolation::draws_in_bulk(method_)) {
      const Result<std::size_t> drawn =
          interpolation::draw_lines(method_, lines_, out, steps::kWords);
      if (!drawn) return drawn.error();
    } else {
      const Result<std::size_t> drawn =
          interpolate(method_, lines_, out, options_.interpolator);
      if (!drawn) return drawn.error();
      for (Step& step : out) step = steps::kWords[step & 7];
    }
    lines_.clear();
    pending_ = 0;
    return {};
  }

  Status draw_arc(const Arc& arc) {
    const Result<interpolation::ArcGeometry> checked =
        interpolation::check_arc(arc);
    if (!checked) return checked.error();
    interpolation::ArcSteps drawn(*checked, method_ == Method::evaluation8,
                                  steps::kWords);
    // Short arcs are not made to clear much memory.
    for (std::size_t part = 256;; part = std::min(2 * part, kBatch)) {
      const std::size_t before = run_.words.size();
      run_.words.resize(before + part);
      const std::size_t count =
          drawn.fill(std::span(run_.words).subspan(before));
      run_.words.resize(before + count);
      if (count == 0) return {};
      if (Status done = take(count); !done) return done;
    }
  }

  Status walk(Interpolator& drawn) {
    std::array<Tick, 256> ticks;
    for (std::size_t n = drawn.fill(ticks); n != 0; n = drawn.fill(ticks)) {
      for (std::size_t i = 0; i < n; ++i) {
        if (ticks[i].kind != Tick::Kind::step) continue;
        if (Status done = take(1); !done) return done;
        run_.words.push_back(steps::kWords[ticks[i].step & 7]);
      }
    }
    return {};
  }

  Status draw_line3(const GridMove& move) {
    if (Status done = draw_lines(); !done) return done;
    steps::Line3 line(move.delta);
    if (Status done = take(line.count()); !done) return done;
    for (std::uint32_t i = 0; i < line.count(); ++i) {
      run_.words.push_back(line.next());
    }
    return {};
  }

  /// Waits of the steps that the move makes.
  Status time(const GridMove& move, const steps::MoveSpeed& speed) {
    const std::size_t before = run_.waits.size();
    const std::size_t count = run_.words.size() + pending_ - before;
    if (count == 0) return {};
    const steps::StepTimes times(speed, move.length,
                                 options_.timing.acceleration,
                                 options_.timing.clock, count);
    run_.waits.resize(before + count);
    if (waits_.make(times, std::span(run_.waits).subspan(before))) return {};
    return Error{ErrorCode::out_of_range,
                 "a step takes longer than 2^32 ticks of the clock, or a "
                 "motion longer than 2^50"};
  }

  const StepMakeOptions& options_;
  Method method_;
  const StepSink& sink_;
  std::uint64_t left_;
  StepRun run_;
  StepRun part_;  ///< of it, as it is handed on
  std::vector<Segment> lines_;
  std::size_t pending_ = 0;  ///< steps of lines_
  steps::WaitMaker waits_;
};

Status check(const StepMakeOptions& options) {
  const MethodInfo& info = method_info(options.method);
  if (!info.lines || info.increments) {
    return Error{ErrorCode::invalid_argument,
                 std::string(info.name) + " makes no unit steps of lines"};
  }
  if (options.axes != 2 && options.axes != 3) {
    return Error{ErrorCode::invalid_argument, "steps have 2 or 3 axes"};
  }
  if (options.step < 1 || options.step > std::int64_t{1} << 40) {
    return Error{ErrorCode::out_of_range,
                 "a step is 0.0000001 mm to 109 m long"};
  }
  for (const std::int32_t at : options.origin) {
    if (at > kMaxCoord || at < -kMaxCoord) {
      return Error{ErrorCode::out_of_range, "the origin of the steps"};
    }
  }
  const StepTiming& timing = options.timing;
  const bool right =
      timing.clock >= 1 && timing.feed > 0 && timing.feed <= 1e9 &&
      timing.rapid > 0 && timing.rapid <= 1e9 && timing.acceleration >= 0 &&
      timing.acceleration <= 1e9 && timing.corner > 0 && timing.corner <= 1e3;
  if (options.timed && !right) {
    return Error{ErrorCode::out_of_range,
                 "clock, feeds and corner are more than 0, at most 10^9"};
  }
  return {};
}

}  // namespace

Status make_steps(const Program& program, const StepMakeOptions& options,
                  const StepSink& sink) {
  if (Status valid = check(options); !valid) return valid;
  try {
    const Result<std::vector<GridMove>> moves =
        steps::grid_moves(program, options);
    if (!moves) return moves.error();
    return Maker(options, sink).run(*moves);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the steps"};
  }
}

StepHead step_head(const StepMakeOptions& options) {
  StepHead head{options.axes, options.step,
                options.timed ? options.timing.clock : 0, options.origin};
  if (options.axes == 2) head.origin[2] = 0;
  return head;
}

Result<StepStream> make_steps(const Program& program,
                              const StepMakeOptions& options) {
  StepStream stream;
  stream.head = step_head(options);
  const Status done =
      make_steps(program, options, [&stream](const StepRun& run) {
        if (stream.runs.empty() || stream.runs.back().rapid != run.rapid) {
          stream.runs.push_back(run);
          return Status();
        }
        StepRun& last = stream.runs.back();
        last.words.insert(last.words.end(), run.words.begin(), run.words.end());
        last.waits.insert(last.waits.end(), run.waits.begin(), run.waits.end());
        return Status();
      });
  if (!done) return done.error();
  return stream;
}

}  // namespace unstep
