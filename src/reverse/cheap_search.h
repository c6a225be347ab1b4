#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "reverse/line_price.h"
#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// The shortest path of fit_cheap_lines over parts of chains, one after
/// another.
class CheapSearch {
 public:
  explicit CheapSearch(PathTolerance tolerance);

  /// What follows is about this chain. Both must outlive it.
  void begin(const ChainWalk& chain, const LinePrice& price);

  /// No vertex is above this one, nor left of it in its row.
  void set_top(Point top) {
    top_ = top;
    has_top_ = true;
  }

  /// Lines from the last of `path`, a point of the chain, to `last`, another;
  /// the line to it costs nothing if it is `free`. Appends the lines' ends and
  /// gives back what they cost; nothing if there is no way that keeps below the
  /// top.
  std::optional<std::int64_t> append(const LineVertex& last, bool free,
                                     LineVertices& path);

 private:
  /// A vertex beside a candidate and the best way to it.
  struct Node {
    std::int32_t cost = 0;
    std::int32_t from = 0;  ///< node
    Point in;               ///< the line to it
  };
  /// A point of the chain beside which vertices may be.
  struct Candidate {
    std::size_t index = 0;
    Point at;
    bool corner = false;       ///< the chain turns there
    std::uint32_t places = 1;  ///< where vertices may be, a bit each
    std::int32_t bound = 0;    ///< nodes that cost more are given up
  };

  /// Where lines start that are tried.
  struct Source {
    std::int32_t node = 0;
    std::int32_t cost = 0;
    Point at;
    LinePrice::Context context;
  };

  void find_candidates(const LineVertex& first, std::size_t last);
  void share_places();
  [[nodiscard]] bool is_nearest(std::size_t k, Point place) const;
  void extend(std::size_t i, std::size_t place);
  void end_at(const Source& from, std::size_t k, std::size_t place,
              std::int32_t least);
  [[nodiscard]] std::size_t best_end() const;
  [[nodiscard]] Point point(std::size_t node) const;
  [[nodiscard]] bool allowed(Point at) const {
    return !has_top_ || at.y > top_.y || (at.y == top_.y && at.x >= top_.x);
  }

  Cone cone_;
  std::vector<Point> places_;  ///< of a vertex beside the chain; 0 0 is first
  std::int32_t margin_;        ///< what may be dearer than the cheapest
  std::size_t beside_;         ///< steps from a corner to a candidate
  std::int32_t reach_ = 0;     ///< the largest component of places
  const ChainWalk* chain_ = nullptr;
  const LinePrice* price_ = nullptr;
  Point top_;
  bool has_top_ = false;

  std::vector<Candidate> candidates_;
  // The window: candidates first_.., nodes of each for all places.
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  bool ends_ = false;  ///< its last candidate is the path's end
  bool free_ = false;  ///< the line to that costs nothing
  Point start_;        ///< instead of the first candidate's places
  vectors::Vec before_;
  std::vector<Node> nodes_;
};

}  // namespace unstep::reverse
