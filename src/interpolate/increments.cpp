#include "interpolate/increments.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace unstep::interpolation {
namespace {

constexpr std::int64_t kMaxFirstStep = std::int64_t{1} << 20;

std::int64_t choose_first_step(std::int32_t asked, double length) {
  if (asked > 0) return asked;
  const auto quarter = static_cast<std::uint64_t>(std::max(length / 4, 1.0));
  return std::min(static_cast<std::int64_t>(std::bit_floor(quarter)),
                  kMaxFirstStep);
}

}  // namespace

LineIncrements::LineIncrements(Segment segment, double length,
                               std::int32_t first_step)
    : quadrant_(segment), first_step_(choose_first_step(first_step, length)) {
  const auto xk = static_cast<double>(quadrant_.xk);
  const auto yk = static_cast<double>(quadrant_.yk);
  const double line = std::hypot(xk, yk);
  steps_per_period_ =
      line == 0 ? 0 : std::llround(length * (xk + yk) / line * kTwo32);
}

bool LineIncrements::step(std::int64_t h) {
  const std::int64_t xk = quadrant_.xk;
  const std::int64_t yk = quadrant_.yk;
  bool along_x;
  if (h == 1)
    along_x = f_ >= 0;
  else if (xk >= yk)
    along_x = f_ + h * xk > 0;
  else
    along_x = f_ - h * yk >= 0;
  if (xk - x_ < h) along_x = false;
  if (yk - y_ < h) along_x = true;
  if (along_x && xk - x_ < h) return false;
  if (along_x) {
    x_ += h;
    f_ -= h * yk;
  } else {
    y_ += h;
    f_ += h * xk;
  }
  return true;
}

Tick LineIncrements::next() {
  if (x_ == quadrant_.xk && y_ == quadrant_.yk) return {};
  const std::int64_t from_x = x_;
  const std::int64_t from_y = y_;
  std::int64_t left = budget_.take(steps_per_period_);
  for (std::int64_t h = first_step_; h >= 1; h /= 2) {
    const std::int64_t reserve = h > 1 ? 3 * h : 0;
    while (left - h >= reserve && step(h)) left -= h;
  }
  const auto dx = static_cast<std::int32_t>(x_ - from_x);
  const auto dy = static_cast<std::int32_t>(y_ - from_y);
  if (dx == 0 && dy == 0) return idle_tick();
  return {Tick::Kind::increment, 0, quadrant_.along_x == 0 ? dx : -dx,
          quadrant_.along_y == 2 ? dy : -dy};
}

std::size_t LineIncrements::registers(
    std::span<Register, kMaxRegisters> out) const {
  out[0] = {"x", x_};
  out[1] = {"y", y_};
  out[2] = {"F", f_};
  return 3;
}

ArcIncrements::ArcIncrements(const ArcGeometry& arc, double length,
                             std::int32_t first_step)
    : walk_(arc), first_step_(choose_first_step(first_step, length)) {
  const double radius = std::sqrt(static_cast<double>(arc.radius_squared));
  length_over_radius_ = std::llround(length / radius * kTwo32);
}

bool ArcIncrements::step(std::int64_t h, Point& sum) {
  const std::int64_t a = walk_.a();
  const std::int64_t b = walk_.b();
  const std::int64_t f = walk_.f();
  bool along_a;
  if (h == 1)
    along_a = f <= 0;
  else if (b >= a)
    along_a = f + (h - 2 * b) * h < 0;
  else
    along_a = f + (h + 2 * a) * h <= 0;
  if (walk_.left_a() < h) along_a = false;
  if (walk_.left_b() < h) along_a = true;
  if (along_a && walk_.left_a() < h) return false;
  const Point move = along_a ? walk_.move(h, 0) : walk_.move(0, h);
  sum.x += move.x;
  sum.y += move.y;
  return true;
}

Tick ArcIncrements::next() {
  Point sum;
  if (!walk_.advance()) {
    // At most two unit moves lead from the last piece to an end off it.
    for (Point move = walk_.correct(); !(move == Point{});
         move = walk_.correct()) {
      sum.x += move.x;
      sum.y += move.y;
    }
    if (sum == Point{}) return {};
    return {Tick::Kind::increment, 0, sum.x, sum.y};
  }
  std::int64_t left =
      budget_.take(Int128{length_over_radius_} * (walk_.a() + walk_.b()));
  while (left > 0 && walk_.advance()) {
    for (std::int64_t h = first_step_; h >= 1; h /= 2) {
      const std::int64_t reserve = h > 1 ? 3 * h : 0;
      while (left - h >= reserve && step(h, sum)) left -= h;
    }
  }
  if (sum == Point{}) return idle_tick();
  return {Tick::Kind::increment, 0, sum.x, sum.y};
}

std::size_t ArcIncrements::registers(
    std::span<Register, kMaxRegisters> out) const {
  out[0] = {"a", walk_.a()};
  out[1] = {"b", walk_.b()};
  out[2] = {"F", walk_.f()};
  return 3;
}

}  // namespace unstep::interpolation
