#include "codec/start_model.h"

#include <algorithm>
#include <tuple>

namespace unstep::codec {
namespace {

constexpr std::uint16_t kUnknown = 2000;  ///< of 65536: starts are rare

/// Every bit spread to its two neighbours on either side.
std::uint64_t spread(std::uint64_t left, std::uint64_t bits,
                     std::uint64_t right) {
  return bits | bits << 1 | bits << 2 | bits >> 1 | bits >> 2 | left << 63 |
         left << 62 | right >> 63 | right >> 62;
}

}  // namespace

StartModel::StartModel(const CrackMap& cracks, const warm::Table& start)
    : cracks_(cracks),
      far_((static_cast<std::size_t>(cracks.width()) + 63) / 64),
      spans_((static_cast<std::size_t>(cracks.width()) + 63) / 64),
      known_((static_cast<std::size_t>(cracks.width()) + 63) / 64 + 2),
      near_(near_first(kContexts)),
      mixer_({64}, start.start_weights) {
  static_assert(kContexts == warm::kStartContexts);
  static_assert(kFlags == warm::kFlags);
  for (auto& columns : columns_) {
    columns.resize((static_cast<std::size_t>(cracks.width()) + 63) / 64 + 2);
  }
  for (std::size_t i = 0; i < kFlags; ++i) {
    flags_[i] = {start.flags[i][0],
                 static_cast<std::uint8_t>(start.flags[i][1])};
  }
  for (entropy::Counter& counter : near_) counter.p = kUnknown;
  for (std::size_t i = 0; i < kContexts; ++i) {
    start.for_each(warm::kTurnContexts + i, [&](const warm::Record& record) {
      near_[near_first(i) + (record.index >> (16 - near_bits(i)))] = {
          record.p[0], record.n[0]};
    });
  }
}

StartModel::Candidates StartModel::candidates(std::int32_t y, std::int32_t word,
                                              std::uint64_t above,
                                              std::uint64_t used) {
  if (stale_) see(word);
  const std::uint64_t* known = &known_[static_cast<std::size_t>(word)];
  // Nothing known around: most words of most pages.
  if ((known[0] | known[1] | known[2]) == 0)
    return {0, 0, {used & ~above, used & above}};
  const std::uint64_t east = cracks_.horizontal_word(y, word);
  const std::uint64_t west = east >> 1 | cracks_.horizontal_word(y, word - 1)
                                             << 63;
  const std::uint64_t north = cracks_.vertical_word(y - 1, word);
  const std::uint64_t south = cracks_.vertical_word(y, word);
  // A start goes east and comes back from the south, so both are unknown; the
  // other two are absent, or both known (a saddle point).
  const std::uint64_t possible = used & ~east & ~south & ~(north ^ west);
  const std::uint64_t near =
      spread(CrackMap::ordered(known[0]), CrackMap::ordered(known[1]),
             CrackMap::ordered(known[2]));
  const std::uint64_t roof = cracks_.horizontal_word(y - 1, word);
  const std::uint64_t beside_left =
      north >> 1 | cracks_.vertical_word(y - 1, word - 1) << 63;
  const std::uint64_t beside_right =
      south << 1 | cracks_.vertical_word(y, word + 1) >> 63;
  const std::uint64_t likely =
      near & (north | (above & (roof | (beside_left & beside_right))));
  return {possible & near & ~likely,
          possible & likely,
          {possible & ~near & ~above, possible & ~near & above}};
}

void StartModel::begin_row(std::int32_t y) {
  y_ = y;
  far_.begin_row(y);
  spans_.begin_row(y);
  span_end_ = 0;
  see(0);
  row_last_.fill(-128);
  for (std::size_t i = 0; i < 2; ++i) {
    recent_[i] =
        recent_[i] - recent_[i] / 4 + std::min(row_starts_[i], 64U) * 16;
    row_starts_[i] = 0;
  }
  row_near_ = 0;
}

void StartModel::see(std::int32_t word) {
  cracks_.known_around(
      y_, word - 1, std::span(known_).subspan(static_cast<std::size_t>(word)));
  stale_ = false;
}

bool StartModel::is_quiet_span(std::int32_t word,
                               const std::vector<std::uint64_t>& above) {
  constexpr auto kWords = static_cast<std::size_t>(QuietSpanModel::kWords);
  const auto first = static_cast<std::size_t>(word);
  if (first % kWords != 0 || above.size() < QuietSpanModel::kNarrow ||
      cracks_.width() < (word + QuietSpanModel::kWords) * 64) {
    return false;
  }
  if (stale_) see(word);
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < kWords + 2; ++i) seen |= known_[first + i];
  const std::uint64_t colour = above[first];
  for (std::size_t i = 1; i < kWords; ++i) seen |= above[first + i] ^ colour;
  return seen == 0 && colour + 1 < 2;
}

int StartModel::predict_open(std::uint64_t mask, std::int32_t word, bool ink) {
  const std::size_t i = ink ? 1 : 0;
  const int count = ones(mask);
  const unsigned r = recent_[i];
  const std::size_t recent = r > 64 ? 3 : r > 16 ? 2 : r > 3 ? 1 : 0;
  const Column* here = &columns_[i][static_cast<std::size_t>(word) + 1];
  const FarFlagModel::Sight sight{
      ink,
      count > 40   ? 3U
      : count > 16 ? 2U
      : count > 5  ? 1U
                   : 0U,
      std::min(row_starts_[i], 3U),
      {age_level(here[-1]), age_level(here[0]), age_level(here[1])}};
  const std::size_t age =
      *std::min_element(sight.ages.begin(), sight.ages.end());
  const std::size_t context =
      (((i * 4 + sight.size) * 4 + sight.row) * 4 + recent) * 8 + age;
  return far_.predict(flags_[context], static_cast<std::size_t>(word), sight);
}

std::size_t StartModel::group_context(std::uint64_t mask, std::uint64_t above,
                                      std::int32_t x, std::int32_t y) const {
  const std::size_t size = std::min<std::size_t>(
      std::bit_width(static_cast<unsigned>(ones(mask & ~above))), 7);
  const std::size_t inner = std::min<std::size_t>(
      std::bit_width(static_cast<unsigned>(ones(mask & above))), 4);
  const std::uint64_t roof = cracks_.horizontal_word(y - 1, x / 64);
  return kOpenFlags + ((size * 5 + inner) * 3 + std::min(row_near_, 2U)) * 2 +
         ((mask & roof) != 0 ? 1U : 0U);
}

void StartModel::predict_near(std::int32_t x, std::int32_t y, bool ink) {
  const CrackMap::Address at = cracks_.at(x, y);
  const CrackMap::Address stride = cracks_.stride();
  const CrackMap::Address vertical = cracks_.vertical();
  const auto bits = [&](CrackMap::Address first) {
    return cracks_.window(first - 3) >> 56;
  };
  const std::uint64_t row = bits(at);
  const std::uint64_t north = bits(at + vertical - stride);
  const std::uint64_t south = bits(at + vertical);
  const std::uint64_t above = bits(at - stride);
  const std::uint64_t below = bits(at + stride);
  const std::uint64_t higher = bits(at - 2 * stride);
  const std::uint64_t tight = (row >> 2 & 7) | (north >> 2 & 7) << 3 |
                              (south >> 2 & 7) << 6 | (above >> 3 & 7) << 9 |
                              (below >> 3 & 7) << 12 | std::uint64_t{ink} << 15;
  const std::uint64_t mid = (row >> 1 & 31) | (north >> 1 & 31) << 5 |
                            (south >> 1 & 31) << 10 | (above >> 2 & 15) << 15 |
                            (below >> 2 & 15) << 19 | (higher >> 2 & 15) << 23 |
                            std::uint64_t{ink} << 27;
  const std::uint64_t full = row | north << 8 | south << 16 | above << 24 |
                             below << 32 | higher << 40 |
                             std::uint64_t{ink} << 48;
  const auto slot = [&](std::size_t i, std::uint64_t value) {
    const std::uint64_t hash = (value + 1) * 0x9e3779b97f4a7c15ULL;
    active_[i] = &near_[near_first(i) + (hash >> (64 - near_bits(i)))];
  };
  active_[0] = &near_[tight];
  slot(1, mid);
  slot(2, full);
}

int StartModel::probability() {
  auto& inputs = mixer_.inputs();
  for (std::size_t i = 0; i < kContexts; ++i) {
    inputs[i] = static_cast<std::int16_t>(entropy::stretch(active_[i]->p));
  }
  const std::size_t ages =
      std::min<std::size_t>(std::bit_width(unsigned{active_[1]->n}), 7) * 8 +
      std::min<std::size_t>(std::bit_width(unsigned{active_[2]->n}), 7);
  const int x = mixer_.mix({ages});
  return std::clamp(entropy::squash(x), 4, 65532);
}

void StartModel::update_near(bool bit) {
  mixer_.update(bit);
  for (entropy::Counter* counter : active_) counter->update(bit);
}

}  // namespace unstep::codec
