#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace unstep::codec {

/// The slopes dx / dy of the straight lines that an edge may be a part of.
struct SlopeRange {
  int low = -1000, low_of = 1;
  int high = 1000, high_of = 1;

  /// The line is at column `dx` or beyond, half a column less, `dy` rows on.
  void from(int dx, int dy);
  /// The line is at most half a column beyond `dx` there.
  void up_to(int dx, int dy);
  [[nodiscard]] bool holds(int dx, int dy) const;
  /// The weight of all lines of these slopes that end `dy` rows on or later.
  [[nodiscard]] std::uint64_t weight(int dy) const;
};

/// Remembers what ranges weigh: those of the first rows of an edge come again
/// and again.
class SlopeWeights {
 public:
  SlopeWeights() : known_(std::size_t{1} << kBits) {}

  /// range.weight(dy). REQUIRES: 1 <= dy < 2^8, bounds of the range as from()
  /// and up_to() make them for such dy and |dx| <= 4001.
  std::uint64_t of(const SlopeRange& range, int dy);

 private:
  static constexpr int kBits = 12;
  struct Known {
    std::uint64_t key = 0;
    std::uint64_t weight = 0;
  };
  std::vector<Known> known_;
};

/// Foretells contours of filled polygons. Their vertices are pixels; in each
/// row an edge is where the line from one vertex to the next crosses the middle
/// of the row. Every pixel at which an edge was met may be a vertex: the
/// forecast weighs for each the lines that go through all rows since, and says
/// how many of them would bend the contour here.
///
/// Follows a walk along cracks as encoder and decoder see it; integers only.
class EdgeForecast {
 public:
  /// A walk starts with a step to the east, ink on the right or not.
  void begin(bool ink);
  /// The walk took a step: 0 east, 1 south, 2 west, 3 north.
  void step(int direction);

  /// Looks ahead from where the walk is.
  void look();
  /// Of 65536, 60..65476: the walk bends, and if so to the right.
  [[nodiscard]] int bends() const { return bends_; }
  [[nodiscard]] int right() const { return right_; }
  /// 0..200: rows since the likeliest vertex.
  [[nodiscard]] int age() const { return age_; }
  /// 0..255: how likely the last pixel is one.
  [[nodiscard]] unsigned vertex() const { return vertex_; }
  /// Where the walk is, seen from the likeliest vertex.
  [[nodiscard]] std::uint64_t place() const { return place_; }

 private:
  static constexpr int kOldest = 200;             ///< rows
  static constexpr std::size_t kMostAnchors = 8;  ///< bounds the work

  /// A pixel that may be the vertex where the edge began.
  struct Anchor {
    int x = 0;
    int row = 0;
    std::uint64_t chance = 0;
    std::uint64_t weight = 0;  ///< chance times that of the lines from here
    SlopeRange slopes;
  };
  /// The chances of what comes next.
  struct Ahead {
    std::uint64_t here = 0;  ///< the next row's edge is in this column
    std::uint64_t east = 0;  ///< or farther to the east
    std::uint64_t west = 0;  ///< or to the west
  };

  void begin_edge();
  void reach_row();
  void forget_one();
  void scale(std::uint64_t all);
  void add(Ahead& ahead, const Anchor& anchor, int x);
  [[nodiscard]] bool beside() const { return moved_ > 0; }
  /// The ink pixel beside the edge if it goes on in this column.
  [[nodiscard]] int pixel(int direction) const {
    return column_ - (ink_ == (direction == 1) ? 1 : 0);
  }

  SlopeWeights weights_;
  std::vector<Anchor> anchors_;
  bool ink_ = false;
  int direction_ = 0;         ///< of the last step
  int down_ = 0;              ///< 1 or 3: the way of the edge; 0: none yet
  int column_ = 0;            ///< of the walk
  int moved_ = 0;             ///< steps along the row
  int row_ = 0;               ///< of the edge
  int x_ = 0;                 ///< its pixel there
  std::uint64_t chance_ = 0;  ///< of a vertex there

  int bends_ = 0, right_ = 0, age_ = 0;
  unsigned vertex_ = 0;
  std::uint64_t place_ = 0;
};

}  // namespace unstep::codec
