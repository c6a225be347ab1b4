#pragma once

#include <cstdint>
#include <vector>

#include "machine/carriage.h"
#include "unstep/result.h"

/// The result that the article shows: a photomask of 114 x 114 dots on a grid
/// of 1 mm, worst error 1.2 um, in 30 minutes.
namespace unstep::machine {

inline constexpr double kMaskErrorUm = 1.2;
inline constexpr double kMaskSeconds = 30 * 60;

/// Dots are flashed in motion, row by row, there and back: at 1 cm/s the way
/// alone takes 21.5 minutes, so there is no time to stop at 12996 dots. A flash
/// of 1 ms would smear 10 um; 50 us smear 0.5 um.
struct MaskJob {
  int columns = 114;
  int rows = 114;
  std::int32_t pitch_pulses = 12'500;  ///< of lambda / 8: 1 mm
  std::int32_t width_us = 50;          ///< of a flash, 1..1000
  std::int32_t rate = 950;             ///< in 10 um/s: 9.5 mm/s
};

/// One row: x from `start` past the last dot, in pulses.
struct MaskRow {
  std::int32_t y = 0;
  std::int32_t start = 0;  ///< where the run-up begins
  std::int32_t first = 0;  ///< the count at which the first flash begins
  int direction = 1;
};

struct MaskReport {
  int dots = 0;
  double seconds = 0;
  /// From a grid point to the light, the farthest during a flash.
  double worst_um = 0;
  double rms_um = 0;
  double smear_um = 0;  ///< the longest way during a flash
  double top_speed_um = 0;
};

/// The rows, the flashes begun early by half of their smear.
/// out_of_range naming the number: 1 <= columns, rows; the grid within 23 bits
/// of pulses; at most 500 flashes a second; 2 <= rate <= 1000; 1 <= width_us <=
/// 1000.
Result<std::vector<MaskRow>> plan_mask(const MaskJob& job);

/// Plans, runs all of it on a Zenit by controller words, and measures.
/// internal if the machine did not come to rest or lost dots.
Result<MaskReport> expose_mask(const MaskJob& job, const Plant& plant,
                               std::uint64_t seed);

}  // namespace unstep::machine
