#include "cli/reshape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "cli/centreline.h"
#include "cli/line_choice.h"
#include "unstep/codec.h"
#include "unstep/deviation.h"
#include "unstep/interpolate.h"
#include "unstep/program.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

namespace unstep::cli {
namespace {

/// value, or a little less, as a fraction.
Result<Rational> fraction_below(double value) {
  if (!(value <= 1 << 20)) {
    return Error{ErrorCode::invalid_argument,
                 fmt::format("a tolerance of {} pixels is too large", value)};
  }
  // A decimal as the user wrote it, if it is one.
  for (std::uint32_t denominator = 1; denominator <= 100'000;
       denominator *= 10) {
    const double scaled = value * denominator;
    const double whole = std::round(scaled);
    if (std::abs(scaled - whole) > 1e-9 * scaled || whole > 4e9) continue;
    const auto numerator = static_cast<std::uint32_t>(whole);
    const std::uint32_t common = std::gcd(numerator, denominator);
    return Rational{numerator / common, denominator / common};
  }
  constexpr std::uint32_t kParts = 1U << 12;
  const auto numerator = static_cast<std::uint32_t>(std::floor(value * kParts));
  const std::uint32_t common = std::gcd(numerator, kParts);
  return Rational{numerator / common, kParts / common};
}

Result<Page> by_tolerance(Page page, const Rational& tolerance, bool arcs,
                          Effort effort, LineAim aim) {
  Result<Drawing> chains = chains_of(page);
  if (!chains) return chains.error();
  const ToleranceOptions options{tolerance, effort, arcs};
  if (aim == LineAim::few_bytes) {
    Result<Page> cheapest =
        lines_of_few_bytes(std::move(page), *chains, options);
    if (!cheapest || cheapest->kind != PageKind::paths) return cheapest;
    page = *std::move(cheapest);
  } else {
    page.ink = Bitmap();
    Result<Drawing> lines = reverse_tolerance(*chains, options);
    if (!lines) return lines.error();
    page = page_of_lines(page.info, tolerance, *std::move(lines));
  }
  const Status within = check_deviation(*chains, page.drawing, tolerance);
  if (!within) {
    return Error{ErrorCode::internal,
                 "the lines break the bound: " + within.error().message};
  }
  return page;
}

Result<Path> device_path(const Chain& chain, YAxis axis) {
  const Result<std::vector<Segment>> segments = reverse_device(chain.steps);
  if (!segments) return segments.error();
  Path path;
  path.origin = chain.origin;
  path.closed = chain.closed;
  path.elements.reserve(segments->size());
  for (const Segment& segment : *segments) {
    const std::int32_t dy = axis == YAxis::up ? segment.dy : -segment.dy;
    path.elements.push_back({Path::Kind::segment, {segment.dx, dy}, {}});
  }
  return path;
}

Result<Page> by_device(Page page) {
  Result<Drawing> chains = chains_of(page);
  if (!chains) return chains.error();
  Drawing paths;
  paths.canvas = chains->canvas;
  for (std::size_t i = 0; i < chains->chains.size(); ++i) {
    Result<Path> path = device_path(chains->chains[i], chains->canvas.y_axis);
    if (!path) {
      return Error{path.error().code,
                   fmt::format("chain {}: {}", i + 1, path.error().message)};
    }
    paths.paths.push_back(*std::move(path));
  }
  const bool filled = page.kind == PageKind::ink;
  paths.paint = filled ? Paint::fill : Paint::stroke;
  const Result<Deviation> found = measure_device_deviation(*chains, paths);
  if (!found) return found.error();
  if (found->distance > 1) {
    return Error{ErrorCode::internal,
                 fmt::format("the device's lines break its bound at chain {}, "
                             "step {}",
                             found->path + 1, found->step)};
  }
  page.kind = PageKind::paths;
  page.fidelity = {Fidelity::Kind::device, {1, 1}};
  page.drawing = std::move(paths);
  page.ink = Bitmap();
  return page;
}

bool all_closed(const Drawing& drawing) {
  return std::ranges::all_of(drawing.paths, &Path::closed);
}

/// The smallest and largest coordinates, grown point by point.
struct Bounds {
  double left = std::numeric_limits<double>::max();
  double top = left;
  double right = -left;
  double bottom = -left;
  void add(double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
  [[nodiscard]] bool empty() const { return left > right; }
};

void add_chain(Bounds& bounds, const Chain& chain, YAxis axis) {
  Point at = chain.origin;
  bounds.add(at.x, at.y);
  for (const Step step : chain.steps) {
    const Point move = step_delta(step, axis);
    at = {at.x + move.x, at.y + move.y};
    bounds.add(at.x, at.y);
  }
}

/// Of arcs the whole circle counts.
void add_path(Bounds& bounds, const Path& path, double scale) {
  double x = path.origin.x / scale;
  double y = path.origin.y / scale;
  bounds.add(x, y);
  for (const Path::Element& element : path.elements) {
    if (element.kind == Path::Kind::segment) {
      x += element.segment.dx / scale;
      y += element.segment.dy / scale;
    } else {
      const Arc& arc = element.arc;
      const double radius = std::hypot(arc.centre.x, arc.centre.y) / scale;
      const double cx = x + arc.centre.x / scale;
      const double cy = y + arc.centre.y / scale;
      bounds.add(cx - radius, cy - radius);
      bounds.add(cx + radius, cy + radius);
      x += arc.end.x / scale;
      y += arc.end.y / scale;
    }
    bounds.add(x, y);
  }
}

/// Gives a drawing without a canvas one that holds it, and moves it there.
Status give_canvas(Drawing& drawing, std::vector<std::string>& notes) {
  if (drawing.canvas.width > 0 && drawing.canvas.height > 0) return {};
  Bounds bounds;
  for (const Chain& chain : drawing.chains) {
    add_chain(bounds, chain, drawing.canvas.y_axis);
  }
  for (const Path& path : drawing.paths) {
    add_path(bounds, path, drawing.scale);
  }
  if (bounds.empty()) {
    return Error{ErrorCode::unsupported,
                 "an empty drawing without a canvas has no pixels"};
  }
  const double left = std::floor(bounds.left);
  const double top = std::floor(bounds.top);
  const double width = std::floor(bounds.right) - left + 1;
  const double height = std::floor(bounds.bottom) - top + 1;
  if (width > kMaxCoord || height > kMaxCoord) {
    return Error{ErrorCode::out_of_range,
                 "the drawing is too large for a raster"};
  }
  const auto dx = static_cast<std::int32_t>(-left);
  const auto dy = static_cast<std::int32_t>(-top);
  for (Chain& chain : drawing.chains) {
    chain.origin = {chain.origin.x + dx, chain.origin.y + dy};
  }
  for (Path& path : drawing.paths) {
    const std::int64_t x = path.origin.x + std::int64_t{dx} * drawing.scale;
    const std::int64_t y = path.origin.y + std::int64_t{dy} * drawing.scale;
    if (std::abs(x) > kMaxCoord || std::abs(y) > kMaxCoord) {
      return Error{ErrorCode::out_of_range,
                   "the drawing is too large for a raster"};
    }
    path.origin = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }
  drawing.canvas.width = static_cast<std::int32_t>(width);
  drawing.canvas.height = static_cast<std::int32_t>(height);
  notes.push_back(fmt::format(
      "the drawing has no canvas; its own box of {} x {} pixels is taken",
      drawing.canvas.width, drawing.canvas.height));
  return {};
}

bool are_contours(const Drawing& drawing) {
  return std::ranges::all_of(drawing.chains, [](const Chain& chain) {
    return chain.closed && chain.connectivity == Connectivity::four;
  });
}

/// Rasters have y down.
Drawing with_y_down(Drawing drawing) {
  if (drawing.canvas.y_axis == YAxis::down) return drawing;
  const std::int32_t height = drawing.canvas.height;
  // Codes are as seen, so steps stay. Contours run on the corners of pixels,
  // other chains on the pixels themselves, of which the last is height - 1.
  const std::int32_t last = are_contours(drawing) ? height : height - 1;
  for (Chain& chain : drawing.chains) chain.origin.y = last - chain.origin.y;
  for (Path& path : drawing.paths) {
    path.origin.y = height * drawing.scale - path.origin.y;
    for (Path::Element& element : path.elements) {
      element.segment.dy = -element.segment.dy;
      element.arc.centre.y = -element.arc.centre.y;
      element.arc.end.y = -element.arc.end.y;
    }
  }
  drawing.canvas.y_axis = YAxis::down;
  return drawing;
}

/// A chain as hairlines: the pixels it visits are those of its steps.
Path as_hairline(const Chain& chain) {
  Path path;
  path.origin = chain.origin;
  path.closed = chain.closed;
  for (std::size_t i = 0; i < chain.steps.size();) {
    std::size_t run = i;
    while (run < chain.steps.size() && chain.steps[run] == chain.steps[i]) {
      ++run;
    }
    const Point move = step_delta(chain.steps[i], YAxis::down);
    const auto n = static_cast<std::int32_t>(run - i);
    path.elements.push_back(
        {Path::Kind::segment, {move.x * n, move.y * n}, {}});
    i = run;
  }
  return path;
}

Status fits(const Canvas& canvas, const DecodeLimits& limits) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(canvas.width) *
                               static_cast<std::uint64_t>(canvas.height);
  if (pixels <= limits.max_pixels) return {};
  return Error{ErrorCode::limit_exceeded,
               fmt::format("a raster of {} x {} pixels is above --max-pixels",
                           canvas.width, canvas.height)};
}

double units_of(const Rational& value) {
  return static_cast<double>(value.numerator) / value.denominator;
}

}  // namespace

Result<Rational> to_tolerance(const Quantity& length,
                              const Resolution& resolution) {
  const bool finer_y =
      resolution.known() && units_of(resolution.y) < units_of(resolution.x);
  const Result<double> units = to_grid_units(
      length, finer_y ? resolution.y : resolution.x, resolution.unit);
  if (!units) return units.error();
  return fraction_below(*units);
}

Result<Drawing> chains_of(const Page& page) {
  if (page.kind == PageKind::chains) return page.drawing;
  Drawing drawing;
  drawing.canvas = {page.ink.width(), page.ink.height(), YAxis::down};
  const Status traced = trace_contours(page.ink, [&](const Chain& contour) {
    drawing.chains.push_back(contour);
    return true;
  });
  if (!traced) return traced.error();
  return drawing;
}

Result<Page> to_lines(Page page, const LineOptions& options, Effort effort,
                      LineAim aim) {
  if (page.kind == PageKind::ink &&
      options.trace != LineOptions::Trace::contour) {
    return to_strokes(std::move(page), options, effort, aim);
  }
  if (page.kind == PageKind::paths ||
      options.method == LineOptions::Method::none) {
    return page;
  }
  if (options.method == LineOptions::Method::device) {
    return by_device(std::move(page));
  }
  const Result<Rational> tolerance =
      to_tolerance(options.tolerance, page.info.resolution);
  if (!tolerance) return tolerance.error();
  return by_tolerance(std::move(page), *tolerance, options.arcs, effort, aim);
}

Result<Page> to_drawing(Page page, const LineOptions& options, Effort effort) {
  Result<Page> drawn =
      to_lines(std::move(page), options, effort, LineAim::few_lines);
  if (!drawn || drawn->kind != PageKind::ink) return drawn;
  Result<Drawing> edges = chains_of(*drawn);
  if (!edges) return edges.error();
  drawn->drawing = *std::move(edges);
  drawn->kind = PageKind::chains;
  return drawn;
}

Status order_page(Page& page, std::vector<std::string>& notes) {
  if (page.kind == PageKind::program) {
    return Error{ErrorCode::unsupported,
                 "--order travel is for drawings; the motions of a program "
                 "keep their order"};
  }
  if (page.kind == PageKind::ink) {
    return Error{ErrorCode::unsupported,
                 "--order travel needs lines or chains; ink has none without "
                 "--tolerance or --trace"};
  }
  const TravelReport report = order_travel(page.drawing);
  const Resolution& resolution = page.info.resolution;
  double per_metre = units_of(resolution.x);
  switch (resolution.unit) {
    case Resolution::Unit::none: per_metre = 0; break;
    case Resolution::Unit::inch: per_metre /= 0.0254; break;
    case Resolution::Unit::centimetre: per_metre *= 100; break;
    case Resolution::Unit::metre: break;
  }
  const bool known = per_metre > 0;
  const double scale = known ? per_metre : 1;
  notes.push_back(fmt::format(
      "travel between lines is {:.4g} {} instead of {:.4g}",
      report.after / scale, known ? "m" : "px", report.before / scale));
  return {};
}

Result<Page> to_steps(Page page, const Quantity& grid,
                      std::uint64_t max_steps) {
  Resolution& resolution = page.info.resolution;
  const Result<double> width =
      to_grid_units(grid, resolution.x, resolution.unit);
  if (!width) return width.error();
  const bool outlines =
      page.drawing.paint == Paint::fill && all_closed(page.drawing);
  const Method lines = outlines ? Method::evaluation : Method::evaluation8;
  Result<Drawing> steps = step_paths(page.drawing, {lines, *width, max_steps});
  if (!steps) return steps.error();
  page.kind = PageKind::chains;
  page.drawing = *std::move(steps);
  if (resolution.known()) {
    // Units per length over the grid's width, to a part in a million.
    for (Rational* axis : {&resolution.x, &resolution.y}) {
      const double rate = units_of(*axis) / *width;
      if (!(rate < 4000)) continue;
      const auto millionths =
          static_cast<std::uint32_t>(std::llround(rate * 1e6));
      const std::uint32_t common = std::gcd(millionths, 1'000'000U);
      *axis = {millionths / common, 1'000'000U / common};
    }
  }
  return page;
}

Result<Page> draw_program_page(const Page& page,
                               std::vector<std::string>& notes) {
  const Result<Program> program = read_gcode(page.program, {});
  if (!program) return program.error();
  Result<Drawing> drawing = program_drawing(*program, &notes);
  if (!drawing) return drawing.error();
  Page out;
  out.kind = PageKind::paths;
  out.info = page.info;
  // A grid unit is a millimetre.
  out.info.resolution = {{10, 1}, {10, 1}, Resolution::Unit::centimetre};
  out.drawing = *std::move(drawing);
  return out;
}

Result<Drawing> device_chains(const Drawing& paths) {
  return step_paths(paths, {Method::device, 1.0, std::uint64_t{1} << 40});
}

Result<Bitmap> to_ink(const Page& page, const DecodeLimits& limits,
                      std::vector<std::string>& notes) {
  if (page.kind == PageKind::ink) return page.ink;
  Drawing drawing = page.drawing;
  if (page.kind == PageKind::paths &&
      page.fidelity.kind == Fidelity::Kind::device) {
    Result<Drawing> chains = device_chains(drawing);
    if (!chains) return chains.error();
    drawing = *std::move(chains);
  }
  if (Status canvas = give_canvas(drawing, notes); !canvas) {
    return canvas.error();
  }
  if (Status small = fits(drawing.canvas, limits); !small) {
    return small.error();
  }
  drawing = with_y_down(std::move(drawing));
  if (drawing.paths.empty() && are_contours(drawing)) {
    Result<Bitmap> filled = fill_contours(drawing.chains, drawing.canvas.width,
                                          drawing.canvas.height);
    if (filled || filled.error().code != ErrorCode::out_of_range) {
      return filled;
    }
  }
  if (!drawing.chains.empty()) {
    drawing.paint = Paint::stroke;
    drawing.scale = 1;
    for (const Chain& chain : drawing.chains) {
      drawing.paths.push_back(as_hairline(chain));
    }
    drawing.chains.clear();
  }
  return render_paths(drawing);
}

}  // namespace unstep::cli
