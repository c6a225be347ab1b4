#include "codec/turn_model.h"

#include <algorithm>
#include <bit>

#include "codec/context.h"

namespace unstep::codec {
namespace {

/// log2 of the contexts of the refiners, without the decision.
constexpr int kTurnRefinerBits = 12;
constexpr int kNearRefinerBits = 11;

/// The contexts of all views, in the order of the table: how many fewer bits of
/// slots they get, for some have few values.
constexpr std::array<int, 15> kFewer{1, 0, 0, 0, 0, 0, 0, 3,
                                     0, 0, 0, 1, 2, 0, 0};
/// Those that the light model has.
constexpr std::array<std::size_t, 6> kFew{2, 4, 6, 7, 9, 10};

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
    : Walk(cracks),
      slots_(table_sizes<MixedTurnModel>(table_bits)),
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
  if constexpr (kAll) {
    warm::for_each_vector<kInputs>(
        start.vectors,
        [&](std::size_t number) { return start.turn_weights[number % 2]; },
        [&](std::size_t number, const auto& weights) {
          mixer_.begin(number, weights);
        });
  }
}

template <TurnViews kViews>
void MixedTurnModel<kViews>::look_around() {
  const std::uint64_t at_point = patch::ways(around_);
  const std::uint64_t base = at_point << 1 | (ink_ ? 1U : 0U);
  this->look_aside();
  const Sight right = look(true);
  const Sight left = look(false);
  const std::uint64_t right_sight = right.distance << 6 | right.shape;
  const std::uint64_t left_sight = left.distance << 6 | left.shape;
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
    const std::uint64_t segment =
        (std::uint64_t{dss_.verdict(direction_)} << 4 |
         std::min(dss_.previous_length(), 15U))
            << 6 |
        history(3);
    ask(0, history(12));
    ask(1, history(18));
    ask(2, runs);
    ask(3, (around_ & patch::kNear) << 8 | history(4));
    ask(4, all);
    ask(5, (left_sight << 18 | chord(16)) << 6 | history(3));
    ask(6, sights);
    ask(7, followed);
    ask(8, runs_ & 0x7f7f7f7f);
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
        runs, all, sights, followed, chord32, chord64};
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
