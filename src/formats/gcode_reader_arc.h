#pragma once

#include <array>
#include <cstdint>
#include <string>

/// Arcs as programs give them: by their centre or by their radius.
namespace unstep {

/// In ProgramPosition units, |coordinates| <= 2 * kMaxProgramLength.
struct GcodeArc {
  std::array<std::int64_t, 2> start{};
  std::array<std::int64_t, 2> end{};
  bool counter = false;
  bool has_centre = false;
  std::array<std::int64_t, 2> centre{};
  std::int64_t radius = 0;  ///< 0: not given; below 0: more than a half turn
};

/// Finds the centre of an arc that has a radius, checks that of one that has
/// a centre. Returns what is wrong, or nothing.
std::string solve_arc(GcodeArc& arc, double tolerance_mm,
                      double tolerance_relative);

}  // namespace unstep
