#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "unstep/grid.h"
#include "unstep/result.h"

/// Paths and chains as the writers take them.
namespace unstep {

/// A place or a move in path units. A chain's coordinates times the scale are
/// below 2^30 * 2^20, so nothing here comes near the end of int64.
struct WidePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const WidePoint&, const WidePoint&) = default;
  friend WidePoint operator+(WidePoint a, WidePoint b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend WidePoint operator-(WidePoint a, WidePoint b) {
    return {a.x - b.x, a.y - b.y};
  }
};

/// A smallest box around what is drawn.
struct WideBox {
  WidePoint low;
  WidePoint high;
};

/// A segment or an arc as a move in the y direction of the format.
struct Piece {
  bool is_arc = false;
  WidePoint end;
  WidePoint centre;        ///< arcs
  bool ascending = false;  ///< arcs: angle grows from +x to +y
  [[nodiscard]] bool is_circle() const { return is_arc && end == WidePoint{}; }
};

/// A path in path units and the y direction of the format.
struct Outline {
  WidePoint origin;
  bool closed = false;
  std::int64_t width = 0;
  std::vector<Piece> pieces;
};

/// `flip`: y changes its sign, and then `height` is added to places.
struct Frame {
  bool flip = false;
  std::int64_t height = 0;
};

/// out_of_range if a point is not within kMaxCoord or the width is negative,
/// invalid_argument if a closed path does not return or an arc has no radius.
Status check_path(const Path& path);

/// out_of_range or invalid_argument, likewise.
Status check_chain(const Chain& chain, YAxis axis);

/// REQUIRES: check_path(path).
void to_outline(const Path& path, const Frame& frame, Outline& outline);

/// Runs of equal steps become one segment. REQUIRES: check_chain(chain).
void to_outline(const Chain& chain, YAxis axis, std::int32_t scale,
                const Frame& frame, Outline& outline);

/// Makes the box hold what is drawn, the pen's width aside.
void extend(WideBox& box, const Outline& outline);

/// Whether an arc turns by more than half a circle. REQUIRES: is_arc.
[[nodiscard]] bool is_large(const Piece& arc);

/// The circle through both ends whose centre, on the line that halves the
/// chord, is nearest to the stored one; full circles as stored. REQUIRES:
/// is_arc.
struct RealCircle {
  double x = 0;  ///< of the centre, relative to the start
  double y = 0;
  double radius = 0;
};
[[nodiscard]] RealCircle circle_of(const Piece& arc);

/// Calls visit(x, y) with points of an arc, relative to its start, the end
/// last: the lines between them are at most `limit` path units from the arc.
/// REQUIRES: is_arc, limit > 0.
void flatten(const Piece& arc, double limit,
             const std::function<void(double x, double y)>& visit);

/// The angle that an arc turns by, above 0, at most 2 pi. REQUIRES: is_arc.
[[nodiscard]] double sweep_of(const Piece& arc);

}  // namespace unstep
