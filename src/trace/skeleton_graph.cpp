#include "trace/skeleton_graph.h"

#include <bit>
#include <cmath>
#include <utility>

#include "grid/row_distances.h"
#include "trace/neighbourhood.h"
#include "trace/pixel_index.h"

namespace unstep::trace {
namespace {

template <class Use>
void for_each_pixel(const Bitmap& ink, Use use) {
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    const auto words = ink.row(y);
    for (std::size_t w = 0; w < words.size(); ++w) {
      for (std::uint64_t left = words[w]; left != 0;) {
        const int bit = std::countl_zero(left);
        left &= ~(std::uint64_t{1} << (63 - bit));
        use(Point{static_cast<std::int32_t>(w * 64) + bit, y});
      }
    }
  }
}

class GraphBuilder {
 public:
  GraphBuilder(const Bitmap& ink, const Bitmap& skeleton)
      : skeleton_(skeleton),
        index_(skeleton),
        squares_(index_.size()),
        junction_(index_.size(), kFree) {
    RowDistances distances(ink, RowDistances::To::paper);
    std::int32_t row = -1;
    std::span<const std::int64_t> squares;
    for_each_pixel(skeleton, [&](Point at) {
      if (at.y != row) squares = distances.row(row = at.y);
      squares_[index_.of(at)] = squares[static_cast<std::size_t>(at.x)];
    });
  }

  SkeletonGraph run() {
    for_each_pixel(skeleton_, [&](Point at) {
      if (junction_[index_.of(at)] == kFree && neighbours(at) > 2) gather(at);
    });
    for (std::size_t j = 0; j < graph_.junctions.size(); ++j) leave(j);
    // What is left has no junction: lines, from an end, then rings.
    for_each_pixel(skeleton_, [&](Point at) {
      if (junction_[index_.of(at)] == kFree && neighbours(at) < 2) {
        add_branch(walk(at, Branch::kNone));
      }
    });
    for_each_pixel(skeleton_, [&](Point at) {
      if (junction_[index_.of(at)] != kFree) return;
      Branch ring = walk(at, Branch::kNone);
      ring.closed = true;
      add_branch(std::move(ring));
    });
    return std::move(graph_);
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t{0};
  static constexpr std::uint32_t kOnBranch = kFree - 1;

  [[nodiscard]] int neighbours(Point at) const {
    return std::popcount(ring_of(skeleton_, at));
  }
  [[nodiscard]] Spot spot(Point at) const {
    return {at, squares_[index_.of(at)]};
  }

  template <class Use>
  void around(Point at, Use use) const {
    // Along rows and columns first: a walk then takes no short cut.
    for (const std::size_t i : {0U, 2U, 4U, 6U, 1U, 3U, 5U, 7U}) {
      const Point p{at.x + kRing[i].x, at.y + kRing[i].y};
      if (pixel_at(skeleton_, p)) use(p);
    }
  }

  void gather(Point first) {
    const auto number = static_cast<std::uint32_t>(graph_.junctions.size());
    Junction& junction = graph_.junctions.emplace_back();
    junction_[index_.of(first)] = number;
    junction.spots.push_back(spot(first));
    for (std::size_t i = 0; i < junction.spots.size(); ++i) {
      const Point at = junction.spots[i].at;
      around(at, [&](Point p) {
        if (junction_[index_.of(p)] != kFree || neighbours(p) < 3) return;
        junction_[index_.of(p)] = number;
        junction.spots.push_back(spot(p));
      });
    }
    junction.middle = junction.spots[0];
    for (const Spot& s : junction.spots) {
      if (s.square > junction.middle.square) junction.middle = s;
    }
  }

  void leave(std::size_t j) {
    for (std::size_t i = 0; i < graph_.junctions[j].spots.size(); ++i) {
      const Point from = graph_.junctions[j].spots[i].at;
      around(from, [&](Point p) {
        if (junction_[index_.of(p)] == kFree) add_branch(walk(p, j));
      });
    }
  }

  /// From a free pixel to the end or to a junction. The first pixel may touch
  /// the junction it comes from more than once, the walk leaves it if it can.
  Branch walk(Point at, std::size_t from) {
    Branch branch;
    branch.from = from;
    for (bool more = true; more;) {
      branch.spots.push_back(spot(at));
      junction_[index_.of(at)] = kOnBranch;
      more = false;
      Point next;
      around(at, [&](Point p) {
        if (more || junction_[index_.of(p)] != kFree) return;
        next = p;
        more = true;
      });
      if (more) at = next;
    }
    branch.to = junction_after(branch);
    return branch;
  }

  /// The junction that the last spot touches; of a single spot another one
  /// than it came from, or the same if it touches two of its pixels.
  [[nodiscard]] std::size_t junction_after(const Branch& branch) const {
    const bool single = branch.spots.size() == 1;
    std::size_t found = Branch::kNone;
    int touched = 0;
    around(branch.spots.back().at, [&](Point p) {
      const std::uint32_t number = junction_[index_.of(p)];
      if (number >= kOnBranch) return;
      ++touched;
      if (found == Branch::kNone || found == branch.from) found = number;
    });
    if (single && found == branch.from && touched < 2) return Branch::kNone;
    return found;
  }

  void add_branch(Branch branch) {
    const std::size_t number = graph_.branches.size();
    for (const std::size_t end : {branch.from, branch.to}) {
      if (end != Branch::kNone) {
        graph_.junctions[end].branches.push_back(number);
      }
    }
    graph_.branches.push_back(std::move(branch));
  }

  const Bitmap& skeleton_;
  PixelIndex index_;
  std::vector<std::int64_t> squares_;    ///< by pixel
  std::vector<std::uint32_t> junction_;  ///< by pixel; or kFree, kOnBranch
  SkeletonGraph graph_;
};

}  // namespace

double radius_of(const Spot& spot) {
  return std::sqrt(static_cast<double>(spot.square)) - 0.5;
}

Result<SkeletonGraph> graph_of(const Bitmap& ink, const Bitmap& skeleton) {
  if (skeleton.ink() >= std::uint64_t{1} << 31) {
    return Error{ErrorCode::limit_exceeded,
                 "a skeleton of more than 2^31 pixels"};
  }
  return GraphBuilder(ink, skeleton).run();
}

}  // namespace unstep::trace
