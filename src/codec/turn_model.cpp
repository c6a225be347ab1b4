#include "codec/turn_model.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "codec/context.h"

namespace unstep::codec {
namespace {

constexpr unsigned kFar = 40;  ///< how far gaps() sees, in points
constexpr int kSight = 12;     ///< and look()

/// log2 of the contexts of the refiners, without the decision.
constexpr int kTurnRefinerBits = 12;
constexpr int kNearRefinerBits = 11;

/// The contexts of all views, in the order of the table: how many fewer bits of
/// slots they get, for some have few values.
constexpr std::array<int, 15> kFewer{1, 0, 0, 0, 0, 0, 0, 3,
                                     0, 0, 0, 1, 2, 0, 0};
/// Those that the light model has.
constexpr std::array<std::size_t, 7> kFew{2, 4, 6, 7, 9, 10, 11};

/// Which context of all views is the model's i-th.
template <class Model>
constexpr std::size_t view(std::size_t i) {
  return Model::kAll ? i : kFew[i];
}

template <class Model>
std::array<int, Model::kContexts> table_sizes(int table_bits) {
  std::array<int, Model::kContexts> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i)
    bits[i] = table_bits - kFewer[view<Model>(i)];
  return bits;
}

/// The weights of the table for the inputs that the model has.
template <class Model>
std::array<std::array<std::int16_t, Model::kInputs>, 2> first_weights(
    const warm::Table& start) {
  constexpr std::size_t kFrom = entropy::ContextSlots<15>::kLanes;
  constexpr std::size_t kTo = Model::Slots::kLanes;
  std::array<std::array<std::int16_t, Model::kInputs>, 2> weights{};
  for (std::size_t node = 0; node < 2; ++node) {
    const auto& from = start.turn_weights[node];
    for (std::size_t i = 0; i < Model::kContexts; ++i) {
      weights[node][i] = from[view<Model>(i)];
      weights[node][kTo + i] = from[kFrom + view<Model>(i)];
    }
    weights[node][Model::kGateInput] = from[warm::kTurnContexts];
  }
  return weights;
}

template <class Model>
std::array<std::size_t, Model::kSets> set_sizes() {
  if constexpr (Model::kAll) {
    return {64, 1024, 1024, 1024};
  } else {
    return {64, 1024, 1024};
  }
}

template <class Model>
std::array<entropy::Refiner, Model::kRefiners> make_refiners() {
  entropy::Refiner near(std::size_t{2} << kNearRefinerBits);
  if constexpr (Model::kAll) {
    return {near, entropy::Refiner(std::size_t{2} << kTurnRefinerBits)};
  } else {
    return {near};
  }
}

}  // namespace

template <TurnViews kViews>
std::uint64_t MixedTurnModel<kViews>::memory(int table_bits) {
  std::uint64_t bytes = std::uint64_t{2} << 20;  // gates, match, weights ...
  for (const int bits : table_sizes<MixedTurnModel>(table_bits)) {
    bytes += sizeof(entropy::Slot) << bits;
  }
  return bytes;
}

template <TurnViews kViews>
MixedTurnModel<kViews>::MixedTurnModel(const CrackMap& cracks, int table_bits,
                                       const warm::Table& start)
    : cracks_(cracks),
      slots_(table_sizes<MixedTurnModel>(table_bits)),
      gates_(std::size_t{1} << kGateBits),
      mixer_(set_sizes<MixedTurnModel>(), first_weights<MixedTurnModel>(start)),
      refiners_(make_refiners<MixedTurnModel>()) {
  for (std::size_t i = 0; i < kContexts; ++i) {
    const auto slots = slots_.slots(i);
    // Index and check of a record are the upper 28 bits of the hash.
    const int shift = 28 - std::countr_zero(slots.size());
    start.for_each(view<MixedTurnModel>(i), [&](const warm::Record& record) {
      const std::uint32_t hash =
          std::uint32_t{record.index} << 12 | record.check;
      slots[hash >> shift] = {record.p, record.n,
                              static_cast<std::uint16_t>(record.check + 1)};
    });
  }
}

template <TurnViews kViews>
void MixedTurnModel<kViews>::begin(CrackMap::Address point,
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
  curve_.begin();
  gaps_ = gaps(point, flipped, 0);
  if constexpr (kAll) curve_.step(0, 1, 0, gaps_);
}

template <TurnViews kViews>
void MixedTurnModel<kViews>::advance(Turn turn) {
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
  gaps_ = gaps(point_, flipped_, direction_);
  if constexpr (kAll) curve_.step(direction_, here_.x, here_.y, gaps_);
  point_ += cracks_.step(direction_);
  flipped_ += cracks_.flipped_step(direction_);
  ++steps_;
  trail_[steps_ % trail_.size()] = here_;
}

/// The nearest cracks parallel to the one that leaves a point.
template <TurnViews kViews>
CurveFit::Gaps MixedTurnModel<kViews>::gaps(CrackMap::Address point,
                                            CrackMap::Address flipped,
                                            Quarter direction) const {
  // The crack's bit in the plane where those beside it are its neighbours.
  const CrackMap::Address bit =
      (direction & 1) != 0 ? point + cracks_.crack(direction)
      : direction == 0     ? flipped
                           : flipped + cracks_.flipped_step(2);
  const std::uint64_t after = cracks_.window(bit + 1) >> (64 - kFar);
  const std::uint64_t before =
      cracks_.window(bit - CrackMap::Address{kFar}) >> (64 - kFar);
  return {after != 0 ? static_cast<int>(kFar) + 1 -
                           static_cast<int>(std::bit_width(after))
                     : 0,
          before != 0 ? 1 + std::countr_zero(before) : 0};
}

/// The nearest crack parallel to the one just walked, on one side.
template <TurnViews kViews>
typename MixedTurnModel<kViews>::Sight MixedTurnModel<kViews>::look(
    bool right) const {
  const bool greater = right == (direction_ == 0 || direction_ == 3);
  const int distance = gaps_[greater ? 0 : 1];
  if (distance == 0 || distance > kSight) return {};
  const Quarter side = (direction_ + (right ? 1 : 3)) & 3;
  return {static_cast<unsigned>(distance),
          shape(point_ + CrackMap::Address{distance} * cracks_.step(side))};
}

/// Where the curve goes, on the axis along which most of the last steps went.
template <TurnViews kViews>
CurveFit::Forecast MixedTurnModel<kViews>::forecast() const {
  const Trail& t = trail(std::min(steps_, 16U));
  const std::size_t axis =
      std::abs(here_.x - t.x) >= std::abs(here_.y - t.y) ? 0 : 1;
  return curve_.forecast(axis, direction_, here_.x, here_.y,
                         gaps(point_, flipped_, curve_.heading(axis)));
}

template <TurnViews kViews>
unsigned MixedTurnModel<kViews>::shape(CrackMap::Address point) const {
  const CrackMap::Address on = cracks_.crack(direction_);
  const CrackMap::Address right = cracks_.crack((direction_ + 1) & 3);
  const CrackMap::Address left = cracks_.crack((direction_ + 3) & 3);
  const CrackMap::Address next = point + cracks_.step(direction_);
  return cracks_.test(point + on) << 5 | cracks_.test(point + right) << 4 |
         cracks_.test(point + left) << 3 | cracks_.test(next + on) << 2 |
         cracks_.test(next + right) << 1 | cracks_.test(next + left);
}

template <TurnViews kViews>
entropy::Counter& MixedTurnModel<kViews>::find_gate() {
  const std::uint64_t recent = history_ & 0xffffff;  // 12 turns
  const std::uint64_t hash = mix(around_ & patch::kNear, recent) * kGolden;
  gate_ = &gates_[hash >> (64 - kGateBits)];
  return *gate_;
}

/// The last n steps as a chord, in the frame of the current direction: 18 bits.
template <TurnViews kViews>
std::uint64_t MixedTurnModel<kViews>::chord(std::uint32_t n) const {
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
template <TurnViews kViews>
unsigned MixedTurnModel<kViews>::bulge(std::uint32_t n) const {
  if (steps_ < n) return 0;
  const Trail& t = trail(n);
  const std::int64_t dx = here_.x - t.x;
  const std::int64_t dy = here_.y - t.y;
  return quantise_area(here_.area - t.area -
                       (std::int64_t{t.y} * dx - std::int64_t{t.x} * dy));
}

template <TurnViews kViews>
void MixedTurnModel<kViews>::look_around() {
  const std::uint64_t at_point = patch::ways(around_);
  const std::uint64_t base = at_point << 1 | (ink_ ? 1U : 0U);
  const auto history = [&](unsigned turns) {
    return history_ & ((std::uint64_t{1} << (2 * turns)) - 1);
  };
  const Sight right = look(true);
  const Sight left = look(false);
  const std::uint64_t right_sight = right.distance << 6 | right.shape;
  const std::uint64_t left_sight = left.distance << 6 | left.shape;
  const std::uint64_t verdict = dss_.verdict(direction_);
  const unsigned level = match_.confidence();
  const unsigned guess = level > 0 ? match_.prediction() : 3;

  // Every value fits 60 bits, base included.
  const auto ask = [&](std::size_t i, std::uint64_t value) {
    slots_.ask(i, (value << 4 | base) * kGolden);
  };
  const std::uint64_t runs = (runs_ & 0xffff) << 4 | (bends_ & 15);
  const std::uint64_t all = (around_ & patch::kAll) << 2 | history(1);
  const std::uint64_t sights =
      (right_sight << 10 | left_sight) << 6 | history(3);
  const std::uint64_t followed = (level << 2 | guess) << 4 | history(2);
  const std::uint64_t chord32 = (chord(32) << 8 | history(4)) << 5 | bulge(32);
  const std::uint64_t chord64 = (chord(64) << 18 | chord(8)) << 5 | bulge(64);
  const std::uint64_t segment =
      (verdict << 4 | std::min(dss_.previous_length(), 15U)) << 6 | history(3);
  next_selectors_[0] =
      std::min(right.distance, 7U) * 2 + (left.distance > 0 ? 16U : 0U);
  next_selectors_[1] = static_cast<std::size_t>(history(4)) * 2;
  next_selectors_[2] =
      (level * 4 + guess) * 2 + static_cast<std::size_t>(at_point) * 64;
  next_refined_[0] =
      (around_ & patch::kNear) * kGolden >> (64 - kNearRefinerBits) << 1;
  if constexpr (kAll) {
    const CurveFit::Forecast expected = forecast();
    const std::uint64_t bend = expected.curve >> 3;
    ask(0, history(12));
    ask(1, history(18));
    ask(2, runs);
    ask(3, (around_ & patch::kNear) << 8 | history(4));
    ask(4, all);
    ask(5, (left_sight << 18 | chord(16)) << 6 | history(3));
    ask(6, sights);
    ask(7, followed);
    ask(8, std::uint64_t{runs_} & 0x7f7f7f7f);
    ask(9, chord32);
    ask(10, chord64);
    ask(11, segment);
    ask(12, expected.curve);
    ask(13, expected.right << 20 | bend);
    ask(14, expected.left << 20 | bend);
    next_selectors_[3] =
        static_cast<std::size_t>(expected.curve >> 8 & 511) * 2;
    next_refined_[1] = static_cast<std::size_t>(history(6)) * 2;
  } else {
    const std::array<std::uint64_t, kContexts> values{
        runs, all, sights, followed, chord32, chord64, segment};
    for (std::size_t i = 0; i < kContexts; ++i) ask(i, values[i]);
  }
}

template <TurnViews kViews>
int MixedTurnModel<kViews>::probability(Node node) {
  auto& inputs = mixer_.inputs(node);
  slots_.predict(node, inputs.data());
  inputs[kGateInput] = static_cast<std::int16_t>(
      node == kBends ? entropy::stretch(gate_->p) : 0);
  std::array<std::size_t, kSets> chosen = selectors_;
  for (std::size_t& vector : chosen) vector += node;
  const int x = mixer_.mix(chosen, node);
  int p = entropy::squash(x);
  for (std::size_t i = 0; i < refiners_.size(); ++i) {
    p += refiners_[i].refine(x, refined_[i] + node);
  }
  return std::clamp(p / static_cast<int>(1 + kRefiners), 1, 65535);
}

template class MixedTurnModel<TurnViews::all>;
template class MixedTurnModel<TurnViews::few>;

}  // namespace unstep::codec
