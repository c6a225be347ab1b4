#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

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

  __extension__ using Wide = __int128;
  static constexpr int kFraction2 = 2 * PathTolerance::kBits;

  struct Vector {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const Vector&, const Vector&) = default;
  };
  struct Sides {
    Vector left;
    Vector right;
    friend bool operator==(const Sides&, const Sides&) = default;
  };

  explicit Cone(PathTolerance tolerance)
      : e_(tolerance.fixed),
        near2_(square_below(tolerance)),
        fast2_(near2_ < kFastReach2 ? kFastReach2 : 0),
        back_(tolerance) {}

  /// The greatest r^2 of points whose discs hold the apex.
  static std::int64_t square_below(PathTolerance tolerance) {
    return static_cast<std::int64_t>(square(tolerance.fixed) >> kFraction2);
  }

  /// The directions that pass q within `across`, times 2^12. REQUIRES: q is
  /// farther than that from the apex, or as far, and |q| < 2^9.
  static Sides sides_of(Point q, std::int64_t across) {
    const std::int64_t r2 = std::int64_t{q.x} * q.x + std::int64_t{q.y} * q.y;
    return sides_of(q.x, q.y, opening<std::int64_t>(r2, across));
  }

  /// Keeps the roots of small distances, for a cone that is restarted often.
  void keep_roots() {
    roots_.assign(kRoots, 0);
    for (std::int64_t r2 = near2_ + 1; r2 < kRoots && r2 < fast2_; ++r2) {
      roots_[static_cast<std::size_t>(r2)] = static_cast<std::int32_t>(
          opening<std::int64_t>(r2, e_).along);  // below 2^18
    }
  }

  /// Forgets the points; the apex is elsewhere.
  void restart() {
    farthest2_ = 0;
    bounded_ = false;
  }

  /// A chain that comes back from a point at R to one at r < R lets a ray fall
  /// behind by d = (R^2 - r^2) / (2 t(R)) at most. d is rounded up to quarters
  /// of the tolerance: 1 to 4 of them, more means that no ray can wait so long.
  class BackRule {
   public:
    explicit BackRule(PathTolerance tolerance)
        : e_(tolerance.fixed),
          e2_(square(e_)),
          round_up2_(static_cast<std::int64_t>(
              (e2_ + (Wide{1} << kFraction2) - 1) >> kFraction2)) {
      for (std::size_t n = 1; n <= 4; ++n) {
        const Wide rest = e2_ * static_cast<int>(16 - n * n) / 16;
        across_[n] = root_down(rest);
      }
    }

    /// More than 4 if no ray can wait so long. Of squares below 2^48 the left
    /// side is below 2^122 and the right ones below 2^116; with int64 for
    /// squares below 2^12 and a tolerance of at most 2^4.
    template <class Int>
    [[nodiscard]] int quarters(std::int64_t farthest2, std::int64_t r2) const {
      const Int difference = farthest2 - r2;
      const Int left = difference * difference << (kFraction2 + 2);
      const Int right = static_cast<Int>(e2_) * (farthest2 - round_up2_);
      return 1 + int{left > right} + int{left > 4 * right} +
             int{left > 9 * right} + int{left > 16 * right};
    }

    /// How far from the point a ray may pass, for 1 to 4 quarters.
    [[nodiscard]] std::int64_t across(int quarters) const {
      return across_[static_cast<std::size_t>(quarters)];
    }

    /// True if the disc around the point at r holds all places of a ray up to
    /// t(R), whatever its direction.
    [[nodiscard]] bool holds_all(std::int64_t farthest2,
                                 std::int64_t r2) const {
      const std::int64_t r = root_up(Wide{r2} << kFraction2);
      return root_up((Wide{farthest2} << kFraction2) - e2_) + r <= e_;
    }

   private:
    std::int64_t e_;
    Wide e2_;                 ///< the tolerance's square times 2^24
    std::int64_t round_up2_;  ///< the same in whole units, rounded up
    std::array<std::int64_t, 5> across_{};
  };

  /// Goes on as if points had been added: the farthest at this r^2, and between
  /// them they left these directions if one is outside the tolerance.
  void resume(std::int64_t farthest2, const Sides& sides) {
    farthest2_ = farthest2;
    bounded_ = farthest2 > near2_;
    left_ = sides.left;
    right_ = sides.right;
    single_ = bounded_ && cross<Wide>(right_, left_) == 0;
  }

  /// What is left of the directions. REQUIRES: a point outside the tolerance
  /// was added.
  [[nodiscard]] Sides sides() const { return {left_, right_}; }

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
  /// is then as before.
  [[nodiscard]] bool add(std::int64_t x, std::int64_t y) {
    const std::int64_t r2 = x * x + y * y;
    if (r2 < farthest2_) {
      if (farthest2_ <= near2_) return true;
      return farthest2_ < fast2_ ? step_back<std::int64_t>(x, y, r2)
                                 : step_back<Wide>(x, y, r2);
    }
    if (r2 > kReach * kReach) return false;
    if (r2 > near2_ &&
        !(r2 < fast2_ ? narrow<std::int64_t>(x, y, opening_of_disc(r2))
                      : narrow<Wide>(x, y, opening<Wide>(r2, e_)))) {
      return false;
    }
    farthest2_ = r2;
    return true;
  }

 private:
  static constexpr std::int64_t kRoots = 1 << 12;
  static constexpr std::int64_t kFastReach2 = std::int64_t{1} << 18;

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

  template <class Int>
  static Int dot(Vector a, Vector b) {
    return static_cast<Int>(a.x) * b.x + static_cast<Int>(a.y) * b.y;
  }

  /// The least t with t^2 >= value. Below 2^52 a double holds the value, and
  /// its root rounds to an integer only if that is not above the true one.
  static std::int64_t root_up(std::int64_t value) {
    const auto t =
        static_cast<std::int64_t>(std::sqrt(static_cast<double>(value)));
    return t + (t * t < value ? 1 : 0);
  }
  /// A double's root of a value below 2^74 is off by less than 1.
  static std::int64_t root_up(Wide value) {
    auto t = static_cast<std::int64_t>(std::sqrt(static_cast<double>(value)));
    while (Wide{t} * t < value) ++t;
    while (t > 0 && Wide{t - 1} * (t - 1) >= value) --t;
    return t;
  }

  static std::int64_t root_down(Wide value) {
    const std::int64_t t = root_up(value);
    return Wide{t} * t > value ? t - 1 : t;
  }
  static std::int64_t root_down(std::int64_t value) {
    return static_cast<std::int64_t>(std::sqrt(static_cast<double>(value)));
  }

  /// (r^2 - d^2) * 2^24, d given times 2^12.
  template <class Int>
  static Int power(std::int64_t r2, std::int64_t d) {
    return (static_cast<Int>(r2) << kFraction2) - static_cast<Int>(d) * d;
  }

  /// The angle asin(across / r): its tangent is across / sqrt(r^2 - across^2),
  /// and that root is rounded up. Less than a quarter turn.
  template <class Int>
  static Opening opening(std::int64_t r2, std::int64_t across) {
    const std::int64_t along = root_up(power<Int>(r2, across));
    return {along > 0 ? along : 1, across};
  }

  static Sides sides_of(std::int64_t x, std::int64_t y, Opening half) {
    return {
        {x * half.along - y * half.across, y * half.along + x * half.across},
        {x * half.along + y * half.across, y * half.along - x * half.across}};
  }

  /// opening(r2, e).
  [[nodiscard]] Opening opening_of_disc(std::int64_t r2) const {
    return r2 < static_cast<std::int64_t>(roots_.size())
               ? Opening{roots_[static_cast<std::size_t>(r2)], e_}
               : opening<std::int64_t>(r2, e_);
  }

  /// A point at r < the farthest R: the ray's point at t = t(R) is in its disc
  /// if the ray's distance from q is at most sqrt(e^2 - d^2), where d = (R^2 -
  /// r^2) / (2 t) is what t is beyond the foot of q at most.
  template <class Int>
  bool step_back(std::int64_t x, std::int64_t y, std::int64_t r2) {
    if (r2 <= near2_) {
      // The disc holds the apex: perhaps all points up to t in any direction.
      if (back_.holds_all(farthest2_, r2)) return true;
      if (r2 == 0) return false;
    }
    const int quarters = back_.quarters<Wide>(farthest2_, r2);
    if (quarters > 4) return false;
    const std::int64_t across = back_.across(quarters);
    return narrow<Int>(x, y, opening<Int>(r2, across));
  }

  /// Intersects with the directions around q up to the opening's angle, at most
  /// a quarter turn. Both cones are narrower than half a turn, so one of the
  /// two left sides is the left side of the intersection if it is in the other
  /// cone; likewise right.
  template <class Int>
  bool narrow(std::int64_t x, std::int64_t y, Opening half) {
    const auto [left, right] = sides_of(x, y, half);
    if (!bounded_) {
      bounded_ = true;
      single_ = half.across == 0;
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
    // Selections instead of branches: no processor can foretell them.
    const Int of_left = tighter_left ? right_to_new_left : new_right_to_left;
    const Int of_right = tighter_right ? new_right_to_left : right_to_new_left;
    if ((of_left | of_right) < 0) return false;
    const Vector new_left{tighter_left ? left.x : left_.x,
                          tighter_left ? left.y : left_.y};
    const Vector new_right{tighter_right ? right.x : right_.x,
                           tighter_right ? right.y : right_.y};
    const bool single = cross<Int>(new_right, new_left) == 0;
    // A single direction: neither the opposite of q nor of what it was before.
    if (single && (dot<Int>(new_left, {x, y}) <= 0 ||
                   (single_ && dot<Int>(new_left, left_) <= 0))) {
      return false;
    }
    single_ = single;
    left_ = new_left;
    right_ = new_right;
    return true;
  }

  template <class Int>
  [[nodiscard]] bool inside(std::int64_t x, std::int64_t y) const {
    const Vector q{x, y};
    const Int from_right = cross<Int>(right_, q);
    const Int to_left = cross<Int>(q, left_);
    if (from_right < 0 || to_left < 0) return false;
    if (from_right != 0 || to_left != 0) return true;
    // A single direction: not its opposite.
    return dot<Int>(left_, q) > 0;
  }

  std::int64_t e_;      ///< times 2^12
  std::int64_t near2_;  ///< r^2 of points that the apex alone serves
  std::int64_t fast2_;
  BackRule back_;
  std::int64_t farthest2_ = 0;
  Vector left_;
  Vector right_;
  std::vector<std::int32_t> roots_;  ///< for each r^2, if they are kept
  bool bounded_ = false;             ///< the sides are set
  bool single_ = false;              ///< and are one direction
};

}  // namespace unstep::reverse
