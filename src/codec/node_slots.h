#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/context.h"
#include "entropy/counter.h"
#include "entropy/logistic.h"

namespace unstep::codec {

/// The memory of kContexts hashed contexts of a symbol that is made of binary
/// decisions, each with a node of eight, at most kLanes of them. Per symbol:
/// ask() for every context; learn() what became of the symbol before;
/// recall(); then predict() a decision, code it, note() it. The order lets
/// memory arrive while the last symbol is learned.
template <std::size_t kContexts, std::size_t kLanes>
class NodeSlots {
 public:
  static constexpr std::size_t kNodes = 8;
  /// Of a mixer: two for each context, and if there is room one that never
  /// changes.
  static constexpr std::size_t kInputs = (2 * kContexts + 7) / 8 * 8;

  /// 2^table_bits slots per context.
  explicit NodeSlots(int table_bits)
      : table_bits_(table_bits), slots_(kContexts << table_bits) {
    for (Slot& slot : slots_) slot.p.fill(32768);
  }

  /// Bytes of the slots.
  static std::uint64_t memory(int table_bits) {
    return sizeof(Slot) * kContexts << table_bits;
  }

  void ask(std::size_t i, std::uint64_t value) {
    const std::uint64_t hash = (value + i) * kGolden;
    Slot* slot = &slots_[(i << table_bits_) + (hash >> (64 - table_bits_))];
    __builtin_prefetch(slot, 1);
    next_[i] = slot;
    checks_[i] = static_cast<std::uint16_t>(hash >> 32);
  }

  /// For a warm start: what is known under a hash of which the upper 32 bits
  /// are those. REQUIRES: 2^16 slots per context at most, nothing asked for.
  void know(std::size_t i, std::uint16_t index, std::uint16_t check,
            std::size_t node, std::uint16_t p, std::uint8_t n) {
    const std::size_t at = std::size_t{index} >> (16 - table_bits_);
    Slot& slot = slots_[(i << table_bits_) + at];
    if (slot.check != check) renew(slot, check);
    slot.p[node] = p;
    slot.n[node] = n;
  }
  /// For training one: calls `see(context, index, check, p, n)` for the slots
  /// that know something, p and n by nodes. REQUIRES: 2^16 slots per context.
  template <class See>
  void for_each(See see) const {
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      const Slot& slot = slots_[k];
      if (slot.n == decltype(slot.n){}) continue;
      see(k >> 16, static_cast<std::uint16_t>(k), slot.check, slot.p, slot.n);
    }
  }

  void recall() {
    active_ = next_;
    for (std::size_t i = 0; i < kContexts; ++i) {
      Slot& slot = *active_[i];
      if (slot.check != checks_[i]) renew(slot, checks_[i]);
    }
  }

  /// The lane of the next decision.
  [[nodiscard]] std::size_t lane() const { return decided_; }

  /// Inputs of a mixer for the next decision: stretches, from the middle
  /// on distances from one half that grow with the age.
  void predict(std::size_t node,
               std::array<std::int16_t, kInputs>& inputs) const {
    for (std::size_t i = 0; i < kContexts; ++i) {
      const Slot& slot = *active_[i];
      inputs[i] = static_cast<std::int16_t>(entropy::stretch(slot.p[node]));
      inputs[i + kInputs / 2] = static_cast<std::int16_t>(
          ((slot.p[node] - 32768) * kTrust[slot.n[node]]) >> 16);
    }
    if constexpr (kContexts < kInputs / 2) inputs[kContexts] = 77;
  }

  void note(std::size_t node, bool bit) {
    decisions_[decided_++] = {static_cast<std::uint8_t>(node), bit};
  }

  /// Calls `each(bit, lane)` for the mixer to learn the decisions, too.
  template <class Each>
  void learn(const Each& each) {
    for (std::size_t lane = 0; lane < decided_; ++lane) {
      const auto [node, bit] = decisions_[lane];
      each(bit, lane);
      for (Slot* slot : active_) {
        std::uint8_t& n = slot->n[node];
        slot->p[node] =
            entropy::moved(slot->p[node], bit, entropy::detail::kRates[n]);
        n = static_cast<std::uint8_t>(n +
                                      (n < entropy::Counter::kLimit ? 1 : 0));
      }
    }
    decided_ = 0;
  }

 private:
  struct alignas(32) Slot {  ///< a counter for each node
    std::array<std::uint16_t, kNodes> p;
    std::array<std::uint8_t, kNodes> n;
    std::uint16_t check;
  };
  static void renew(Slot& slot, std::uint16_t check) {
    slot.p.fill(32768);
    slot.n.fill(0);
    slot.check = check;
  }
  struct Decision {  ///< one that is not yet learned from
    std::uint8_t node;
    bool bit;
  };

  int table_bits_;
  std::vector<Slot> slots_;
  std::array<Slot*, kContexts> next_{};
  std::array<std::uint16_t, kContexts> checks_{};
  std::array<Slot*, kContexts> active_{};
  std::array<Decision, kLanes> decisions_{};
  std::size_t decided_ = 0;
};

}  // namespace unstep::codec
