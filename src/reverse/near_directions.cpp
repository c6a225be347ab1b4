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

/// Both in the first quadrant; sides of near points are shorter than 2^25.
bool is_before(Vector a, Vector b) { return a.x * b.y > a.y * b.x; }
bool is_same(Vector a, Vector b) { return a.x * b.y == a.y * b.x; }

}  // namespace

NearDirections::NearDirections(PathTolerance tolerance)
    : near2_(static_cast<std::int32_t>(Cone::square_below(tolerance))) {
  constexpr std::int32_t kReach = kRow / 2 - 2;
  struct Near {
    Point at;
    Cone::Sides sides;
  };
  std::vector<Near> points;
  for (std::int32_t y = 0; y <= kReach; ++y) {
    for (std::int32_t x = 1; x <= kReach; ++x) {
      Near near{{x, y}, {}};
      if (x * x + y * y > near2_)
        near.sides = Cone::sides_of(near.at, tolerance);
      points.push_back(near);
    }
  }
  const auto add = [this](Vector v) {
    (void)into_first_quadrant(v);
    vectors_.push_back(v);
  };
  for (const Near& near : points) {
    add({near.at.x, near.at.y});
    if (near.at.x * near.at.x + near.at.y * near.at.y <= near2_) continue;
    add(near.sides.left);
    add(near.sides.right);
  }
  std::sort(vectors_.begin(), vectors_.end(), is_before);
  vectors_.erase(std::unique(vectors_.begin(), vectors_.end(), is_same),
                 vectors_.end());
  entries_[kApex].r2 = 0;
  for (const Near& near : points) {
    const std::int32_t r2 = near.at.x * near.at.x + near.at.y * near.at.y;
    Entry entry;
    entry.r2 = static_cast<std::uint16_t>(r2);
    entry.direction = find({near.at.x, near.at.y});
    if (r2 > near2_) {
      entry.left = find(near.sides.left);
      entry.right = find(near.sides.right);
    }
    Point at = near.at;
    for (int quarter = 0; quarter < 4; ++quarter) {
      entries_[static_cast<std::size_t>(place_of(at))] = entry;
      at = {-at.y, at.x};
      for (std::uint16_t* place :
           {&entry.direction, &entry.left, &entry.right}) {
        *place = static_cast<std::uint16_t>(*place + (1U << kQuadrantBits));
      }
    }
  }
}

std::uint16_t NearDirections::find(Cone::Vector vector) const {
  const unsigned quarters = into_first_quadrant(vector);
  const auto found =
      std::lower_bound(vectors_.begin(), vectors_.end(), vector, is_before);
  return static_cast<std::uint16_t>(
      (quarters << kQuadrantBits) +
      static_cast<unsigned>(found - vectors_.begin()));
}

Cone::Vector NearDirections::vector_of(std::uint16_t direction) const {
  Vector v = vectors_[direction & ((1U << kQuadrantBits) - 1)];
  for (unsigned i = direction >> kQuadrantBits; i > 0; --i) v = turned(v);
  return v;
}

}  // namespace unstep::reverse
