#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// Line `line` of path `path`, from its vertex of that index to the next.
struct LineId {
  std::uint32_t path = 0;
  std::uint32_t line = 0;
  friend bool operator==(const LineId&, const LineId&) = default;
};

struct LineEnds {
  Point a;
  Point b;
};

/// How the lines of some paths meet. `closed[i]`: path i is a ring.
///
/// Range: coordinates are within kMaxCoord, so an orientation, the difference
/// of two products of differences, is below 2^63.
class LineMeeting {
 public:
  LineMeeting(std::span<const LineVertices> paths,
              const std::vector<bool>& closed)
      : paths_(paths), closed_(closed) {}

  [[nodiscard]] LineEnds ends(LineId id) const {
    return {paths_[id.path][id.line].at, paths_[id.path][id.line + 1].at};
  }
  [[nodiscard]] std::uint32_t lines(std::uint32_t path) const {
    return static_cast<std::uint32_t>(paths_[path].size() - 1);
  }

  /// True if they follow one another in a path, or are the same.
  [[nodiscard]] bool consecutive(LineId a, LineId b) const {
    if (a.path != b.path) return false;
    const std::uint32_t apart =
        a.line > b.line ? a.line - b.line : b.line - a.line;
    return apart <= 1 || (closed_[a.path] && apart + 1 == lines(a.path));
  }

  /// True if they cross, at a vertex or between, or lie on each other for a
  /// length.
  [[nodiscard]] bool cross(LineId first, LineId second) const;

 private:
  /// The vertex before a line's start or after its end; none at an open end.
  [[nodiscard]] std::optional<Point> beyond(LineId id, bool after) const {
    const LineVertices& path = paths_[id.path];
    if (after) {
      if (id.line + 2 < path.size()) return path[id.line + 2].at;
      if (closed_[id.path]) return path[1].at;
    } else {
      if (id.line > 0) return path[id.line - 1].at;
      if (closed_[id.path]) return path[path.size() - 2].at;
    }
    return std::nullopt;
  }

  struct Passage {
    Point in;
    Point out;
  };
  /// How a path passes through a point of one of its lines.
  [[nodiscard]] std::optional<Passage> passage(LineId id, Point at) const {
    const auto [a, b] = ends(id);
    if (at == a) {
      const std::optional<Point> before = beyond(id, false);
      if (!before) return std::nullopt;
      return Passage{*before, b};
    }
    if (at == b) {
      const std::optional<Point> after = beyond(id, true);
      if (!after) return std::nullopt;
      return Passage{a, *after};
    }
    return Passage{a, b};
  }

  [[nodiscard]] bool cross_at(LineId p, LineId q, Point at) const;

  std::span<const LineVertices> paths_;
  const std::vector<bool>& closed_;
};

/// True if two curves that meet at `at` change sides there, when the first
/// comes from `a_in` and goes on to `a_out`, the second likewise. False if
/// they leave in a common direction.
bool change_sides(Point at, Point a_in, Point a_out, Point b_in, Point b_out);

}  // namespace unstep::reverse
