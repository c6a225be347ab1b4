#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/decision_model.h"
#include "codec/deep_decisions.h"
#include "codec/pixel_planes.h"
#include "codec/vertex_rulers.h"
#include "entropy/counter.h"

namespace unstep::codec {

/// Predicts where pieces of ink are met, in the order of rows: for the 64
/// pixels of a word whether there is one, then for each span of eight in turn,
/// then for each of its pixels. `Decisions` has the interface of
/// DecisionModel<5, 3>.
template <class Decisions>
class LineStartModel {
 public:
  using Words = Decisions;
  using Spans = Decisions;
  using Pixels = Decisions;

  /// The planes and rulers must outlive the model.
  LineStartModel(const PixelPlanes& planes, const VertexRulers& rulers);

  /// Bytes that the constructor allocates, rounded up.
  static std::uint64_t memory(std::int32_t width);

  void begin_row(std::int32_t y);

  /// Which of the unknown pixels `mask` (not 0) of the word is the first of
  /// ink: its bit, or 0 if none is. `ink`: the true ones (encoder only).
  template <class Coder>
  std::uint64_t code(Coder& coder, std::uint64_t mask, std::int32_t word,
                     std::uint64_t ink) {
    entropy::Counter& gate = look_at_word(mask, word);
    bool any = (ink & mask) != 0;
    if (gate.n >= kGateAge && gate.p < kGateRare) {
      any = coder.code(any, gate.p + 4);
    } else {
      set_word_contexts(word);
      any = words_.code(coder, any, 0, word_selectors_);
    }
    gate.update(any);
    if (!any) return 0;
    mask = code_span(coder, mask, word, ink);
    for (;;) {
      const std::uint64_t bit = std::bit_floor(mask);
      mask &= ~bit;
      const std::int32_t x = word * 64 + std::countl_zero(bit);
      if (mask != 0) {
        look_at_pixel(x, mask);
        if (!pixels_.code(coder, (ink & bit) != 0, 0, pixel_selectors_)) {
          continue;
        }
      }
      count(x);
      return bit;
    }
  }

  /// For the training of kLineStartWeights.
  [[nodiscard]] const Words& words() const { return words_; }
  [[nodiscard]] const Spans& spans() const { return spans_; }
  [[nodiscard]] const Pixels& pixels() const { return pixels_; }

 private:
  static constexpr int kTableBits = 14;
  static constexpr int kGateAge = 24;    ///< observations before it may
  static constexpr int kGateRare = 512;  ///< of 65536
  static constexpr int kSpan = 8;        ///< pixels
  static constexpr std::uint64_t kFirstSpan = ~(~std::uint64_t{0} >> kSpan);

  /// Starts in the columns of a word, decaying over the rows; 4096 is one.
  struct Density {
    std::uint32_t quick = 0, slow = 0;
    std::int32_t last = -1000;  ///< row of the last start
    std::int32_t column = 0;    ///< and its column
  };

  /// What the flags of a word are asked under.
  struct WordSight {
    unsigned quick = 0, beside = 0, slow = 0;  ///< densities, octaves
    unsigned size = 0, close = 0;  ///< unknown pixels, those near ink, octaves
    unsigned few = 0;              ///< starts in this row before, at most 3
    std::uint64_t near_ink = 0;    ///< pixels near ink
  };

  /// Those of `mask` that are in the span of the first pixel of ink: one is.
  template <class Coder>
  std::uint64_t code_span(Coder& coder, std::uint64_t mask, std::int32_t word,
                          std::uint64_t ink) {
    for (;;) {
      const int before = std::countl_zero(mask) / kSpan * kSpan;
      const std::uint64_t span = mask & kFirstSpan >> before;
      mask &= ~span;
      if (mask == 0) return span;
      look_at_span(word * (64 / kSpan) + before / kSpan, span, mask);
      if (spans_.code(coder, (ink & span) != 0, 0, pixel_selectors_)) {
        return span;
      }
    }
  }

  /// Returns its gate.
  entropy::Counter& look_at_word(std::uint64_t mask, std::int32_t word);
  void set_word_contexts(std::int32_t word);
  void look_at_pixel(std::int32_t x, std::uint64_t rest);
  /// `at`: the span, counted along the row. `span`: its unknown pixels.
  void look_at_span(std::int32_t at, std::uint64_t span, std::uint64_t rest);
  void count(std::int32_t x);

  const PixelPlanes& planes_;
  const VertexRulers& rulers_;
  VertexRulers starts_;                     ///< starts alone
  std::vector<Density> density_;            ///< a word more on either side
  std::vector<std::int32_t> last_;          ///< the last start's row, by column
  std::vector<std::int32_t> last_in_span_;  ///< and by span
  std::vector<entropy::Counter> gates_;
  Words words_;
  Spans spans_;
  Pixels pixels_;
  WordSight sight_;
  typename Words::Selectors word_selectors_{};
  typename Pixels::Selectors pixel_selectors_{};
  std::int32_t y_ = 0;
  unsigned row_starts_ = 0;    ///< in this row
  std::int32_t row_last_ = 0;  ///< column of the last one
};

/// What the mixers start with, 12 fractional bits: words, spans, pixels.
using LineStartWeights = std::array<DecisionModel<5, 3, true>::Weights, 3>;
extern const LineStartWeights kLineStartWeights;

using CentrelineStartModel = LineStartModel<DecisionModel<5, 3, true>>;
using DeepLineStartModel = LineStartModel<DeepDecisions<5, 3>>;
extern template class LineStartModel<DecisionModel<5, 3, true>>;
extern template class LineStartModel<DeepDecisions<5, 3>>;

}  // namespace unstep::codec
