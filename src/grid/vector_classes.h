#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>

#include "unstep/grid.h"

/// Vectors of paths as their models see them: quarters, classes of direction
/// and of length. All in integers; components are below 2^31.
namespace unstep::vectors {

struct Vec {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Vec&, const Vec&) = default;
  [[nodiscard]] constexpr bool zero() const { return x == 0 && y == 0; }
};

/// The vector from one point to another.
[[nodiscard]] inline Vec between(const Point& from, const Point& to) {
  return {std::int64_t{to.x} - from.x, std::int64_t{to.y} - from.y};
}

/// The larger of |x| and |y|.
[[nodiscard]] inline std::int64_t size_of(const Vec& v) {
  return std::max(std::abs(v.x), std::abs(v.y));
}

/// 0..3: which quarter turn of the quadrant x > 0, y >= 0 the vector is in.
/// REQUIRES: not zero.
[[nodiscard]] constexpr int quarter_of(const Vec& v) {
  if (v.x > 0 && v.y >= 0) return 0;
  if (v.y > 0) return 1;
  return v.x < 0 && v.y <= 0 ? 2 : 3;
}

/// The vector turned back (towards -y) by quarters.
[[nodiscard]] constexpr Vec turned_back(Vec v, int quarters) {
  for (; quarters > 0; --quarters) v = {v.y, -v.x};
  return v;
}

/// Classes of direction: in each quarter the axis itself, three of slopes
/// below 1/3, 2/3, 1 and three more to the next axis.
inline constexpr int kDirections = 28;
inline constexpr int kNoDirection = 28;

/// The class within the quarter, 0..6, of a vector that was turned back.
[[nodiscard]] constexpr int slope_class(const Vec& v) {
  if (v.y == 0) return 0;
  if (v.y <= v.x) return 3 * v.y <= v.x ? 1 : 3 * v.y <= 2 * v.x ? 2 : 3;
  return 3 * v.x > 2 * v.y ? 4 : 3 * v.x > v.y ? 5 : 6;
}

/// 0..27, kNoDirection for zero.
[[nodiscard]] constexpr int direction_of(const Vec& v) {
  if (v.zero()) return kNoDirection;
  const int quarter = quarter_of(v);
  return 7 * quarter + slope_class(turned_back(v, quarter));
}

/// A finer angle, 0..191, 48 a quarter; eight to a class. REQUIRES: not zero.
[[nodiscard]] constexpr int fine_angle(const Vec& v) {
  const int quarter = quarter_of(v);
  const Vec r = turned_back(v, quarter);
  return 48 * quarter +
         static_cast<int>(r.y <= r.x ? r.y * 24 / r.x : 48 - r.x * 24 / r.y);
}

/// Two classes to each doubling: 0 for 0, 1 for 1, 2 for 2, 3 for 3, ..
[[nodiscard]] constexpr int length_class(std::int64_t length) {
  if (length <= 0) return 0;
  const auto width =
      static_cast<int>(std::bit_width(static_cast<std::uint64_t>(length)));
  return width < 2
             ? 1
             : 2 * width - 2 + static_cast<int>(length >> (width - 2) & 1);
}

/// What the smaller component may be.
struct MinorRange {
  std::int64_t low = 0;
  std::int64_t high = 0;  ///< below `low` if there is none
};

/// Of vectors of slope class 0..6 and this length: classes 1..6 hold a third
/// of them each.
[[nodiscard]] constexpr MinorRange minor_range(int slope, std::int64_t length) {
  if (slope == 0) return {0, 0};
  const int third = slope <= 3 ? slope : 7 - slope;
  const std::int64_t low = length * (third - 1) / 3 + 1;
  std::int64_t high = third == 3 ? length : length * third / 3;
  // Equal components belong to the lower half of the quarter; the bounds of
  // the upper half are open where those of the lower one are closed.
  if (slope == 4) --high;
  return {low, high};
}

/// The same direction with components below 2^bits, at least nearly.
[[nodiscard]] inline Vec shortened(Vec v, int bits) {
  while (size_of(v) >> bits != 0) v = {v.x / 2, v.y / 2};
  return v;
}

}  // namespace unstep::vectors
