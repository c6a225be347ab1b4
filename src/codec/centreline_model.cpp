#include "codec/centreline_model.h"

#include <algorithm>
#include <bit>

#include "codec/context.h"

namespace unstep::codec {
CentrelineModel::CentrelineModel(const PixelPlanes& planes,
                                 const VertexRulers& rulers, int table_bits,
                                 const centreline_warm::Table& start)
    : LineFollower(planes, rulers),
      slots_(table_bits),
      mixer_(twice(kVectors), std::span(kInitialWeights).first<kNodes>()),
      refiners_{entropy::Refiner(2 * kVectors[kRefined[0]]),
                entropy::Refiner(2 * kVectors[kRefined[1]])} {
  std::size_t number = 0;
  for (const std::size_t half : kVectors) {
    number += half;
    for (std::size_t k = half; k < 2 * half; ++k, ++number) {
      mixer_.begin(number, kInitialWeights[kNodes + k % kNodes]);
    }
  }
  start.for_each([&](std::size_t i, const centreline_warm::Record& record) {
    for (std::size_t k = 0; k < record.size; ++k) {
      const auto& [node, n, p] = record.counters[k];
      slots_.know(i, record.index, record.check, node, p, n);
    }
  });
}

std::uint64_t CentrelineModel::memory(int table_bits) {
  return Slots::memory(table_bits) + (std::uint64_t{2} << 20);
}

void CentrelineModel::ask(unsigned found) {
  for (std::size_t i = 0; i < kContexts; ++i) {
    slots_.ask(i, found == 0 ? values_[i] : mix(values_[i], found));
  }
  if (found != 0) {
    for (std::size_t set = 0; set < kSets; ++set) sight_[set] += kVectors[set];
  }
  // The decisions of before are learned; those to come see what was asked for.
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
  const int p = 2 * entropy::squash(x) +
                refiners_[0].refine(x, chosen[kRefined[0]]) +
                refiners_[1].refine(x, chosen[kRefined[1]]);
  return std::clamp(p / 4, 4, 65532);
}

}  // namespace unstep::codec
