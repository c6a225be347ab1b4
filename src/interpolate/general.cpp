#include "interpolate/general.h"

#include <algorithm>
#include <cmath>

namespace unstep::interpolation {
namespace {

constexpr int kLengthBits = 20;  // of Vk Tk below one unit
constexpr int kRadiusBits = 24;
constexpr double kAngleUnit = 1152921504606846976.0;  // 2^60

std::int64_t rounded(Int128 value, int bits) {
  return static_cast<std::int64_t>((value + (Int128{1} << (bits - 1))) >> bits);
}

// round(sqrt(squared) * 2^24): 55 bits of root.
std::int64_t fine_root(std::int64_t squared) {
  const Int128 v = Int128{squared} << (2 * kRadiusBits);
  Int128 root = 0;
  for (int bit = 55; bit >= 0; --bit) {
    const Int128 next = root | Int128{1} << bit;
    if (next * next <= v) root = next;
  }
  return static_cast<std::int64_t>(root + (v - root * root > root ? 1 : 0));
}

// The angle from start to end in the sense of the arc, 0..2 pi.
std::int64_t arc_angle(const ArcGeometry& arc) {
  if (arc.full) return 2 * kPi;
  const Int128 cross =
      Int128{arc.start_x} * arc.end_y - Int128{arc.start_y} * arc.end_x;
  const Int128 dot =
      Int128{arc.start_x} * arc.end_x + Int128{arc.start_y} * arc.end_y;
  if (cross == 0 && dot >= 0) return 0;
  const std::int64_t left = angle_of(arc.end_x, arc.end_y);
  const std::int64_t right = angle_of(arc.start_x, arc.start_y);
  Int128 angle = arc.clockwise ? Int128{right} - left : Int128{left} - right;
  if (angle <= 0) angle += 2 * kPi;
  return static_cast<std::int64_t>(angle);
}

}  // namespace

SinCos Sine::rotate(std::int64_t phi, std::int64_t start) const {
  const auto* digits = std::get_if<Digits>(&source_);
  return digits != nullptr && digits->meggitt ? meggitt(phi, n_, start)
                                              : volder(phi, n_, start);
}

SinCos Sine::at(std::int64_t phi) {
  int quarter = 0;
  for (; phi < 0; phi += kHalfPi) --quarter;
  for (; phi > kHalfPi; phi -= kHalfPi) ++quarter;
  Rom* rom = std::get_if<Rom>(&source_);
  const SinCos v =
      rom != nullptr ? rom->at(phi, n_) : rotate(phi, unit_start(n_));
  switch (quarter & 3) {
    case 1: return {-v.sin, v.cos};
    case 2: return {-v.cos, -v.sin};
    case 3: return {v.sin, -v.cos};
    default: return v;
  }
}

Tick Follower::follow(std::int64_t x, std::int64_t y) {
  std::int64_t dx = x - x_;
  std::int64_t dy = y - y_;
  if (unit_steps_) {
    dx = std::clamp<std::int64_t>(dx, -1, 1);
    dy = std::clamp<std::int64_t>(dy, -1, 1);
  }
  x_ += dx;
  y_ += dy;
  if (unit_steps_) return unit_tick(static_cast<int>(dx), static_cast<int>(dy));
  if (dx == 0 && dy == 0) return idle_tick();
  return {Tick::Kind::increment, 0, static_cast<std::int32_t>(dx),
          static_cast<std::int32_t>(dy)};
}

GeneralLine::GeneralLine(Segment segment, Sine sine, double length,
                         bool unit_steps)
    : quadrant_(segment), follower_(unit_steps) {
  const double line = std::hypot(static_cast<double>(quadrant_.xk),
                                 static_cast<double>(quadrant_.yk));
  ticks_left_ = static_cast<std::int64_t>(std::ceil(line / length));
  phi_ = angle_of(quadrant_.xk, quadrant_.yk);
  if (unit_steps && sine.rotates()) {
    // The results of the digit machine are the increments: Xn = dL / m.
    const double start =
        length * static_cast<double>(unit_start(sine.digits()));
    const SinCos v = sine.rotate(phi_, std::llround(start));
    dx_ = v.cos;
    dy_ = v.sin;
    scale_ = sine.digits();
  } else {
    const Int128 fine = std::llround(std::ldexp(length, kLengthBits));
    const SinCos v = sine.at(phi_);
    dx_ = fine * v.cos;
    dy_ = fine * v.sin;
    scale_ = sine.digits() + kLengthBits;
  }
}

Tick GeneralLine::next() {
  if (follower_.at(quadrant_.xk, quadrant_.yk) && ticks_left_ <= 0) return {};
  if (ticks_left_ > 0) --ticks_left_;
  x_ += dx_;
  y_ += dy_;
  Tick tick = ticks_left_ > 0
                  ? follower_.follow(rounded(x_, scale_), rounded(y_, scale_))
                  : follower_.follow(quadrant_.xk, quadrant_.yk);
  if (quadrant_.along_x != 0) tick.dx = -tick.dx;
  if (quadrant_.along_y != 2) tick.dy = -tick.dy;
  if (tick.kind == Tick::Kind::step) return unit_tick(tick.dx, tick.dy);
  return tick;
}

std::size_t GeneralLine::registers(
    std::span<Register, kMaxRegisters> out) const {
  out[0] = {"x", follower_.x()};
  out[1] = {"y", follower_.y()};
  out[2] = {"phi_nrad",
            std::llround(static_cast<double>(phi_) / kAngleUnit * 1e9)};
  return 3;
}

GeneralArc::GeneralArc(const ArcGeometry& arc, Sine sine, double length,
                       bool unit_steps)
    : sine_(sine),
      follower_(unit_steps),
      radius_(fine_root(arc.radius_squared)),
      start_x_(arc.start_x),
      start_y_(arc.start_y),
      end_x_(arc.full ? 0 : arc.end_x - arc.start_x),
      end_y_(arc.full ? 0 : arc.end_y - arc.start_y),
      phi_(angle_of(arc.start_x, arc.start_y)),
      total_(arc_angle(arc)),
      clockwise_(arc.clockwise) {
  const double radius = std::sqrt(static_cast<double>(arc.radius_squared));
  const double angle = std::min(length / radius, 6.25);
  dphi_ = std::llround(angle * kAngleUnit);
}

Tick GeneralArc::next() {
  if (turned_ >= total_) {
    if (follower_.at(end_x_, end_y_)) return {};
    return follower_.follow(end_x_, end_y_);
  }
  const Int128 turned = Int128{turned_} + dphi_;
  turned_ = static_cast<std::int64_t>(std::min(turned, Int128{total_}));
  if (turned_ == total_) return follower_.follow(end_x_, end_y_);
  Int128 phi = Int128{phi_} + (clockwise_ ? -dphi_ : dphi_);
  if (phi > kPi) phi -= 2 * kPi;
  if (phi < -kPi) phi += 2 * kPi;
  phi_ = static_cast<std::int64_t>(phi);
  const SinCos v = sine_.at(phi_);
  const int bits = sine_.digits() + kRadiusBits;
  return follower_.follow(rounded(Int128{radius_} * v.cos, bits) - start_x_,
                          rounded(Int128{radius_} * v.sin, bits) - start_y_);
}

std::size_t GeneralArc::registers(
    std::span<Register, kMaxRegisters> out) const {
  out[0] = {"x", follower_.x()};
  out[1] = {"y", follower_.y()};
  out[2] = {"phi_nrad",
            std::llround(static_cast<double>(phi_) / kAngleUnit * 1e9)};
  return 3;
}

}  // namespace unstep::interpolation
