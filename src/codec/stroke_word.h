#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "codec/vector_classes.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// Quotient rounded down. REQUIRES: b > 0.
[[nodiscard]] constexpr std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// Paths that follow each other, which come again as a whole: a letter, a
/// symbol.
struct StrokeWord {
  std::uint64_t first = 0;  ///< of the paths where they came for the first time
  std::uint64_t count = 0;
};

/// What an element leads to.
[[nodiscard]] inline Vec move_of(const Path::Element& element) {
  return element.kind == Path::Kind::arc
             ? Vec{element.arc.end.x, element.arc.end.y}
             : Vec{element.segment.dx, element.segment.dy};
}

/// A box of vertices, of all that was added.
struct VertexBox {
  std::int64_t left = INT64_MAX;
  std::int64_t top = INT64_MAX;
  std::int64_t right = INT64_MIN;
  std::int64_t bottom = INT64_MIN;

  void add(std::int64_t x, std::int64_t y) {
    left = std::min(left, x);
    top = std::min(top, y);
    right = std::max(right, x);
    bottom = std::max(bottom, y);
  }
  void add(const Path& path) {
    std::int64_t x = path.origin.x;
    std::int64_t y = path.origin.y;
    add(x, y);
    for (const Path::Element& element : path.elements) {
      const Vec move = move_of(element);
      x += move.x;
      y += move.y;
      add(x, y);
    }
  }
};

[[nodiscard]] inline VertexBox box_of(std::span<const Path> paths) {
  VertexBox box;
  for (const Path& path : paths) box.add(path);
  return box;
}

/// The point of a path's origin, a multiple of the unit, and what is left of
/// it.
struct UnitPoint {
  Point at;    ///< in units
  Point rest;  ///< 0..unit - 1
};
[[nodiscard]] inline UnitPoint in_units(Point p, std::int32_t unit) {
  const auto x = static_cast<std::int32_t>(floor_div(p.x, unit));
  const auto y = static_cast<std::int32_t>(floor_div(p.y, unit));
  return {{x, y}, {p.x - x * unit, p.y - y * unit}};
}

/// An element with all its numbers divided or multiplied.
template <class Change>
[[nodiscard]] Path::Element changed(const Path::Element& e, Change change) {
  if (e.kind == Path::Kind::segment) {
    return {e.kind, {change(e.segment.dx), change(e.segment.dy)}, {}};
  }
  const auto point = [&](const Point& p) {
    return Point{change(p.x), change(p.y)};
  };
  return {e.kind, {}, {point(e.arc.centre), point(e.arc.end), e.arc.clockwise}};
}

}  // namespace unstep::codec
