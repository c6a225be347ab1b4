#include "cli/centreline.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/message.h"
#include "cli/reshape.h"
#include "cli/stored_size.h"
#include "unstep/trace.h"

namespace unstep::cli {
namespace {

/// Trace::automatic: ink may be this far off, in pixels, beside the tolerance.
constexpr double kAutomaticReach = 2.5;

Result<Page> strokes_of(const Page& page, const Rational& tolerance,
                        const LineOptions& options, Effort effort,
                        LineAim aim) {
  const Result<std::vector<Stroke>> strokes = trace_strokes(page.ink);
  if (!strokes) return strokes.error();
  const Canvas canvas{page.ink.width(), page.ink.height(), YAxis::down};
  Result<Drawing> drawing = stroke_paths(
      *strokes, canvas, {tolerance, effort, options.arcs, aim, &page.ink});
  if (!drawing) return drawing.error();
  Page drawn;
  drawn.kind = PageKind::paths;
  drawn.info = page.info;
  drawn.fidelity = {Fidelity::Kind::tolerance, tolerance};
  drawn.drawing = *std::move(drawing);
  return drawn;
}

std::size_t weight(const Drawing& drawing) {
  std::size_t sum = 0;
  for (const Path& path : drawing.paths) sum += 2 + path.elements.size();
  return sum;
}

/// Whether strokes draw the ink about as it is.
Result<bool> draw_well(const Bitmap& ink, const Page& strokes,
                       const Rational& tolerance) {
  const Result<Bitmap> drawn = render_paths(strokes.drawing);
  if (!drawn) return drawn.error();
  if (ink.ink() == 0 || drawn->ink() == 0) return ink.ink() == drawn->ink();
  const Result<InkDistance> found = measure_ink(ink, *drawn);
  if (!found) return found.error();
  const double reach =
      kAutomaticReach + static_cast<double>(tolerance.numerator) /
                            static_cast<double>(tolerance.denominator);
  return found->worst().distance() <= reach;
}

Result<Page> by_contours(Page page, LineOptions options, Effort effort,
                         LineAim aim) {
  options.trace = LineOptions::Trace::contour;
  return to_lines(std::move(page), options, effort, aim);
}

/// Whether strokes are the simpler ones, or the smaller ones in a file.
Result<bool> are_better(const Page& strokes, const Page& contours,
                        Effort effort, LineAim aim) {
  if (aim == LineAim::few_lines) {
    return weight(strokes.drawing) < weight(contours.drawing);
  }
  const Result<std::size_t> mine = stored_size(strokes, effort);
  if (!mine) return mine.error();
  const Result<std::size_t> theirs = stored_size(contours, effort);
  if (!theirs) return theirs.error();
  return *mine < *theirs;
}

/// Which of the two is better; the contours' lines if the ink says so.
Result<Page> choose(Page page, Page strokes, const Rational& tolerance,
                    const LineOptions& options, Effort effort, LineAim aim) {
  const Result<bool> well = draw_well(page.ink, strokes, tolerance);
  if (!well) return well.error();
  const bool exact = options.method == LineOptions::Method::none;
  if (exact) return *well ? std::move(strokes) : std::move(page);
  Result<Page> contours = by_contours(std::move(page), options, effort, aim);
  if (!contours || !*well) return contours;
  const Result<bool> better = are_better(strokes, *contours, effort, aim);
  if (!better) return better.error();
  return *better ? std::move(strokes) : *std::move(contours);
}

/// The contours of the ink that is in `ink` and, if `both`, in `other` too, or
/// else not there.
void append_layer(const Bitmap& ink, const Bitmap& other, bool both,
                  const char* colour, std::string& svg) {
  Bitmap layer = ink;
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::size_t w = 0; w < ink.words_per_row(); ++w) {
      layer.row(y)[w] &= both ? other.row(y)[w] : ~other.row(y)[w];
    }
  }
  svg += fmt::format("<path fill=\"{}\" fill-rule=\"evenodd\" d=\"", colour);
  // A visitor that never stops: no error is possible.
  (void)trace_contours(layer, [&](const Chain& contour) {
    svg += fmt::format("M{} {}", contour.origin.x, contour.origin.y);
    const std::vector<Step>& steps = contour.steps;
    for (std::size_t i = 0; i < steps.size();) {
      std::size_t end = i;
      while (end < steps.size() && steps[end] == steps[i]) ++end;
      const Point move = step_delta(steps[i], YAxis::down);
      const auto n = static_cast<std::int32_t>(end - i);
      svg += move.x != 0 ? fmt::format("h{}", move.x * n)
                         : fmt::format("v{}", move.y * n);
      i = end;
    }
    svg += "z";
    return true;
  });
  svg += "\"/>\n";
}

}  // namespace

Status warn_of_strokes(const Bitmap& ink, const Page& strokes,
                       std::vector<std::string>& notes) {
  const Result<bool> well = draw_well(ink, strokes, strokes.fidelity.tolerance);
  if (!well) return well.error();
  if (!*well) {
    notes.emplace_back(
        "strokes are not what this ink is: some of it is far off what they "
        "draw; verify says how far, --trace auto keeps contours where it is");
  }
  return {};
}

Result<Page> to_strokes(Page page, const LineOptions& options, Effort effort,
                        LineAim aim) {
  if (options.method == LineOptions::Method::device) {
    return Error{ErrorCode::invalid_argument,
                 "the device draws contours and chains, no centrelines; leave "
                 "--trace or --reverse out"};
  }
  Rational tolerance{0, 1};
  if (options.method == LineOptions::Method::tolerance) {
    const Result<Rational> asked =
        to_tolerance(options.tolerance, page.info.resolution);
    if (!asked) return asked.error();
    tolerance = *asked;
  }
  Result<Page> strokes = strokes_of(page, tolerance, options, effort, aim);
  if (!strokes || options.trace == LineOptions::Trace::centreline) {
    return strokes;
  }
  return choose(std::move(page), *std::move(strokes), tolerance, options,
                effort, aim);
}

bool is_strokes(const Page& page) {
  return page.kind == PageKind::paths && page.drawing.paint == Paint::stroke &&
         page.fidelity.kind == Fidelity::Kind::tolerance &&
         std::ranges::any_of(page.drawing.paths,
                             [](const Path& path) { return path.width > 0; });
}

std::string describe_ink_distance(const InkDistance& distance) {
  const InkDistance::Worst& worst = distance.worst();
  const std::uint64_t differing = distance.only_a + distance.only_b;
  return fmt::format(
      "drawn ink is up to {:.3g} px off, at ({}, {}); {} {}, {} of the ink",
      worst.distance(), worst.at.x, worst.at.y, counted(differing, "pixel"),
      differing == 1 ? "differs" : "differ",
      per_cent(differing, std::max<std::uint64_t>(distance.ink, 1)));
}

std::string overlay_svg(const Bitmap& first, const Bitmap& second) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      first.width(), first.height());
  append_layer(first, second, true, "#999", svg);
  append_layer(first, second, false, "#d00", svg);
  append_layer(second, first, false, "#06c", svg);
  return svg + "</svg>\n";
}

}  // namespace unstep::cli
