#include "codec/turn_model.h"

#include <algorithm>
#include <bit>

#include "codec/context.h"
#include "codec/warm_start.h"

namespace unstep::codec {
namespace {

constexpr unsigned kSight = 12;  ///< how far look() sees, in points

/// How many fewer bits of slots the contexts with few values get.
constexpr std::array<int, 16> kFewer{1, 0, 0, 0, 0, 0, 0, 3,
                                     0, 0, 0, 1, 0, 0, 0, 1};

template <std::size_t kCount>
constexpr std::array<int, kCount> table_sizes(int table_bits) {
  std::array<int, kCount> bits{};
  for (std::size_t i = 0; i < kCount; ++i) bits[i] = table_bits - kFewer[i];
  return bits;
}

/// The weights that a model starts with: those of the table, and a little for
/// what it has no weights for.
template <std::size_t kInputs>
std::array<std::array<std::int16_t, kInputs>, 2> first_weights() {
  std::array<std::array<std::int16_t, kInputs>, 2> weights{};
  for (std::size_t node = 0; node < 2; ++node) {
    for (std::size_t i = 0; i < 32; ++i) {
      weights[node][i] = warm::kTurnWeights[node][i];
    }
    if constexpr (kInputs > 32) {
      for (const std::size_t i : {12U, 13U}) {
        weights[node][kInputs - 8 + i - 12] = weights[node][i];
      }
      for (std::size_t i = 12; i < 16; ++i) {
        weights[node][i] = weights[node][16 + i] = 200;
      }
    }
  }
  return weights;
}

}  // namespace

template <std::size_t kCount>
std::uint64_t MixedTurnModel<kCount>::memory(int table_bits) {
  std::uint64_t bytes = (std::uint64_t{1} << 20);  // gates, match, weights
  for (const int bits : table_sizes<kCount>(table_bits)) {
    bytes += sizeof(entropy::Slot) << bits;
  }
  return bytes;
}

template <std::size_t kCount>
MixedTurnModel<kCount>::MixedTurnModel(const CrackMap& cracks, int table_bits)
    : cracks_(cracks),
      slots_(table_sizes<kCount>(table_bits)),
      gates_(std::size_t{1} << kGateBits),
      mixer_({64, 1024, 1024}, first_weights<kInputs>()) {
  for (std::size_t i = 0; i < warm::kTurnContexts; ++i) {
    const auto slots = slots_.slots(i);
    // Index and check of a record are the upper 28 bits of the hash.
    const int shift = 28 - std::countr_zero(slots.size());
    warm::for_each(i, [&](const warm::Record& record) {
      const std::uint32_t hash =
          std::uint32_t{record.index} << 12 | record.check;
      slots[hash >> shift] = {record.p, record.n,
                              static_cast<std::uint16_t>(record.check + 1)};
    });
  }
}

template <std::size_t kCount>
void MixedTurnModel<kCount>::begin(CrackMap::Address point,
                                   CrackMap::Address flipped, bool ink) {
  direction_ = 0;
  point_ = point + cracks_.step(0);
  flipped_ = flipped + cracks_.flipped_step(0);
  ink_ = ink;
  history_ = 0;
  runs_ = 0;
  bends_ = 0;
  steps_ = 1;
  here_ = {1, 0, 0};
  trail_[0] = {0, 0, 0};
  trail_[1] = here_;
  dss_.reset();
  dss_.push(0);
}

template <std::size_t kCount>
void MixedTurnModel<kCount>::advance(Turn turn) {
  match_.push(turn);
  history_ = history_ << 2 | turn;
  if (turn == kStraight) {
    runs_ += (runs_ & 255) != 255 ? 1U : 0U;
  } else {
    runs_ <<= 8;
    bends_ = bends_ << 2 | turn;
  }
  direction_ = turned(direction_, turn);
  dss_.push(direction_);
  const auto d = static_cast<std::size_t>(direction_);
  here_.area += std::int64_t{here_.y} * kQuarterDx[d] -
                std::int64_t{here_.x} * kQuarterDy[d];
  here_.x += kQuarterDx[d];
  here_.y += kQuarterDy[d];
  point_ += cracks_.step(direction_);
  flipped_ += cracks_.flipped_step(direction_);
  ++steps_;
  trail_[steps_ % trail_.size()] = here_;
}

/// The nearest cracks parallel to the one just walked: right, left.
template <std::size_t kCount>
std::array<typename MixedTurnModel<kCount>::Sight, 2>
MixedTurnModel<kCount>::look() const {
  // The crack's bit in the plane where those beside it are its neighbours.
  const CrackMap::Address on = cracks_.crack(direction_);
  const CrackMap::Address before = point_ - cracks_.step(direction_);
  const CrackMap::Address bit = (direction_ & 1) != 0 ? before + on
                                : direction_ == 0
                                    ? flipped_ - cracks_.flipped_step(0)
                                    : flipped_;
  const std::uint64_t after = cracks_.window(bit + 1) >> (64 - kSight);
  const std::uint64_t back = cracks_.window(bit - kSight) >> (64 - kSight);
  const auto sight = [&](unsigned distance, int side) -> Sight {
    if (distance == 0) return {};
    return {distance,
            shape(point_ + static_cast<CrackMap::Address>(distance) *
                               cracks_.step((direction_ + side) & 3))};
  };
  const unsigned ahead =
      after != 0 ? kSight + 1 - static_cast<unsigned>(std::bit_width(after))
                 : 0;
  const unsigned behind =
      back != 0 ? 1 + static_cast<unsigned>(std::countr_zero(back)) : 0;
  const bool right_after = direction_ == 0 || direction_ == 3;
  return {sight(right_after ? ahead : behind, 1),
          sight(right_after ? behind : ahead, 3)};
}

template <std::size_t kCount>
unsigned MixedTurnModel<kCount>::shape(CrackMap::Address point) const {
  const CrackMap::Address on = cracks_.crack(direction_);
  const CrackMap::Address right = cracks_.crack((direction_ + 1) & 3);
  const CrackMap::Address left = cracks_.crack((direction_ + 3) & 3);
  const CrackMap::Address next = point + cracks_.step(direction_);
  return cracks_.test(point + on) << 5 | cracks_.test(point + right) << 4 |
         cracks_.test(point + left) << 3 | cracks_.test(next + on) << 2 |
         cracks_.test(next + right) << 1 | cracks_.test(next + left);
}

template <std::size_t kCount>
entropy::Counter& MixedTurnModel<kCount>::find_gate() {
  const std::uint64_t recent = history_ & 0xffffff;  // 12 turns
  const std::uint64_t hash = mix(around_ & patch::kNear, recent) * kGolden;
  gate_ = &gates_[hash >> (64 - kGateBits)];
  return *gate_;
}

/// The last n steps as a chord, in the frame of the current direction: 18 bits.
template <std::size_t kCount>
std::uint64_t MixedTurnModel<kCount>::chord(std::uint32_t n) const {
  if (steps_ < n) return 0;
  const std::int32_t dx = here_.x - trail(n).x;
  const std::int32_t dy = here_.y - trail(n).y;
  const auto d = static_cast<std::size_t>(direction_);
  const std::int32_t c = kQuarterDx[d];
  const std::int32_t s = kQuarterDy[d];
  return static_cast<std::uint64_t>((dx * c + dy * s + 128) << 9 |
                                    (dy * c - dx * s + 128));
}

/// Doubled area between the last n steps and their chord (patent's F).
template <std::size_t kCount>
unsigned MixedTurnModel<kCount>::bulge(std::uint32_t n) const {
  if (steps_ < n) return 0;
  const Trail& t = trail(n);
  const std::int64_t dx = here_.x - t.x;
  const std::int64_t dy = here_.y - t.y;
  return quantise_area(here_.area - t.area -
                       (std::int64_t{t.y} * dx - std::int64_t{t.x} * dy));
}

template <std::size_t kCount>
void MixedTurnModel<kCount>::look_around() {
  const std::uint64_t at_point = patch::ways(around_);
  const std::uint64_t base = at_point << 1 | (ink_ ? 1U : 0U);
  const auto history = [&](unsigned turns) {
    return history_ & ((std::uint64_t{1} << (2 * turns)) - 1);
  };
  const auto [right, left] = look();
  const std::uint64_t right_sight = right.distance << 6 | right.shape;
  const std::uint64_t left_sight = left.distance << 6 | left.shape;
  const std::uint64_t verdict = dss_.verdict(direction_);
  const unsigned level = match_.confidence();
  const unsigned guess = level > 0 ? match_.prediction() : 3;

  // Every value fits 60 bits, base included.
  const auto ask = [&](std::size_t i, std::uint64_t value) {
    slots_.ask(i, (value << 4 | base) * kGolden);
  };
  ask(0, history(12));
  ask(1, history(18));
  ask(2, (runs_ & 0xffff) << 4 | (bends_ & 15));
  ask(3, (around_ & patch::kNear) << 8 | history(4));
  ask(4, (around_ & patch::kAll) << 2 | history(1));
  ask(5, (left_sight << 18 | chord(16)) << 6 | history(3));
  ask(6, (right_sight << 10 | left_sight) << 6 | history(3));
  ask(7, (level << 2 | guess) << 4 | history(2));
  ask(8, std::uint64_t{runs_} & 0x7f7f7f7f);
  ask(9, (chord(32) << 8 | history(4)) << 5 | bulge(32));
  ask(10, (chord(64) << 18 | chord(8)) << 5 | bulge(64));
  ask(11,
      (verdict << 4 | std::min(dss_.previous_length(), 15U)) << 6 | history(3));
  if constexpr (kCount > 12) {
    ask(12, history(6));
    ask(13, right_sight << 12 | history(6));
    ask(14, ((around_ & patch::kNear) << 10 | right_sight) << 10 | left_sight);
    ask(15, (chord(32) << 18 | chord(16)) << 2 | history(1));
  }
  next_selectors_ = {
      std::min(right.distance, 7U) * 2 + (left.distance > 0 ? 16U : 0U),
      static_cast<std::size_t>(history(4)) * 2,
      (level * 4 + guess) * 2 + static_cast<std::size_t>(at_point) * 64};
}

template <std::size_t kCount>
int MixedTurnModel<kCount>::probability(Node node) {
  auto& inputs = mixer_.inputs(node);
  slots_.predict(node, inputs.data());
  inputs[kConstant] = 77;
  inputs[kConstant + 1] = static_cast<std::int16_t>(
      node == kBends ? entropy::stretch(gate_->p) : 0);
  const int x = mixer_.mix(
      {selectors_[0] + node, selectors_[1] + node, selectors_[2] + node}, node);
  return std::clamp(entropy::squash(x), 1, 65535);
}

template class MixedTurnModel<12>;
template class MixedTurnModel<16>;

}  // namespace unstep::codec
