#pragma once

#include <cstdint>

#include "interpolate/ticks.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// An arc as quadrant pieces, the frame of D1 and D2.
namespace unstep::interpolation {

/// An arc in the coordinates of its centre, checked.
struct ArcGeometry {
  std::int64_t start_x = 0;  ///< of the start, relative to the centre
  std::int64_t start_y = 0;
  std::int64_t end_x = 0;
  std::int64_t end_y = 0;
  std::int64_t radius_squared = 0;  ///< of the start, exact
  bool clockwise = true;
  bool full = false;
};

/// out_of_range for the centre, invalid_argument if the end is further than
/// one unit of radius from the circle.
///
/// Range: |centre| <= 2^30 per axis, so R^2 < 2^61 and R < 2^30.5; the end is
/// within R + 1 of the centre once checked.
Result<ArcGeometry> check_arc(const Arc& arc);

/// round(sqrt(value)). REQUIRES: 0 <= value < 2^61.
[[nodiscard]] std::int64_t rounded_root(std::int64_t value);

/// Where a walk begins and ends, in the frames of its first and last piece.
struct ArcFrame {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t axis_radius = 0;  ///< round(R), where axes are crossed
  std::int64_t end_a = 0;
  std::int64_t end_b = 0;
  int crossings = 0;  ///< axes to cross
  int turns = 0;      ///< quarter turns from plane to frame
  bool mirrored = false;
};

/// Walks the pieces of an arc, one per quadrant. Each is turned (and, for
/// counter-clockwise arcs, mirrored) into the first quadrant with a growing
/// and b shrinking, from the axis b to the axis a. F = a^2 + b^2 - R^2.
///
/// An axis is crossed at the grid point nearest to the circle. A piece ends
/// where neither a nor b may go further; an end off the circle is reached by
/// the moves that then remain.
///
/// Range: a, b <= R + 1 < 2^31 and a walk keeps within H <= 2^20 units of the
/// circle, so |F| < 2 * 2^31 * 2^20 + 2^40 < 2^53.
class ArcWalk {
 public:
  explicit ArcWalk(const ArcGeometry& arc);

  /// REQUIRES: advance() was not called yet.
  [[nodiscard]] ArcFrame frame() const {
    return {a_,     b_,         axis_radius_, end_a_,
            end_b_, crossings_, turns_ % 4,   mirrored_};
  }

  [[nodiscard]] std::int64_t a() const { return a_; }
  [[nodiscard]] std::int64_t b() const { return b_; }
  [[nodiscard]] std::int64_t f() const { return f_; }

  /// Moves left in this piece along a (growing) and b (shrinking).
  [[nodiscard]] std::int64_t left_a() const { return target_a_ - a_; }
  [[nodiscard]] std::int64_t left_b() const { return b_ - target_b_; }

  /// Goes on to the next piece when this one is walked. False: all pieces are
  /// walked, only correction() may remain.
  bool advance();

  /// a += da, b -= db, 0 <= da <= left_a(), 0 <= db <= left_b(). The move on
  /// the plane.
  Point move(std::int64_t da, std::int64_t db);

  /// Puts the walk where moves within this piece have led, with their F.
  void go_to(std::int64_t a, std::int64_t b, std::int64_t f) {
    a_ = a;
    b_ = b;
    f_ = f;
  }

  /// Quarter turns from the plane to this piece.
  [[nodiscard]] int turns() const { return turns_; }

  /// A move of this piece's frame on the plane.
  [[nodiscard]] Point to_plane(std::int64_t da, std::int64_t db) const;

  /// The next diagonal or straight unit move to an end off the circle; (0, 0)
  /// when the end is reached.
  Point correct();

 private:
  void set_target();

  std::int64_t a_ = 0;
  std::int64_t b_ = 0;
  std::int64_t f_ = 0;
  std::int64_t target_a_ = 0;
  std::int64_t target_b_ = 0;
  std::int64_t end_a_ = 0;  ///< in the frame of the last piece
  std::int64_t end_b_ = 0;
  std::int64_t axis_radius_ = 0;  ///< round(R), where axes are crossed
  int crossings_ = 0;             ///< axes still to cross
  int turns_ = 0;                 ///< quarter turns from plane to frame
  bool mirrored_ = false;
  bool walked_ = false;  ///< all pieces; a correction does not reopen them
};

}  // namespace unstep::interpolation
