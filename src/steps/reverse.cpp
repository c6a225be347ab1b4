#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <numbers>
#include <optional>
#include <span>
#include <string>

#include "formats/gcode_number.h"
#include "grid/wide_product.h"
#include "steps/arc_search.h"
#include "steps/exact_lines.h"
#include "steps/format.h"
#include "steps/line3_search.h"
#include "steps/reverse_arc.h"
#include "steps/words.h"
#include "unstep/step_stream.h"

/// Steps to programs. docs/steps.md, "Back".
namespace unstep {
namespace {

using steps::GridDelta;

/// No line has more steps.
using steps::kReach;

/// Writes the elements of runs as text.
class Reverser {
 public:
  Reverser(const StepStream& stream, const StepReverseOptions& options)
      : head_(stream.head), options_(options) {
    move(head_.origin);
    if (head_.axes == 3) options_.method = Method::evaluation8;
  }

  Result<std::string> reverse(const StepStream& stream) {
    text_ = "G21 G90 G17 G94\n";
    bool first = true;
    for (const StepRun& run : stream.runs) {
      if (Status valid = steps::check_run(head_, run); !valid) {
        return valid.error();
      }
      if (run.words.empty()) continue;
      // A rapid that goes nowhere says where the steps begin.
      if (first) {
        text_ += "G0";
        position();
        text_ += '\n';
      }
      first = false;
      spaces(run);
      if (!in_range_) {
        return Error{ErrorCode::out_of_range,
                     "the steps leave the range of 2^30 steps or 100 km"};
      }
    }
    return std::move(text_);
  }

 private:
  void number(const char* word, std::int64_t steps) {
    text_ += word;
    append_number(text_, steps * head_.step);
  }
  void position() {
    number(" X", at_[0]);
    number(" Y", at_[1]);
    if (head_.axes == 3) number(" Z", at_[2]);
  }
  void feed(const StepRun& run, std::size_t begin, std::size_t end,
            double steps) {
    if (run.rapid) {
      text_ += '\n';
      return;
    }
    double speed = options_.feed;
    if (head_.clock > 0) {
      double ticks = 0;
      for (std::size_t i = begin; i < end; ++i) ticks += run.waits[i];
      speed = steps * static_cast<double>(head_.step) /
              static_cast<double>(kProgramUnitsPerMm) * 60 * head_.clock /
              std::max(ticks, 1.0);
    }
    text_ += " F";
    const double kept = std::clamp(std::round(speed), 1.0, 1e7);
    append_number(text_, static_cast<std::int64_t>(kept) * kProgramUnitsPerMm);
    text_ += '\n';
  }

  void move(const GridDelta& delta) {
    // A line has at most 2^22 steps and an arc stays within 2^31 of its start:
    // nothing overflows before it is found out of range.
    for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
      const std::int64_t at = std::int64_t{at_[axis]} + delta[axis];
      const Int128 length = Int128{at} * head_.step;
      if (at > kMaxCoord || at < -kMaxCoord || length > kMaxProgramLength ||
          length < -kMaxProgramLength) {
        in_range_ = false;
        return;
      }
      at_[axis] = static_cast<std::int32_t>(at);
    }
  }

  void put_line(const StepRun& run, std::size_t begin, std::size_t end,
                const GridDelta& delta) {
    text_ += run.rapid ? "G0" : "G1";
    move(delta);
    position();
    const double length =
        std::hypot(static_cast<double>(delta[0]), static_cast<double>(delta[1]),
                   static_cast<double>(delta[2]));
    feed(run, begin, end, length);
  }

  void put_arc(const StepRun& run, std::size_t begin,
               const steps::ExactArc& found) {
    const Arc& arc = found.arc;
    text_ += arc.clockwise ? "G2" : "G3";
    move({arc.end.x, arc.end.y, 0});
    position();
    number(" I", arc.centre.x);
    number(" J", arc.centre.y);
    const double radius = std::hypot(static_cast<double>(arc.centre.x),
                                     static_cast<double>(arc.centre.y));
    const double first = std::atan2(-arc.centre.y, -arc.centre.x);
    const double last =
        std::atan2(arc.end.y - arc.centre.y, arc.end.x - arc.centre.x);
    double turn = arc.clockwise ? first - last : last - first;
    if (turn <= 0) turn += 2 * std::numbers::pi;
    feed(run, begin, begin + found.steps, radius * turn);
  }

  /// Whether z steps.
  static bool leaves_plane(StepWord word) { return (word & 0x30) != 0; }

  /// Lines of three axes, and elements of two where z rests.
  void spaces(const StepRun& run) {
    const auto& words = run.words;
    for (std::size_t at = 0; at < words.size() && in_range_;) {
      const auto end = static_cast<std::size_t>(
          std::find_if(words.begin() + static_cast<std::ptrdiff_t>(at),
                       words.end(), leaves_plane) -
          words.begin());
      if (end > at) at = elements(run, at, end);
      if (at == words.size() || !in_range_) break;
      GridDelta delta{};
      const std::size_t count = steps::longest_line3(words, at, delta);
      put_line(run, at, at + count, delta);
      at += count;
    }
  }

  /// Whether a line of three axes from there goes on beyond `end`, where z
  /// steps.
  static bool climbs(const StepRun& run, std::size_t at, std::size_t end) {
    constexpr std::size_t kNear = 4096;
    if (end == run.words.size() || end - at > kNear) return false;
    GridDelta delta{};
    return steps::longest_line3(run.words, at, delta) > end - at;
  }

  /// Two axes, from step `begin` on until `end` or where a line of three
  /// begins. Returns where that is.
  std::size_t elements(const StepRun& run, std::size_t begin, std::size_t end) {
    codes_.clear();
    for (std::size_t i = begin; i < end; ++i) {
      codes_.push_back(steps::kCodes[run.words[i] & 15]);
    }
    find_points();
    steps::LineSearch lines(codes_, options_.method, kReach);
    std::size_t tried = 0;  // arcs are looked for where lines are short
    std::optional<steps::LaterArc> later;
    std::optional<Element> next;
    std::size_t at = 0;
    while (at < codes_.size() && in_range_) {
      if (climbs(run, begin + at, end)) break;
      if (later) tried = at;
      Element element =
          next && !later
              ? *next
              : longest(lines, at, options_.arcs && !run.rapid, tried);
      next.reset();
      if (later && later->arc.steps > element.count) {
        element.arc = later->arc;
        element.count = later->arc.steps;
      }
      later.reset();
      if (options_.arcs && !run.rapid) {
        later = shorten(lines, at, element);
        if (!later) next = step_back(lines, at, element);
      }
      if (!later && !element.arc) {
        const std::size_t count =
            lines.before_next(at, element.count, element.line);
        if (count != element.count) next.reset();
        element.count = count;
      }
      if (element.arc) {
        put_arc(run, begin + at, *element.arc);
      } else {
        put_line(run, begin + at, begin + at + element.count,
                 {element.line.dx, element.line.dy, 0});
      }
      at += element.count;
    }
    return begin + at;
  }

  /// A line, or an arc.
  struct Element {
    std::size_t count = 0;  ///< steps
    Segment line;
    std::optional<steps::ExactArc> arc;
  };

  Element longest(steps::LineSearch& lines, std::size_t at, bool arcs,
                  std::size_t& tried) const {
    Element element;
    element.count = lines.longest(at, element.line);
    if (!arcs || at < tried) return element;
    element.arc = steps::longest_arc(std::span(codes_).subspan(at),
                                     std::span(points_).subspan(at),
                                     3 * element.count, combined(), step_mm());
    if (element.arc) {
      element.count = element.arc->steps;
    } else {
      tried = at + element.count / 4 + 1;
    }
    return element;
  }

  /// Ends the element where an arc begins that it has run into, and returns
  /// that.
  std::optional<steps::LaterArc> shorten(steps::LineSearch& lines,
                                         std::size_t at,
                                         Element& element) const {
    const std::size_t end = at + element.count;
    if (end >= codes_.size()) return std::nullopt;
    std::optional<steps::LaterArc> later = steps::later_arc(
        codes_, points_, at + 1, end, combined(), step_mm(),
        [&](std::size_t here) { return may_end(lines, at, element, here); });
    if (later) end_at(lines, at, element, later->begin);
    return later;
  }

  /// Ends the element a few steps earlier where what follows it then comes
  /// much farther; returns that.
  std::optional<Element> step_back(steps::LineSearch& lines, std::size_t at,
                                   Element& element) const {
    constexpr std::size_t kShort = 64;
    constexpr std::size_t kBack = 16;
    const std::size_t end = at + element.count;
    if (end >= codes_.size()) return std::nullopt;
    const auto longest_from = [&](std::size_t here) {
      std::size_t tried = 0;
      return longest(lines, here, true, tried);
    };
    Element next = longest_from(end);
    if (next.count >= kShort) return next;
    std::size_t best = end + next.count + kShort / 4;
    std::size_t chosen = end;
    for (std::size_t back = 1; back <= kBack && back < element.count; ++back) {
      const std::size_t here = end - back;
      if (!may_end(lines, at, element, here)) continue;
      const Element other = longest_from(here);
      if (here + other.count <= best) continue;
      best = here + other.count;
      chosen = here;
      next = other;
    }
    end_at(lines, at, element, chosen);
    return next;
  }

  /// Whether the element draws its steps up to there and no more.
  bool may_end(steps::LineSearch& lines, std::size_t at, const Element& element,
               std::size_t here) const {
    if (here == at + element.count) return true;
    Segment line;
    if (!element.arc) return lines.is_line(at, here - at, line);
    const Arc& arc = element.arc->arc;
    return steps::ArcSearch(std::span(codes_).subspan(at),
                            std::span(points_).subspan(at), combined(),
                            step_mm())
        .is_end(arc.centre, arc.clockwise, here - at);
  }

  void end_at(steps::LineSearch& lines, std::size_t at, Element& element,
              std::size_t here) const {
    if (here == at + element.count) return;
    element.count = here - at;
    if (!element.arc) {
      lines.is_line(at, element.count, element.line);
      return;
    }
    element.arc->steps = element.count;
    element.arc->arc.end = {points_[here].x - points_[at].x,
                            points_[here].y - points_[at].y};
  }

  [[nodiscard]] bool combined() const {
    return options_.method == Method::evaluation8;
  }
  [[nodiscard]] double step_mm() const {
    return static_cast<double>(head_.step) /
           static_cast<double>(kProgramUnitsPerMm);
  }

  /// Relative to the run's first; steps of a run stay within 2^31 of it.
  void find_points() {
    points_.assign(1, Point{});
    points_.reserve(codes_.size() + 1);
    for (const Step code : codes_) {
      const Point d = step_delta(code);
      points_.push_back({points_.back().x + d.x, points_.back().y + d.y});
    }
  }

  StepHead head_;
  StepReverseOptions options_;
  std::string text_;
  std::array<std::int32_t, kMaxStepAxes> at_{};
  bool in_range_ = true;
  std::vector<Step> codes_;
  std::vector<Point> points_;
};

}  // namespace

Result<Program> reverse_steps(const StepStream& stream,
                              const StepReverseOptions& options) {
  if (Status valid = steps::check_head(stream.head); !valid) {
    return valid.error();
  }
  if (options.method != Method::evaluation8 &&
      options.method != Method::evaluation &&
      options.method != Method::device) {
    return Error{ErrorCode::invalid_argument,
                 "steps are reversed for evaluation8, evaluation or device"};
  }
  if (!(options.feed > 0) || !(options.feed <= 1e7)) {
    return Error{ErrorCode::out_of_range, "a feed is 0 to 10,000,000 mm/min"};
  }
  if (options.method != Method::evaluation8 && stream.head.axes == 2) {
    for (const StepRun& run : stream.runs) {
      for (const StepWord word : run.words) {
        if ((word & 5) != 5) continue;
        return Error{ErrorCode::invalid_argument,
                     "two axes step at once, which only evaluation8 does"};
      }
    }
  }
  try {
    const Result<std::string> text = Reverser(stream, options).reverse(stream);
    if (!text) return text.error();
    return read_gcode(*text, {});
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the program"};
  }
}

}  // namespace unstep
