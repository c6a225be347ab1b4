#include "reverse/tolerance_cheap.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "reverse/cheap_search.h"

namespace unstep::reverse {
namespace {

/// Rings of more steps are searched from one start.
constexpr std::size_t kManyStarts = 256;

/// Rings of so few steps must keep some ink.
constexpr std::size_t kSmallRing = 24;

/// A ring of vertices on the chain, begun at the topmost one.
LineVertices from_top(LineVertices ring, std::size_t lap) {
  if (ring.size() < 2) return ring;
  const auto top = std::min_element(
      ring.begin(), ring.end() - 1,
      [](const LineVertex& a, const LineVertex& b) {
        return a.at.y < b.at.y || (a.at.y == b.at.y && a.at.x < b.at.x);
      });
  ring.pop_back();
  std::rotate(ring.begin(), top, ring.end());
  // What came before the top is a lap later now.
  const std::size_t first = ring.front().index;
  for (LineVertex& vertex : ring) {
    if (vertex.index < first) vertex.index += lap;
    vertex.index -= first / lap * lap;
  }
  ring.push_back({ring.front().index + lap, ring.front().at});
  return ring;
}

/// Lines along the one-pass fit: between the ends of its long lines, searched.
std::optional<std::int64_t> lay(const LineVertices& fit, CheapSearch& search,
                                bool free, LineVertices& path) {
  std::int64_t cost = 0;
  for (std::size_t i = 1; i < fit.size(); ++i) {
    const bool last = i + 1 == fit.size();
    const bool kept = fit[i].index - fit[i - 1].index > kCheapLine;
    if (!kept && !last) continue;
    const auto part = search.append(fit[kept ? i - 1 : i], free && !kept, path);
    if (!part) return std::nullopt;
    cost += *part;
    if (kept) path.push_back(fit[i]);
  }
  return cost;
}

LineVertices one_pass(const ChainWalk& chain, PathTolerance tolerance,
                      const LineVertex& first) {
  LineVertices fit{first};
  fit_lines_between(chain, tolerance, first.index + chain.size(), chain.size(),
                    fit);
  return fit;
}

/// The topmost point of a ring, the leftmost of them.
LineVertex top_of(const ChainWalk& ring) {
  LineVertex top{0, ring.origin()};
  Point at = top.at;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Point move = ring.delta(ring.step(i - 1));
    at = {at.x + move.x, at.y + move.y};
    if (at.y < top.at.y || (at.y == top.at.y && at.x < top.at.x)) top = {i, at};
  }
  return top;
}

/// The straight steps from the topmost point along its row, forwards or, if
/// negative, backwards.
std::ptrdiff_t row_length(const ChainWalk& ring, const LineVertex& top) {
  const auto lap = static_cast<std::ptrdiff_t>(ring.size());
  const auto start = static_cast<std::ptrdiff_t>(top.index);
  // Whether step i leads along the row, away from its left end if `right`.
  const auto along = [&](std::ptrdiff_t i, bool right) {
    const Point move =
        ring.delta(ring.step(static_cast<std::size_t>((i + lap) % lap)));
    return move.y == 0 && (move.x > 0) == right;
  };
  std::ptrdiff_t n = 0;
  while (n < lap && along(start + n, true)) ++n;
  if (n > 0) return n;
  while (-n < lap && along(start + n - 1, false)) --n;
  return n;
}

/// Twice the area, with its sign. Coordinates are below 2^31, sums of areas of
/// rings within that square below 2^63.
std::int64_t area(const LineVertices& ring) {
  std::int64_t sum = 0;
  const Point origin = ring.front().at;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const vectors::Vec a = vectors::between(origin, ring[i - 1].at);
    const vectors::Vec b = vectors::between(origin, ring[i].at);
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

bool same_side(std::int64_t a, std::int64_t b) {
  return (a > 0 && b > 0) || (a < 0 && b < 0);
}

/// Whether the middle of a unit square is inside the ring, so that it has ink.
/// For small rings.
bool has_ink(const LineVertices& ring) {
  const auto [low, high] = std::minmax_element(
      ring.begin(), ring.end(),
      [](const LineVertex& a, const LineVertex& b) { return a.at.x < b.at.x; });
  const auto [top, bottom] = std::minmax_element(
      ring.begin(), ring.end(),
      [](const LineVertex& a, const LineVertex& b) { return a.at.y < b.at.y; });
  for (std::int64_t y = top->at.y; y < bottom->at.y; ++y) {
    for (std::int64_t x = low->at.x; x < high->at.x; ++x) {
      bool inside = false;
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const Point a = ring[i - 1].at;
        const Point b = ring[i].at;
        if ((a.y <= y) == (b.y <= y)) continue;
        // Which side of the line the middle (x + 1/2, y + 1/2) is on.
        const std::int64_t side = (2 * x + 1 - 2 * a.x) * (b.y - a.y) -
                                  (2 * y + 1 - 2 * a.y) * (b.x - a.x);
        if ((b.y > a.y) == (side < 0)) inside = !inside;
      }
      if (inside) return true;
    }
  }
  return false;
}

LineVertices fit_ring(CheapSearch& search, const ChainWalk& chain,
                      PathTolerance tolerance, const LinePrice& price,
                      std::size_t most_starts, const LineVertices& fit) {
  const LineVertex top = top_of(chain);
  const std::ptrdiff_t row = row_length(chain, top);
  const std::size_t starts =
      chain.size() > kManyStarts && most_starts <= 2 ? 1 : most_starts;
  LineVertices best;
  std::int64_t best_cost = std::numeric_limits<std::int64_t>::max();
  std::ptrdiff_t tried = -1;
  for (std::size_t k = 0; k < starts; ++k) {
    const std::ptrdiff_t along =
        starts == 1 ? 0
                    : row * static_cast<std::ptrdiff_t>(k) /
                          static_cast<std::ptrdiff_t>(starts - 1);
    if (k > 0 && along == tried) continue;
    tried = along;
    const auto lap = static_cast<std::ptrdiff_t>(chain.size());
    const auto index =
        (static_cast<std::ptrdiff_t>(top.index) + along + lap) % lap;
    const auto shift =
        static_cast<std::int32_t>(std::abs(along)) * std::abs(chain.delta(0).x);
    const LineVertex start{static_cast<std::size_t>(index),
                           {top.at.x + shift, top.at.y}};
    search.begin(chain, price);
    search.set_top(start.at);
    LineVertices path{start};
    const auto cost =
        lay(one_pass(chain, tolerance, start), search, true, path);
    if (!cost || *cost >= best_cost) continue;
    if (!same_side(area(path), area(fit))) continue;
    if (chain.size() <= kSmallRing && !has_ink(path)) continue;
    best_cost = *cost;
    best = std::move(path);
  }
  return best.empty() ? from_top(fit, chain.size()) : best;
}

}  // namespace

LineVertices fit_cheap_lines(CheapSearch& search, const ChainWalk& chain,
                             PathTolerance tolerance, const LinePrice& price,
                             std::size_t starts) {
  LineVertices fit = fit_lines(chain, tolerance);
  if (fit.size() <= 2) return fit;
  if (chain.closed()) {
    const bool whole = std::abs(chain.delta(0).x) == 1;
    if (fit.size() <= 3 || (chain.size() <= kSpeckSteps && !whole)) {
      return from_top(std::move(fit), chain.size());
    }
    return fit_ring(search, chain, tolerance, price, starts, fit);
  }
  search.begin(chain, price);
  LineVertices path{fit.front()};
  return lay(fit, search, false, path) ? path : fit;
}

}  // namespace unstep::reverse
