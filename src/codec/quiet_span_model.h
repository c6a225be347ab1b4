#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/far_flag_model.h"
#include "entropy/counter.h"

namespace unstep::codec {

/// Predicts whether a contour starts in a quiet span: four words in a row of
/// one colour with no known crack around. Most of most pages are such, and one
/// flag for 256 points takes less time than four. If one starts there, says in
/// which of the words (docs/format.md, Quiet spans).
class QuietSpanModel {
 public:
  static constexpr std::int32_t kWords = 4;
  /// Narrower drawings have none: they are over before this pays.
  static constexpr std::int32_t kNarrow = 16;  ///< words

  /// `words`: of 64 columns, in a row.
  explicit QuietSpanModel(std::size_t words)
      : far_(words / kWords), last_(2 * (words / kWords + 2), kNever) {
    for (entropy::Counter& counter : flags_) counter = {kRare, kFirstAge};
  }

  void begin_row(std::int32_t y) {
    y_ = y;
    far_.begin_row(y);
    found_.fill(0);
  }

  /// A far start in a word, in a quiet span or not.
  void count(std::int32_t word, bool ink) {
    const std::size_t span = static_cast<std::size_t>(word / kWords) + 1;
    if (span + 1 < last_.size() / 2) last(span, ink) = y_;
    ++found_[ink ? 1 : 0];
  }

  /// Whether a contour starts in the span that begins with `word`.
  template <class Coder>
  bool code(Coder& coder, std::int32_t word, bool ink, bool truth) {
    const auto span = static_cast<std::size_t>(word / kWords);
    const FarFlagModel::Sight sight{
        ink,
        3,
        std::min(found_[ink ? 1 : 0], 3U),
        {age(span, ink), age(span + 1, ink), age(span + 2, ink)}};
    entropy::Counter& known =
        flags_[(sight.row * 8 + sight.ages[1]) * 2 + (ink ? 1 : 0)];
    const bool any = coder.code(truth, far_.predict(known, span, sight));
    far_.update(any);
    return any;
  }

  /// The counter of the flag of a word in a span that has a start. `age`: of
  /// the word's last start, 0..7. `found`: one was found in a word before.
  entropy::Counter& word_flag(std::int32_t word, std::size_t age, bool found) {
    const auto place = static_cast<std::size_t>(word % kWords);
    return places_[(place * 8 + age) * 2 + (found ? 1 : 0)];
  }

 private:
  static constexpr std::int32_t kNever = -(1 << 20);
  static constexpr std::uint16_t kRare = 3000;  ///< of 65536
  static constexpr std::uint8_t kFirstAge = 8;

  std::int32_t& last(std::size_t span, bool ink) {
    return last_[span * 2 + (ink ? 1 : 0)];
  }
  /// 0..7: how many rows ago the last start was, an octave apart.
  std::size_t age(std::size_t span, bool ink) {
    return far_start_age(y_ - last(span, ink));
  }

  FarFlagModel far_;
  /// Rows of the last starts, by span, one more on either side, and colour.
  std::vector<std::int32_t> last_;
  std::array<entropy::Counter, 4 * 8 * 2> flags_{};
  std::array<entropy::Counter, 4 * 8 * 2> places_{};
  std::array<unsigned, 2> found_{};  ///< far starts in this row
  std::int32_t y_ = 0;
};

}  // namespace unstep::codec
