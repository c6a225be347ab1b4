#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "entropy/counter.h"

namespace unstep::codec {

/// Codes whole numbers: the length of v + 1 in unary, then its bits below the
/// first, of which the highest three have their own probabilities.
class NumberModel {
 public:
  static constexpr unsigned kMaxWidth = 50;  ///< numbers below 2^50 - 1

  template <class Coder>
  std::uint64_t code(Coder& coder, std::uint64_t value) {
    const auto true_width = static_cast<unsigned>(std::bit_width(value + 1));
    unsigned width = 1;
    while (width < kMaxWidth) {
      if (!decide(coder, widths_[width], true_width > width)) break;
      ++width;
    }
    std::uint64_t v = 1;
    for (unsigned i = width - 1; i-- > 0;) {
      const bool bit = (value + 1) >> i & 1;
      const unsigned depth = width - 2 - i;
      const bool coded = depth < 3 ? decide(coder, leading_[width * 8 + v], bit)
                                   : coder.code(bit, 32768);
      v = v << 1 | (coded ? 1U : 0U);
    }
    return v - 1;
  }

  /// Starts with what numbers of other drawings were like, in 256ths: how often
  /// v + 1 has more than 1, 2, .. binary digits, and how often the digit is 1
  /// after 1, if there are two digits; after 1, 10, 11, if three; after 1, 10,
  /// 11, 100, .. 111, if four.
  void expect(std::span<const std::uint8_t> widths,
              std::span<const std::uint8_t> digits) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
      widths_[i + 1] = expected(widths[i]);
    }
    for (std::size_t i = 0; i < digits.size(); ++i) {
      // 1; 1, 2, 3; 1 .. 7: what stands before a digit, by length.
      const std::size_t width = i < 1 ? 2 : i < 4 ? 3 : 4;
      const std::size_t first = i < 1 ? 0 : i < 4 ? 1 : 4;
      leading_[width * 8 + 1 + i - first] = expected(digits[i]);
    }
  }

  /// A counter that has seen 4 bits, of which `p` / 256 were 1.
  static entropy::Counter expected(std::uint8_t p) {
    return {static_cast<std::uint16_t>(p * 256), 4};
  }

  template <class Coder>
  static bool decide(Coder& coder, entropy::Counter& counter, bool bit) {
    const bool coded = coder.code(bit, counter.p1());
    counter.update(coded);
    return coded;
  }

 private:
  std::array<entropy::Counter, kMaxWidth + 1> widths_;
  std::array<entropy::Counter, (kMaxWidth + 1) * 8> leading_;
};

/// Numbers of either sign: the size, then the sign if there is one.
class SignedNumberModel {
 public:
  /// The same for sizes; `negative` as often.
  void expect(std::span<const std::uint8_t> widths,
              std::span<const std::uint8_t> digits, std::uint8_t negative) {
    size_.expect(widths, digits);
    sign_ = NumberModel::expected(negative);
  }

  template <class Coder>
  std::int64_t code(Coder& coder, std::int64_t value) {
    const auto size = static_cast<std::uint64_t>(value < 0 ? -value : value);
    const auto coded = static_cast<std::int64_t>(size_.code(coder, size));
    if (coded == 0) return 0;
    const bool negative = NumberModel::decide(coder, sign_, value < 0);
    return negative ? -coded : coded;
  }

 private:
  NumberModel size_;
  entropy::Counter sign_;
};

}  // namespace unstep::codec
