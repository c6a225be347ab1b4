#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "interpolate/ticks.h"
#include "unstep/interpolate.h"

/// C: the classic evaluation function F = xk y - yk x, "Interpolator",
/// section 3.3.1, and its 8-connected form.
namespace unstep::interpolation {

/// F >= 0: step along x, F -= yk. F < 0: step along y, F += xk.
///
/// Range: a step along x leaves F >= -yk, one along y leaves F < xk; so
/// -2^31 <= F < 2^31 in int64. Stopping: with x == xk and y < yk, F < 0, and
/// with y == yk and x < xk, F > 0, so no axis overruns. The one exception is
/// xk == 0, where F stays 0: it steps y only.
class Evaluation {
 public:
  explicit Evaluation(Segment segment) : quadrant_(segment) {}

  Tick next() {
    if (x_ == quadrant_.xk && y_ == quadrant_.yk) return {};
    if (f_ >= 0 && quadrant_.xk != 0) {
      ++x_;
      f_ -= quadrant_.yk;
      return step_tick(quadrant_.along_x);
    }
    ++y_;
    f_ += quadrant_.xk;
    return step_tick(quadrant_.along_y);
  }

  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  Quadrant quadrant_;
  std::int64_t x_ = 0;
  std::int64_t y_ = 0;
  std::int64_t f_ = 0;
};

/// Diagonal steps: n = max, m = min of the magnitudes; every tick moves the
/// major axis, and the minor axis too when the point would otherwise be more
/// than half a unit behind. remainder r = F + floor(n / 2), in [0, n) always:
/// r -= m; r < 0: diagonal, r += n. It comes back to its start after n steps,
/// so exactly m of them are diagonal.
class Evaluation8 {
 public:
  explicit Evaluation8(Segment segment);

  Tick next();
  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  Step straight_;
  Step diagonal_;
  bool x_major_;
  std::int64_t n_;
  std::int64_t m_;
  std::int64_t remainder_;
  std::int64_t major_ = 0;
  std::int64_t minor_ = 0;
};

}  // namespace unstep::interpolation
