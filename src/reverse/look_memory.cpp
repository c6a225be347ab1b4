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

std::int8_t along(Point p, Point axis) {
  return static_cast<std::int8_t>(p.x * axis.x + p.y * axis.y);
}

}  // namespace

LookMemory::LookMemory(std::size_t steps) {
  const int bits =
      std::clamp(static_cast<int>(std::bit_width(steps / 4)), 8, 14);
  entries_.resize(std::size_t{1} << bits);
  shift_ = 64 - bits;
  head_steps_ = static_cast<std::size_t>(bits / 2 + 1);
  heads_.resize(std::size_t{1} << 2 * (head_steps_ - 1));
}

void LookMemory::begin(const ChainWalk& chain) {
  words_.clear();
  const std::span<const Step> steps = chain.steps();
  if (chain.connectivity() != Connectivity::four || steps.empty()) return;
  for (std::size_t i = 0; i < quarters_.size(); ++i) {
    quarters_[i] = chain.delta(static_cast<Step>(2 * i));
  }
  const bool counter_clockwise =
      quarters_[0].x * quarters_[1].y - quarters_[0].y * quarters_[1].x > 0;
  quarter_ = counter_clockwise ? 1U << 14 : 3U << 14;
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

/// The steps' moves are unit vectors, so coordinates are products.
LookMemory::Ends LookMemory::into_frame(std::uint64_t word,
                                        const Found& found) const {
  const Point first = quarters_[word & 3];
  const Point second = quarters_[(word + 1) & 3];
  return {static_cast<std::uint8_t>(found.farthest_after),
          static_cast<std::uint8_t>(found.before_after),
          along(found.farthest, first),
          along(found.farthest, second),
          along(found.before, first),
          along(found.before, second)};
}

void LookMemory::keep(std::uint64_t word, std::size_t seen,
                      const Found& found) {
  const std::uint64_t turned = turn_to_first(word);
  entries_[place_of(turned)] = {
      turned, static_cast<std::uint8_t>(62 - 2 * seen),
      static_cast<std::uint8_t>(seen), into_frame(word, found)};
}

void LookMemory::keep_done(std::uint64_t word, const Found& found) {
  Head& head = heads_[head_of(word)];
  head.kind_ = Head::kDone;
  head.ends_ = into_frame(word, found);
}

void LookMemory::keep_begun(std::uint64_t word, const Begun& begun) {
  const std::uint16_t turn = quarters_of(word);
  Head& head = heads_[head_of(word)];
  head.kind_ = Head::kGoesOn;
  head.farthest2_ = static_cast<std::uint8_t>(begun.farthest2);
  head.ends_ = into_frame(word, begun.found);
  head.left_ = static_cast<std::uint16_t>(begun.left - turn);
  head.right_ = static_cast<std::uint16_t>(begun.right - turn);
  head.at_x_ = along(begun.at, quarters_[word & 3]);
  head.at_y_ = along(begun.at, quarters_[(word + 1) & 3]);
}

}  // namespace unstep::reverse
