#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "unstep/codec.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// What a reader of a vector file finds, in the numbers of the file, before it
/// is put on a grid (grid_fit.h).
namespace unstep {

struct RealPoint {
  double x = 0;
  double y = 0;
  friend bool operator==(const RealPoint&, const RealPoint&) = default;
  friend RealPoint operator+(RealPoint p, RealPoint q) {
    return {p.x + q.x, p.y + q.y};
  }
  friend RealPoint operator-(RealPoint p, RealPoint q) {
    return {p.x - q.x, p.y - q.y};
  }
  friend RealPoint operator*(double factor, RealPoint p) {
    return {factor * p.x, factor * p.y};
  }
};

struct RealPiece {
  enum class Kind : std::uint8_t { line, arc, circle, cubic };
  Kind kind = Kind::line;
  bool ascending = false;  ///< arc, circle: angle grows from +x to +y
  bool computed = false;   ///< the end is no vertex that the file gives
  RealPoint end;           ///< absolute, as all points
  RealPoint a;             ///< arc, circle: centre; cubic: control point
  RealPoint b;             ///< cubic: the second control point
};

struct RealPath {
  RealPoint origin;
  bool closed = false;
  bool filled = false;
  bool computed = false;  ///< the origin is no vertex that the file gives
  double width = 0;       ///< of the pen
  std::vector<RealPiece> pieces;
};

/// Collects paths. The first error stays, and what comes after it is ignored:
/// limit_exceeded for more than the memory limit allows, out_of_range for a
/// coordinate beyond kMaxCoord.
class RealDrawing {
 public:
  explicit RealDrawing(const DecodeLimits& limits) : limits_(limits) {}

  /// Of the paths that begin from now on.
  void set_style(bool filled, double width) {
    filled_ = filled;
    width_ = width;
  }

  /// Of points from now on, where curves end that the file describes by their
  /// angles: their rounding is one of curves.
  void set_computed(bool computed) { computed_ = computed; }

  void move_to(RealPoint at);
  void line_to(RealPoint at);
  /// Two arcs that make a circle become one.
  void arc_to(RealPoint centre, RealPoint end, bool ascending);
  /// From the current point, once around.
  void circle(RealPoint centre, bool ascending);
  void cubic_to(RealPoint a, RealPoint b, RealPoint end);
  /// An elliptical arc, counted in angles of a circle that `to_x`, `to_y` (the
  /// ends of its axes from the centre) turn into the ellipse. `end` replaces
  /// the computed end. Cubics, to within 1e-7 of the longer axis.
  void ellipse_to(RealPoint centre, RealPoint to_x, RealPoint to_y,
                  double begin, double sweep, RealPoint end);
  /// Goes back to the start with a line if it is not there.
  void close();
  /// Filled paths that are open are closed. A line to where it began makes a
  /// point of a path, a path without lines is none.
  void end_path();

  [[nodiscard]] RealPoint at() const { return at_; }
  [[nodiscard]] bool in_path() const { return in_path_; }
  [[nodiscard]] const Status& status() const { return status_; }
  [[nodiscard]] std::vector<RealPath>& paths() { return paths_; }
  [[nodiscard]] const DecodeLimits& limits() const { return limits_; }
  [[nodiscard]] std::uint64_t memory() const { return memory_; }

  /// Counts memory that is used elsewhere.
  void use_memory(std::uint64_t bytes);
  void fail(Error error);

 private:
  void add(const RealPiece& piece);
  [[nodiscard]] bool check(RealPoint point);

  DecodeLimits limits_;
  Status status_;
  std::uint64_t memory_ = 0;
  std::vector<RealPath> paths_;
  RealPoint at_;
  bool in_path_ = false;
  bool filled_ = true;
  bool computed_ = false;
  double width_ = 0;
};

}  // namespace unstep
