#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "interpolate/arc_walk.h"
#include "interpolate/ticks.h"
#include "unstep/interpolate.h"

/// D2: code increments per period. The evaluation function runs in
/// accelerated time inside one period, with a step that starts at H0 and is
/// halved down to one unit; the sum of its moves is the output.
namespace unstep::interpolation {

/// Unit steps a period owes: Vk Tk (|xk| + |yk|) / L on a line, Vk Tk (a + b)
/// / R on a circle, as D1 corrects its feed. The fraction is carried over.
class StepBudget {
 public:
  /// Takes whole steps of `steps` (2^-32 of a step, >= 0) and the carry.
  std::int64_t take(Int128 steps) {
    const Int128 sum = steps + carry_;
    carry_ = static_cast<std::int64_t>(sum & 0xFFFFFFFF);
    return static_cast<std::int64_t>(sum >> 32);
  }

 private:
  std::int64_t carry_ = 0;
};

/// F = xk y - yk x as in C. A step of H > 1 is taken along the minor axis
/// only if it does not cross the line, so what is left for the smaller steps
/// is a lag they can make up; 3H steps are kept back for them.
///
/// Range: |F| < 2^32 * 3H <= 2^54.
class LineIncrements {
 public:
  /// REQUIRES: length = Vk Tk in [2^-10, 2^30], first_step a power of two.
  LineIncrements(Segment segment, double length, std::int32_t first_step);

  Tick next();
  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  bool step(std::int64_t h);

  Quadrant quadrant_;
  std::int64_t first_step_;
  std::int64_t steps_per_period_;  ///< 2^-32
  StepBudget budget_;
  std::int64_t x_ = 0;
  std::int64_t y_ = 0;
  std::int64_t f_ = 0;
};

/// The same on an arc, with F = a^2 + b^2 - R^2 as in D1.
class ArcIncrements {
 public:
  ArcIncrements(const ArcGeometry& arc, double length, std::int32_t first_step);

  Tick next();
  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  bool step(std::int64_t h, Point& sum);

  ArcWalk walk_;
  std::int64_t first_step_;
  std::int64_t length_over_radius_;  ///< 2^-32
  StepBudget budget_;
};

}  // namespace unstep::interpolation
