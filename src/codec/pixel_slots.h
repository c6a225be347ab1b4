#pragma once

#include <cstddef>
#include <cstdint>

#include "codec/context.h"
#include "entropy/counter.h"
#include "entropy/table_memory.h"

namespace unstep::codec {

/// A probability with its age in the low and check bits of its context in the
/// high byte of `tag`. No field is a byte, which in C++ may alias anything: the
/// loop over the pixels keeps its state in registers.
struct PixelSlot {
  std::uint16_t p = 32768;
  std::uint16_t tag = 0;

  [[nodiscard]] unsigned age() const { return tag & 0xffU; }

  void learn(bool bit) {
    p = entropy::moved(p, bit, entropy::detail::kRates[age()]);
    tag = static_cast<std::uint16_t>(tag + (age() != 0xff ? 1 : 0));
  }
};
static_assert(sizeof(PixelSlot) == 4);

/// The slots of one hashed context.
class PixelTable {
 public:
  explicit PixelTable(int bits)
      : shift_(64 - bits),
        slots_(entropy::make_table(std::size_t{1} << bits, PixelSlot{})) {}

  static constexpr std::uint64_t memory(int bits) {
    return std::uint64_t{sizeof(PixelSlot)} << bits;
  }

  /// A slot as it was found, or a new one if its check differs. Without
  /// branches: whether a large context is known is anyone's guess.
  struct Found {
    PixelSlot* place;
    PixelSlot slot;

    void learn(bool bit) {
      slot.learn(bit);
      *place = slot;
    }
  };
  /// A new one begins with the probability p.
  Found find(std::uint64_t context, int p = 32768) {
    const std::uint64_t hash = context * kGolden;
    PixelSlot* place = &slots_[hash >> shift_];
    const unsigned check = hash >> 32 & 0xff00U;
    const unsigned differs = (place->tag ^ check) >> 8;
    const unsigned known = (differs - 1) >> 16;  // 0xffff or 0
    const auto start = static_cast<unsigned>(p);
    return {place,
            {static_cast<std::uint16_t>(((place->p ^ start) & known) ^ start),
             static_cast<std::uint16_t>(check | (place->tag & known & 0xffU))}};
  }

 private:
  int shift_;
  entropy::Table<PixelSlot> slots_;
};

}  // namespace unstep::codec
