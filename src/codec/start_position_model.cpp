#include "codec/start_position_model.h"

#include <algorithm>

namespace unstep::codec {
namespace {

constexpr std::array<StartPositionModel::Decisions::Weights, 1> make_initial() {
  StartPositionModel::Decisions::Weights weights{};
  for (std::size_t i = 0; i < 2 * StartPositionModel::kContexts; ++i) {
    weights[i] = 4096 * 14 / 10 / StartPositionModel::kContexts;
  }
  return {weights};
}
constexpr auto kInitial = make_initial();

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
  const std::uint32_t left = density.count(low, half, y);
  const std::uint32_t right = density.count(middle, half, y);
  const std::uint32_t both = left + right;
  const int share = both == 0 ? 0 : 1 + static_cast<int>(right * 14 / both);
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
       joined(2, count_class(left), count_class(right), before),
       joined(3, share, count_class(both), before), joined(4, distance, row),
       joined(5, distance, row, share),
       mix(static_cast<std::uint64_t>(low), joined(6, row))});
  return {static_cast<std::uint32_t>(level * 8 + before),
          static_cast<std::uint32_t>(share * 8 + count_class(both))};
}

}  // namespace unstep::codec
