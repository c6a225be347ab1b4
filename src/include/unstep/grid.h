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

/// A circular arc of a path, from the current point. `centre` and `end` are
/// relative to the current point; end == (0,0) is a full circle.
struct Arc {
  Point centre;
  Point end;
  bool clockwise = true;
  friend bool operator==(const Arc&, const Arc&) = default;
};

/// An origin and segments or arcs, joined end to start.
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

/// A canvas and what is drawn on it, in drawing order: chains (unit steps) and
/// paths (lines and arcs).
struct Drawing {
  Canvas canvas;
  std::vector<Chain> chains;
  std::vector<Path> paths;
  friend bool operator==(const Drawing&, const Drawing&) = default;
};

}  // namespace unstep
