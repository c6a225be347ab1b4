#pragma once

#include <cmath>

#include "unstep/grid.h"

/// Places and directions between pixels, for decisions that need no exactness.
/// Only + - * / and sqrt, which IEEE 754 rounds the same everywhere.
namespace unstep::trace {

struct Vector2 {
  double x = 0;
  double y = 0;
};

[[nodiscard]] inline Vector2 to_vector(Point p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}
[[nodiscard]] inline Vector2 operator+(Vector2 a, Vector2 b) {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline Vector2 operator-(Vector2 a, Vector2 b) {
  return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline Vector2 operator*(double s, Vector2 v) {
  return {s * v.x, s * v.y};
}
[[nodiscard]] inline double dot(Vector2 a, Vector2 b) {
  return a.x * b.x + a.y * b.y;
}
[[nodiscard]] inline double cross(Vector2 a, Vector2 b) {
  return a.x * b.y - a.y * b.x;
}
[[nodiscard]] inline double length(Vector2 v) { return std::sqrt(dot(v, v)); }

/// (0, 0) stays what it is.
[[nodiscard]] inline Vector2 unit(Vector2 v) {
  const double l = length(v);
  return l > 0 ? (1 / l) * v : v;
}

/// The pixel whose middle is nearest. REQUIRES: within the coordinate range.
[[nodiscard]] inline Point nearest(Vector2 v) {
  return {static_cast<std::int32_t>(std::floor(v.x + 0.5)),
          static_cast<std::int32_t>(std::floor(v.y + 0.5))};
}

}  // namespace unstep::trace
