#include "strokes/stroke_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "grid/chain_end.h"

namespace unstep::strokes {
namespace {

/// Groups with a longer side are no letters.
constexpr std::int32_t kLetter = 96;
/// Ends are on a line if they are so near, in pixels, or within the pen.
constexpr std::int32_t kNear = 2;
constexpr std::uint32_t kNone = UINT32_MAX;
/// What follows in a string of text: no longer side than this, so far beyond
/// the right side of what is before, or above it. The last strings are asked.
constexpr std::int32_t kCharacter = 40;
constexpr std::int32_t kGap = 16;
constexpr std::int32_t kOverlap = 8;
constexpr std::ptrdiff_t kStrings = 12;

/// Points of one chain after another.
template <class Visit>
void for_each_point(const Chain& chain, Visit visit) {
  Point at = chain.origin;
  visit(at);
  for (const Step step : chain.steps) {
    const Point move = step_delta(step, YAxis::down);
    at = {at.x + move.x, at.y + move.y};
    visit(at);
  }
}

void turn(Stroke& stroke, Point end) {
  stroke.chain.origin = end;
  std::ranges::reverse(stroke.chain.steps);
  for (Step& step : stroke.chain.steps) step ^= 4;
  std::ranges::reverse(stroke.pieces);
}

/// The pixels of all strokes' middles, each with the stroke that has it first.
class Owners {
 public:
  explicit Owners(const std::vector<Stroke>& strokes) {
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      for_each_point(strokes[i].chain, [&](Point at) {
        points_.try_emplace(key(at), static_cast<std::uint32_t>(i));
      });
    }
  }
  [[nodiscard]] std::uint32_t at(Point p) const {
    const auto found = points_.find(key(p));
    return found == points_.end() ? kNone : found->second;
  }

 private:
  static std::uint64_t key(Point p) {
    return std::uint64_t{static_cast<std::uint32_t>(p.y)} << 32 |
           static_cast<std::uint32_t>(p.x);
  }
  std::unordered_map<std::uint64_t, std::uint32_t> points_;
};

/// Sets of strokes that touch.
class Groups {
 public:
  explicit Groups(std::size_t size) : parents_(size) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }
  std::uint32_t root(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

struct Extent {
  std::int32_t left = INT32_MAX;
  std::int32_t top = INT32_MAX;
  std::int32_t right = INT32_MIN;
  std::int32_t bottom = INT32_MIN;
  void add(Point p) {
    left = std::min(left, p.x);
    top = std::min(top, p.y);
    right = std::max(right, p.x);
    bottom = std::max(bottom, p.y);
  }
  [[nodiscard]] std::int32_t side() const {
    return std::max(right - left, bottom - top);
  }
};

class Orderer {
 public:
  explicit Orderer(std::vector<Stroke>& strokes)
      : strokes_(strokes),
        owners_(strokes),
        groups_(strokes.size()),
        parents_(strokes.size(), {kNone, kNone}),
        children_(strokes.size()),
        done_(strokes.size()) {
    for (std::uint32_t i = 0; i < strokes_.size(); ++i) look_around(i);
  }

  void run() {
    std::vector<std::vector<std::uint32_t>> groups = in_groups();
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
      for (const std::uint32_t i : groups[g]) strokes_[i].group = g;
      lay_out(groups[g]);
    }
    std::vector<Stroke> sorted;
    sorted.reserve(strokes_.size());
    for (const std::uint32_t i : order_) {
      sorted.push_back(std::move(strokes_[i]));
    }
    strokes_ = std::move(sorted);
  }

 private:
  /// Which other stroke is near an end, the nearest.
  std::uint32_t beside(std::uint32_t self, Point end, std::int32_t reach) {
    std::uint32_t best = kNone;
    std::int32_t least = INT32_MAX;
    for (std::int32_t dy = -reach; dy <= reach; ++dy) {
      for (std::int32_t dx = -reach; dx <= reach; ++dx) {
        const std::int32_t far = dx * dx + dy * dy;
        if (far >= least || far > reach * reach + 1) continue;
        const std::uint32_t other = owners_.at({end.x + dx, end.y + dy});
        if (other == kNone || other == self) continue;
        best = other;
        least = far;
      }
    }
    return best;
  }

  void look_around(std::uint32_t i) {
    const Stroke& stroke = strokes_[i];
    for_each_point(stroke.chain, [&](Point at) {
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          const std::uint32_t other = owners_.at({at.x + dx, at.y + dy});
          if (other != kNone && other != i) groups_.join(i, other);
        }
      }
    });
    if (stroke.chain.closed) return;
    const std::array<std::pair<Point, std::int32_t>, 2> ends{
        std::pair{stroke.chain.origin, stroke.pieces.front().width},
        std::pair{chain_end(stroke.chain, YAxis::down),
                  stroke.pieces.back().width}};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::int32_t reach = std::max(kNear, ends[k].second / 4);
      const std::uint32_t other = beside(i, ends[k].first, std::min(reach, 12));
      if (other == kNone) continue;
      groups_.join(i, other);
      parents_[i][k] = other;
      children_[other].push_back(i);
    }
  }

  /// Groups in the order of reading, large ones last.
  std::vector<std::vector<std::uint32_t>> in_groups() {
    std::vector<std::vector<std::uint32_t>> members(strokes_.size());
    std::vector<Extent> extents(strokes_.size());
    for (std::uint32_t i = 0; i < strokes_.size(); ++i) {
      const std::uint32_t root = groups_.root(i);
      members[root].push_back(i);
      for_each_point(strokes_[i].chain,
                     [&](Point at) { extents[root].add(at); });
    }
    std::vector<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < strokes_.size(); ++i) {
      if (!members[i].empty()) roots.push_back(i);
    }
    const auto large = [&](std::uint32_t i) {
      return extents[i].side() > kLetter;
    };
    std::ranges::sort(roots, [&](std::uint32_t a, std::uint32_t b) {
      const auto value = [&](std::uint32_t i) {
        return std::tuple(large(i), extents[i].top, extents[i].left, i);
      };
      return value(a) < value(b);
    });
    std::vector<std::vector<std::uint32_t>> groups;
    std::vector<bool> used(strokes_.size());
    for (std::size_t k = 0; k < roots.size(); ++k) {
      if (used[roots[k]]) continue;
      std::vector<std::uint32_t> line{roots[k]};
      std::int32_t bottom = extents[roots[k]].bottom;
      const std::int32_t top = extents[roots[k]].top;
      for (std::size_t j = k + 1; !large(roots[k]) && j < roots.size(); ++j) {
        const Extent& e = extents[roots[j]];
        if (large(roots[j]) || e.top > bottom) break;
        const std::int32_t middle = (e.top + e.bottom) / 2;
        if (used[roots[j]] || middle < top - 2 || middle > bottom + 2) continue;
        line.push_back(roots[j]);
        bottom = std::max(bottom, std::min(e.bottom, top + 48));
      }
      std::ranges::sort(line, [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(extents[a].left, a) < std::tuple(extents[b].left, b);
      });
      for (const std::uint32_t root : in_strings(line, extents)) {
        used[root] = true;
        groups.push_back(std::move(members[root]));
      }
    }
    return groups;
  }

  /// A line from left to right: those that follow each other at the same
  /// height stand together.
  static std::vector<std::uint32_t> in_strings(
      const std::vector<std::uint32_t>& line,
      const std::vector<Extent>& extents) {
    std::vector<std::vector<std::uint32_t>> strings;
    for (const std::uint32_t root : line) {
      const auto known =
          std::find_if(strings.rbegin(),
                       strings.rbegin() + std::min<std::ptrdiff_t>(
                                              kStrings, std::ssize(strings)),
                       [&](const std::vector<std::uint32_t>& string) {
                         return follows(extents[root], extents[string.back()]);
                       });
      if (known == strings.rbegin() + std::min<std::ptrdiff_t>(
                                          kStrings, std::ssize(strings))) {
        strings.push_back({root});
      } else {
        known->push_back(root);
      }
    }
    std::vector<std::uint32_t> sorted;
    for (const std::vector<std::uint32_t>& string : strings) {
      sorted.insert(sorted.end(), string.begin(), string.end());
    }
    return sorted;
  }

  static bool follows(const Extent& e, const Extent& before) {
    const std::int32_t gap = e.left - before.right;
    const std::int32_t overlap =
        std::min(e.bottom, before.bottom) - std::max(e.top, before.top);
    const std::int32_t height =
        std::min(e.bottom - e.top, before.bottom - before.top);
    return gap > -kOverlap && gap <= kGap && 2 * overlap >= height &&
           e.side() <= kCharacter;
  }

  /// Strokes that begin nowhere first, each followed by those on it.
  void lay_out(std::vector<std::uint32_t> group) {
    std::ranges::sort(group, [&](std::uint32_t a, std::uint32_t b) {
      const auto value = [&](std::uint32_t i) {
        const Point p = top_of(strokes_[i]);
        const auto ends = (parents_[i][0] != kNone ? 1 : 0) +
                          (parents_[i][1] != kNone ? 1 : 0);
        return std::tuple(ends, p.y, p.x, i);
      };
      return value(a) < value(b);
    });
    for (const std::uint32_t i : group) visit(i);
  }

  static Point top_of(const Stroke& stroke) {
    const Point a = stroke.chain.origin;
    if (stroke.chain.closed) return a;
    const Point b = chain_end(stroke.chain, YAxis::down);
    return std::tie(b.y, b.x) < std::tie(a.y, a.x) ? b : a;
  }

  void visit(std::uint32_t root) {
    std::vector<std::uint32_t> open{root};
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      if (done_[i]) continue;
      done_[i] = true;
      order_.push_back(i);
      begin_well(i);
      // The last pushed comes first.
      auto children = children_[i];
      std::erase_if(children, [&](std::uint32_t c) { return done_[c]; });
      const Point from = strokes_[i].chain.origin;
      std::ranges::sort(children, [&](std::uint32_t a, std::uint32_t b) {
        const auto value = [&](std::uint32_t c) {
          const std::size_t k = parents_[c][0] == i ? 0 : 1;
          const Point p = k == 0 ? strokes_[c].chain.origin
                                 : chain_end(strokes_[c].chain, YAxis::down);
          return std::tuple(
              std::max(std::abs(p.x - from.x), std::abs(p.y - from.y)), p.y,
              p.x, c);
        };
        return value(a) < value(b);
      });
      open.insert(open.end(), children.begin(), children.end());
    }
  }

  /// Turns a stroke so that it begins on one that is drawn, or at its top.
  void begin_well(std::uint32_t i) {
    Stroke& stroke = strokes_[i];
    if (stroke.chain.closed) return;
    const auto drawn = [&](std::size_t k) {
      return parents_[i][k] != kNone && done_[parents_[i][k]] &&
             parents_[i][k] != i;
    };
    const Point end = chain_end(stroke.chain, YAxis::down);
    const Point begin = stroke.chain.origin;
    const bool top = std::tie(end.y, end.x) < std::tie(begin.y, begin.x);
    if (drawn(0) != drawn(1) ? drawn(1) : top) {
      turn(stroke, end);
      std::swap(parents_[i][0], parents_[i][1]);
    }
  }

  std::vector<Stroke>& strokes_;
  Owners owners_;
  Groups groups_;
  /// On which strokes the ends lie.
  std::vector<std::array<std::uint32_t, 2>> parents_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<bool> done_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

void order_strokes(std::vector<Stroke>& strokes) { Orderer(strokes).run(); }

}  // namespace unstep::strokes
