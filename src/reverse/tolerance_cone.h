#pragma once

#include <cmath>
#include <cstdint>

#include "unstep/grid.h"

namespace unstep::reverse {

/// The distance allowed, in path units: a multiple of 2^-12.
/// INVARIANT: 1 <= units() <= 2^20.
struct PathTolerance {
  static constexpr int kBits = 12;
  std::int64_t fixed = std::int64_t{1} << kBits;
};

/// The directions in which a ray from the apex meets, in their order, all the
/// discs of radius e around the points that were added. A line along such a
/// ray has Frechet distance at most e to the chain through these points;
/// docs/algorithms.md has the proof. In short: a ray that meets the disc around
/// q, |q| = r > e, has its point at distance t(r) = sqrt(r^2 - e^2) in it (the
/// power of the apex), so points that do not come nearer to the apex ask for
/// nothing but that their discs be met. Of a point that comes nearer we ask
/// that the ray's point at t(the farthest before) lies in its disc.
///
/// The cone's sides are integer vectors, rounded inwards: every direction that
/// is accepted is right, exactly.
///
/// Range: points are relative to the apex and |q| <= kReach = 2^24, else they
/// are refused. A side is q * C + perp(q) * S with C^2 + S^2 <= (2^12 |q|)^2 *
/// (1 + 2^-10), so its length is below 2^61 and products of two fit 2^122 <
/// 2^127. While all points have |q| < 2^9 and e < 2^9, sides are shorter than
/// 2^30.1 and everything fits int64: that is the fast way.
class Cone {
 public:
  static constexpr std::int64_t kReach = std::int64_t{1} << 24;

  explicit Cone(PathTolerance tolerance)
      : e_(tolerance.fixed),
        near2_(static_cast<std::int64_t>(square(e_) >> kFraction2)),
        fast2_(near2_ < kFastReach2 ? kFastReach2 : 0) {}

  /// Forgets the points; the apex is elsewhere.
  void restart() {
    farthest2_ = 0;
    bounded_ = false;
  }

  /// True if a line from the apex may end at q, the next point of the
  /// chain or one within e of the last that was added.
  [[nodiscard]] bool may_end_at(std::int64_t x, std::int64_t y) const {
    const std::int64_t r2 = x * x + y * y;
    if (r2 == 0 || r2 > kReach * kReach) return false;
    if (farthest2_ <= near2_) return true;
    if (r2 + near2_ < farthest2_) return false;
    return farthest2_ < fast2_ && r2 < fast2_ ? inside<std::int64_t>(x, y)
                                              : inside<Wide>(x, y);
  }

  /// Adds the next point of the chain. False if no direction is left; the cone
  /// is then spent until restart().
  [[nodiscard]] bool add(std::int64_t x, std::int64_t y) {
    const std::int64_t r2 = x * x + y * y;
    if (r2 >= farthest2_) {
      if (r2 > kReach * kReach) return false;
      farthest2_ = r2;
      if (r2 <= near2_) return true;
      return r2 < fast2_ ? narrow<std::int64_t>(x, y, tangent<std::int64_t>(r2))
                         : narrow<Wide>(x, y, tangent<Wide>(r2));
    }
    if (farthest2_ <= near2_) return true;
    return farthest2_ < fast2_ ? step_back<std::int64_t>(x, y, r2)
                               : step_back<Wide>(x, y, r2);
  }

 private:
  __extension__ using Wide = __int128;
  static constexpr int kFraction2 = 2 * PathTolerance::kBits;
  static constexpr std::int64_t kFastReach2 = std::int64_t{1} << 18;

  struct Vector {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };
  /// Adjacent and opposite side of half the angle that a disc leaves.
  struct Opening {
    std::int64_t along = 0;
    std::int64_t across = 0;
  };

  static Wide square(std::int64_t value) { return Wide{value} * value; }

  template <class Int>
  static Int cross(Vector a, Vector b) {
    return static_cast<Int>(a.x) * b.y - static_cast<Int>(a.y) * b.x;
  }

  /// The least t with t^2 >= value. A double's root of a value below 2^80 is
  /// off by less than 1 (2^40 * 2^-52), so few corrections are needed.
  template <class Int>
  static std::int64_t root_up(Int value) {
    auto t = static_cast<std::int64_t>(std::sqrt(static_cast<double>(value)));
    while (static_cast<Int>(t) * t < value) ++t;
    while (t > 0 && static_cast<Int>(t - 1) * (t - 1) >= value) --t;
    return t;
  }

  /// (r^2 - e^2) * 2^24.
  template <class Int>
  [[nodiscard]] Int power(std::int64_t r2) const {
    return (static_cast<Int>(r2) << kFraction2) - static_cast<Int>(e_) * e_;
  }

  /// tan = e / t(r); t rounded up makes the angle smaller.
  template <class Int>
  [[nodiscard]] Opening tangent(std::int64_t r2) const {
    return {root_up(power<Int>(r2)), e_};
  }

  /// A point at r < the farthest R: the ray's point at t = t(R) is in its disc
  /// if cos(angle) >= (t^2 + r^2 - e^2) / (2 t r) = along / r. `along` is
  /// rounded up, `across` = sqrt(r^2 - along^2) down.
  template <class Int>
  bool step_back(std::int64_t x, std::int64_t y, std::int64_t r2) {
    const std::int64_t t_up = root_up(power<Int>(farthest2_));
    const Int own = power<Int>(r2);
    const std::int64_t divisor = own >= 0 ? t_up - 1 : t_up;
    if (divisor <= 0) return false;
    const Int quotient = own / divisor + (own > 0 ? 1 : 0);
    const Int twice = quotient + t_up;
    Opening opening;
    opening.along = static_cast<std::int64_t>(twice <= 1 ? 1 : (twice + 1) / 2);
    const Int rest = (static_cast<Int>(r2) << kFraction2) -
                     static_cast<Int>(opening.along) * opening.along;
    if (rest < 0) return false;
    opening.across = root_up(rest);
    if (static_cast<Int>(opening.across) * opening.across > rest) {
      --opening.across;
    }
    return narrow<Int>(x, y, opening);
  }

  /// Intersects with the directions around q up to the opening's angle, at most
  /// a quarter turn. Both cones are narrower than half a turn, so one of the
  /// two left sides is the left side of the intersection if it is in the other
  /// cone; likewise right.
  template <class Int>
  bool narrow(std::int64_t x, std::int64_t y, Opening opening) {
    const Vector left{x * opening.along - y * opening.across,
                      y * opening.along + x * opening.across};
    const Vector right{x * opening.along + y * opening.across,
                       y * opening.along - x * opening.across};
    if (!bounded_) {
      bounded_ = true;
      left_ = left;
      right_ = right;
      return true;
    }
    const Int right_to_new_left = cross<Int>(right_, left);
    const Int new_right_to_left = cross<Int>(right, left_);
    const Int new_left_to_left = cross<Int>(left, left_);
    const Int right_to_new_right = cross<Int>(right_, right);
    const bool tighter_left = new_left_to_left >= 0;
    const bool tighter_right = right_to_new_right >= 0;
    const bool some =
        (tighter_left ? right_to_new_left : new_right_to_left) >= 0 &&
        (tighter_right ? new_right_to_left : right_to_new_left) >= 0;
    if (!some) return false;
    if (tighter_left) left_ = left;
    if (tighter_right) right_ = right;
    // A single direction: not the opposite of the one that is asked for.
    if (cross<Int>(right_, left_) != 0) return true;
    return static_cast<Int>(left_.x) * x + static_cast<Int>(left_.y) * y >= 0 &&
           static_cast<Int>(left_.x) * right_.x +
                   static_cast<Int>(left_.y) * right_.y >
               0;
  }

  template <class Int>
  [[nodiscard]] bool inside(std::int64_t x, std::int64_t y) const {
    const Vector q{x, y};
    const Int from_right = cross<Int>(right_, q);
    const Int to_left = cross<Int>(q, left_);
    if (from_right < 0 || to_left < 0) return false;
    if (from_right != 0 || to_left != 0) return true;
    // A single direction: not its opposite.
    return static_cast<Int>(left_.x) * x + static_cast<Int>(left_.y) * y > 0;
  }

  std::int64_t e_;      ///< times 2^12
  std::int64_t near2_;  ///< r^2 of points that the apex alone serves
  std::int64_t fast2_;
  std::int64_t farthest2_ = 0;
  Vector left_;
  Vector right_;
  bool bounded_ = false;
};

}  // namespace unstep::reverse
