#include "reverse/look_memory.h"

#include <algorithm>
#include <bit>

namespace unstep::reverse {
namespace {

/// Eight even codes as 16 bits, the first one lowest.
std::uint64_t pack_eight(const Step* steps) {
  std::uint64_t codes = 0;
  for (int i = 7; i >= 0; --i) codes = codes << 8 | steps[i];
  codes = codes >> 1 & 0x0303030303030303U;
  codes = (codes | codes >> 6) & 0x000F000F000F000FU;
  codes = (codes | codes >> 12) & 0x000000FF000000FFU;
  return (codes | codes >> 24) & 0xFFFFU;
}

}  // namespace

LookMemory::LookMemory(std::size_t steps) {
  const int bits =
      std::clamp(static_cast<int>(std::bit_width(steps / 4)), 8, 14);
  entries_.resize(std::size_t{1} << bits);
  shift_ = 64 - bits;
}

void LookMemory::begin(const ChainWalk& chain) {
  words_.clear();
  const std::span<const Step> steps = chain.steps();
  if (chain.connectivity() != Connectivity::four || steps.empty()) return;
  for (std::size_t i = 0; i < quarters_.size(); ++i) {
    quarters_[i] = chain.delta(static_cast<Step>(2 * i));
  }
  const std::size_t needed = steps.size() + kSteps;
  words_.resize(needed / kSteps + 3);
  std::size_t i = 0;
  for (; i + 8 <= steps.size(); i += 8) {
    words_[i / kSteps] |= pack_eight(&steps[i]) << 2 * (i % kSteps);
  }
  for (; i < steps.size(); ++i) {
    words_[i / kSteps] |= std::uint64_t{steps[i]} >> 1 << 2 * (i % kSteps);
  }
  // A word from the last step on goes round to the first ones: as many as there
  // are, again and again.
  while (i < needed) {
    const std::size_t count = std::min(i, kSteps);
    const std::uint64_t first =
        words_[0] << (64 - 2 * count) >> (64 - 2 * count);
    const std::size_t bit = 2 * (i % kSteps);
    words_[i / kSteps] |= first << bit;
    words_[i / kSteps + 1] |= first >> 1 >> (63 - bit);
    i += count;
  }
}

void LookMemory::keep(std::uint64_t word, std::size_t seen,
                      const Found& found) {
  const std::uint64_t turned = turn_to_first(word);
  // The steps' moves are unit vectors, so coordinates are products.
  const Point first = quarters_[word & 3];
  const Point second = quarters_[(word + 1) & 3];
  const auto along = [](Point p, Point axis) {
    return static_cast<std::int8_t>(p.x * axis.x + p.y * axis.y);
  };
  entries_[place_of(turned)] = {turned,
                                static_cast<std::uint8_t>(62 - 2 * seen),
                                static_cast<std::uint8_t>(seen),
                                static_cast<std::uint8_t>(found.farthest_after),
                                static_cast<std::uint8_t>(found.before_after),
                                along(found.farthest, first),
                                along(found.farthest, second),
                                along(found.before, first),
                                along(found.before, second)};
}

}  // namespace unstep::reverse
