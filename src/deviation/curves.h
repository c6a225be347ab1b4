#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "grid/arc_circle.h"
#include "unstep/grid.h"

/// A chain as a polyline in path units, and the tolerance in path units.
namespace unstep::deviation {

/// numerator / denominator path units. REQUIRES (fits): both in [1, 2^30], and
/// reach <= 2^30.
struct Bound {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  std::int64_t reach = 0;  ///< rounded up
  std::int64_t unit = 1;   ///< path units per grid unit

  /// |a - b| <= bound. The parts of a - b are small (reach), so that
  /// (denominator part)^2 <= (numerator + denominator)^2 < 2^62.
  [[nodiscard]] bool within(Vector64 a, Vector64 b) const {
    const Vector64 d = a - b;
    if (d.x > reach || d.x < -reach || d.y > reach || d.y < -reach)
      return false;
    const std::int64_t x = d.x * denominator;
    const std::int64_t y = d.y * denominator;
    return static_cast<std::uint64_t>(x * x) +
               static_cast<std::uint64_t>(y * y) <=
           static_cast<std::uint64_t>(numerator * numerator);
  }
};

/// The points of a chain one after another; a cursor over its steps.
class ChainWalk {
 public:
  ChainWalk(Vector64 origin, std::span<const Step> steps, YAxis axis,
            std::int64_t unit)
      : at_(origin), steps_(steps) {
    for (Step step = 0; step < 8; ++step) {
      const Point delta = step_delta(step, axis);
      moves_[step] = {delta.x * unit, delta.y * unit};
    }
  }

  [[nodiscard]] std::size_t size() const { return steps_.size(); }
  [[nodiscard]] std::size_t index() const { return index_; }
  [[nodiscard]] Vector64 at() const { return at_; }
  [[nodiscard]] std::span<const Step> steps() const { return steps_; }
  [[nodiscard]] const std::array<Vector64, 8>& moves() const { return moves_; }

  /// The move of step i. REQUIRES: i < size().
  [[nodiscard]] Vector64 move(std::size_t i) const { return moves_[steps_[i]]; }

  /// Goes to the point after `index` steps, in as many steps as it is away.
  void seek(std::size_t index) {
    for (; index_ < index; ++index_) at_ = at_ + move(index_);
    for (; index_ > index; --index_) at_ = at_ - move(index_ - 1);
  }

  /// Takes over a walk that went on elsewhere.
  void set(std::size_t index, Vector64 at) {
    index_ = index;
    at_ = at;
  }

 private:
  Vector64 at_;
  std::size_t index_ = 0;
  std::span<const Step> steps_;
  std::array<Vector64, 8> moves_{};
};

}  // namespace unstep::deviation
