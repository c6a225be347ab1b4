#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "unstep/step_stream.h"

namespace unstep::steps {

/// A line of three axes: the axis with most steps, n, steps every time, the
/// others where floor((i d + n / 2) / n) grows. |d| < 2^31, so sums stay below
/// 2^33.
class Line3 {
 public:
  explicit Line3(const std::array<std::int32_t, kMaxStepAxes>& delta) {
    for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
      const std::int64_t d = delta[axis];
      size_[axis] = d < 0 ? -d : d;
      bits_[axis] = static_cast<StepWord>((d < 0 ? 3U : 1U) << (2 * axis));
      count_ = std::max(count_, size_[axis]);
    }
    rest_.fill(count_ / 2);
  }

  [[nodiscard]] std::uint32_t count() const {
    return static_cast<std::uint32_t>(count_);
  }

  StepWord next() {
    StepWord word = 0;
    for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
      rest_[axis] += size_[axis];
      if (rest_[axis] < count_) continue;
      rest_[axis] -= count_;
      word = static_cast<StepWord>(word | bits_[axis]);
    }
    return word;
  }

 private:
  std::array<std::int64_t, kMaxStepAxes> size_{};
  std::array<std::int64_t, kMaxStepAxes> rest_{};
  std::array<StepWord, kMaxStepAxes> bits_{};
  std::int64_t count_ = 0;
};

}  // namespace unstep::steps
