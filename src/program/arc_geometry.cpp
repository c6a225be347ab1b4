#include "program/arc_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unstep {

double distance(const PlanePoint& a, const PlanePoint& b) {
  return std::hypot(static_cast<double>(a[0] - b[0]),
                    static_cast<double>(a[1] - b[1]));
}

std::optional<PlanePoint> centre_by_radius(const PlanePoint& start,
                                           const PlanePoint& end,
                                           std::int64_t radius, bool counter) {
  const double chord = distance(start, end);
  if (chord == 0) return std::nullopt;
  const auto dx = static_cast<double>(end[0] - start[0]);
  const auto dy = static_cast<double>(end[1] - start[1]);
  const double size = std::abs(static_cast<double>(radius));
  // The product keeps the digits that a difference of squares would lose.
  const double square = (size - chord / 2) * (size + chord / 2);
  const double height = square > 0 ? std::sqrt(square) : 0;
  const double side = counter == (radius > 0) ? 1 : -1;
  const double x = dx / 2 - side * height * dy / chord;
  const double y = dy / 2 + side * height * dx / chord;
  if (std::max(std::abs(x), std::abs(y)) >
      static_cast<double>(kMaxProgramLength)) {
    return std::nullopt;
  }
  return PlanePoint{start[0] + std::llround(x), start[1] + std::llround(y)};
}

double arc_sweep(const PlanePoint& start, const PlanePoint& end,
                 const PlanePoint& centre, bool counter) {
  const auto sx = static_cast<double>(start[0] - centre[0]);
  const auto sy = static_cast<double>(start[1] - centre[1]);
  const auto ex = static_cast<double>(end[0] - centre[0]);
  const auto ey = static_cast<double>(end[1] - centre[1]);
  const double sign = counter ? 1 : -1;
  const double sweep =
      std::atan2((sx * ey - sy * ex) * sign, sx * ex + sy * ey);
  return sweep > 0 ? sweep : sweep + 2 * std::numbers::pi;
}

ProgramArc::ProgramArc(const ProgramMove& move) : move_(move) {
  const auto plane = plane_axes(move.plane);
  const PlanePoint from{move.start[plane[0]], move.start[plane[1]]};
  const PlanePoint to{move.end[plane[0]], move.end[plane[1]]};
  radius_ = distance(from, move.centre);
  sweep_ =
      arc_sweep(from, to, move.centre, move.kind == ProgramItem::Kind::counter);
  first_ = std::atan2(static_cast<double>(from[1] - move.centre[1]),
                      static_cast<double>(from[0] - move.centre[0]));
}

ProgramPosition ProgramArc::at(double part) const {
  const auto plane = plane_axes(move_.plane);
  const bool counter = move_.kind == ProgramItem::Kind::counter;
  const double angle = first_ + (counter ? sweep_ : -sweep_) * part;
  ProgramPosition at = move_.start;
  at[plane[0]] = move_.centre[0] + std::llround(radius_ * std::cos(angle));
  at[plane[1]] = move_.centre[1] + std::llround(radius_ * std::sin(angle));
  at[plane[2]] += std::llround(
      part * static_cast<double>(move_.end[plane[2]] - move_.start[plane[2]]));
  return at;
}

}  // namespace unstep
