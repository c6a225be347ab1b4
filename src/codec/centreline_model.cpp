#include "codec/centreline_model.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "codec/context.h"

namespace unstep::codec {
namespace {

/// Vectors of each set for the first pixels; as many follow for those beside.
constexpr std::array<std::size_t, CentrelineModel::kSets> kVectors{
    64, 512, 1024, 256, 256};

std::array<std::size_t, CentrelineModel::kSets> all_vectors() {
  auto all = kVectors;
  for (std::size_t& n : all) n *= 2;
  return all;
}

}  // namespace

CentrelineModel::CentrelineModel(const PixelPlanes& planes,
                                 const VertexRulers& rulers, int table_bits)
    : planes_(planes),
      rulers_(rulers),
      slots_(table_bits),
      mixer_(all_vectors(), std::span(kInitialWeights).first<kNodes>()),
      refiners_{entropy::Refiner(2 * kVectors[0]),
                entropy::Refiner(2 * kVectors[1])} {
  for (std::size_t set = 0; set < kSets; ++set) {
    for (std::size_t k = kVectors[set]; k < 2 * kVectors[set]; ++k) {
      Weights weights = kInitialWeights[kNodes + k % kNodes];
      for (std::int16_t& w : weights) {
        w = static_cast<std::int16_t>(std::clamp(w * 4, -32768, 32767));
      }
      mixer_.set_weights(set, k, weights, 0);
    }
  }
}

std::uint64_t CentrelineModel::memory(int table_bits) {
  return Slots::memory(table_bits) + (std::uint64_t{2} << 20);
}

void CentrelineModel::begin_line(Point at, Step direction, int turn) {
  dss_.reset();
  if (turn < 0) return track_.begin(at, direction);
  const Point move = step_delta(direction, YAxis::down);
  track_.begin({at.x - move.x, at.y - move.y},
               static_cast<Step>((direction - turn) & 7));
  advance(static_cast<unsigned>(turn));
}

/// The way to the start of the piece if it is near, else 0.
std::uint64_t CentrelineModel::home() const {
  constexpr std::int32_t kNear = 20;
  const std::int32_t dx = start_.x - track_.position().x;
  const std::int32_t dy = start_.y - track_.position().y;
  if (std::abs(dx) > kNear || std::abs(dy) > kNear) return 0;
  return static_cast<std::uint64_t>((dx + 32) << 7 | (dy + 32));
}

void CentrelineModel::look_around() {
  const std::uint64_t base = (track_.direction() & 1U) |
                             std::uint64_t{std::min(track_.steps(), 3U)} << 1;
  const auto history = [this](unsigned turns) { return track_.history(turns); };
  const auto run = [this](std::size_t k, std::uint32_t limit) {
    return track_.run(k, limit);
  };
  const std::uint64_t bends = track_.bends();
  const PixelPatch patch = pixel_patch::at(
      planes_, planes_.at(track_.position().x, track_.position().y),
      track_.direction() / 2U);
  const std::uint64_t near = pixel_patch::near(patch);
  const std::uint64_t all = pixel_patch::all(patch);
  const std::uint64_t grid = rulers_.column(track_.position().x) << 6 |
                             rulers_.row(track_.position().y);
  const std::uint64_t verdict = dss_.verdict(track_.direction());
  const unsigned level = match_.confidence();
  const unsigned guess = level > 0 ? match_.prediction() : 0;
  const std::uint64_t way_home = home();

  values_ = {
      mix(near, mix(history(2), base)),
      mix(near, mix(history(6), base)),
      mix(history(12), base),
      mix(run(0, 255) << 8 | run(1, 255), mix(bends & 63, base)),
      mix((run(0, 127) << 7 | run(1, 127)) << 14 | run(2, 127) << 7 |
              run(3, 127),
          mix(bends, base)),
      mix(all, mix(history(1), base)),
      mix(verdict << 8 | dss_.previous_length(), mix(history(2), base)),
      mix(verdict, mix(history(4), base)),
      mix(track_.chord(16), mix(track_.bulge(16) << 9 | history(3), base)),
      mix(track_.chord(32), mix(track_.bulge(32) << 9 | history(3), base)),
      mix(level << 3 | guess, mix(history(2), base)),
      way_home != 0 ? mix(way_home, mix(history(1), track_.direction()))
                    : mix(history(3) << 3 | track_.direction(), 99),
      mix(grid, mix(near, track_.direction())),
      mix(grid, mix(history(2), base)),
      mix(verdict, mix(grid, base))};

  sight_ = {
      std::min<std::size_t>(std::bit_width(track_.run(0, 255)), 7) * kNodes,
      static_cast<std::size_t>(history(2)) * kNodes,
      (level * 8 + guess) * kNodes +
          ((patch.ink & pixel_patch::kOuter) != 0 ? 512U : 0U),
      static_cast<std::size_t>(verdict >> 5 & 31) * kNodes,
      (std::min(track_.steps(), 15U) * 2 + (way_home != 0 ? 1U : 0U)) * kNodes};
}

void CentrelineModel::ask_slots(unsigned found) {
  for (std::size_t i = 0; i < kContexts; ++i) {
    slots_.ask(i, found == 0 ? values_[i] : mix(values_[i], found));
  }
  if (found == 0) return;
  for (std::size_t set = 0; set < kSets; ++set) sight_[set] += kVectors[set];
}

/// Learns the decisions of before; those to come see what was asked for.
void CentrelineModel::learn_last() {
  slots_.learn(
      [this](bool bit, std::size_t lane) { mixer_.update(bit, lane); });
  slots_.recall();
  selectors_ = sight_;
}

int CentrelineModel::probability(Node node) {
  auto& inputs = mixer_.inputs(slots_.lane());
  slots_.predict(node, inputs);
  Selectors chosen = selectors_;
  for (std::size_t& vector : chosen) vector += node;
  const int x = mixer_.mix(chosen, slots_.lane());
  const int p = 2 * entropy::squash(x) + refiners_[0].refine(x, chosen[0]) +
                refiners_[1].refine(x, chosen[1]);
  return std::clamp(p / 4, 4, 65532);
}

void CentrelineModel::advance(unsigned turn) {
  match_.push(turn);
  track_.advance(turn);
  dss_.push(track_.direction());
}

}  // namespace unstep::codec
