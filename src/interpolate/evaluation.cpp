#include "interpolate/evaluation.h"

#include <algorithm>

namespace unstep::interpolation {

std::size_t Evaluation::registers(
    std::span<Register, kMaxRegisters> out) const {
  out[0] = {"x", x_};
  out[1] = {"y", y_};
  out[2] = {"F", f_};
  return 3;
}

Evaluation8::Evaluation8(Segment segment) {
  const Quadrant q(segment);
  x_major_ = q.xk >= q.yk;
  straight_ = x_major_ ? q.along_x : q.along_y;
  diagonal_ = q.diagonal();
  n_ = std::max(q.xk, q.yk);
  m_ = std::min(q.xk, q.yk);
  remainder_ = n_ / 2;
}

Tick Evaluation8::next() {
  if (major_ == n_) return {};
  ++major_;
  remainder_ -= m_;
  if (remainder_ >= 0) return step_tick(straight_);
  remainder_ += n_;
  ++minor_;
  return step_tick(diagonal_);
}

std::size_t Evaluation8::registers(
    std::span<Register, kMaxRegisters> out) const {
  out[0] = {"x", x_major_ ? major_ : minor_};
  out[1] = {"y", x_major_ ? minor_ : major_};
  out[2] = {"F", remainder_ - n_ / 2};
  return 3;
}

}  // namespace unstep::interpolation
