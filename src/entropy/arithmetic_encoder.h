#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace unstep::entropy {

/// Binary arithmetic coder, carryless, 32-bit interval [low, high] (after
/// M. Mahoney, "Data Compression Explained", 2012, 3.2). docs/format.md gives
/// the decoder's view.
class ArithmeticEncoder {
 public:
  /// Bounded, so that a decoder can tell a damaged payload by its overrun.
  static constexpr int kMaxDropped = 8;

  /// Codes `bit`, whose probability of being 1 is p1 / 65536, and returns it.
  /// REQUIRES: 1 <= p1 <= 65535.
  bool code(bool bit, int p1) {
    const std::uint32_t range = high_ - low_;
    const std::uint32_t middle =
        low_ +
        static_cast<std::uint32_t>(
            (std::uint64_t{range} * static_cast<std::uint32_t>(p1)) >> 16);
    if (bit) {
      high_ = middle;
    } else {
      low_ = middle + 1;
    }
    while (((low_ ^ high_) & 0xff000000U) == 0) {
      bytes_.push_back(static_cast<std::uint8_t>(high_ >> 24));
      low_ <<= 8;
      high_ = (high_ << 8) | 0xff;
    }
    return bit;
  }

  /// The coded bytes. The decoder reads zeros past the end, so the tail is the
  /// shortest byte string that lands in the interval, and up to kMaxDropped
  /// trailing zero bytes are dropped. The encoder is spent afterwards.
  [[nodiscard]] std::vector<std::uint8_t> finish() {
    for (int keep = 0; keep <= 4; ++keep) {
      // The smallest multiple of 256^(4 - keep) that is not below low.
      const std::uint64_t unit = std::uint64_t{1} << (32 - 8 * keep);
      const std::uint64_t value = (low_ + unit - 1) / unit * unit;
      if (value > high_) continue;
      for (int i = 0; i < keep; ++i) {
        bytes_.push_back(static_cast<std::uint8_t>(value >> (24 - 8 * i)));
      }
      break;
    }
    for (int i = 0; i < kMaxDropped; ++i) {
      if (bytes_.empty() || bytes_.back() != 0) break;
      bytes_.pop_back();
    }
    return std::move(bytes_);
  }

  /// Bytes written so far, for cost estimates.
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }

 private:
  std::uint32_t low_ = 0;
  std::uint32_t high_ = 0xffffffffU;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace unstep::entropy
