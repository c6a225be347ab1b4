#include "codec/deep_centreline_model.h"

#include <algorithm>
#include <bit>

#include "codec/centreline_model.h"
#include "codec/context.h"

namespace unstep::codec {
namespace {

constexpr std::size_t kNears = 1024;
constexpr std::size_t kRuns = 16;  ///< octaves, twice

}  // namespace

const DeepCentrelineModel::Model::Choice DeepCentrelineModel::kSizes{
    {2 * kVectors[0], 2 * kVectors[1], 2 * kVectors[2], 2 * kVectors[3],
     kRuns* kNodes, kNears* kNodes, 1024 * kNodes},
    {kRuns * kNodes, 2 * kVectors[0], kNears* kNodes},
    8 * kNodes};

/// Those of CentrelineModel for the contexts that it has.
std::array<DeepCentrelineModel::Model::Weights,
           LineFollower<DeepCentrelineModel>::kNodes>
DeepCentrelineModel::first_weights() {
  constexpr std::size_t kKnown = LineFollower::kContexts;
  std::array<Model::Weights, kNodes> weights{};
  for (std::size_t node = 0; node < kNodes; ++node) {
    Model::Weights& to = weights[node];
    const auto& from = CentrelineModel::kInitialWeights[node];
    const auto scaled = [&](std::size_t i) {
      return static_cast<std::int16_t>(from[i] * 4 / 5);
    };
    for (std::size_t i = 0; i < kAll; ++i) {
      to[i] = i < kKnown ? scaled(i) : std::int16_t{5200 / kAll};
      to[kAll + i] = i < kKnown ? scaled(CentrelineModel::kInputs / 2 + i)
                                : std::int16_t{2000 / kAll};
      to[2 * kAll + i] = 1500 / kAll;
    }
  }
  return weights;
}

DeepCentrelineModel::DeepCentrelineModel(const PixelPlanes& planes,
                                         const VertexRulers& rulers,
                                         int table_bits,
                                         const centreline_warm::Table& start)
    : LineFollower(planes, rulers),
      model_(table_bits, kSizes, first_weights()) {
  start.for_each([&](std::size_t i, const centreline_warm::Record& record) {
    const std::uint32_t upper =
        std::uint32_t{record.index} << 12 | record.check >> 4;
    for (std::size_t k = 0; k < record.size; ++k) {
      const auto& [node, n, p] = record.counters[k];
      model_.know(i, upper, node, p, n);
    }
  });
}

std::uint64_t DeepCentrelineModel::memory(int table_bits) {
  // The match comes on top.
  return Model::memory(table_bits, kSizes) + (std::uint64_t{1} << 20);
}

void DeepCentrelineModel::look(const Sight& sight) {
  const Values known = contexts(sight);
  std::copy(known.begin(), known.end(), values_.begin());
  const auto history = [this](unsigned turns) { return track_.history(turns); };
  const std::uint64_t base = sight.base;
  const auto run = [this](std::size_t k, std::uint32_t limit) {
    return track_.run(k, limit);
  };
  const std::uint64_t last = run(0, 255);
  const std::array<std::uint64_t, kAll - LineFollower::kContexts> more{
      mix(last << 8 | run(1, 255), mix(track_.bends() & 63, base)),
      mix(track_.chord(32), mix(track_.bulge(32) << 9 | history(3), base)),
      mix(history(12), base),
      mix((run(0, 127) << 7 | run(1, 127)) << 14 | run(2, 127) << 7 |
              run(3, 127),
          mix(track_.bends(), base)),
      mix(sight.verdict << 8 | dss_.previous_length(), mix(history(2), base)),
      mix(track_.chord(16), mix(track_.bulge(16) << 9 | history(3), base)),
      mix(sight.verdict, mix(sight.grid, base)),
      mix(sight.all, mix(history(4), base)),
      mix(history(20), base),
      mix(sight.verdict,
          mix(last << 8 | run(1, 255), track_.bends() << 3 | base)),
      mix(track_.chord(8), mix(track_.chord(60), base)),
      mix(track_.chord(24), mix(track_.bulge(24) << 8 | last, base)),
      mix(sight.verdict, mix(history(8), base)),
      mix(sight.grid, mix(last << 3 | history(1), base)),
      mix(sight.near, mix(sight.level << 3 | sight.guess, base))};
  std::copy(more.begin(), more.end(), values_.begin() + known.size());

  const std::size_t near =
      static_cast<std::size_t>(sight.near * kGolden >> 54) * kNodes;
  const Selectors first = selectors(sight);
  std::copy(first.begin(), first.end(), choice_.vectors.begin());
  const std::size_t octave =
      std::min<std::size_t>(std::bit_width(last), 7) * kNodes;
  choice_.vectors[4] = octave;
  choice_.vectors[5] = near;
  choice_.vectors[6] = static_cast<std::size_t>(sight.verdict) * kNodes;
  choice_.refined = {octave, first[0], near};
  choice_.last = std::min(sight.level, 7U) * kNodes;
}

void DeepCentrelineModel::ask(unsigned found) {
  for (std::size_t i = 0; i < kAll; ++i) {
    ask(i, found == 0 ? values_[i] : mix(values_[i], found));
  }
  if (found == 0) return;
  for (std::size_t s = 0; s < kVectors.size(); ++s) {
    choice_.vectors[s] += kVectors[s];
  }
  choice_.vectors[4] += kRuns / 2 * kNodes;
  choice_.refined[0] += kRuns / 2 * kNodes;
  choice_.refined[1] += kVectors[0];
}

/// Those of CentrelineModel by its hash, so that they have its warm start.
void DeepCentrelineModel::ask(std::size_t i, std::uint64_t value) {
  if (i < LineFollower::kContexts) return model_.ask(i, (value + i) * kGolden);
  model_.ask_mixed(i, value);
}

/// Whether there are more pixels depends on which was found first.
void DeepCentrelineModel::ask_beside(Node first) {
  for (std::size_t i = 0; i < kAll; ++i) {
    ask(i, mix(values_[i], 256U + first));
  }
}

}  // namespace unstep::codec
