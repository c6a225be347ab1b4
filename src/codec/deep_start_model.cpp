#include "codec/deep_start_model.h"

#include "codec/context.h"
#include "grid/bit_count.h"

namespace unstep::codec {
namespace {

/// An octave a level, 0..11, and half an octave, 0..20.
std::uint64_t level(std::uint64_t density) {
  return std::min<std::uint64_t>(std::bit_width(density >> 4), 11);
}
std::uint64_t fine_level(std::uint64_t density) {
  density >>= 3;
  const auto octave = static_cast<std::uint64_t>(std::bit_width(density));
  if (octave < 2) return octave;
  return std::min(2 * octave - 2 + (density >> (octave - 2) & 1),
                  std::uint64_t{20});
}

std::uint64_t count_level(std::uint64_t points) {
  return static_cast<std::uint64_t>(
      std::bit_width(static_cast<unsigned>(ones(points))));
}

/// 0..6: how many points are asked about.
std::uint64_t size_level(int points) {
  std::uint64_t size = 0;
  for (const int step : {4, 8, 16, 24, 40, 56}) size += points > step ? 1U : 0U;
  return size;
}

/// Every bit spread to its neighbours, in three words.
std::array<std::uint64_t, 3> spread(const std::array<std::uint64_t, 3>& w) {
  return {w[0] | w[0] << 1 | w[0] >> 1 | w[1] >> 63,
          w[1] | w[1] << 1 | w[1] >> 1 | w[0] << 63 | w[2] >> 63,
          w[2] | w[2] << 1 | w[2] >> 1 | w[1] << 63};
}

int share(std::uint64_t part, std::uint64_t all) {
  return entropy::stretch(static_cast<int>(
      std::clamp<std::uint64_t>(65536 * part / all, 100, 65400)));
}

}  // namespace

const DeepStartModel::Flags::Choice DeepStartModel::kFlagSizes{
    {512, 256, 512, 256}, {512, 256}, 2};
const DeepStartModel::Places::Choice DeepStartModel::kPlaceSizes{
    {128, 1024, 1024}, {128}, 2};

std::uint64_t DeepStartModel::memory(std::int32_t width) {
  const std::uint64_t words = (static_cast<std::uint64_t>(width) + 63) / 64 + 2;
  return Flags::memory(kTableBits, kFlagSizes) +
         Places::memory(kTableBits, kPlaceSizes) +
         2 * words * ((kRates + kBytes) * sizeof(std::uint32_t) + sizeof(Last));
}

DeepStartModel::DeepStartModel(const CrackMap& cracks, const warm::Table& start)
    : StartModel(cracks, start),
      cracks_(cracks),
      flags_(kTableBits, kFlagSizes),
      places_(kTableBits, kPlaceSizes) {
  const std::size_t words =
      (static_cast<std::size_t>(cracks.width()) + 63) / 64 + 2;
  for (Past& past : pasts_) {
    for (auto& densities : past.words) densities.resize(words);
    past.bytes.resize(words * kBytes);
    past.last.resize(words);
  }
}

void DeepStartModel::begin_row(std::int32_t y) {
  StartModel::begin_row(y);
  y_ = y;
  const auto decay = [](std::vector<std::uint32_t>& densities) {
    for (std::uint32_t& d : densities) d -= d >> 3;
  };
  for (Past& past : pasts_) {
    past.x = -128;
    past.rows = past.rows << 8 | std::min(past.row, 255U);
    past.row = 0;
    decay(past.words[0]);
    if (y % 8 == 0) decay(past.words[1]);
    if (y % 16 == 0) decay(past.bytes);
    if (y % 64 == 0) decay(past.words[2]);
  }
}

/// Which points of the word are near known cracks, of rows above and below.
void DeepStartModel::look_at_cracks(std::int32_t word) {
  std::array<std::uint64_t, 3> near{};
  for (std::int32_t d = 0; d <= kReach; ++d) {
    if (d > 0) near = spread(near);
    for (const std::int32_t y : {y_ - d, y_ + d}) {
      if (y > cracks_.height()) continue;
      for (std::int32_t k = 0; k < 3; ++k) {
        near[static_cast<std::size_t>(k)] |=
            cracks_.horizontal_word(y, word - 1 + k) |
            cracks_.vertical_word(y, word - 1 + k);
      }
    }
    if (d == 4) near_[0] = near[1];
    if (d == 8) near_[1] = near[1];
  }
  near_[2] = near[1];
}

void DeepStartModel::look_at_word(std::uint64_t mask, std::int32_t word,
                                  bool ink) {
  look_at_cracks(word);
  past_ = &pasts_[ink ? 1 : 0];
  at_ = static_cast<std::size_t>(word) + 1;
  colour_ = ink ? 1 : 0;
  const Last* last = &past_->last[at_];
  const std::int32_t gap = word * 64 - past_->x;
  kind_ = gap >= 128 ? 2 : gap < 64 ? 1 : 0;
  anchor_ = (kind_ == 2 ? std::countl_zero(last->bit) : past_->x) & 63;

  const std::uint64_t size = size_level(ones(mask));
  const std::uint64_t row = std::min(past_->row, 3U);
  const std::array<std::uint64_t, 3> ages{age(last[-1]), age(last[0]),
                                          age(last[1])};
  const std::uint64_t youngest = *std::min_element(ages.begin(), ages.end());
  const std::uint64_t all_ages = ages[0] << 6 | ages[1] << 3 | ages[2];
  const std::uint64_t coast = count_level(mask & near_[0]) |
                              count_level(mask & near_[1]) << 3 |
                              count_level(mask & near_[2]) << 6;
  const std::uint64_t rough =
      std::min(count_level(mask & near_[1]), std::uint64_t{3}) |
      ((mask & near_[2]) != 0 ? 4U : 0U);
  const auto& quick = past_->words[0];
  const auto& slow = past_->words[1];
  const auto& slowest = past_->words[2];
  const std::uint64_t since = std::min<std::uint64_t>(
      std::bit_width(static_cast<unsigned>(std::max(gap, 0)) / 32), 7);

  std::size_t i = 0;
  const auto ask = [&](std::uint64_t a, std::uint64_t b = 0) {
    flags_.ask_mixed(i++, mix(a << 1 | colour_, b));
  };
  ask(size | row << 3 | youngest << 5);
  ask(all_ages, size);
  ask(fine_level(wide(0)), fine_level(wide(1)));
  ask(fine_level(slow[at_]), fine_level(slowest[at_]) | size << 5);
  ask(coast, level(wide(1)));
  ask(coast, size | row << 3);
  ask(rough | fine_level(wide(1)) << 3, level(wide(2)));
  ask(rough | fine_level(wide(2)) << 3, level(wide(0)));
  ask(past_->rows & 0xffff, row);
  ask(since | youngest << 3, level(wide(1)));
  ask(at_);
  ask(coast, all_ages);
  ask(fine_level(quick[at_]),
      fine_level(quick[at_ - 1]) << 8 | fine_level(quick[at_ + 1]));
  flags_.set_extra(0, 8 * ones(mask) - 256);
  choice_.vectors = {(colour_ << 3 | size) << 5 | row << 3 | youngest,
                     level(wide(1)) * 16 + level(wide(2)), coast,
                     (colour_ * 12 + level(wide(0))) * 8 + rough};
  choice_.refined = {choice_.vectors[0], choice_.vectors[1]};
  choice_.last = colour_;
}

/// Starts among these points, with those beside them in their bytes.
std::uint32_t DeepStartModel::density(std::uint64_t points) const {
  std::uint32_t sum = 0;
  for (std::size_t k = 0; k < kBytes; ++k) {
    const auto count = static_cast<std::uint32_t>(ones(points << 8 * k >> 56));
    sum += past_->bytes[at_ * kBytes + k] * count / 8;
  }
  return sum;
}

/// 0..26: whether none, some or most of the points are near cracks.
unsigned DeepStartModel::nearness(std::uint64_t points) const {
  unsigned near = 0;
  for (const std::uint64_t within : near_) {
    const int count = ones(points & within);
    near = near * 3 + (count == 0 ? 0 : 2 * count <= ones(points) ? 1 : 2);
  }
  return near;
}

void DeepStartModel::look_at_halves(std::uint64_t before, std::uint64_t after,
                                    unsigned half, std::size_t node) {
  const auto few = static_cast<std::uint64_t>(ones(before));
  const auto later = static_cast<std::uint64_t>(ones(after));
  const std::uint64_t ratio = 16 * later / (few + later);
  const std::uint64_t near = nearness(before) * 27 + nearness(after);
  const std::uint64_t dense_before = density(before);
  const std::uint64_t dense_after = density(after);
  const auto octave = [](std::uint64_t d) {
    return std::min<std::uint64_t>(std::bit_width(d >> 3), 10);
  };
  const std::uint64_t dense = octave(dense_before) * 11 + octave(dense_after);
  const Last& last = past_->last[at_];
  const std::uint64_t where = (last.bit & before) != 0  ? 1
                              : (last.bit & after) != 0 ? 2
                                                        : 0;
  const std::uint64_t size = std::uint64_t{half} << 1 | colour_;
  const std::uint64_t place = node << 1 | colour_;

  std::size_t i = 0;
  const auto ask = [&](std::uint64_t a, std::uint64_t b) {
    places_.ask_mixed(i++, mix(a, b));
  };
  ask(place, kind_);
  ask(size, near << 5 | ratio);
  ask(half, near);
  ask(size, dense << 5 | ratio);
  ask(size, (where << 3 | age(last)) << 2 | kind_);
  ask(place, where << 3 | age(last));
  ask(place, static_cast<std::uint64_t>(anchor_) << 2 | kind_);
  ask(half, ratio << 2 | kind_);
  places_.set_extra(0, share(later, few + later));
  places_.set_extra(1, share(dense_after + 8 * later,
                             dense_before + dense_after + 8 * (few + later)));
  place_choice_.vectors = {
      half | colour_ << 6, near,
      dense * 8 + static_cast<std::size_t>(std::countr_zero(half))};
  place_choice_.refined = {place_choice_.vectors[0]};
  place_choice_.last = colour_;
}

void DeepStartModel::count(std::uint64_t bit) {
  const int place = std::countl_zero(bit);
  ++past_->row;
  past_->x = (static_cast<std::int32_t>(at_) - 1) * 64 + place;
  past_->last[at_] = {y_, bit};
  for (auto& densities : past_->words) densities[at_] += 256;
  past_->bytes[at_ * kBytes + static_cast<std::size_t>(place) / 8] += 256;
}

}  // namespace unstep::codec
