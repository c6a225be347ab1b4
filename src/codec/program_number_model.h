#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/decision_model.h"
#include "codec/program_predictors.h"

namespace unstep::codec {

/// What is known of a number beside its predictions.
struct ProgramNumberPlace {
  std::size_t word = 0;
  const AxisTrail* trail = nullptr;  ///< of numbers of this word
  unsigned vectors = 0;              ///< lengths of the matches
  unsigned places = 0;
};

/// Codes numbers of motions: how far they are from the prediction that was the
/// best of late, by halving; every prediction is a context of every decision,
/// by where it lies from what the decision separates.
class ProgramNumberModel {
 public:
  static constexpr std::size_t kExtras = 5;
  static constexpr std::size_t kContexts = kProgramPredictors + kExtras;
  using Decisions = DecisionModel<kContexts>;

  explicit ProgramNumberModel(int table_bits);

  /// A motion begins.
  void begin() { line_residual_ = 0; }

  /// What coding a number would start from, for contexts of whether it is
  /// there: the class of the prediction, and of its error.
  [[nodiscard]] std::uint64_t outlook(
      std::size_t word, const ProgramPredictions& predictions) const;

  /// |value| and predictions are at most 2^52. In a decoder the result may be
  /// any number below 2^55.
  template <class Coder>
  std::int64_t code(Coder& coder, const ProgramNumberPlace& place,
                    const ProgramPredictions& predictions, std::int64_t value) {
    begin_number(place, predictions);
    const std::int64_t base = predictions[primary_];
    const std::int64_t coded = base + code_residual(coder, value - base);
    learn(coded);
    return coded;
  }

 private:
  static constexpr unsigned kMaxWidth = 54;
  /// Nodes of decisions.
  static constexpr std::uint32_t kZero = 0, kSign = 1, kWidth = 2, kBits = 64;

  template <class Coder>
  std::int64_t code_residual(Coder& coder, std::int64_t residual) {
    const auto decision = [&](bool bit, std::uint32_t node, std::int64_t border,
                              std::uint32_t selector, std::uint64_t prefix) {
      set_contexts(border, prefix);
      return decisions_.code(coder, bit, node,
                             {word_class_ * 128 + selector, second_selector_});
    };
    if (!decision(residual != 0, kZero, 0, 0, 0)) return 0;
    const bool negative = decision(residual < 0, kSign, 0, 1, 0);
    const std::int64_t sign = negative ? -1 : 1;
    const auto size =
        static_cast<std::uint64_t>(residual < 0 ? -residual : residual);
    const auto true_width = static_cast<unsigned>(std::bit_width(size));
    unsigned width = 1;
    while (width < kMaxWidth &&
           decision(true_width > width, kWidth + width,
                    sign * (std::int64_t{1} << width), 2 + std::min(width, 30U),
                    negative ? 2 : 1)) {
      ++width;
    }
    std::int64_t coded = 1;
    for (unsigned i = width - 1; i-- > 0;) {
      const unsigned depth = width - 2 - i;
      const std::int64_t border = (2 * coded + 1) << i;
      const std::uint64_t prefix =
          static_cast<std::uint64_t>(coded) * 4 + (negative ? 2 : 1);
      const bool one =
          decision((size >> i & 1) != 0,
                   kBits + width * 64 + std::min(depth, 63U), sign * border,
                   34 + std::min(width, 20U) * 4 + std::min(depth, 3U), prefix);
      coded = 2 * coded + (one ? 1 : 0);
    }
    return sign * coded;
  }

  void begin_number(const ProgramNumberPlace& place,
                    const ProgramPredictions& predictions);
  /// `border`: what the decision separates, from the first prediction.
  void set_contexts(std::int64_t border, std::uint64_t prefix);
  void learn(std::int64_t value);
  [[nodiscard]] std::size_t best(std::size_t word) const;

  Decisions decisions_;
  /// Sizes of errors of each prediction in binary digits, times 16, averaged.
  std::array<std::array<std::int32_t, kProgramPredictors>, kProgramWords>
      errors_{};
  std::array<std::array<std::int64_t, 2>, kProgramWords> residuals_{};

  // Of the number at hand.
  ProgramNumberPlace place_;
  ProgramPredictions predictions_{};
  std::size_t primary_ = 0;
  std::uint32_t word_class_ = 0;
  std::uint32_t second_selector_ = 0;
  std::int64_t line_residual_ = 0;  ///< of the number before on the line
};

}  // namespace unstep::codec
