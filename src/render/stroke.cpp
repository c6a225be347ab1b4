#include "render/stroke.h"

#include <algorithm>
#include <utility>

namespace unstep::render {
namespace {

__extension__ using Unsigned = unsigned __int128;

/// A product of 256 bits.
struct Product {
  Unsigned high;
  Unsigned low;
  friend auto operator<=>(const Product&, const Product&) = default;
};

Product product(Unsigned a, Unsigned b) {
  constexpr auto half = [](Unsigned v) { return v & ~std::uint64_t{0}; };
  const Unsigned low = half(a) * half(b);
  const Unsigned one = (a >> 64) * half(b) + (low >> 64);
  const Unsigned two = half(a) * (b >> 64) + half(one);
  return {(a >> 64) * (b >> 64) + (one >> 64) + (two >> 64),
          two << 64 | half(low)};
}

/// A line with round ends. Points that are asked about are within its box, so
/// that all differences are below 2^45, products below 2^91.
class Capsule {
 public:
  Capsule(Place from, Place to, std::int64_t radius)
      : from_(from),
        to_(to),
        direction_{to.x - from.x, to.y - from.y},
        square_(Wide{direction_.x} * direction_.x +
                Wide{direction_.y} * direction_.y),
        radius_square_(Wide{radius} * radius),
        limit_(product(static_cast<Unsigned>(radius_square_),
                       static_cast<Unsigned>(square_))) {}

  [[nodiscard]] bool holds(Place p) const {
    const Place d{p.x - from_.x, p.y - from_.y};
    const Wide along = Wide{d.x} * direction_.x + Wide{d.y} * direction_.y;
    if (along <= 0) return near(d);
    if (along >= square_) return near({p.x - to_.x, p.y - to_.y});
    const Wide across = Wide{d.x} * direction_.y - Wide{d.y} * direction_.x;
    const auto distance = static_cast<Unsigned>(across < 0 ? -across : across);
    return product(distance, distance) <= limit_;
  }

  /// An x of the row y with the least distance from the line.
  [[nodiscard]] std::int64_t nearest_x(std::int64_t y) const {
    const bool down = from_.y < to_.y;
    const Place& top = down ? from_ : to_;
    const Place& bottom = down ? to_ : from_;
    if (y <= top.y) return top.x;
    if (y >= bottom.y) return bottom.x;
    return top.x +
           floor_div(Wide{bottom.x - top.x} * (y - top.y), bottom.y - top.y);
  }

 private:
  [[nodiscard]] bool near(Place d) const {
    return Wide{d.x} * d.x + Wide{d.y} * d.y <= radius_square_;
  }

  Place from_;
  Place to_;
  Place direction_;
  Wide square_;
  Wide radius_square_;
  Product limit_;
};

/// Pixels first..last of a row. REQUIRES: inside the raster.
void ink_run(std::span<std::uint64_t> row, std::int64_t first,
             std::int64_t last) {
  const auto word = [](std::int64_t x) {
    return static_cast<std::size_t>(x / 64);
  };
  const std::uint64_t head = ~std::uint64_t{0} >> (first % 64);
  const std::uint64_t tail = ~std::uint64_t{0} << (63 - last % 64);
  if (word(first) == word(last)) {
    row[word(first)] |= head & tail;
    return;
  }
  row[word(first)] |= head;
  for (std::size_t i = word(first) + 1; i < word(last); ++i)
    row[i] = ~std::uint64_t{0};
  row[word(last)] |= tail;
}

/// The last of inside, inside + step, ... before `end` that is held, if all of
/// them up to one are. REQUIRES: inside is held.
template <class Holds>
std::int64_t last_held(std::int64_t inside, std::int64_t end, Holds holds) {
  const std::int64_t step = end < inside ? -1 : 1;
  std::int64_t held = 0;
  std::int64_t count = (end - inside) * step;
  while (count - held > 1) {
    const std::int64_t middle = held + (count - held) / 2;
    (holds(inside + step * middle) ? held : count) = middle;
  }
  return inside + step * held;
}

}  // namespace

void ink_stroke(Place from, Place to, std::int64_t radius, const SubGrid& grid,
                Bitmap& pixels) {
  const std::int64_t unit = grid.per_grid_unit;
  const auto first_index = [&](std::int64_t a, std::int64_t b) {
    return std::max<std::int64_t>(floor_div(std::min(a, b) - radius, unit), 0);
  };
  const auto last_index = [&](std::int64_t a, std::int64_t b,
                              std::int32_t size) {
    return std::min<std::int64_t>(floor_div(std::max(a, b) + radius, unit),
                                  size - 1);
  };
  const std::int64_t left = first_index(from.x, to.x);
  const std::int64_t right = last_index(from.x, to.x, pixels.width());
  const std::int64_t top = first_index(from.y, to.y);
  const std::int64_t bottom = last_index(from.y, to.y, pixels.height());
  if (left > right) return;

  const Capsule capsule(from, to, radius);
  for (std::int64_t y = top; y <= bottom; ++y) {
    const std::int64_t centre_y = y * unit + unit / 2;
    const auto holds = [&](std::int64_t x) {
      return capsule.holds({x * unit + unit / 2, centre_y});
    };
    // Distance along the row falls to the nearest x and then rises, so the
    // pixels on its two sides decide whether there are any.
    const std::int64_t x =
        floor_div(capsule.nearest_x(centre_y) - unit / 2, unit);
    std::int64_t inside = std::clamp(x, left, right);
    if (!holds(inside)) {
      inside = std::clamp(x + 1, left, right);
      if (!holds(inside)) continue;
    }
    ink_run(pixels.row(static_cast<std::int32_t>(y)),
            last_held(inside, left - 1, holds),
            last_held(inside, right + 1, holds));
  }
}

}  // namespace unstep::render
