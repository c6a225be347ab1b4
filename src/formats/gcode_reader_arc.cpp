#include "formats/gcode_reader_arc.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "program/arc_geometry.h"
#include "program/units.h"
#include "unstep/program.h"

namespace unstep {
namespace {

std::string in_mm(double length) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.4f mm", length / kPerMm);
  return text.data();
}

std::string solve_radius(GcodeArc& arc, double tolerance) {
  const double chord = distance(arc.start, arc.end);
  if (chord == 0) return "with R it cannot end where it starts";
  const double radius = std::abs(static_cast<double>(arc.radius));
  if (chord / 2 - radius > tolerance) {
    return "a radius of " + in_mm(radius) + " does not reach an end " +
           in_mm(chord) + " away";
  }
  const auto centre =
      centre_by_radius(arc.start, arc.end, arc.radius, arc.counter);
  if (!centre) return "its centre is beyond 100 km";
  arc.centre = *centre;
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
  const double first = distance(arc.start, arc.centre);
  const double last = distance(arc.end, arc.centre);
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
