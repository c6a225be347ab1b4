#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/context.h"
#include "codec/crack_map.h"
#include "codec/patch.h"
#include "codec/start_model.h"
#include "codec/turn_walk.h"
#include "codec/warm_start.h"
#include "entropy/counter.h"
#include "entropy/slots.h"

namespace unstep::codec {

namespace detail {

/// Of 64: how much a counter counts, by its age.
constexpr std::array<std::int8_t, 256> make_fast_weights() {
  std::array<std::int8_t, 256> weights{};
  for (std::size_t n = 0; n < 256; ++n) {
    weights[n] = static_cast<std::int8_t>(n == 0   ? 0
                                          : n < 2  ? 14
                                          : n < 4  ? 20
                                          : n < 16 ? 26
                                                   : 30);
  }
  return weights;
}
inline constexpr auto kFastWeights = make_fast_weights();

}  // namespace detail

/// Predicts turns from two contexts without a mixer: the last 12 turns, and the
/// nearest cracks with the last 5. The better known one counts more. For the
/// fast effort; the same interface as MixedTurnModel.
class FastTurnModel {
 public:
  using Starts = StartModel;
  static constexpr bool kClean = false;

  /// log2 of the slots of each context: 2 x 256 kB stay in a cache.
  static constexpr int kBits = 15;

  FastTurnModel(const CrackMap& cracks, int /*table_bits*/,
                const warm::Table& /*start*/)
      : cracks_(cracks), turns_(kSize), near_(kSize), runs_(kSize) {}

  static std::uint64_t memory(int /*table_bits*/) {
    return 3 * kSize * sizeof(entropy::Slot);
  }

  void begin(CrackMap::Address point, CrackMap::Address /*flipped*/, bool ink) {
    direction_ = 0;
    point_ = point + cracks_.step(0);
    ink_ = ink;
    history_ = 0;
    lengths_ = 0;
  }

  unsigned arrive() {
    around_ = patch::at(cracks_, point_, direction_);
    return ~patch::ways(around_) & 7U;
  }

  template <class Coder>
  Turn code(Coder& coder, Turn turn, unsigned allowed) {
    const std::uint64_t base = patch::ways(around_) << 1 | (ink_ ? 1U : 0U);
    entropy::Slot& a = slot(turns_, (history_ & 0xffffff) << 4 | base);
    entropy::Slot& b =
        slot(near_, (around_ & patch::kNear) << 11 | (history_ & 0x3ff) << 1 |
                        (ink_ ? 1U : 0U));
    entropy::Slot& c =
        slot(runs_, std::uint64_t{lengths_} << 6 | (history_ & 3) << 4 | base);
    if ((allowed & 1U << kStraight) != 0 &&
        !decide(coder, turn != kStraight, a, b, c, 0)) {
      return kStraight;
    }
    if ((allowed & 1U << kLeft) == 0) return kRight;
    if ((allowed & 1U << kRight) == 0) return kLeft;
    return decide(coder, turn == kRight, a, b, c, 1) ? kRight : kLeft;
  }

  void advance(Turn turn) {
    history_ = history_ << 2 | turn;
    if (turn == kStraight) {
      lengths_ += (lengths_ & 127) != 127 ? 1U : 0U;
    } else {
      lengths_ = lengths_ << 7;
    }
    direction_ = turned(direction_, turn);
    point_ += cracks_.step(direction_);
  }

 private:
  static constexpr std::size_t kSize = std::size_t{1} << kBits;
  using Table = std::vector<entropy::Slot>;

  static entropy::Slot& slot(Table& table, std::uint64_t value) {
    const std::uint64_t hash = value * kGolden;
    entropy::Slot& slot = table[hash >> (64 - kBits)];
    const auto check = static_cast<std::uint16_t>(hash >> 33 & 0xffff);
    if (slot.check != check) {
      slot = {};
      slot.check = check;
    }
    return slot;
  }

  template <class Coder>
  static bool decide(Coder& coder, bool truth, entropy::Slot& a,
                     entropy::Slot& b, entropy::Slot& c, std::size_t node) {
    const int sa = entropy::stretch(a.p[node]);
    const int sb = entropy::stretch(b.p[node]);
    const int wa = detail::kFastWeights[a.n[node]];
    const int wb = detail::kFastWeights[b.n[node]];
    const int sc = entropy::stretch(c.p[node]);
    const int wc = detail::kFastWeights[c.n[node]];
    const int x = (sa * wa + sb * wb + sc * wc) >> 6;
    const bool bit = coder.code(truth, entropy::squash(x));
    learn(a, node, bit);
    learn(b, node, bit);
    learn(c, node, bit);
    return bit;
  }

  static void learn(entropy::Slot& slot, std::size_t node, bool bit) {
    std::uint8_t& n = slot.n[node];
    slot.p[node] =
        entropy::moved(slot.p[node], bit, entropy::detail::kRates[n]);
    n = static_cast<std::uint8_t>(n + (n != kLimit ? 1 : 0));
  }

  static constexpr int kLimit = 127;

  const CrackMap& cracks_;
  Table turns_;
  Table near_;
  Table runs_;
  std::uint64_t around_ = 0;
  std::uint64_t history_ = 0;  ///< two bits a turn, latest lowest
  CrackMap::Address point_ = 0;
  Quarter direction_ = 0;
  std::uint32_t lengths_ = 0;  ///< of the last runs, 7 bits each
  bool ink_ = false;
};

}  // namespace unstep::codec
