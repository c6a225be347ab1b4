#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "interpolate/arc_walk.h"
#include "interpolate/ticks.h"
#include "unstep/interpolate.h"

/// D1: circular evaluation function, survey of interpolation methods.
namespace unstep::interpolation {

/// Which axes the next move of a walk goes along.
///
/// F <= 0: a + 1, F += 2a + 1. F > 0: b - 1, F += -2b + 1. Combined: of
/// these and the diagonal a + 1, b - 1, F += 2(a - b) + 2, the one that leaves
/// the smallest |F|.
struct CircularMove {
  bool along_a = false;
  bool along_b = false;
};
/// REQUIRES: walk.left_a() or walk.left_b() is more than 0.
[[nodiscard]] CircularMove circular_move(const ArcWalk& walk, bool combined);

/// The interpolator of these moves.
///
/// The step frequency f = Vk (a + b) / R is corrected by +-Vk / R at every
/// step, in 2^-32 of a step per second; |a + b| <= 2^31.5 and Vk <= 2^30 keep
/// it below 2^63 (f <= sqrt(2) Vk).
class Circular {
 public:
  Circular(const ArcGeometry& arc, double feed, bool combined);

  Tick next();
  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

  /// Steps per second for the next step.
  [[nodiscard]] double frequency() const;

 private:
  ArcWalk walk_;
  std::int64_t frequency_;   ///< 2^-32 Hz
  std::int64_t correction_;  ///< Vk / R in the same unit
  bool combined_;
};

}  // namespace unstep::interpolation
