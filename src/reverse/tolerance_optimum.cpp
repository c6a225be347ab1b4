#include "reverse/tolerance_optimum.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

namespace unstep::reverse {
namespace {

/// Lines in the high bits, bits of their vectors in the low ones: a chain has
/// less than 2^28 lines, a line costs at most 64 bits.
using Cost = std::uint64_t;
constexpr int kBitsOfBits = 36;
constexpr Cost kOneLine = Cost{1} << kBitsOfBits;

std::uint64_t lines_of(Cost cost) { return cost >> kBitsOfBits; }

/// About the bits of the vector in any code that makes short ones cheap and
/// has short words for axes and diagonals.
Cost line_cost(Point from, Point to) {
  const auto dx = static_cast<std::uint32_t>(std::abs(to.x - from.x));
  const auto dy = static_cast<std::uint32_t>(std::abs(to.y - from.y));
  const auto x_bits = static_cast<Cost>(std::bit_width(dx));
  const auto y_bits = static_cast<Cost>(std::bit_width(dy));
  const bool regular = dx == 0 || dy == 0 || dx == dy;
  return kOneLine + (regular ? std::max(x_bits, y_bits) : x_bits + y_bits);
}

/// The shortest path over points `first` to `last` of one chain.
class Search {
 public:
  Search(const ChainWalk& chain, PathTolerance tolerance)
      : chain_(chain), cone_(tolerance) {}

  /// Lines from `first` to point `last`.
  Cost run(const LineVertex& first, std::size_t last) {
    points_ = chain_.points(first.index, last, first.at);
    first_ = first.index;
    best_.assign(points_.size(), {std::numeric_limits<Cost>::max(), 0});
    best_[0].cost = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) extend(i);
    return best_.back().cost;
  }

  /// The lines' ends of the last run, in order.
  void append_to(LineVertices& vertices) const {
    const auto old = static_cast<std::ptrdiff_t>(vertices.size());
    for (std::size_t i = points_.size() - 1; i > 0; i = best_[i].from) {
      vertices.push_back({first_ + i, points_[i]});
    }
    std::reverse(vertices.begin() + old, vertices.end());
  }

 private:
  struct Best {
    Cost cost;
    std::size_t from;
  };

  /// All lines that start at point i.
  void extend(std::size_t i) {
    cone_.restart();
    const Point from = points_[i];
    const Cost so_far = best_[i].cost;
    const std::size_t end = std::min(points_.size(), i + kSearchWindow + 1);
    for (std::size_t k = i + 1; k < end; ++k) {
      const Point to = points_[k];
      const std::int64_t x = std::int64_t{to.x} - from.x;
      const std::int64_t y = std::int64_t{to.y} - from.y;
      if (best_[k].cost > so_far + kOneLine && cone_.may_end_at(x, y)) {
        const Cost cost = so_far + line_cost(from, to);
        if (cost < best_[k].cost) best_[k] = {cost, i};
      }
      if (k + 1 < end && !chain_.straight_at(first_ + k) && !cone_.add(x, y)) {
        break;
      }
    }
  }

  const ChainWalk& chain_;
  Cone cone_;
  std::size_t first_ = 0;
  std::vector<Point> points_;
  std::vector<Best> best_;
};

/// Searches between the long lines of `fit`, a chain's or a ring's vertices.
LineVertices improve(const LineVertices& fit, Search& search) {
  LineVertices result{fit.front()};
  for (std::size_t i = 1; i < fit.size(); ++i) {
    const bool kept = fit[i].index - fit[i - 1].index > kSearchWindow / 2;
    const bool last = i + 1 == fit.size();
    if (kept && result.back().index < fit[i - 1].index) {
      search.run(result.back(), fit[i - 1].index);
      search.append_to(result);
    }
    if (kept) {
      result.push_back(fit[i]);
    } else if (last) {
      search.run(result.back(), fit[i].index);
      search.append_to(result);
    }
  }
  return result.size() <= fit.size() ? result : fit;
}

/// The same ring, beginning at its vertex k.
LineVertices turned(const ChainWalk& chain, const LineVertices& ring,
                    std::size_t k) {
  LineVertices result(ring.begin() + static_cast<std::ptrdiff_t>(k),
                      ring.end() - 1);
  for (std::size_t i = 0; i <= k; ++i) {
    result.push_back({ring[i].index + chain.size(), ring[i].at});
  }
  return result;
}

/// Any ring has a vertex among the points after vertex 0 that its line can
/// reach, so one of these starts is the best.
LineVertices best_start(const ChainWalk& chain, const LineVertices& fit,
                        Search& search) {
  std::size_t shortest = 1;
  for (std::size_t i = 2; i < fit.size(); ++i) {
    if (fit[i].index - fit[i - 1].index <
        fit[shortest].index - fit[shortest - 1].index) {
      shortest = i;
    }
  }
  LineVertices best = fit;
  Cost best_cost = std::numeric_limits<Cost>::max();
  const std::vector<Point> starts = chain.points(
      fit[shortest - 1].index, fit[shortest].index, fit[shortest - 1].at);
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const LineVertex start{fit[shortest - 1].index + k, starts[k]};
    const Cost cost = search.run(start, start.index + chain.size());
    if (cost >= best_cost) continue;
    best_cost = cost;
    best = {start};
    search.append_to(best);
  }
  return lines_of(best_cost) <= fit.size() - 1 ? best : fit;
}

}  // namespace

LineVertices fit_fewest_lines(const ChainWalk& chain, PathTolerance tolerance) {
  LineVertices fit = fit_lines(chain, tolerance);
  if (fit.size() < 3) return fit;
  Search search(chain, tolerance);
  if (!chain.closed()) return improve(fit, search);
  if (fit.size() <= 5 || chain.size() <= kSpeckSteps) return fit;
  if (chain.size() <= kSearchWindow) {
    fit = best_start(chain, fit, search);
  } else {
    fit = improve(fit, search);
    fit = improve(turned(chain, fit, fit.size() / 2), search);
  }
  const std::size_t laps = fit.front().index / chain.size() * chain.size();
  for (LineVertex& vertex : fit) vertex.index -= laps;
  return fit;
}

}  // namespace unstep::reverse
