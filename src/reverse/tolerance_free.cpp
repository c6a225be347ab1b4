#include "reverse/tolerance_free.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace unstep::reverse {
namespace {

__extension__ using Wide = __int128;

/// Where a line can start: near the chain's point `anchor`, after `index`
/// steps. `parent` is the node where the line to it starts.
struct Node {
  Point at;
  Point anchor;
  std::size_t index = 0;
  std::size_t parent = 0;
};

/// Nodes that are kept before the way of one of them is made final.
constexpr std::size_t kMaxNodes = 4096;
/// Steps that are looked at in vain, beyond as many as the line has.
constexpr std::size_t kBeamPatience = 64;

class Beam {
 public:
  Beam(const ChainWalk& chain, PathTolerance tolerance, int width)
      : chain_(chain), cone_(tolerance), places_(disc(tolerance, width)) {}

  /// Lines from `first` (and the chain's point there) to `target`, a vertex
  /// further along the chain; nothing if there is no way.
  LineVertices run(const LineVertex& first, Point anchor,
                   const LineVertex& target);

 private:
  static std::vector<Point> disc(PathTolerance tolerance, int width);
  bool extend(std::size_t from, const LineVertex& target);

  const ChainWalk& chain_;
  Cone cone_;
  std::vector<Point> places_;  ///< of a vertex, relative to the chain
  std::vector<Node> nodes_;
  /// For each place the line that gets there farthest along the chain; index 0
  /// if there is none.
  std::vector<Node> found_;
};

/// Up to about 4 * width^2 points of the disc, as far apart as that allows.
/// Range: e <= 2^20 units and |x|, |y| <= e, so r^2 <= 2^41 and both squares
/// times 2^24 are below 2^66: compared as r2 <= e^2 / 2^24, rounded down.
std::vector<Point> Beam::disc(PathTolerance tolerance, int width) {
  const std::int64_t e = tolerance.fixed;
  const std::int64_t units = e >> PathTolerance::kBits;
  const std::int64_t spacing = std::max<std::int64_t>(1, units / width);
  std::vector<Point> result;
  for (std::int64_t y = -units; y <= units; ++y) {
    for (std::int64_t x = -units; x <= units; ++x) {
      if (x % spacing != 0 || y % spacing != 0) continue;
      const Wide r2 = Wide{x * x + y * y} << (2 * PathTolerance::kBits);
      if (r2 <= Wide{e} * e) {
        result.push_back(
            {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)});
      }
    }
  }
  return result;
}

/// Looks along the chain from a node and notes where lines may end. True if one
/// may end at the target.
bool Beam::extend(std::size_t from, const LineVertex& target) {
  cone_.restart();
  const Node start = nodes_[from];
  std::size_t index = start.index;
  Point anchor = start.anchor;
  const auto ends_at = [&](Point at) {
    return cone_.may_end_at(std::int64_t{at.x} - start.at.x,
                            std::int64_t{at.y} - start.at.y);
  };
  std::size_t stop = std::min(target.index, index + kBeamPatience);
  while (index < stop) {
    const Step step = chain_.step(index);
    anchor = moved(anchor, chain_.delta(step));
    ++index;
    if (index == target.index) return ends_at(target.at);
    bool any = false;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (found_[k].index >= index) continue;
      const Point at = moved(anchor, places_[k]);
      if (!ends_at(at)) continue;
      found_[k] = {at, anchor, index, from};
      any = true;
    }
    if (any) {
      stop = std::min(target.index,
                      start.index + 4 * (index - start.index) + kBeamPatience);
    }
    if (chain_.step(index) != step &&
        !cone_.add(std::int64_t{anchor.x} - start.at.x,
                   std::int64_t{anchor.y} - start.at.y)) {
      return false;
    }
  }
  return false;
}

LineVertices Beam::run(const LineVertex& first, Point anchor,
                       const LineVertex& target) {
  LineVertices result{first};
  nodes_ = {{first.at, anchor, first.index, 0}};
  const auto append_way = [&](std::size_t node) {
    const auto old = static_cast<std::ptrdiff_t>(result.size());
    for (std::size_t i = node; i != 0; i = nodes_[i].parent) {
      result.push_back({nodes_[i].index, nodes_[i].at});
    }
    std::reverse(result.begin() + old, result.end());
  };
  for (std::size_t layer = 0; layer < nodes_.size();) {
    const std::size_t end = nodes_.size();
    found_.assign(places_.size(), {});
    for (std::size_t i = layer; i < end; ++i) {
      if (!extend(i, target)) continue;
      append_way(i);
      result.push_back(target);
      return result;
    }
    layer = end;
    for (const Node& node : found_) {
      if (node.index > 0) nodes_.push_back(node);
    }
    if (nodes_.size() > kMaxNodes && layer < nodes_.size()) {
      append_way(layer);
      nodes_ = {nodes_[layer]};
      nodes_.front().parent = 0;
      layer = 0;
    }
  }
  return {};
}

}  // namespace

LineVertices fit_free_lines(const ChainWalk& chain, PathTolerance tolerance,
                            int width) {
  LineVertices fit = fit_lines(chain, tolerance);
  if (chain.size() == 0) return fit;
  Beam beam(chain, tolerance, width);
  if (!chain.closed()) {
    LineVertices free = beam.run(fit.front(), fit.front().at, fit.back());
    return !free.empty() && free.size() < fit.size() ? free : fit;
  }
  if (chain.size() <= kSpeckSteps || fit.size() <= 5) return fit;
  LineVertices once = beam.run(fit.front(), fit.front().at, fit.back());
  if (once.empty()) return fit;
  // The start stays on the chain: there a checker can begin without a search.
  const std::size_t middle = once[once.size() / 2].index;
  const Point anchor =
      chain.points(once.front().index, middle, once.front().at).back();
  const LineVertex start{middle, anchor};
  const LineVertex target{start.index + chain.size(), start.at};
  LineVertices again = beam.run(start, anchor, target);
  LineVertices& best =
      !again.empty() && again.size() < once.size() ? again : once;
  if (best.size() >= fit.size()) return fit;
  const std::size_t laps = best.front().index / chain.size() * chain.size();
  for (LineVertex& vertex : best) vertex.index -= laps;
  return std::move(best);
}

}  // namespace unstep::reverse
