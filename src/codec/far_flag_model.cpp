#include "codec/far_flag_model.h"

#include <algorithm>
#include <bit>

#include "entropy/logistic.h"

namespace unstep::codec {
namespace {

constexpr std::uint8_t kFirstAge = 45;  ///< of a counter that begins as known
/// Starts are rare and surprise: a mixer that learns fast would lose its head.
constexpr std::uint16_t kSteady = 60000;
constexpr std::size_t kVectors = 64;
constexpr std::size_t kReach = 5;  ///< words to either side that are wide
constexpr std::uint32_t kOne = 1 << 12;

/// The known counter weighs most, so that small drawings lose nothing.
constexpr std::array<std::array<std::int16_t, 8>, 1> kWeights{
    {{3100, 332, 332, 332}}};

std::uint8_t density_level(std::uint64_t density) {
  return static_cast<std::uint8_t>(
      std::min(static_cast<int>(std::bit_width(density >> 6)), 7));
}

}  // namespace

FarFlagModel::FarFlagModel(std::size_t words)
    : counters_(kContexts << kContextBits), mixer_({kVectors}, kWeights) {
  for (std::size_t k = 0; k < kVectors; ++k) {
    entropy::Mixer<8, 1>::Inputs weights{};
    std::transform(
        kWeights[0].begin(), kWeights[0].end(), weights.begin(),
        [](std::int16_t w) { return static_cast<std::int16_t>(4 * w); });
    mixer_.set_weights(0, k, weights, kSteady);
  }
  for (Density& density : density_) {
    density.quick.resize(words + 2);
    density.slow.resize(words + 2);
    density.levels.resize(words + 2);
  }
}

void FarFlagModel::begin_row(std::int32_t y) {
  if (y % kRows != 0) return;
  for (Density& density : density_) look(density);
}

void FarFlagModel::look(Density& density) {
  for (std::uint32_t& d : density.quick) d -= (d + 3) / 4;
  for (std::uint32_t& d : density.slow) d -= (d + 31) / 32;
  const auto& quick = density.quick;
  const auto& slow = density.slow;
  std::uint64_t wide = 0;  // of the words within kReach
  for (std::size_t w = 0; w < std::min(kReach + 1, slow.size()); ++w) {
    wide += slow[w];
  }
  for (std::size_t w = 1; w + 1 < slow.size(); ++w) {
    if (w + kReach < slow.size()) wide += slow[w + kReach];
    if (w > kReach + 1) wide -= slow[w - kReach - 1];
    const auto near = [w](const std::vector<std::uint32_t>& d) {
      return std::uint64_t{d[w - 1]} + 2 * d[w] + d[w + 1];
    };
    density.levels[w] = {density_level(near(quick)),
                         density_level(near(slow) / 2),
                         density_level(wide / 4)};
  }
}

int FarFlagModel::predict(entropy::Counter& known, std::size_t word,
                          const Sight& sight) {
  Density& density = density_[sight.ink ? 1 : 0];
  const std::size_t w = word + 1;
  quick_ = &density.quick[w];
  slow_ = &density.slow[w];
  const auto& [quick, slow, wide] = density.levels[w];
  const std::size_t size = sight.size * 2 + (sight.ink ? 1 : 0);
  const std::array<std::size_t, kContexts> values{
      (sight.ages[0] * 64 + sight.ages[1] * 8 + sight.ages[2]) * 8 + size,
      ((quick * 8U + slow) * 4 + sight.row) * 8 + size,
      ((wide * 8U + slow) * 8 + sight.ages[1]) * 8 + size};
  active_[0] = &known;
  auto& inputs = mixer_.inputs();
  inputs[0] = static_cast<std::int16_t>(entropy::stretch(known.p));
  for (std::size_t i = 0; i < kContexts; ++i) {
    entropy::Counter& counter = counters_[(i << kContextBits) + values[i]];
    if (counter.n == 0) counter = {known.p, kFirstAge};
    active_[i + 1] = &counter;
    inputs[i + 1] = static_cast<std::int16_t>(entropy::stretch(counter.p));
  }
  const auto octave = [this](std::size_t i) {
    return static_cast<std::size_t>(
        std::min(static_cast<int>(std::bit_width(unsigned{active_[i]->n})), 7));
  };
  const int x = mixer_.mix({octave(1) * 8 + octave(2)});
  return std::clamp(entropy::squash(x), 2, 65534);
}

void FarFlagModel::update(bool any) {
  mixer_.update(any);
  for (entropy::Counter* counter : active_) counter->update(any);
  if (!any) return;
  *quick_ += kOne;
  *slow_ += kOne;
}

void FarFlagModel::count(std::size_t word, bool ink) {
  Density& density = density_[ink ? 1 : 0];
  density.quick[word + 1] += kOne;
  density.slow[word + 1] += kOne;
}

}  // namespace unstep::codec
