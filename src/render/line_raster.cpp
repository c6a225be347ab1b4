#include "render/line_raster.h"

#include <algorithm>
#include <utility>

namespace unstep::render {
namespace {

/// Where a line crosses one coordinate line of the grid after another:
/// ceil((y - unit / 2) / unit) for x = first, first + unit, ... Divisions only
/// at the start.
///
/// Range: dx and dy are below 2^44 (a chord of an arc), unit at most 2^21 where
/// vertices are below 2^31, else 2^10: their product is below 2^54. The
/// products at the start are below 2^90.
class Crossings {
 public:
  /// REQUIRES: from.x < to.x.
  Crossings(Place from, Place to, std::int64_t first, std::int64_t unit) {
    const std::int64_t dx = to.x - from.x;
    const std::int64_t dy = to.y - from.y;
    whole_ = floor_div(dy, dx);
    part_ = (dy - whole_ * dx) * unit;
    divisor_ = dx * unit;
    const Wide sum = Wide{from.y - unit / 2} * dx + Wide{first - from.x} * dy;
    at_ = ceil_div(sum, divisor_);
    short_of_ = static_cast<std::int64_t>(Wide{at_} * divisor_ - sum);
  }

  [[nodiscard]] std::int64_t at() const { return at_; }

  void next() {
    at_ += whole_;
    short_of_ -= part_;
    if (short_of_ >= 0) return;
    short_of_ += divisor_;
    ++at_;
  }

 private:
  std::int64_t at_;
  std::int64_t short_of_;  // of at_, in 1 / divisor_: 0..divisor_ - 1
  std::int64_t whole_;
  std::int64_t part_;
  std::int64_t divisor_;
};

Place transposed(Place p) { return {p.y, p.x}; }

std::int64_t nearest(std::int64_t at, std::int64_t unit) {
  return ceil_div(at - unit / 2, unit);
}

}  // namespace

void flip_crossings(Place from, Place to, const SubGrid& grid, Bitmap& pixels) {
  const std::int64_t unit = grid.per_grid_unit;
  const std::int64_t half = unit / 2;
  if (from.y > to.y) std::swap(from, to);
  const std::int64_t first =
      std::max<std::int64_t>(ceil_div(from.y - half, unit), 0);
  const std::int64_t end =
      std::min<std::int64_t>(ceil_div(to.y - half, unit), pixels.height());
  if (first >= end) return;
  if (std::min(from.x, to.x) > pixels.width() * unit) return;
  Crossings crossing(transposed(from), transposed(to), first * unit + half,
                     unit);
  for (std::int64_t y = first; y < end; ++y, crossing.next()) {
    const std::int64_t x = std::max<std::int64_t>(crossing.at(), 0);
    if (x >= pixels.width()) continue;
    const auto column = static_cast<std::int32_t>(x);
    const auto row = static_cast<std::int32_t>(y);
    pixels.set(column, row, !pixels.get(column, row));
  }
}

void ink_hairline(Place from, Place to, const SubGrid& grid, Bitmap& pixels) {
  const std::int64_t unit = grid.per_grid_unit;
  const bool steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
  if (steep) {
    from = transposed(from);
    to = transposed(to);
  }
  if (from.x > to.x) std::swap(from, to);
  const std::int64_t along = steep ? pixels.height() : pixels.width();
  const std::int64_t across = steep ? pixels.width() : pixels.height();
  const std::int64_t first = std::max<std::int64_t>(nearest(from.x, unit), 0);
  const std::int64_t last =
      std::min<std::int64_t>(nearest(to.x, unit), along - 1);
  if (first > last) return;
  if (from.x == to.x) to.x = from.x + unit;  // a point, as a level line
  Crossings crossing(from, to, first * unit, unit);
  for (std::int64_t x = first; x <= last; ++x, crossing.next()) {
    const std::int64_t y = crossing.at();
    if (y < 0 || y >= across) continue;
    const auto a = static_cast<std::int32_t>(x);
    const auto b = static_cast<std::int32_t>(y);
    pixels.set(steep ? b : a, steep ? a : b, true);
  }
}

}  // namespace unstep::render
