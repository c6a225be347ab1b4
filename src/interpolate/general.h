#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include "interpolate/arc_walk.h"
#include "interpolate/digit_by_digit.h"
#include "interpolate/rom.h"
#include "interpolate/ticks.h"
#include "unstep/interpolate.h"

/// D5: the general scheme. Stage 1 takes sin and cos of phi from any source,
/// stage 2 makes x = R cos phi, y = R sin phi and puts out new minus old;
/// phi += dphi = Vk Tk / R. D3 and D4 are this driver with a path of 15/16 of
/// a unit per tick, so that no axis moves more than one unit.
namespace unstep::interpolation {

/// Stage 1: sin and cos of any angle in -pi..pi, as words of n digits.
class Sine {
 public:
  struct Digits {
    bool meggitt = false;
  };

  Sine(int word_length, bool meggitt)
      : n_(word_length), source_(Digits{meggitt}) {}
  Sine(int word_length, const Rom& rom) : n_(word_length), source_(rom) {}

  [[nodiscard]] int digits() const { return n_; }
  SinCos at(std::int64_t phi);

  /// True if `start` = r / m may be given instead of multiplying: D3.
  [[nodiscard]] bool rotates() const {
    return std::holds_alternative<Digits>(source_);
  }
  /// (r cos phi, r sin phi), 0 <= phi <= pi / 2. REQUIRES: rotates().
  [[nodiscard]] SinCos rotate(std::int64_t phi, std::int64_t start) const;

 private:
  int n_;
  std::variant<Digits, Rom> source_;
};

/// Path per tick of the methods that make unit steps.
inline constexpr double kUnitPath = 0.9375;

/// Follows target positions, either at once (increments) or by at most one
/// unit per axis and tick.
class Follower {
 public:
  explicit Follower(bool unit_steps) : unit_steps_(unit_steps) {}

  [[nodiscard]] bool at(std::int64_t x, std::int64_t y) const {
    return x_ == x && y_ == y;
  }
  Tick follow(std::int64_t x, std::int64_t y);
  [[nodiscard]] std::int64_t x() const { return x_; }
  [[nodiscard]] std::int64_t y() const { return y_; }

 private:
  bool unit_steps_;
  std::int64_t x_ = 0;
  std::int64_t y_ = 0;
};

/// Lines: phi is the slope; the increments of one tick are found once and
/// summed without rounding (range: 2^32 units in 2^-72).
class GeneralLine {
 public:
  /// length = Vk Tk, or kUnitPath with unit steps.
  GeneralLine(Segment segment, Sine sine, double length, bool unit_steps);

  Tick next();
  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  Quadrant quadrant_;
  Follower follower_;
  Int128 x_ = 0;  ///< sums, 2^-scale_
  Int128 y_ = 0;
  Int128 dx_ = 0;
  Int128 dy_ = 0;
  int scale_ = 0;
  std::int64_t phi_ = 0;
  std::int64_t ticks_left_ = 0;  ///< until the end point is the target
};

class GeneralArc {
 public:
  GeneralArc(const ArcGeometry& arc, Sine sine, double length, bool unit_steps);

  Tick next();
  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  Sine sine_;
  Follower follower_;
  std::int64_t radius_;  ///< 2^-24, < 2^55
  std::int64_t start_x_, start_y_;
  std::int64_t end_x_, end_y_;  ///< from the start
  std::int64_t phi_;
  std::int64_t turned_ = 0;
  std::int64_t total_;
  std::int64_t dphi_;
  bool clockwise_;
};

}  // namespace unstep::interpolation
