#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// The vocabulary: points of the integer grid, unit steps, chains, segments,
/// arcs, paths and drawings. Data only; the other headers do the work.
namespace unstep {

/// Every coordinate of a drawing lies in [-kMaxCoord, kMaxCoord]. A difference
/// of two coordinates then fits int32 (< 2^31), and the sum of two products of
/// differences fits int64 (2 * 2^62 < 2^63).
inline constexpr std::int32_t kMaxCoord = (1 << 30) - 1;

/// A number of 0 or more, exactly.
struct Rational {
  std::uint32_t numerator = 0;
  std::uint32_t denominator = 1;
  friend bool operator==(const Rational&, const Rational&) = default;
};

struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// Freeman code of a unit step, 0..7, counter-clockwise from east with y up:
/// 0 = (1,0), 1 = (1,1), 2 = (0,1), ... 7 = (1,-1). 4-connected chains use the
/// even codes only.
using Step = std::uint8_t;

/// Which way y grows. Freeman codes are defined with y up; in a raster y grows
/// downwards, so code 2 (north) lowers the row number.
enum class YAxis : std::uint8_t { up, down };

/// The move of a Freeman code. REQUIRES: step <= 7.
[[nodiscard]] constexpr Point step_delta(Step step, YAxis axis = YAxis::up) {
  constexpr std::array<std::int8_t, 8> dx{1, 1, 0, -1, -1, -1, 0, 1};
  constexpr std::array<std::int8_t, 8> dy{0, 1, 1, 1, 0, -1, -1, -1};
  return {dx[step], axis == YAxis::up ? dy[step] : -dy[step]};
}

enum class Connectivity : std::uint8_t { four = 4, eight = 8 };

/// An origin and unit steps. A closed chain returns to its origin; its last
/// step leads there. INVARIANT of valid data: steps fit the connectivity and
/// every visited point is within the coordinate range.
struct Chain {
  Point origin;
  Connectivity connectivity = Connectivity::eight;
  bool closed = false;
  std::vector<Step> steps;
  friend bool operator==(const Chain&, const Chain&) = default;
};

/// A straight line of a path, as a move. Plain segment of SU 1089551.
struct Segment {
  std::int32_t dx = 0;
  std::int32_t dy = 0;
  friend bool operator==(const Segment&, const Segment&) = default;
};

/// A digital straight segment: n unit steps that one straight line draws.
/// Step i, 0 <= i < n, is s1 if floor((a (i + 1) + r) / w) exceeds
/// floor((a i + r) / w), otherwise s0. s0 and s1 are neighbours (s0 +- 1, or
/// +- 2 if 4-connected), or equal. INVARIANT: n >= 1, 0 <= a <= w, w >= 1,
/// 0 <= r < w.
struct DigitalSegment {
  Step s0 = 0;
  Step s1 = 0;
  std::uint32_t n = 0;
  std::uint32_t a = 0;
  std::uint32_t w = 1;
  std::uint32_t r = 0;
  friend bool operator==(const DigitalSegment&,
                         const DigitalSegment&) = default;
};

/// A circular arc of a path, from the current point. `centre` and `end` are
/// relative to the current point; end == (0,0) is a full circle, whose radius
/// is |centre|.
///
/// The curve of any other arc is on the circle through its start and its end
/// whose centre is the point nearest to `centre` on the line that halves the
/// chord at right angles. Whatever whole numbers `centre` has, the end is so on
/// the circle, exactly, and SVG's A, the bulge of DXF and G2/G3 by radius say
/// the same. With n = (-end.y, end.x) the true centre is
/// end / 2 + n (centre . n) / |end|^2.
///
/// `clockwise` is meant for y up, whatever the drawing's axis: the angle about
/// the centre, atan2(y, x) of the numbers, falls along the arc.
struct Arc {
  Point centre;
  Point end;
  bool clockwise = true;
  friend bool operator==(const Arc&, const Arc&) = default;
};

/// An origin and segments or arcs, joined end to start. A closed path returns
/// to its origin; its last element leads there. `width` is that of the pen in
/// path units, 0 if there is none (a filled outline, a hairline).
struct Path {
  enum class Kind : std::uint8_t { segment, arc };
  struct Element {
    Kind kind = Kind::segment;
    Segment segment;  ///< when kind == segment
    Arc arc;          ///< when kind == arc
    friend bool operator==(const Element&, const Element&) = default;
  };
  Point origin;
  bool closed = false;
  std::int32_t width = 0;
  std::vector<Element> elements;
  friend bool operator==(const Path&, const Path&) = default;
};

/// The area a drawing lives on, in grid units; 0 x 0 means unbounded.
struct Canvas {
  std::int32_t width = 0;
  std::int32_t height = 0;
  YAxis y_axis = YAxis::down;
  friend bool operator==(const Canvas&, const Canvas&) = default;
};

/// How paths become ink: all closed paths of the drawing together by even-odd
/// filling, or each path by a pen of its width.
enum class Paint : std::uint8_t { fill, stroke };

/// A canvas and what is drawn on it, in drawing order: chains (unit steps) and
/// paths (lines and arcs).
struct Drawing {
  /// Path units per grid unit are 1..kMaxScale.
  static constexpr std::int32_t kMaxScale = 1 << 20;

  Canvas canvas;
  std::vector<Chain> chains;
  std::vector<Path> paths;
  /// Coordinates of `paths`, not of canvas and chains, are in 1 / scale of a
  /// grid unit: a sub-grid of 1/2^k, or the decimals of a vector file.
  std::int32_t scale = 1;
  Paint paint = Paint::fill;  ///< of the paths
  friend bool operator==(const Drawing&, const Drawing&) = default;
};

/// How much work is worth it.
enum class Effort : std::uint8_t { fast, standard, max };

}  // namespace unstep
