#include "cli/simulate_run.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/reshape.h"
#include "machine/chain_follower.h"
#include "machine/esu.h"
#include "machine/ink_distance.h"

namespace unstep::cli {
namespace {

using machine::BrokenLimits;
using machine::FollowReport;
using Json = nlohmann::ordered_json;

/// Collects where the carriage was, a quarter of a unit apart.
class Recorder {
 public:
  static constexpr std::int32_t kScale = 64;

  explicit Recorder(const Drawing& commanded) : commanded_(commanded) {
    followed_.canvas = commanded.canvas;
    followed_.scale = kScale;
    followed_.paths.resize(commanded.chains.size());
    bool contours = !commanded.chains.empty();
    for (const Chain& chain : commanded.chains)
      contours =
          contours && chain.closed && chain.connectivity == Connectivity::four;
    followed_.paint = contours ? Paint::fill : Paint::stroke;
  }

  void add(std::size_t index, double x, double y) {
    const Point at{static_cast<std::int32_t>(std::lround(x * kScale)),
                   static_cast<std::int32_t>(std::lround(y * kScale))};
    Path& path = followed_.paths[index];
    if (index != index_ || !started_) {
      index_ = index;
      started_ = true;
      path.origin = last_ = at;
      return;
    }
    const std::int32_t dx = at.x - last_.x;
    const std::int32_t dy = at.y - last_.y;
    if (std::abs(dx) + std::abs(dy) < kScale / 4) return;
    path.elements.push_back({Path::Kind::segment, {dx, dy}, {}});
    last_ = at;
  }

  Drawing finish() {
    for (std::size_t i = 0; i < followed_.paths.size(); ++i)
      if (commanded_.chains[i].closed) close(followed_.paths[i]);
    return std::move(followed_);
  }

 private:
  static void close(Path& path) {
    Segment back;
    for (const Path::Element& element : path.elements) {
      back.dx -= element.segment.dx;
      back.dy -= element.segment.dy;
    }
    if (back != Segment{})
      path.elements.push_back({Path::Kind::segment, back, {}});
    path.closed = true;
  }

  const Drawing& commanded_;
  Drawing followed_;
  std::size_t index_ = 0;
  bool started_ = false;
  Point last_;
};

std::vector<std::string> words_of(const BrokenLimits& broken) {
  std::vector<std::string> words;
  if (broken.axis_speed) words.push_back("an axis is sent faster than 10 mm/s");
  if (broken.saturated_seconds > 0)
    words.push_back(fmt::format("a motor was at full force for {:.3f} s",
                                broken.saturated_seconds));
  return words;
}

void append_broken(const std::vector<std::string>& broken, std::string& text) {
  if (broken.empty()) text += "limits broken: none\n";
  for (const std::string& words : broken)
    text += "limit broken: " + words + '\n';
}

/// Adds how far the ink that was made is from the drawing's.
void compare_ink(const Bitmap& made, const Bitmap& drawn, Run& run) {
  if (made.width() != drawn.width() || made.height() != drawn.height()) return;
  const machine::InkDistance d = machine::ink_distance(made, drawn);
  run.json["ink"] = {{"differing", d.differing},
                     {"worst_units", d.worst},
                     {"rms_units", d.rms},
                     {"lost", d.lost}};
  run.text += fmt::format(
      "ink: {} differ, worst {:.2f} units, rms {:.3f} units, {} lost\n",
      counted(d.differing, "point"), d.worst, d.rms, grouped(d.lost));
}

Json to_json(const FollowReport& report) {
  return {{"seconds", report.seconds},
          {"lit_seconds", report.lit_seconds},
          {"steps", report.steps},
          {"worst_um", report.worst_um},
          {"rms_um", report.rms_um},
          {"peak_steps_per_second", report.peak_steps_hz},
          {"peak_pulses_per_second", report.peak_pulses_hz},
          {"top_speed_mm_per_second", report.top_speed_um / 1000},
          {"limits_broken", words_of(report.broken)}};
}

std::string to_text(const FollowReport& report, double unit_um) {
  std::string text = fmt::format(
      "time: {:.1f} s, {:.1f} s of it drawing {}\n"
      "contour error: worst {:.2f} um ({:.2f} units), rms {:.2f} um\n"
      "peaks: {:.0f} steps/s, {:.0f} pulses/s, {:.2f} mm/s\n",
      report.seconds, report.lit_seconds, counted(report.steps, "step"),
      report.worst_um, report.worst_um / unit_um, report.rms_um,
      report.peak_steps_hz, report.peak_pulses_hz, report.top_speed_um / 1000);
  append_broken(words_of(report.broken), text);
  return text;
}

/// The machine's own: more of it is more than it should have.
constexpr double kEsuInstability = 0.001;

void report_esu(const machine::Film& film, const machine::BeamError& error,
                const SimulateOptions& options, Run& run) {
  const double seconds = machine::esu_seconds(film);
  std::vector<std::string> broken;
  if (options.noise > 1)
    broken.push_back("the raster wanders by more than 0.1 % of the field");
  run.json = {{"direction", options.write ? "write" : "scan"},
              {"seconds", seconds},
              {"points_per_second", machine::kEsuPointsPerSecond},
              {"worst_um", error.worst_um},
              {"rms_um", error.rms_um},
              {"limits_broken", broken}};
  run.text = fmt::format(
      "time: {:.1f} s for {}\n"
      "beam error: worst {:.2f} um, rms {:.2f} um\n"
      "peaks: {:.0f} points/s\n",
      seconds, counted(film.transmission.size(), "point"), error.worst_um,
      error.rms_um, machine::kEsuPointsPerSecond);
  append_broken(broken, run.text);
}

Result<Drawing> contours_of(const Bitmap& ink) {
  Page page;
  page.ink = ink;
  return chains_of(page);
}

}  // namespace

Result<Page> as_steps(Page page, const SimulateOptions& options) {
  if (page.kind == PageKind::program) {
    return Error{ErrorCode::invalid_argument,
                 "a program has no grid of its own; say how long a step is: "
                 "--grid 0.1mm"};
  }
  if (page.kind != PageKind::paths) return page;
  return to_steps(std::move(page), {1, Quantity::Unit::grid},
                  options.read.limits.max_steps);
}

Result<Run> run_zenit(const Page& page, const SimulateOptions& options,
                      std::vector<std::string>& notes) {
  Result<Drawing> chains = chains_of(page);
  if (!chains) return chains.error();
  Run run;
  run.commanded = *std::move(chains);
  machine::FollowOptions follow;
  // 12.5 pulses a micrometre.
  follow.unit_pulses = (options.unit_um * 25 + 1) / 2;
  follow.speed_um = options.speed_mm * 1000;
  follow.plant = follow.plant.noisier(options.noise);
  follow.seed = static_cast<std::uint64_t>(options.seed);
  Recorder recorder(*run.commanded);
  const Result<FollowReport> report = machine::follow_chains(
      run.commanded->chains, run.commanded->canvas.y_axis, follow,
      [&](std::size_t chain, double x, double y) {
        recorder.add(chain, x, y);
        return !interrupted();
      });
  if (!report) return report.error();
  run.json = to_json(*report);
  run.text = to_text(*report, options.unit_um);
  run.followed = recorder.finish();
  if (options.exposure.empty()) return run;
  Page lit;
  lit.kind = PageKind::paths;
  lit.drawing = *run.followed;
  Result<Bitmap> exposed = to_ink(lit, options.read.limits, notes);
  if (!exposed) return exposed.error();
  std::vector<std::string> same_notes;
  Result<Bitmap> drawn = to_ink(page, options.read.limits, same_notes);
  if (!drawn) return drawn.error();
  compare_ink(*exposed, *drawn, run);
  run.exposure = *std::move(exposed);
  return run;
}

Result<Run> run_esu(const Page& page, const SimulateOptions& options,
                    std::vector<std::string>& notes) {
  const Result<Bitmap> drawn = to_ink(page, options.read.limits, notes);
  if (!drawn) return drawn.error();
  machine::EsuOptions esu;
  esu.instability = kEsuInstability * options.noise;
  esu.seed = static_cast<std::uint64_t>(options.seed);
  const Result<machine::Film> film = options.write
                                         ? machine::esu_write(*drawn, esu)
                                         : machine::esu_scan(*drawn, esu);
  if (!film) return film.error();
  const Result<machine::BeamError> error = machine::esu_beam_error(*drawn, esu);
  if (!error) return error.error();
  Result<Bitmap> made = machine::film_ink(*film);
  if (!made) return made.error();
  Run run;
  report_esu(*film, *error, options, run);
  compare_ink(*made, *drawn, run);
  if (!options.plot.empty()) {
    Result<Drawing> commanded = contours_of(*drawn);
    if (!commanded) return commanded.error();
    Result<Drawing> followed = contours_of(*made);
    if (!followed) return followed.error();
    run.commanded = *std::move(commanded);
    run.followed = *std::move(followed);
  }
  run.exposure = *std::move(made);
  return run;
}

}  // namespace unstep::cli
