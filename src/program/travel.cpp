#include <algorithm>
#include <utility>
#include <vector>

#include "grid/chain_end.h"
#include "program/travel_order.h"
#include "unstep/program.h"

namespace unstep {
namespace {

using program::Leg;
using program::Trip;

Point moved(Point at, Point by) { return {at.x + by.x, at.y + by.y}; }

Point end_of(const Chain& chain, YAxis axis) { return chain_end(chain, axis); }

Point move_of(const Path::Element& element) {
  return element.kind == Path::Kind::arc
             ? element.arc.end
             : Point{element.segment.dx, element.segment.dy};
}

Point end_of(const Path& path, YAxis /*axis*/) {
  Point at = path.origin;
  for (const Path::Element& element : path.elements) {
    at = moved(at, move_of(element));
  }
  return at;
}

void turn(Chain& chain, Point end) {
  chain.origin = end;
  std::ranges::reverse(chain.steps);
  for (Step& step : chain.steps) step ^= 4;
}

/// Arcs keep their centres, which are relative to their starts.
void turn(Path& path, Point end) {
  path.origin = end;
  std::ranges::reverse(path.elements);
  for (Path::Element& element : path.elements) {
    element.segment = {-element.segment.dx, -element.segment.dy};
    if (element.kind != Path::Kind::arc) continue;
    Arc& arc = element.arc;
    arc.centre = {arc.centre.x - arc.end.x, arc.centre.y - arc.end.y};
    arc.end = {-arc.end.x, -arc.end.y};
    arc.clockwise = !arc.clockwise;
  }
}

template <class Shape>
void order_shapes(std::vector<Shape>& shapes, YAxis axis, Point start,
                  double unit, TravelReport& report) {
  if (shapes.empty()) return;
  std::vector<Trip> trips;
  std::vector<Leg> given;
  for (const Shape& shape : shapes) {
    given.push_back({static_cast<std::uint32_t>(trips.size()), false});
    trips.push_back(
        {shape.origin, shape.closed ? shape.origin : end_of(shape, axis)});
  }
  const std::vector<Leg> order = program::short_order(trips, start);
  report.before += program::travel_of(trips, given, start) * unit;
  report.after += program::travel_of(trips, order, start) * unit;
  std::vector<Shape> ordered;
  ordered.reserve(shapes.size());
  for (const Leg leg : order) {
    ordered.push_back(std::move(shapes[leg.trip]));
    if (leg.turned && !ordered.back().closed) {
      turn(ordered.back(), trips[leg.trip].to);
    }
  }
  shapes = std::move(ordered);
}

}  // namespace

TravelReport order_travel(Drawing& drawing) {
  TravelReport report;
  const Canvas& canvas = drawing.canvas;
  const bool up = canvas.y_axis == YAxis::up;
  const Point corner{0, up ? canvas.height : 0};
  order_shapes(drawing.chains, canvas.y_axis, corner, 1, report);
  const std::int64_t top = std::int64_t{corner.y} * drawing.scale;
  const Point start{
      0, static_cast<std::int32_t>(std::min<std::int64_t>(top, kMaxCoord))};
  order_shapes(drawing.paths, canvas.y_axis, start, 1.0 / drawing.scale,
               report);
  return report;
}

}  // namespace unstep
