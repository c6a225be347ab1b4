#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "unstep/interpolate.h"

namespace unstep {
namespace {

struct Place {
  double x = 0;
  double y = 0;
};

/// Draws one path after another on the new grid. Coordinates of drawings are
/// whole numbers below 2^30, so doubles hold them and their sums exactly.
class PathStepper {
 public:
  PathStepper(const Drawing& drawing, const StepOptions& options)
      : unit_(options.grid * drawing.scale),
        up_(drawing.canvas.y_axis == YAxis::up),
        lines_(options.lines),
        left_(options.max_steps) {}

  Result<Chain> draw(const Path& path) {
    chain_ = Chain();
    chain_.connectivity = lines_ == Method::evaluation8 ? Connectivity::eight
                                                        : Connectivity::four;
    chain_.closed = path.closed;
    at_ = {static_cast<double>(path.origin.x),
           static_cast<double>(path.origin.y)};
    const Result<Point> origin = rounded(at_);
    if (!origin) return origin.error();
    chain_.origin = grid_at_ = *origin;
    for (const Path::Element& element : path.elements) {
      const Status drawn = element.kind == Path::Kind::segment
                               ? draw(element.segment)
                               : draw(element.arc);
      if (!drawn) return drawn.error();
    }
    return std::move(chain_);
  }

 private:
  Result<Point> rounded(Place place) const {
    const double x = std::round(place.x / unit_);
    const double y = std::round(place.y / unit_);
    if (!(std::abs(x) <= kMaxCoord) || !(std::abs(y) <= kMaxCoord)) {
      return Error{ErrorCode::out_of_range,
                   "a point of the path leaves the grid's range"};
    }
    return Point{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }

  Status draw(const Segment& segment) {
    at_.x += segment.dx;
    at_.y += segment.dy;
    return line_to(at_);
  }

  Status line_to(Place place) {
    const Result<Point> end = rounded(place);
    if (!end) return end.error();
    // Freeman codes count y upwards.
    const std::int32_t dy = end->y - grid_at_.y;
    const Segment move{end->x - grid_at_.x, up_ ? dy : -dy};
    const std::uint64_t count = step_count(lines_, move);
    if (Status fits = take(count); !fits) return fits;
    const std::size_t before = chain_.steps.size();
    chain_.steps.resize(before + static_cast<std::size_t>(count));
    const Result<std::size_t> drawn = interpolate(
        lines_, std::array{move}, std::span(chain_.steps).subspan(before));
    if (!drawn) return drawn.error();
    grid_at_ = *end;
    return {};
  }

  Status draw(const Arc& arc) {
    const Place centre{at_.x + arc.centre.x, at_.y + arc.centre.y};
    const Place end{at_.x + arc.end.x, at_.y + arc.end.y};
    const Result<Point> grid_centre = rounded(centre);
    const Result<Point> grid_end = rounded(end);
    if (!grid_centre) return grid_centre.error();
    if (!grid_end) return grid_end.error();
    const bool full = arc.end == Point{};
    // The interpolator's y is up, so a y that grows downwards is mirrored.
    const Arc on_grid{minus(*grid_centre), minus(*grid_end),
                      arc.clockwise == up_};
    InterpolatorOptions options;
    options.combined = lines_ == Method::evaluation8;
    const bool vanished = !full && on_grid.end == Point{};
    if (Result<Interpolator> circle =
            Interpolator::arc(Method::circular, on_grid, options);
        circle && !vanished) {
      at_ = end;
      grid_at_ = *grid_end;
      return walk(*circle);
    }
    // Rounding has moved its end off the circle, or it is smaller than a step.
    return chords(centre, end, arc.clockwise, full);
  }

  [[nodiscard]] Point minus(Point point) const {
    const std::int32_t dy = point.y - grid_at_.y;
    return {point.x - grid_at_.x, up_ ? dy : -dy};
  }

  Status walk(Interpolator& circle) {
    for (Tick t = circle.next(); t.kind != Tick::Kind::done;
         t = circle.next()) {
      if (t.kind != Tick::Kind::step) continue;
      if (Status fits = take(1); !fits) return fits;
      chain_.steps.push_back(t.step);
    }
    return {};
  }

  /// Chords of at most half a step of the new grid.
  Status chords(Place centre, Place end, bool clockwise, bool full) {
    const double radius = std::hypot(at_.x - centre.x, at_.y - centre.y);
    const double first = std::atan2(at_.y - centre.y, at_.x - centre.x);
    const double last = std::atan2(end.y - centre.y, end.x - centre.x);
    const double sense = clockwise ? -1.0 : 1.0;
    double turn = std::fmod(sense * (last - first) + 4 * std::numbers::pi,
                            2 * std::numbers::pi);
    if (full || turn == 0) turn = 2 * std::numbers::pi;
    const double wanted = std::ceil(turn * radius / unit_ * 2);
    if (!(wanted <= static_cast<double>(left_) * 4 + 16))
      return take(left_ + 1);
    const auto count = static_cast<std::uint64_t>(std::max(wanted, 1.0));
    for (std::uint64_t i = 1; i < count; ++i) {
      const double angle = first + sense * turn * static_cast<double>(i) /
                                       static_cast<double>(count);
      if (Status drawn = line_to({centre.x + radius * std::cos(angle),
                                  centre.y + radius * std::sin(angle)});
          !drawn) {
        return drawn;
      }
    }
    at_ = end;
    return line_to(end);
  }

  Status take(std::uint64_t steps) {
    if (steps > left_) {
      return Error{ErrorCode::limit_exceeded,
                   "the paths have more unit steps than allowed"};
    }
    left_ -= steps;
    return {};
  }

  double unit_;  ///< path units per step of the new grid
  bool up_;
  Method lines_;
  std::uint64_t left_;
  Chain chain_;
  Place at_;  ///< path units
  Point grid_at_;
};

Result<std::int32_t> grid_side(std::int32_t side, double grid) {
  const double wanted = std::ceil(side / grid);
  if (wanted <= kMaxCoord) return static_cast<std::int32_t>(wanted);
  return Error{ErrorCode::out_of_range, "the canvas leaves the grid's range"};
}

}  // namespace

Result<Drawing> step_paths(const Drawing& drawing, const StepOptions& options) {
  const bool method = options.lines == Method::evaluation8 ||
                      options.lines == Method::evaluation ||
                      options.lines == Method::device;
  if (!method || !(options.grid > 0) || !std::isfinite(options.grid)) {
    return Error{ErrorCode::invalid_argument,
                 method ? "the grid must be more than 0"
                        : "paths are drawn by evaluation8, evaluation or "
                          "device"};
  }
  const Result<std::int32_t> width =
      grid_side(drawing.canvas.width, options.grid);
  if (!width) return width.error();
  const Result<std::int32_t> height =
      grid_side(drawing.canvas.height, options.grid);
  if (!height) return height.error();
  Drawing out;
  out.canvas = {*width, *height, drawing.canvas.y_axis};
  PathStepper stepper(drawing, options);
  for (std::size_t i = 0; i < drawing.paths.size(); ++i) {
    Result<Chain> chain = stepper.draw(drawing.paths[i]);
    if (!chain) {
      return Error{chain.error().code, "path " + std::to_string(i + 1) + ": " +
                                           chain.error().message};
    }
    out.chains.push_back(*std::move(chain));
  }
  return out;
}

}  // namespace unstep
