#include "codec/start_position_model.h"

#include <algorithm>

namespace unstep::codec {
namespace {

/// What the weights came to, on the average, over the images that coder 24's
/// table was learned from; 12 fractional bits.
constexpr std::array<StartPositionModel::Decisions::Weights, 1> kInitial{
    {{45, -280, 312,  -429, 330, -9,  101, 49,  483, 24,  280,
      87, 634,  -251, 301,  105, 273, 370, 165, -40, -177}}};

/// What is left and right of the middle of a range.
struct Halves {
  std::uint32_t left = 0;
  std::uint32_t right = 0;

  Halves(const DensityGrid& density, std::int64_t low, std::int64_t half,
         std::int64_t y)
      : left(density.count(low, half, y)),
        right(density.count(low + half, half, y)) {}
  [[nodiscard]] std::uint32_t both() const { return left + right; }
  /// 0 of nothing, else 1..15.
  [[nodiscard]] int share() const {
    return both() == 0 ? 0 : 1 + static_cast<int>(right * 14 / both());
  }
};

int count_class(std::uint32_t count) {
  return std::min(7, static_cast<int>(std::bit_width(count)));
}

}  // namespace

StartPositionModel::StartPositionModel(int table_bits)
    : decisions_(table_bits, kInitial) {}

std::array<std::uint32_t, 2> StartPositionModel::set_contexts(
    const DensityGrid& density, std::int64_t low, int level, std::int64_t y,
    bool same_row) {
  const std::int64_t half = std::int64_t{1} << (level - 1);
  const std::int64_t middle = low + half;
  const Halves points(density, low, half, y);
  const Halves starts(starts_, low, half, y);
  // Where the start before lies, if in the same row.
  const int before = !same_row                   ? 0
                     : before_.x < low           ? 1
                     : before_.x < middle        ? 2
                     : before_.x < middle + half ? 3
                                                 : 4;
  const std::int64_t unit = std::max<std::int64_t>(half / 8, 1);
  const int distance = static_cast<int>(
      std::clamp<std::int64_t>((before_.x - middle) / unit, -20, 20));
  const int row = same_row ? 1 : 0;
  decisions_.set_contexts(
      {joined(0), joined(1, before),
       joined(2, count_class(points.left), count_class(points.right), before),
       joined(3, points.share(), count_class(points.both()), before),
       joined(4, distance, row), joined(5, distance, row, points.share()),
       mix(static_cast<std::uint64_t>(low), joined(6, row)),
       joined(7, count_class(starts.left), count_class(starts.right), before),
       joined(8, starts.share(), points.share(), before),
       joined(9, starts.share(), count_class(starts.both()), distance)});
  return {static_cast<std::uint32_t>(level * 8 + before),
          static_cast<std::uint32_t>(points.share() * 8 +
                                     count_class(points.both()))};
}

}  // namespace unstep::codec
