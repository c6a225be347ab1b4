#pragma once

#include "grid/wide_product.h"
#include "unstep/grid.h"

/// The circle of an Arc in whole numbers. P, Q are points relative to the
/// start of the arc, C the true centre (see Arc), R its radius.
///
/// With E = |end|^2, n = (-end.y, end.x) and m = centre . n the centre is
/// (E end + 2 m n) / 2 E and 4 R^2 = (E^2 + 4 m^2) / E: all below follows from
/// a = E, b = E end + 2 m n and k = E^2 + 4 m^2, integers; for a full circle
/// from a = 1, b = 2 centre and k = |b|^2.
///
/// Range: the parts of centre and end are below 2^27 (arc_fits) and those of
/// points below 2^30. Then a < 2^55, |m| < 2^55, k < 2^113, |b| < 2^84, and
/// every sum below is less than 2^120.
namespace unstep {

struct Vector64 {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend constexpr bool operator==(const Vector64&, const Vector64&) = default;
  friend constexpr Vector64 operator+(Vector64 a, Vector64 b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend constexpr Vector64 operator-(Vector64 a, Vector64 b) {
    return {a.x - b.x, a.y - b.y};
  }
};

[[nodiscard]] constexpr Int128 dot(Vector64 a, Vector64 b) {
  return Int128{a.x} * b.x + Int128{a.y} * b.y;
}
[[nodiscard]] constexpr Int128 cross(Vector64 a, Vector64 b) {
  return Int128{a.x} * b.y - Int128{a.y} * b.x;
}

inline constexpr std::int64_t kMaxCirclePart = std::int64_t{1} << 27;

/// The numbers of the arc are within the range above and it has a radius.
[[nodiscard]] constexpr bool arc_fits(const Arc& arc) {
  const auto fits = [](Point p) {
    return p.x > -kMaxCirclePart && p.x < kMaxCirclePart &&
           p.y > -kMaxCirclePart && p.y < kMaxCirclePart;
  };
  return fits(arc.centre) && fits(arc.end) &&
         !(arc.end == Point{} && arc.centre == Point{});
}

class ArcCircle {
 public:
  /// REQUIRES: arc_fits(arc).
  explicit constexpr ArcCircle(const Arc& arc)
      : full_(arc.end == Point{}), sign_(arc.clockwise ? -1 : 1) {
    const Vector64 centre{arc.centre.x, arc.centre.y};
    const Vector64 end{arc.end.x, arc.end.y};
    if (full_) {
      bx_ = 2 * centre.x;
      by_ = 2 * centre.y;
      k_ = static_cast<UInt128>(4 * dot(centre, centre));
      return;
    }
    const Int128 e = dot(end, end);
    const Int128 m = cross(end, centre);
    a_ = e;
    bx_ = e * end.x - 2 * m * end.y;
    by_ = e * end.y + 2 * m * end.x;
    k_ = static_cast<UInt128>(e * e + 4 * m * m);
  }

  [[nodiscard]] constexpr bool full() const { return full_; }
  [[nodiscard]] constexpr Int128 a() const { return a_; }
  [[nodiscard]] constexpr UInt128 k() const { return k_; }

  /// a (|P - C|^2 - R^2).
  [[nodiscard]] constexpr Int128 power(Vector64 p) const {
    return a_ * dot(p, p) - bx_ * p.x - by_ * p.y;
  }

  /// power(P + move) - power(P).
  [[nodiscard]] constexpr Int128 power_change(Vector64 p, Vector64 move) const {
    return a_ * (2 * dot(p, move) + dot(move, move)) - bx_ * move.x -
           by_ * move.y;
  }

  /// 2 a (P - C) x (Q - C), positive if Q is ahead in the sense of the arc, by
  /// less than half a turn.
  [[nodiscard]] constexpr Int128 ahead(Vector64 p, Vector64 q) const {
    const Vector64 move = q - p;
    const Int128 left = 2 * a_ * cross(p, q) - (bx_ * move.y - by_ * move.x);
    return sign_ * left;
  }

  /// 4 a (P - C) . (Q - C).
  [[nodiscard]] constexpr Int128 inner(Vector64 p, Vector64 q) const {
    return 4 * a_ * dot(p, q) - 2 * (bx_ * (p.x + q.x) + by_ * (p.y + q.y)) +
           static_cast<Int128>(k_);
  }

 private:
  bool full_;
  int sign_;
  Int128 a_ = 1;
  Int128 bx_ = 0;
  Int128 by_ = 0;
  UInt128 k_ = 0;
};

}  // namespace unstep
