#include "reverse/near_directions.h"

#include <algorithm>

namespace unstep::reverse {
namespace {

using Vector = Cone::Vector;

constexpr int kQuadrantBits = 14;

Vector turned_back(Vector v) { return {v.y, -v.x}; }
Vector turned(Vector v) { return {-v.y, v.x}; }

/// Turns a vector other than 0 into x > 0, y >= 0; the number of quarters.
unsigned into_first_quadrant(Vector& v) {
  unsigned quarters = 0;
  while (v.x <= 0 || v.y < 0) {
    v = turned_back(v);
    ++quarters;
  }
  return quarters;
}

/// Of a vector in the first quadrant. Vectors of near points are shorter than
/// 2^25, so different slopes differ by 2^-50 of themselves and more: their
/// order and equality survive the rounding.
double slope(Vector v) {
  return static_cast<double>(v.y) / static_cast<double>(v.x);
}

std::int32_t square(Point p) { return p.x * p.x + p.y * p.y; }

}  // namespace

struct NearDirections::Near {
  Point at;
  Entry entry;
  std::array<Range, 4> waiting;
};

namespace {

/// A direction and where its place in the order is to be written.
struct Sought {
  double slope = 0;
  Vector vector;
  unsigned quarters = 0;
  std::uint16_t* place = nullptr;
};

}  // namespace

NearDirections::NearDirections(PathTolerance tolerance)
    : back_(tolerance),
      near2_(static_cast<std::int32_t>(Cone::square_below(tolerance))) {
  constexpr std::int32_t kReach = kRow / 2 - 2;
  std::vector<Near> points;
  for (std::int32_t y = 0; y <= kReach; ++y) {
    for (std::int32_t x = 1; x <= kReach; ++x)
      points.push_back({{x, y}, {}, {}});
  }
  std::vector<Sought> sought;
  sought.reserve(points.size() * 11);
  const auto seek = [&sought](Vector v, std::uint16_t& place) {
    const unsigned quarters = into_first_quadrant(v);
    sought.push_back({slope(v), v, quarters, &place});
  };
  for (Near& near : points) {
    const std::int32_t r2 = square(near.at);
    near.entry.r2 = static_cast<std::uint16_t>(r2);
    seek({near.at.x, near.at.y}, near.entry.direction);
    const auto seek_sides = [&](std::int64_t across, std::uint16_t& left,
                                std::uint16_t& right) {
      // Nearer points have none, and are not asked for them.
      if (across * across > std::int64_t{r2} << Cone::kFraction2) return;
      const Cone::Sides sides = Cone::sides_of(near.at, across);
      seek(sides.left, left);
      seek(sides.right, right);
    };
    seek_sides(tolerance.fixed, near.entry.left, near.entry.right);
    for (int n = 1; n <= 4; ++n) {
      Range& range = near.waiting[static_cast<std::size_t>(n - 1)];
      seek_sides(back_.across(n), range.left, range.right);
    }
  }
  std::ranges::sort(sought, {}, &Sought::slope);
  for (std::size_t i = 0; i < sought.size(); ++i) {
    const Sought& s = sought[i];
    if (i == 0 || s.slope != sought[i - 1].slope) vectors_.push_back(s.vector);
    *s.place = static_cast<std::uint16_t>((s.quarters << kQuadrantBits) +
                                          vectors_.size() - 1);
  }
  for (std::int32_t r2 = 0; r2 <= near2_; ++r2) {
    std::int32_t& held = held_[static_cast<std::size_t>(r2)];
    held = near2_;
    while (back_.holds_all(held + 1, r2)) ++held;
  }
  entries_[kApex].r2 = 0;
  for (const Near& near : points) enter(near);
}

void NearDirections::enter(const Near& near) {
  Entry entry = near.entry;
  std::array<Range, 4> waiting = near.waiting;
  Point at = near.at;
  const auto turn = [](std::uint16_t& direction) {
    direction = static_cast<std::uint16_t>(direction + (1U << kQuadrantBits));
  };
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto place = static_cast<std::size_t>(place_of(at));
    entries_[place] = entry;
    waiting_[place] = waiting;
    at = {-at.y, at.x};
    turn(entry.direction);
    turn(entry.left);
    turn(entry.right);
    for (Range& range : waiting) {
      turn(range.left);
      turn(range.right);
    }
  }
}

Cone::Vector NearDirections::vector_of(std::uint16_t direction) const {
  Vector v = vectors_[direction & ((1U << kQuadrantBits) - 1)];
  for (unsigned i = direction >> kQuadrantBits; i > 0; --i) v = turned(v);
  return v;
}

}  // namespace unstep::reverse
