#include "formats/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace unstep {
namespace {

bool in_range(WidePoint point) {
  return point.x >= -kMaxCoord && point.x <= kMaxCoord &&
         point.y >= -kMaxCoord && point.y <= kMaxCoord;
}

Error beyond_range(const char* what) {
  return {ErrorCode::out_of_range,
          std::string(what) + " leaves the coordinate range of -" +
              std::to_string(kMaxCoord) + " to " + std::to_string(kMaxCoord)};
}

WidePoint turned(std::int64_t x, std::int64_t y, const Frame& frame) {
  return {x, frame.flip ? -y : y};
}

/// Sine and cosine of the turn from a to b, times their lengths. Moves are
/// below 2^32, so doubles hold the products to 2^-53 of their size.
double cross(WidePoint a, WidePoint b) {
  return static_cast<double>(a.x) * static_cast<double>(b.y) -
         static_cast<double>(a.y) * static_cast<double>(b.x);
}

}  // namespace

Status check_path(const Path& path) {
  WidePoint at{path.origin.x, path.origin.y};
  if (!in_range(at)) return beyond_range("a path");
  if (path.width < 0) {
    return Error{ErrorCode::out_of_range, "a pen of negative width"};
  }
  for (const Path::Element& element : path.elements) {
    if (element.kind == Path::Kind::segment) {
      at = at + WidePoint{element.segment.dx, element.segment.dy};
    } else {
      const Arc& arc = element.arc;
      if (arc.centre == Point{}) {
        return Error{ErrorCode::invalid_argument, "an arc without a radius"};
      }
      if (!in_range({arc.centre.x, arc.centre.y})) {
        return beyond_range("the centre of an arc");
      }
      at = at + WidePoint{arc.end.x, arc.end.y};
    }
    if (!in_range(at)) return beyond_range("a path");
  }
  if (path.closed && at != WidePoint{path.origin.x, path.origin.y}) {
    return Error{ErrorCode::invalid_argument,
                 "a closed path that does not return to its origin"};
  }
  return {};
}

Status check_chain(const Chain& chain, YAxis axis) {
  WidePoint at{chain.origin.x, chain.origin.y};
  if (!in_range(at)) return beyond_range("a chain");
  for (const Step step : chain.steps) {
    if (step > 7) {
      return Error{ErrorCode::invalid_argument, "a step above 7"};
    }
    const Point delta = step_delta(step, axis);
    at = at + WidePoint{delta.x, delta.y};
    if (!in_range(at)) return beyond_range("a chain");
  }
  if (chain.closed && at != WidePoint{chain.origin.x, chain.origin.y}) {
    return Error{ErrorCode::invalid_argument,
                 "a closed chain that does not return to its origin"};
  }
  return {};
}

void to_outline(const Path& path, const Frame& frame, Outline& outline) {
  outline.origin = turned(path.origin.x, path.origin.y, frame);
  outline.origin.y += frame.height;
  outline.closed = path.closed;
  outline.width = path.width;
  outline.pieces.clear();
  for (const Path::Element& element : path.elements) {
    Piece piece;
    if (element.kind == Path::Kind::segment) {
      piece.end = turned(element.segment.dx, element.segment.dy, frame);
    } else {
      const Arc& arc = element.arc;
      piece.is_arc = true;
      piece.end = turned(arc.end.x, arc.end.y, frame);
      piece.centre = turned(arc.centre.x, arc.centre.y, frame);
      // Clockwise is meant with y up, whatever the axis of the drawing.
      piece.ascending = arc.clockwise == frame.flip;
    }
    outline.pieces.push_back(piece);
  }
}

void to_outline(const Chain& chain, YAxis axis, std::int32_t scale,
                const Frame& frame, Outline& outline) {
  outline.origin = turned(std::int64_t{chain.origin.x} * scale,
                          std::int64_t{chain.origin.y} * scale, frame);
  outline.origin.y += frame.height;
  outline.closed = chain.closed;
  outline.width = 0;
  outline.pieces.clear();
  for (std::size_t i = 0; i < chain.steps.size();) {
    std::size_t next = i + 1;
    while (next < chain.steps.size() && chain.steps[next] == chain.steps[i]) {
      ++next;
    }
    const auto length = static_cast<std::int64_t>(next - i) * scale;
    const Point delta = step_delta(chain.steps[i], axis);
    Piece piece;
    piece.end = turned(delta.x * length, delta.y * length, frame);
    outline.pieces.push_back(piece);
    i = next;
  }
}

bool is_large(const Piece& arc) {
  // From the start, the centre lies on the side to which the arc turns unless
  // the arc is larger than half a circle.
  const double side = cross(arc.end, arc.centre);
  return arc.is_circle() || (arc.ascending ? side < 0 : side > 0);
}

RealCircle circle_of(const Piece& arc) {
  if (arc.is_circle()) {
    const auto x = static_cast<double>(arc.centre.x);
    const auto y = static_cast<double>(arc.centre.y);
    return {x, y, std::hypot(x, y)};
  }
  const auto ex = static_cast<double>(arc.end.x);
  const auto ey = static_cast<double>(arc.end.y);
  const double chord2 = ex * ex + ey * ey;
  const double height = cross(arc.end, arc.centre) / chord2;
  return {ex / 2 - height * ey, ey / 2 + height * ex,
          std::sqrt(chord2 * (0.25 + height * height))};
}

void flatten(const Piece& arc, double limit,
             const std::function<void(double x, double y)>& visit) {
  const RealCircle circle = circle_of(arc);
  const double sweep = sweep_of(arc);
  // The sagitta of a chord is radius (1 - cos(turn / 2)).
  const double cosine = std::max(0.5, 1 - limit / circle.radius);
  const auto count =
      static_cast<int>(std::ceil(sweep / (2 * std::acos(cosine))));
  const double turn = (arc.ascending ? sweep : -sweep) / count;
  const double begin = std::atan2(-circle.y, -circle.x);
  for (int i = 1; i < count; ++i) {
    const double angle = begin + turn * i;
    visit(circle.x + circle.radius * std::cos(angle),
          circle.y + circle.radius * std::sin(angle));
  }
  visit(static_cast<double>(arc.end.x), static_cast<double>(arc.end.y));
}

double sweep_of(const Piece& arc) {
  if (arc.is_circle()) return 2 * std::numbers::pi;
  const double chord = std::hypot(static_cast<double>(arc.end.x),
                                  static_cast<double>(arc.end.y));
  const double side = cross(arc.end, arc.centre) / chord;
  return 2 * std::atan2(chord / 2, arc.ascending ? side : -side);
}

void extend(WideBox& box, const Outline& outline) {
  const auto include = [&box](WidePoint point) {
    box.low = {std::min(box.low.x, point.x), std::min(box.low.y, point.y)};
    box.high = {std::max(box.high.x, point.x), std::max(box.high.y, point.y)};
  };
  WidePoint at = outline.origin;
  include(at);
  for (const Piece& piece : outline.pieces) {
    if (piece.is_arc) {
      // The whole circle: never too small.
      const auto x = static_cast<double>(piece.centre.x);
      const auto y = static_cast<double>(piece.centre.y);
      const auto radius =
          static_cast<std::int64_t>(std::ceil(std::hypot(x, y)));
      const WidePoint centre = at + piece.centre;
      include(centre - WidePoint{radius, radius});
      include(centre + WidePoint{radius, radius});
    }
    at = at + piece.end;
    include(at);
  }
}

}  // namespace unstep
