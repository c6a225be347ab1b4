#include "reverse/near_directions.h"

#include <algorithm>
#include <utility>

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
  Cone::Sides disc;  ///< if it has not the apex
  std::array<Cone::Sides, 4> waiting;
};

NearDirections::NearDirections(PathTolerance tolerance)
    : back_(tolerance),
      near2_(static_cast<std::int32_t>(Cone::square_below(tolerance))) {
  constexpr std::int32_t kReach = kRow / 2 - 2;
  std::vector<Near> points;
  for (std::int32_t y = 0; y <= kReach; ++y) {
    for (std::int32_t x = 1; x <= kReach; ++x) {
      Near near{{x, y}, {{x, y}, {x, y}}, {}};
      const auto sides = [&near](std::int64_t across) {
        const std::int64_t r2 = std::int64_t{square(near.at)}
                                << Cone::kFraction2;
        return across * across <= r2 ? Cone::sides_of(near.at, across)
                                     : near.disc;
      };
      near.disc = sides(tolerance.fixed);
      for (int n = 1; n <= 4; ++n) {
        near.waiting[static_cast<std::size_t>(n - 1)] = sides(back_.across(n));
      }
      points.push_back(near);
    }
  }
  std::vector<std::pair<double, Vector>> found;
  const auto add = [&found](const Cone::Sides& sides) {
    for (Vector v : {sides.left, sides.right}) {
      (void)into_first_quadrant(v);
      found.emplace_back(slope(v), v);
    }
  };
  for (const Near& near : points) {
    add({{near.at.x, near.at.y}, {near.at.x, near.at.y}});
    add(near.disc);
    for (const Cone::Sides& sides : near.waiting) add(sides);
  }
  std::ranges::sort(found, {}, &std::pair<double, Vector>::first);
  for (const auto& [steep, vector] : found) {
    if (!slopes_.empty() && slopes_.back() == steep) continue;
    slopes_.push_back(steep);
    vectors_.push_back(vector);
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
  Entry entry{find({near.at.x, near.at.y}), find(near.disc.left),
              find(near.disc.right),
              static_cast<std::uint16_t>(square(near.at))};
  std::array<Range, 4> waiting;
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    waiting[i] = {find(near.waiting[i].left), find(near.waiting[i].right)};
  }
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

std::uint16_t NearDirections::find(Cone::Vector vector) const {
  const unsigned quarters = into_first_quadrant(vector);
  const auto found = std::ranges::lower_bound(slopes_, slope(vector));
  return static_cast<std::uint16_t>(
      (quarters << kQuadrantBits) +
      static_cast<unsigned>(found - slopes_.begin()));
}

Cone::Vector NearDirections::vector_of(std::uint16_t direction) const {
  Vector v = vectors_[direction & ((1U << kQuadrantBits) - 1)];
  for (unsigned i = direction >> kQuadrantBits; i > 0; --i) v = turned(v);
  return v;
}

}  // namespace unstep::reverse
