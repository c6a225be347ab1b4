#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/crack_map.h"
#include "codec/deep_model.h"
#include "codec/start_model.h"
#include "codec/warm_start.h"

namespace unstep::codec {

/// Predicts where contours start for the max effort. Starts far from known
/// cracks, most of the bytes, are told by two DeepModels: whether there is one
/// in a word, and in which half of what is left of it. Both see how densely
/// starts have come here and how near known cracks are: islands lie off coasts.
class DeepStartModel : public StartModel {
 public:
  DeepStartModel(const CrackMap& cracks, const warm::Table& start);

  /// Bytes that the constructor allocates beside what StartModel does.
  static std::uint64_t memory(std::int32_t width);

  void begin_row(std::int32_t y);

  /// Quiet spans save time, not bytes: none.
  template <class Coder, class AnyStart>
  static std::int32_t code_quiet_span(
      Coder& /*coder*/, std::int32_t /*word*/,
      const std::vector<std::uint64_t>& /*above*/,
      const AnyStart& /*any_start*/) {
    return 0;
  }

  /// As of StartModel.
  template <class Coder>
  std::uint64_t code_open(Coder& coder, std::uint64_t mask, std::int32_t word,
                          bool ink, std::uint64_t starts) {
    look_at_word(mask, word, ink);
    if (!flags_.code(coder, (starts & mask) != 0, choice_)) return 0;
    std::uint64_t start = std::bit_floor(starts & mask);
    // What is left of the mask is turned so that it begins at the anchor.
    mask = std::rotl(mask, anchor_);
    start = std::rotl(start, anchor_);
    std::uint64_t range = ~std::uint64_t{0};
    std::size_t node = 1;
    for (unsigned half = 32; half > 0; half /= 2) {
      const std::uint64_t first = range & ~(range >> half);
      const std::uint64_t before = mask & first;
      const std::uint64_t after = mask & range & ~first;
      bool second = before == 0;
      if (!second && after != 0) {
        look_at_halves(std::rotr(before, anchor_), std::rotr(after, anchor_),
                       half, node);
        second = places_.code(coder, (start & first) == 0, place_choice_);
      }
      range &= second ? ~first : first;
      node = node * 2 + (second ? 1 : 0);
    }
    const std::uint64_t bit = std::rotr(mask & range, anchor_);
    count(bit);
    return bit;
  }

 private:
  static constexpr int kTableBits = 16;
  static constexpr std::size_t kRates = 3;
  static constexpr std::size_t kBytes = 8;  ///< of a word: 8 points each
  static constexpr std::int32_t kReach = 15;
  using Flags = DeepModel<13, 1, 4, 2>;
  using Places = DeepModel<8, 2, 3, 1>;
  static const Flags::Choice kFlagSizes;
  static const Places::Choice kPlaceSizes;

  /// The last start among the points of a word.
  struct Last {
    std::int32_t y = -(1 << 20);
    std::uint64_t bit = 0;
  };
  /// What is known of the starts of one colour, with a word more on either
  /// side. 256 is one start.
  struct Past {
    std::array<std::vector<std::uint32_t>, kRates> words;
    std::vector<std::uint32_t> bytes;
    std::vector<Last> last;
    unsigned row = 0;        ///< in this row
    std::uint64_t rows = 0;  ///< in the rows before, 8 bits each
    std::int32_t x = -128;   ///< of the last one in this row
  };

  void look_at_word(std::uint64_t mask, std::int32_t word, bool ink);
  void look_at_halves(std::uint64_t before, std::uint64_t after, unsigned half,
                      std::size_t node);
  void count(std::uint64_t bit);
  void look_at_cracks(std::int32_t word);
  [[nodiscard]] std::size_t age(const Last& last) const {
    return far_start_age(y_ - last.y);
  }
  [[nodiscard]] std::uint64_t wide(std::size_t rate) const {
    const auto& d = past_->words[rate];
    return d[at_] + (d[at_ - 1] + d[at_ + 1]) / 2;
  }
  [[nodiscard]] std::uint32_t density(std::uint64_t points) const;
  [[nodiscard]] unsigned nearness(std::uint64_t points) const;

  const CrackMap& cracks_;
  Flags flags_;
  Places places_;
  Flags::Choice choice_;
  Places::Choice place_choice_;
  std::array<Past, 2> pasts_;
  std::int32_t y_ = 0;

  // The word looked at.
  Past* past_ = nullptr;
  std::size_t at_ = 0;  ///< its number and 1
  std::uint64_t colour_ = 0;
  int anchor_ = 0;
  unsigned kind_ = 0;  ///< of the anchor
  /// Points within 4, 8 and 15 of a known crack, along columns plus rows.
  std::array<std::uint64_t, 3> near_{};
};

}  // namespace unstep::codec
