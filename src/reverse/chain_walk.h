#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "unstep/grid.h"

namespace unstep::reverse {

[[nodiscard]] inline Point moved(Point at, Point by) {
  return {at.x + by.x, at.y + by.y};
}

/// The moves of all codes on one axis and the finer grids that there are.
using ScaledMoves = std::array<std::array<Point, 8>, 21>;

template <YAxis axis>
inline constexpr ScaledMoves kScaledMoves = [] {
  ScaledMoves moves;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    for (std::size_t code = 0; code < 8; ++code) {
      const Point delta = step_delta(static_cast<Step>(code), axis);
      moves[k][code] = {delta.x * (1 << k), delta.y * (1 << k)};
    }
  }
  return moves;
}();

/// A chain in path units. Indices count steps; on a closed chain they go on
/// beyond the last one, round and round (up to five times).
class ChainWalk {
 public:
  /// REQUIRES: scale is a power of two, at most Drawing::kMaxScale.
  ChainWalk(const Chain& chain, YAxis axis, std::int32_t scale)
      : steps_(chain.steps),
        deltas_(moves_of(axis)[static_cast<std::size_t>(
            std::countr_zero(static_cast<std::uint32_t>(scale)))]),
        origin_{chain.origin.x * scale, chain.origin.y * scale},
        connectivity_(chain.connectivity),
        closed_(chain.closed) {}

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
  static const ScaledMoves& moves_of(YAxis axis) {
    return axis == YAxis::up ? kScaledMoves<YAxis::up>
                             : kScaledMoves<YAxis::down>;
  }

  std::span<const Step> steps_;
  std::span<const Point, 8> deltas_;  ///< drawings have many chains
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
