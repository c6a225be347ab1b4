#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "unstep/grid.h"

namespace unstep::reverse {

[[nodiscard]] inline Point moved(Point at, Point by) {
  return {at.x + by.x, at.y + by.y};
}

/// A chain in path units. Indices count steps; on a closed chain they go on
/// beyond the last one, round and round (up to five times).
class ChainWalk {
 public:
  ChainWalk(const Chain& chain, YAxis axis, std::int32_t scale)
      : steps_(chain.steps),
        origin_{chain.origin.x * scale, chain.origin.y * scale},
        connectivity_(chain.connectivity),
        closed_(chain.closed) {
    for (std::size_t code = 0; code < deltas_.size(); ++code) {
      const Point delta = step_delta(static_cast<Step>(code), axis);
      deltas_[code] = {delta.x * scale, delta.y * scale};
    }
  }

  [[nodiscard]] std::span<const Step> steps() const { return steps_; }
  [[nodiscard]] std::size_t size() const { return steps_.size(); }
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] Point origin() const { return origin_; }
  [[nodiscard]] Connectivity connectivity() const { return connectivity_; }

  /// Step i of the chain. REQUIRES: i < size(), or < 5 * size() if closed.
  [[nodiscard]] Step step(std::size_t i) const {
    while (i >= steps_.size()) i -= steps_.size();
    return steps_[i];
  }

  [[nodiscard]] Point delta(Step step) const { return deltas_[step]; }

  /// True if the chain goes on at point i in the direction it came: every
  /// distance there is at most one of the neighbours'.
  [[nodiscard]] bool straight_at(std::size_t i) const {
    return step(i - 1) == step(i);
  }

  /// Every point from index `first` to `last`, both included, given where the
  /// chain is at `first`.
  [[nodiscard]] std::vector<Point> points(std::size_t first, std::size_t last,
                                          Point at) const {
    std::vector<Point> result;
    result.reserve(last - first + 1);
    result.push_back(at);
    for (std::size_t i = first; i < last; ++i) {
      const Point move = delta(step(i));
      at = {at.x + move.x, at.y + move.y};
      result.push_back(at);
    }
    return result;
  }

 private:
  std::span<const Step> steps_;
  std::array<Point, 8> deltas_;
  Point origin_;
  Connectivity connectivity_;
  bool closed_;
};

/// A vertex of a path of lines and where it is along the chain: the line from
/// one vertex to the next stands for the steps between their indices. `at` is
/// within the tolerance of the chain's point there, mostly that point itself.
struct LineVertex {
  std::size_t index = 0;
  Point at;
  friend bool operator==(const LineVertex&, const LineVertex&) = default;
};

}  // namespace unstep::reverse
