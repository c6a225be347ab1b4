#include "codec/deep_turn_model.h"

#include <algorithm>
#include <bit>

#include "codec/context.h"

namespace unstep::codec {
namespace {

constexpr int kRefinerBits = 11;

/// The match's length and what it expects.
template <class Match>
std::uint64_t expected_by(const Match& match) {
  const unsigned level = match.confidence();
  return level << 2 | (level > 0 ? match.prediction() : 3U);
}

/// 4..59: steps of a quarter of a nat.
int level_of(int probability) {
  return (entropy::stretch(probability) + 2048) >> 6;
}

}  // namespace

// Each is for both nodes.
const DeepTurnModel::Model::Choice DeepTurnModel::kSizes{
    {64, 1024, 1024, 1024, 2048, 2048, 1024, 512, 128, 1024},
    {2 << kRefinerBits, 8192, 2048, 64, 128},
    64};

/// The weights of the table for the contexts that it knows, a little smaller
/// because there are more.
std::array<DeepTurnModel::Model::Weights, 2> DeepTurnModel::first_weights(
    const warm::Table& start) {
  constexpr std::size_t kKnown = warm::kTurnContexts;
  std::array<Model::Weights, 2> weights{};
  for (std::size_t node = 0; node < 2; ++node) {
    Model::Weights& to = weights[node];
    const auto& from = start.turn_weights[node];
    const auto scaled = [&](std::size_t i) {
      return static_cast<std::int16_t>(from[i] * 4 / 5);
    };
    for (std::size_t i = 0; i < kContexts; ++i) {
      to[i] = i < kKnown ? scaled(i) : std::int16_t{5200 / kContexts};
      to[kContexts + i] =
          i < kKnown ? scaled(kKnown + 1 + i) : std::int16_t{2000 / kContexts};
      to[2 * kContexts + i] = 1500 / kContexts;
    }
    to[Model::kFirstExtra] = from[kKnown];
    to[Model::kFirstExtra + 1] = 300;
  }
  return weights;
}

std::uint64_t DeepTurnModel::memory(int table_bits) {
  // The gates and the matches come on top.
  return Model::memory(table_bits, kSizes) + (std::uint64_t{2} << 20);
}

DeepTurnModel::DeepTurnModel(const CrackMap& cracks, int table_bits,
                             const warm::Table& start)
    : TurnWalk(cracks), model_(table_bits, kSizes, first_weights(start)) {
  for (std::size_t i = 0; i < warm::kTurnContexts; ++i) {
    start.for_each(i, [&](const warm::Record& record) { know(i, record); });
  }
}

DeepTurnModel::DeepTurnModel(const CrackMap& cracks, int table_bits,
                             const warm::DeepTable& start, std::uint16_t age)
    : TurnWalk(cracks), model_(table_bits, kSizes, start.weights) {
  static_assert(Model::kInputs == warm::DeepTable::kInputs);
  static_assert(kContexts == warm::DeepTable::kContexts);
  for (std::size_t i = 0; i < kContexts; ++i) {
    warm::for_each_record(start.records, start.counts, i,
                          [&](const warm::Record& record) { know(i, record); });
  }
  warm::for_each_vector<Model::kInputs, warm::DeepTable::kNumber>(
      start.vectors,
      [&](std::size_t number) { return start.weights[number % 2]; },
      [&](std::size_t number, const auto& weights) {
        model_.begin(number, weights, age);
      });
}

void DeepTurnModel::know(std::size_t context, const warm::Record& record) {
  for (std::size_t node = 0; node < 2; ++node) {
    model_.know(context, std::uint32_t{record.index} << 12 | record.check, node,
                record.p[node], record.n[node]);
  }
}

void DeepTurnModel::look_around() {
  const std::uint64_t base = patch::ways(around_) << 1 | (ink_ ? 1U : 0U);
  const Sight right = look(true);
  const Sight left = look(false);
  const std::uint64_t right_sight = right.distance << 6 | right.shape;
  const std::uint64_t left_sight = left.distance << 6 | left.shape;
  const std::uint64_t verdict = dss_.verdict(direction_);
  const CurveFit::Forecast expected = forecast();
  const std::uint64_t bend = expected.curve >> 3;
  const std::uint64_t all = around_ & patch::kAll;
  const std::uint64_t runs = (runs_ & 0xffff) << 4 | (bends_ & 15);

  // Those of the warm start, as in MixedTurnModel.
  const auto ask = [&](std::size_t i, std::uint64_t value) {
    model_.ask(i, (value << 4 | base) * kGolden);
  };
  ask(0, history(12));
  ask(1, history(18));
  ask(2, runs);
  ask(3, (around_ & patch::kNear) << 8 | history(4));
  ask(4, all << 2 | history(1));
  ask(5, (left_sight << 18 | chord(16)) << 6 | history(3));
  ask(6, (right_sight << 10 | left_sight) << 6 | history(3));
  ask(7, expected_by(match_) << 4 | history(2));
  ask(8, runs_ & 0x7f7f7f7f);
  ask(9, (chord(32) << 8 | history(4)) << 5 | bulge(32));
  ask(10, (chord(64) << 18 | chord(8)) << 5 | bulge(64));
  ask(11,
      (verdict << 4 | std::min(dss_.previous_length(), 15U)) << 6 | history(3));
  ask(12, expected.curve);
  ask(13, expected.right << 20 | bend);
  ask(14, expected.left << 20 | bend);

  const auto ask_more = [&](std::size_t i, std::uint64_t a, std::uint64_t b) {
    model_.ask_mixed(i, mix(mix(a, b), base));
  };
  // Two points ahead, and to both sides.
  const auto beyond = [&](int turns) {
    const Quarter way = (direction_ + turns) & 3;
    return patch::at(cracks_, point_ + 2 * cracks_.step(way), direction_);
  };
  const std::uint64_t ahead = beyond(0);
  ask_more(15, all, ahead);
  ask_more(16, mix(all, ahead), mix(beyond(1), beyond(3)));
  ask_more(17, expected.curve, right.distance << 4 | left.distance);
  ask_more(18, expected.right, expected.left);
  ask_more(19, right_sight, runs);
  ask_more(20, left_sight, runs);
  ask_more(21, runs_ & 0xffffffffffff, bends_ & 0xfff);
  ask_more(22, chord(24) << 5 | bulge(24), runs_ & 255);
  ask_more(23, chord(48) << 5 | bulge(48), chord(4));
  ask_more(24, chord(40) << 18 | chord(12), history(2));
  ask_more(25, expected_by(long_match_), 0);
  ask_about_edges(base, right, left);
  choose(right, left, expected.curve);
}

void DeepTurnModel::ask_about_edges(std::uint64_t base, const Sight& right,
                                    const Sight& left) {
  edges_.look();
  const auto bends = static_cast<std::uint64_t>(level_of(edges_.bends()));
  const auto to_right = static_cast<std::uint64_t>(level_of(edges_.right()));
  const auto ask = [&](std::size_t i, std::uint64_t a, std::uint64_t b) {
    model_.ask_mixed(i, mix(mix(a, b), base));
  };
  ask(26, bends, to_right >> 2);
  ask(27, (bends >> 2) << 8 | to_right >> 3,
      mix(around_ & patch::kNear, history(4)));
  ask(28, static_cast<std::uint64_t>(edges_.age()) << 4 | edges_.vertex() >> 4,
      (runs_ & 255) << 4 | history(2));
  ask(29, edges_.place(), mix(bends >> 1, right.distance << 4 | left.distance));
}

/// The forecast's probability of the next decision: two inputs, a vector and a
/// context of a refiner.
void DeepTurnModel::expect(int probability) {
  model_.set_extra(1, entropy::stretch(probability));
  model_.set_extra(2, (probability - 32768) / 32);
  const auto level = static_cast<std::size_t>(level_of(probability));
  choice_.vectors[8] = level * 2;
  choice_.refined[4] = level * 2;
}

void DeepTurnModel::choose(const Sight& right, const Sight& left,
                           std::uint64_t curve) {
  const std::uint64_t near =
      (around_ & patch::kNear) * kGolden >> (64 - kRefinerBits);
  const std::uint64_t followed = expected_by(match_);
  const std::uint64_t verdict = dss_.verdict(direction_);
  const auto run = [this](unsigned k) {
    return std::min<std::uint64_t>(runs_ >> 8 * k & 255, 15);
  };
  choice_.vectors = {
      std::min(right.distance, 7U) * 2 + (left.distance > 0 ? 16U : 0U),
      history(4) * 2,
      followed * 2 + patch::ways(around_) * std::size_t{64},
      (curve >> 8 & 511) * 2,
      verdict * 2,
      (near >> 1) * 2,
      (run(0) * 16 + run(1)) * 4 + (bends_ & 1) * 2,
      expected_by(long_match_) * 16 +
          std::min<std::size_t>(std::bit_width(steps_), 7) * 2,
      0,
      static_cast<std::size_t>(std::min(edges_.age(), 31)) * 32 +
          (edges_.vertex() >> 4) * 2};
  choice_.refined = {near * 2, history(6) * 2, verdict * 2, followed * 2, 0};
  choice_.last = followed * 2;
}

}  // namespace unstep::codec
