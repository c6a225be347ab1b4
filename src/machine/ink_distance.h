#pragma once

#include <cstdint>

#include "unstep/bitmap.h"

/// How far what a machine made is from what it was told.
namespace unstep::machine {

struct InkDistance {
  std::uint64_t differing = 0;  ///< points that are ink in one only
  /// From an ink point of one to the nearest ink point of the other, both
  /// ways: the largest, and the root of the mean square over all ink points.
  double worst = 0;
  double rms = 0;
  /// Ink with none of the other within kReach: counted as that far.
  std::uint64_t lost = 0;

  static constexpr std::int32_t kReach = 32;
};

/// REQUIRES: both of one size. Time is that of reading both, and kReach^2 for
/// each lost point at most.
[[nodiscard]] InkDistance ink_distance(const Bitmap& a, const Bitmap& b);

}  // namespace unstep::machine
