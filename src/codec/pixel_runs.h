#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/colour_run.h"
#include "codec/pixel_slots.h"

namespace unstep::codec {

/// Decisions about many pixels at once: whether a run of one colour changes it,
/// and where. Each is made under two contexts, how far back the row had such a
/// change and how the edges beside the run go; their mean is coded.
class PixelRuns {
 public:
  static constexpr std::uint64_t memory() {
    return (kSince + kEdges + kOctaves * (kSince + kLeft)) * sizeof(PixelSlot);
  }

  /// What is known of a run.
  struct Around {
    unsigned colours;  ///< of the two pixels above the first, the nearest low
    unsigned left;     ///< slope of the edge before the run
    unsigned right;    ///< slope of the one after it, above
  };

  /// Columns that an edge moves in a row, as a context: 0..7.
  [[nodiscard]] static unsigned slope(int columns) {
    return static_cast<unsigned>(std::clamp(columns, -4, 3) + 4);
  }

  void begin_row() { last_ = -kFar; }

  /// Whether and where a run from x to `end` changes its colour: the first
  /// pixel that does, or `end`. `change` is the truth.
  template <class Coder>
  std::int32_t code_run(Coder& coder, std::int32_t change, std::int32_t x,
                        std::int32_t end, const Around& around) {
    const unsigned length = octave(end - x);
    const unsigned kind = around.colours << 4 | length;
    const unsigned since = (std::clamp(octave(x - last_), 3U, 10U) - 3) << 6;
    if (!decide(coder, change < end, since_[since | kind],
                edges_[around.right << 9 | around.left << 6 | kind])) {
      return end;
    }
    PixelSlot* near_since = &near_since_[(since | kind) * kOctaves];
    PixelSlot* near_left = &near_left_[(around.left << 4 | length) * kOctaves];
    // Powers of two, up to the first that the change is not as far as.
    std::int32_t from = x;
    std::int32_t until = x + 1;
    while (until < end) {
      const unsigned far = octave(until - x);
      if (!decide(coder, change >= until, near_since[far], near_left[far])) {
        break;
      }
      from = until;
      until += until - x;
    }
    last_ = code_change(coder, change, from, std::min(until, end));
    return last_;
  }

 private:
  // How many contexts there are of each kind.
  static constexpr std::size_t kOctaves = 16;
  static constexpr std::size_t kLeft = 8 * kOctaves;
  static constexpr std::size_t kSince = 8 * 4 * kOctaves;
  static constexpr std::size_t kEdges = 8 * kSince;
  static constexpr std::int32_t kFar = 512;  ///< the last class, 512 and more

  /// Binary digits, at most 15.
  static unsigned octave(std::int32_t length) {
    return std::min(
        static_cast<unsigned>(std::bit_width(static_cast<unsigned>(length))),
        15U);
  }

  template <class Coder>
  static bool decide(Coder& coder, bool truth, PixelSlot& a, PixelSlot& b) {
    const bool bit = coder.code(truth, std::clamp((a.p + b.p) / 2, 2, 65534));
    a.learn(bit);
    b.learn(bit);
    return bit;
  }

  using Slots = std::vector<PixelSlot>;
  Slots since_ = Slots(kSince);
  Slots edges_ = Slots(kEdges);
  Slots near_since_ = Slots(kSince * kOctaves);
  Slots near_left_ = Slots(kLeft * kOctaves);
  std::int32_t last_ = 0;  ///< where this row changed its colour last
};

}  // namespace unstep::codec
