#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/colour_run.h"
#include "codec/pixel_models.h"
#include "codec/pixel_rows.h"
#include "codec/pixel_slots.h"

namespace unstep::codec {

/// Decisions about many pixels at once.
class PixelRuns {
 public:
  static constexpr std::uint64_t memory() { return kRuns * sizeof(PixelSlot); }

  /// Whether and where a run from x to `end` changes its colour: the first
  /// pixel that does, or `end`. `change` is the truth. `colours`: of the pixels
  /// before x and of the two above it, bit 0 first.
  template <class Coder>
  std::int32_t code_run(Coder& coder, std::int32_t change, std::int32_t x,
                        std::int32_t end, unsigned colours, bool last) {
    const auto length = static_cast<unsigned>(end - x);
    const unsigned octave =
        std::min(static_cast<unsigned>(std::bit_width(length)), 15U);
    PixelSlot& slot = runs_[octave | colours << 4 | (last ? 128U : 0U) |
                            (x == 0 ? 256U : 0U)];
    const bool changes =
        coder.code(change < end, std::clamp<int>(slot.p, 2, 65534));
    slot.learn(changes);
    return changes ? code_change(coder, change, x, end) : end;
  }

 private:
  static constexpr std::size_t kRuns = 512;
  std::array<PixelSlot, kRuns> runs_{};
};

}  // namespace unstep::codec
