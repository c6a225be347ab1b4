#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "unstep/grid.h"

namespace unstep::steps {

/// Where the centre of an arc may be that begins at (0, 0) and draws given
/// steps. F = |p - c|^2 - |c|^2 is linear in c, and the sign of F at a place
/// between two steps says which of them is taken: each step leaves a half
/// plane of centres, all of them a convex polygon.
///
/// Steps whose choice depends on more (near diagonals and axes) are passed
/// over, so the region may hold centres that do not draw all steps; a centre
/// that does is in it, but for forced steps where the circle crosses an axis.
class CentreRegion {
 public:
  /// Centres up to 2^20 steps away. `clockwise`: y up.
  explicit CentreRegion(bool clockwise) : clockwise_(clockwise) {}

  /// Takes steps in until no centre is left, at most `steps.size()`, and
  /// returns how many. `points[i]` is where the pen is before step i.
  /// `combined`: diagonal steps are made where they are nearer.
  std::size_t take(std::span<const Step> steps, std::span<const Point> points,
                   bool combined);

  /// Whole-numbered centres for as many steps as there are any, at most
  /// kMost, those in the middle of the region first; next time those of a
  /// larger region, for fewer steps.
  [[nodiscard]] std::vector<Point> next_centres();

  static constexpr std::size_t kMost = 24;

 private:
  struct Corner {
    double x = 0;
    double y = 0;
  };
  using Region = std::vector<Corner>;
  struct Limit {
    double x2 = 0;  ///< twice the place where F is asked
    double y2 = 0;
    bool outside = false;
  };

  /// In which octant an arc makes a diagonal step: the steps beside it go
  /// along its first part or along its second.
  enum class Turn { unknown, flat, steep };
  [[nodiscard]] Turn turn_at(Corner at, Point a, Point b) const;

  /// False if nothing is left.
  bool cut(const Limit& limit);
  [[nodiscard]] static std::vector<Point> whole_points(const Region& region,
                                                       std::size_t most);

  bool clockwise_;
  /// One after each step that made it smaller.
  std::vector<Region> regions_;
};

}  // namespace unstep::steps
