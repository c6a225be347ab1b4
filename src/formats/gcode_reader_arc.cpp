#include "formats/gcode_reader_arc.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "unstep/program.h"

namespace unstep {
namespace {

constexpr double kPerMm = static_cast<double>(kProgramUnitsPerMm);

std::string in_mm(double length) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.4f mm", length / kPerMm);
  return text.data();
}

std::string solve_radius(GcodeArc& arc, double tolerance) {
  const auto dx = static_cast<double>(arc.end[0] - arc.start[0]);
  const auto dy = static_cast<double>(arc.end[1] - arc.start[1]);
  const double chord = std::hypot(dx, dy);
  if (chord == 0) return "with R it cannot end where it starts";
  const double radius = std::abs(static_cast<double>(arc.radius));
  if (chord / 2 - radius > tolerance) {
    return "a radius of " + in_mm(radius) + " does not reach an end " +
           in_mm(chord) + " away";
  }
  // The product keeps the digits that a difference of squares would lose.
  const double square = (radius - chord / 2) * (radius + chord / 2);
  const double height = square > 0 ? std::sqrt(square) : 0;
  const double side = arc.counter == (arc.radius > 0) ? 1 : -1;
  const double x = dx / 2 - side * height * dy / chord;
  const double y = dy / 2 + side * height * dx / chord;
  if (std::max(std::abs(x), std::abs(y)) >
      static_cast<double>(kMaxProgramLength)) {
    return "its centre is beyond 100 km";
  }
  arc.centre = {arc.start[0] + std::llround(x), arc.start[1] + std::llround(y)};
  return {};
}

}  // namespace

std::string solve_arc(GcodeArc& arc, double tolerance_mm,
                      double tolerance_relative) {
  const double tolerance = tolerance_mm * kPerMm;
  if (arc.radius != 0) {
    if (arc.has_centre) return "both a radius and a centre";
    return solve_radius(arc, tolerance);
  }
  if (!arc.has_centre) return "neither a radius nor a centre";
  const auto distance = [&arc](const std::array<std::int64_t, 2>& point) {
    return std::hypot(static_cast<double>(point[0] - arc.centre[0]),
                      static_cast<double>(point[1] - arc.centre[1]));
  };
  const double first = distance(arc.start);
  const double last = distance(arc.end);
  if (first == 0 || last == 0) return "its radius is 0";
  const double apart = std::abs(first - last);
  if (apart > 100 * tolerance ||
      (apart > tolerance &&
       apart > tolerance_relative * std::max(first, last))) {
    return "its radius is " + in_mm(first) + " at the start and " +
           in_mm(last) + " at the end, " + in_mm(apart) + " apart";
  }
  return {};
}

}  // namespace unstep
