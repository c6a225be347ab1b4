#include "deviation/flatten.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unstep::deviation {
namespace {

constexpr long double kFullTurn = 2 * std::numbers::pi_v<long double>;
/// So that an absurd radius cannot ask for all memory; a chord of the largest
/// circle of all is then still within 2^-6 of a unit.
constexpr long double kMaxChords = 1 << 22;

void append_arc(std::vector<Place>& out, Place from, const Arc& arc,
                long double unit, long double sagitta) {
  const ArcCurve curve = curve_of(arc);
  const long double radius = curve.radius * unit;
  // A chord of angle 2 h is R (1 - cos h) <= R h^2 / 2 from its arc.
  const long double half =
      std::min<long double>(std::sqrt(2 * sagitta / radius), 0.5L);
  const long double wanted = std::ceil(std::abs(curve.turn) / (2 * half));
  const auto chords =
      static_cast<std::size_t>(std::clamp(wanted, 1.0L, kMaxChords));
  for (std::size_t i = 1; i < chords; ++i) {
    const long double angle =
        curve.first + curve.turn * static_cast<long double>(i) /
                          static_cast<long double>(chords);
    out.push_back(
        {from.x + (curve.centre.x + curve.radius * std::cos(angle)) * unit,
         from.y + (curve.centre.y + curve.radius * std::sin(angle)) * unit});
  }
}

}  // namespace

long double distance(Place a, Place b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

ArcCurve curve_of(const Arc& arc) {
  ArcCurve curve;
  const long double ex = arc.end.x;
  const long double ey = arc.end.y;
  curve.centre = {static_cast<long double>(arc.centre.x),
                  static_cast<long double>(arc.centre.y)};
  if (arc.end == Point{}) {
    curve.turn = kFullTurn;
  } else {
    const long double along =
        (curve.centre.y * ex - curve.centre.x * ey) / (ex * ex + ey * ey);
    curve.centre = {ex / 2 - ey * along, ey / 2 + ex * along};
  }
  curve.radius = std::hypot(curve.centre.x, curve.centre.y);
  curve.first = std::atan2(-curve.centre.y, -curve.centre.x);
  if (arc.end != Point{}) {
    curve.turn =
        std::atan2(ey - curve.centre.y, ex - curve.centre.x) - curve.first;
    if (arc.clockwise) curve.turn = -curve.turn;
    while (curve.turn <= 0) curve.turn += kFullTurn;
    while (curve.turn > kFullTurn) curve.turn -= kFullTurn;
  }
  if (arc.clockwise) curve.turn = -curve.turn;
  return curve;
}

std::vector<Place> polyline_of(const Chain& chain, YAxis axis) {
  std::vector<Place> out;
  out.reserve(chain.steps.size() + 1);
  std::int64_t x = 0;
  std::int64_t y = 0;
  out.push_back({});
  for (const Step step : chain.steps) {
    const Point delta = step_delta(step, axis);
    x += delta.x;
    y += delta.y;
    out.push_back({static_cast<long double>(x), static_cast<long double>(y)});
  }
  return out;
}

std::vector<Place> polyline_of(const Path& path, std::int32_t scale,
                               Place origin, long double sagitta) {
  const long double unit = 1.0L / scale;
  std::vector<Place> out{origin};
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (const Path::Element& element : path.elements) {
    if (element.kind == Path::Kind::arc) {
      append_arc(out, out.back(), element.arc, unit, sagitta);
      x += element.arc.end.x;
      y += element.arc.end.y;
    } else {
      x += element.segment.dx;
      y += element.segment.dy;
    }
    out.push_back({origin.x + static_cast<long double>(x) * unit,
                   origin.y + static_cast<long double>(y) * unit});
  }
  return out;
}

}  // namespace unstep::deviation
