#include "interpolate/circular.h"

#include <cmath>
#include <cstdlib>

namespace unstep::interpolation {

CircularMove circular_move(const ArcWalk& walk, bool combined) {
  const std::int64_t a = walk.a();
  const std::int64_t b = walk.b();
  const std::int64_t f = walk.f();
  // A piece ends exactly: what one axis has used up the other must walk.
  if (walk.left_b() == 0) return {true, false};
  if (walk.left_a() == 0) return {false, true};
  if (!combined) return {f <= 0, f > 0};
  const std::int64_t only_a = std::abs(f + 2 * a + 1);
  const std::int64_t only_b = std::abs(f - 2 * b + 1);
  const std::int64_t both = std::abs(f + 2 * (a - b) + 2);
  return {only_a <= only_b || both <= only_b,
          only_b < only_a || both <= only_a};
}

Circular::Circular(const ArcGeometry& arc, double feed, bool combined)
    : walk_(arc), combined_(combined) {
  const double radius = std::sqrt(static_cast<double>(arc.radius_squared));
  correction_ = std::llround(feed / radius * kTwo32);
  frequency_ = std::llround(feed * static_cast<double>(walk_.a() + walk_.b()) /
                            radius * kTwo32);
}

Tick Circular::next() {
  if (!walk_.advance()) {
    const Point move = walk_.correct();
    if (move == Point{}) return {};
    return unit_tick(move.x, move.y);
  }
  const auto [step_a, step_b] = circular_move(walk_, combined_);
  if (step_a) frequency_ += correction_;
  if (step_b) frequency_ -= correction_;
  const Point move = walk_.move(step_a, step_b);
  return unit_tick(move.x, move.y);
}

double Circular::frequency() const {
  return static_cast<double>(frequency_) / kTwo32;
}

std::size_t Circular::registers(std::span<Register, kMaxRegisters> out) const {
  out[0] = {"a", walk_.a()};
  out[1] = {"b", walk_.b()};
  out[2] = {"F", walk_.f()};
  out[3] = {"f_mHz", std::llround(frequency() * 1000.0)};
  return 4;
}

}  // namespace unstep::interpolation
