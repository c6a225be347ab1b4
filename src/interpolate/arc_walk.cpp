#include "interpolate/arc_walk.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

namespace unstep::interpolation {
namespace {

struct Vector {
  std::int64_t x;
  std::int64_t y;
};

// A quarter turn counter-clockwise: the quadrant after the first, going
// clockwise, comes back to the first.
Vector turned(Vector v) { return {-v.y, v.x}; }

// Turns until a >= 0 and b > 0.
int turns_to_first(Vector& v) {
  int turns = 0;
  while (!(v.x >= 0 && v.y > 0)) {
    v = turned(v);
    ++turns;
  }
  return turns;
}

// |sqrt(v) - sqrt(q)| <= 1 for integers: for the larger, v <= q + 1 + 2
// sqrt(q), so (v - q - 1)^2 <= 4 q.
bool within_one(Int128 v, Int128 q) {
  if (v < q) std::swap(v, q);
  const Int128 over = v - q - 1;
  return over <= 0 || (over < (Int128{1} << 40) && over * over <= 4 * q);
}

}  // namespace

std::int64_t rounded_root(std::int64_t value) {
  const auto v = static_cast<std::uint64_t>(value);
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1)
    if ((root | bit) * (root | bit) <= v) root |= bit;
  // sqrt(v) > root + 1/2 when v > root^2 + root.
  return static_cast<std::int64_t>(root + (v - root * root > root ? 1 : 0));
}

Result<ArcGeometry> check_arc(const Arc& arc) {
  if (magnitude(arc.centre.x) > kMaxCoord ||
      magnitude(arc.centre.y) > kMaxCoord)
    return Error{ErrorCode::out_of_range,
                 "arc centre (" + std::to_string(arc.centre.x) + ", " +
                     std::to_string(arc.centre.y) + ") is beyond +-" +
                     std::to_string(kMaxCoord)};
  if (arc.centre == Point{})
    return Error{ErrorCode::out_of_range,
                 "arc radius is 0: the centre (0, 0) is the start"};
  ArcGeometry g;
  g.start_x = -std::int64_t{arc.centre.x};
  g.start_y = -std::int64_t{arc.centre.y};
  g.end_x = std::int64_t{arc.end.x} - arc.centre.x;
  g.end_y = std::int64_t{arc.end.y} - arc.centre.y;
  g.radius_squared = g.start_x * g.start_x + g.start_y * g.start_y;
  g.clockwise = arc.clockwise;
  g.full = arc.end == Point{};
  const Int128 end_squared =
      Int128{g.end_x} * g.end_x + Int128{g.end_y} * g.end_y;
  if (!within_one(end_squared, g.radius_squared))
    return Error{ErrorCode::invalid_argument,
                 "arc end (" + std::to_string(arc.end.x) + ", " +
                     std::to_string(arc.end.y) +
                     ") is not on the circle: its distance from the centre "
                     "squared is more than one unit of radius off " +
                     std::to_string(g.radius_squared)};
  return g;
}

ArcWalk::ArcWalk(const ArcGeometry& arc)
    : axis_radius_(rounded_root(arc.radius_squared)),
      mirrored_(!arc.clockwise) {
  Vector start{arc.start_x, arc.start_y};
  Vector end{arc.end_x, arc.end_y};
  if (mirrored_) {
    std::swap(start.x, start.y);
    std::swap(end.x, end.y);
  }
  turns_ = turns_to_first(start);
  a_ = start.x;
  b_ = start.y;
  // An end one unit off a circle of radius 1 can be the centre; it lies in
  // the first quadrant of the walk then.
  if (end.x == 0 && end.y == 0) {
    crossings_ = 0;
  } else {
    const int end_turns = turns_to_first(end);
    crossings_ = (end_turns - turns_ + 4) % 4;
    // In the quadrant of the start, but behind it (or a full circle).
    const bool behind = a_ * end.y > b_ * end.x;
    if (arc.full || (crossings_ == 0 && behind)) crossings_ = 4;
  }
  end_a_ = end.x;
  end_b_ = end.y;
  set_target();
}

void ArcWalk::set_target() {
  if (crossings_ > 0) {
    target_a_ = axis_radius_;
    target_b_ = 0;
  } else {
    target_a_ = std::max(a_, end_a_);
    target_b_ = std::min(b_, end_b_);
  }
}

bool ArcWalk::advance() {
  while (!walked_ && left_a() == 0 && left_b() == 0) {
    if (crossings_ == 0) {
      walked_ = true;
      break;
    }
    --crossings_;
    ++turns_;
    b_ = a_;  // (R, 0) of this frame is (0, R) of the next
    a_ = 0;
    set_target();
  }
  return !walked_;
}

Point ArcWalk::to_plane(std::int64_t da, std::int64_t db) const {
  Vector v{da, db};
  // Undo the turns: three more make four.
  for (int i = turns_ % 4; i < 4; ++i) v = turned(v);
  if (mirrored_) std::swap(v.x, v.y);
  return {static_cast<std::int32_t>(v.x), static_cast<std::int32_t>(v.y)};
}

Point ArcWalk::move(std::int64_t da, std::int64_t db) {
  f_ += (2 * a_ + da) * da + (db - 2 * b_) * db;
  a_ += da;
  b_ -= db;
  return to_plane(da, -db);
}

Point ArcWalk::correct() {
  const std::int64_t da = std::clamp<std::int64_t>(end_a_ - a_, -1, 1);
  const std::int64_t db = std::clamp<std::int64_t>(end_b_ - b_, -1, 1);
  f_ += (2 * a_ + da) * da + (2 * b_ + db) * db;
  a_ += da;
  b_ += db;
  return to_plane(da, db);
}

}  // namespace unstep::interpolation
