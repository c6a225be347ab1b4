#include "interpolate/arc_steps.h"

#include <algorithm>
#include <cstring>

#include "interpolate/circular.h"
#include "interpolate/ticks.h"

namespace unstep::interpolation {

std::uint8_t ArcSteps::letter(Point move) const {
  return letters_[unit_step(move.x, move.y)];
}

/// Of the moves of this piece, on the plane.
void ArcSteps::name_moves() {
  if (named_ == walk_.turns()) return;
  named_ = walk_.turns();
  along_a_ = letter(walk_.to_plane(1, 0));
  along_b_ = letter(walk_.to_plane(0, -1));
  both_ = letter(walk_.to_plane(1, -1));
}

std::size_t ArcSteps::fill(std::span<std::uint8_t> out) {
  std::size_t count = 0;
  while (count < out.size()) {
    if (!walk_.advance()) {
      const Point move = walk_.correct();
      if (move == Point{}) break;
      out[count++] = letter(move);
      continue;
    }
    name_moves();
    const std::size_t run = draw_run(out.subspan(count));
    count += run;
    if (run > 0) continue;
    const CircularMove next = circular_move(walk_, combined_);
    out[count++] = letter(walk_.move(next.along_a, next.along_b));
  }
  return count;
}

std::size_t ArcSteps::draw_run(std::span<std::uint8_t> out) {
  if (walk_.left_a() == 0 || walk_.left_b() == 0) return draw_straight(out);
  if (!combined_) return draw_separate(out);
  const std::int64_t a = walk_.a();
  const std::int64_t b = walk_.b();
  const std::int64_t f = walk_.f();
  if (a <= b - 2 && -b <= f && f < b) return draw_flat(out);
  if (a >= b - 1 && -a <= f && f <= a) return draw_steep(out);
  return 0;
}

/// What one axis has used up the other walks: F grows by the difference of two
/// squares.
std::size_t ArcSteps::draw_straight(std::span<std::uint8_t> out) {
  const std::int64_t a = walk_.a();
  const std::int64_t b = walk_.b();
  const bool along_a = walk_.left_b() == 0;
  const std::int64_t left = along_a ? walk_.left_a() : walk_.left_b();
  const auto count = std::min(static_cast<std::size_t>(left), out.size());
  const auto n = static_cast<std::int64_t>(count);
  std::memset(out.data(), along_a ? along_a_ : along_b_, count);
  if (along_a) {
    walk_.go_to(a + n, b, walk_.f() + (2 * a + n) * n);
  } else {
    walk_.go_to(a, b - n, walk_.f() + (n - 2 * b) * n);
  }
  return count;
}

/// Without diagonal steps the sign of F decides everywhere.
std::size_t ArcSteps::draw_separate(std::span<std::uint8_t> out) {
  std::int64_t a = walk_.a();
  std::int64_t b = walk_.b();
  std::int64_t f = walk_.f();
  const std::int64_t last_a = a + walk_.left_a();
  const std::int64_t last_b = b - walk_.left_b();
  std::size_t count = 0;
  while (count < out.size() && a != last_a && b != last_b) {
    const bool down = f > 0;
    out[count++] = down ? along_b_ : along_a_;
    f += down ? 1 - 2 * b : 2 * a + 1;
    a += down ? 0 : 1;
    b -= down ? 1 : 0;
  }
  walk_.go_to(a, b, f);
  return count;
}

/// The octant next to the axis b. With g = F + 2a + 1, what a step along a
/// leaves, the diagonal leaves g - (2b - 1), which is no larger where g >= b.
///
/// INVARIANT: a <= b - 2 and -b <= F < b. A step along a leaves g < b, and g
/// >= F; a diagonal one from g >= b leaves at least -b + 1 and, F being below
/// b, at most 2a - b + 1 <= b - 3. Along b alone |F| would be 2b - 1 - F >= b,
/// more than either: it is never taken.
std::size_t ArcSteps::draw_flat(std::span<std::uint8_t> out) {
  std::int64_t a = walk_.a();
  std::int64_t b = walk_.b();
  std::int64_t f = walk_.f();
  const std::int64_t last_b = b - walk_.left_b();
  // A step brings a and b nearer by two at most.
  const std::int64_t most = std::min(walk_.left_a(), (b - a) / 2);
  const auto room = std::min(static_cast<std::size_t>(most), out.size());
  std::size_t count = 0;
  while (count < room && b != last_b) {
    const std::int64_t g = f + 2 * a + 1;
    const bool diagonal = g >= b;
    out[count++] = diagonal ? both_ : along_a_;
    f = diagonal ? g - 2 * b + 1 : g;
    b -= diagonal ? 1 : 0;
    ++a;
  }
  walk_.go_to(a, b, f);
  return count;
}

/// The octant next to the axis a. With h = F - 2b + 1, what a step along b
/// leaves, the diagonal leaves h + 2a + 1, which is no larger where h < -a.
///
/// INVARIANT: a >= b - 1 and -a <= F <= a. A step along b leaves h >= -a, and
/// h < F; a diagonal one from h < -a leaves at most a and at least -a - 2b + 1
/// + 2a + 1 >= -a. Along a alone |F| would be F + 2a + 1 > a, more than
/// either: it is never taken.
std::size_t ArcSteps::draw_steep(std::span<std::uint8_t> out) {
  std::int64_t a = walk_.a();
  std::int64_t b = walk_.b();
  std::int64_t f = walk_.f();
  const std::int64_t last_a = a + walk_.left_a();
  const auto room =
      std::min(static_cast<std::size_t>(walk_.left_b()), out.size());
  std::size_t count = 0;
  while (count < room && a != last_a) {
    const std::int64_t h = f - 2 * b + 1;
    const bool diagonal = h < -a;
    out[count++] = diagonal ? both_ : along_b_;
    f = diagonal ? h + 2 * a + 1 : h;
    a += diagonal ? 1 : 0;
    --b;
  }
  walk_.go_to(a, b, f);
  return count;
}

}  // namespace unstep::interpolation
