#pragma once

#include <algorithm>
#include <cstdint>

#include "grid/arc_circle.h"
#include "grid/wide_product.h"

/// The ring of points within a distance t = numerator / denominator of an
/// arc's circle, decided exactly.
namespace unstep {

class ArcRing {
 public:
  /// The numbers are within the range of the decisions and the radius is at
  /// least t + 2 units: then a disc of radius t about a point of the ring
  /// spans less than half a turn, and an edge of the chain less than an
  /// eighth. REQUIRES: 0 <= numerator, 0 < denominator, 0 < unit, all <= 2^30.
  [[nodiscard]] static bool decides(const Arc& arc, std::int64_t numerator,
                                    std::int64_t denominator,
                                    std::int64_t unit) {
    if (!arc_fits(arc)) return false;
    const std::int64_t inner =
        (numerator + denominator - 1) / denominator + 2 * unit;
    if (inner >= kMaxCirclePart) return false;
    const ArcCircle circle(arc);
    // 4 R^2 = k / a.
    if (circle.k() < static_cast<UInt128>(4 * circle.a() * inner * inner))
      return false;
    const auto scale = static_cast<UInt128>(std::max(numerator, denominator)) *
                       static_cast<UInt128>(denominator);
    return circle.k() <= (UInt128{1} << 122) / scale;
  }

  /// REQUIRES: decides(arc, numerator, denominator, unit). Range: k
  /// denominator^2 and k denominator numerator are then below 2^122; points
  /// are within t + 2 units of the ring, so that |power| <= 3 k / 4.
  ArcRing(const Arc& arc, std::int64_t numerator, std::int64_t denominator)
      : circle_(arc), numerator_(numerator), denominator_(denominator) {
    // power / a = D^2 - R^2 with D = R +- t: t^2 +- 2 t R, and 2 a R =
    // sqrt(a k). A whole power is at most (x + sqrt(y)) / d^2 if it is at most
    // its floor, and that is the floor with floor(sqrt(y)).
    const Int128 n = numerator;
    const Int128 d = denominator;
    const auto root = static_cast<Int128>(
        floor_root(wide_product(static_cast<UInt128>(circle_.a() * n * d),
                                circle_.k() * static_cast<UInt128>(n * d))));
    const Int128 square = circle_.a() * n * n;
    highest_ = floor_quotient(square + root, d * d);
    lowest_ = -floor_quotient(root - square, d * d);
  }

  [[nodiscard]] const ArcCircle& circle() const { return circle_; }

  /// A point of that power is in the ring.
  [[nodiscard]] bool holds(Int128 power) const {
    return power <= highest_ && power >= lowest_;
  }

  /// An edge does not dip into the inner circle between its ends. `power` is
  /// of its start and changes by `change` along `move`: a parabola, power +
  /// b s + a |move|^2 s^2 for 0 <= s <= 1.
  [[nodiscard]] bool stays_outside(Vector64 move, Int128 power,
                                   Int128 change) const {
    const Int128 square = circle_.a() * dot(move, move);
    const Int128 b = change - square;
    if (b >= 0 || -b >= 2 * square) return true;  // lowest at an end
    const Int128 room = power - lowest_;
    if (room >= square) return true;
    if (room < 0) return false;
    const UInt128 fall = magnitude_of(b);
    return wide_product(fall, fall) <=
           wide_product(static_cast<UInt128>(4 * square),
                        static_cast<UInt128>(room));
  }

  /// |Q - M| <= t for the point M of the circle on the radius of P: with
  /// D = |Q - C|, D^2 + R^2 - t^2 <= 2 R (Q - C) . (P - C) / |P - C|, squared
  /// and freed of its denominators.
  [[nodiscard]] bool near_radius(Vector64 p, Int128 power_of_p, Vector64 q,
                                 Int128 power_of_q) const {
    const Int128 inner = circle_.inner(p, q);
    if (inner < 0) return false;
    const Int128 n = numerator_;
    const Int128 d2 = Int128{denominator_} * denominator_;
    const auto k = static_cast<Int128>(circle_.k());
    const Int128 left =
        4 * d2 * power_of_q + 2 * d2 * k - 4 * circle_.a() * n * n;
    if (left <= 0) return true;
    const auto l = static_cast<UInt128>(left);
    const auto r = static_cast<UInt128>(2 * d2 * inner);
    return triple_product(l, l, static_cast<UInt128>(4 * power_of_p + k)) <=
           triple_product(r, r, circle_.k());
  }

 private:
  static Int128 floor_quotient(Int128 a, Int128 b) {
    return a / b - (a % b < 0 ? 1 : 0);
  }

  ArcCircle circle_;
  std::int64_t numerator_;
  std::int64_t denominator_;
  Int128 highest_ = 0;  ///< power at R + t, rounded inwards
  Int128 lowest_ = 0;   ///< power at R - t
};

}  // namespace unstep
