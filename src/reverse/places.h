#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "unstep/grid.h"

namespace unstep::reverse {

/// A rectangle of path units: its sides belong to it.
struct Box {
  std::int32_t low_x = 0;
  std::int32_t high_x = 0;
  std::int32_t low_y = 0;
  std::int32_t high_y = 0;

  static Box around(Point a, Point b) {
    return {std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y),
            std::max(a.y, b.y)};
  }
  void add(const Box& other) {
    low_x = std::min(low_x, other.low_x);
    high_x = std::max(high_x, other.high_x);
    low_y = std::min(low_y, other.low_y);
    high_y = std::max(high_y, other.high_y);
  }
  [[nodiscard]] Box grown(std::int32_t by) const {
    return {low_x - by, high_x + by, low_y - by, high_y + by};
  }
  /// Without branches: which side is free is different each time.
  [[nodiscard]] bool meets(const Box& other) const {
    return (static_cast<int>(high_x >= other.low_x) &
            static_cast<int>(other.high_x >= low_x) &
            static_cast<int>(high_y >= other.low_y) &
            static_cast<int>(other.high_y >= low_y)) != 0;
  }
};

/// All there is.
inline constexpr Box kEverywhere{-kMaxCoord, kMaxCoord, -kMaxCoord, kMaxCoord};

/// Some places, as the cells of a grid that they reach.
class Places {
 public:
  explicit Places(std::span<const Box> places) : box_(places.front()) {
    for (const Box& place : places) box_.add(place);
    all_ = places.size() == 1;
    if (all_) return;
    const auto most = static_cast<std::int64_t>(64 * places.size());
    while (column(box_.high_x) >= most / (row(box_.high_y) + 1)) ++shift_;
    columns_ = column(box_.high_x) + 1;
    marks_.resize(static_cast<std::size_t>(columns_ * (row(box_.high_y) + 1)));
    for (const Box& place : places) {
      for_cells(place, [this](std::size_t cell) {
        marks_[cell] = 1;
        return false;
      });
    }
  }

  /// True if the box reaches one, perhaps if it is near one.
  [[nodiscard]] bool meets(const Box& box) const {
    if (!box_.meets(box)) return false;
    return all_ || for_cells(box, [this](std::size_t cell) {
             return marks_[cell] != 0;
           });
  }

 private:
  [[nodiscard]] std::int64_t column(std::int64_t x) const {
    return (x - box_.low_x) >> shift_;
  }
  [[nodiscard]] std::int64_t row(std::int64_t y) const {
    return (y - box_.low_y) >> shift_;
  }

  /// Until `visit` says true; then true.
  template <class Visit>
  bool for_cells(const Box& box, const Visit& visit) const {
    const std::int64_t left = column(std::max(box.low_x, box_.low_x));
    const std::int64_t right = column(std::min(box.high_x, box_.high_x));
    const std::int64_t last = row(std::min(box.high_y, box_.high_y));
    for (std::int64_t r = row(std::max(box.low_y, box_.low_y)); r <= last; ++r)
      for (std::int64_t c = left; c <= right; ++c)
        if (visit(static_cast<std::size_t>(r * columns_ + c))) return true;
    return false;
  }

  Box box_;
  bool all_ = false;
  int shift_ = 2;
  std::int64_t columns_ = 1;
  std::vector<std::uint8_t> marks_;
};

}  // namespace unstep::reverse
