#pragma once

#include <cstdint>
#include <span>

namespace unstep::entropy {

/// The inverse of ArithmeticEncoder. Reads zeros past the end and never fails
/// while decoding; whoever decodes checks finished() and the checksum.
class ArithmeticDecoder {
 public:
  /// `bytes` must outlive the decoder.
  explicit ArithmeticDecoder(std::span<const std::uint8_t> bytes)
      : bytes_(bytes) {
    for (int i = 0; i < 4; ++i) value_ = (value_ << 8) | next();
  }

  /// The next bit, whose probability of being 1 is p1 / 65536. The first
  /// argument is what the encoder coded; here it is not known and not used.
  bool code(bool /*bit*/, int p1) {
    const std::uint32_t range = high_ - low_;
    const std::uint32_t middle =
        low_ +
        static_cast<std::uint32_t>(
            (std::uint64_t{range} * static_cast<std::uint32_t>(p1)) >> 16);
    const bool bit = value_ <= middle;
    if (bit) {
      high_ = middle;
    } else {
      low_ = middle + 1;
    }
    while (((low_ ^ high_) & 0xff000000U) == 0) {
      low_ <<= 8;
      high_ = (high_ << 8) | 0xff;
      value_ = (value_ << 8) | next();
    }
    return bit;
  }

  /// Whether every payload byte was read.
  [[nodiscard]] bool finished() const { return position_ >= bytes_.size(); }

  /// Whether more was read past the end than an encoder can have dropped (8
  /// zero bytes, and 4 that the interval looks ahead): the payload is damaged.
  [[nodiscard]] bool overrun() const { return position_ > bytes_.size() + 12; }

 private:
  std::uint32_t next() {
    const std::uint32_t byte =
        position_ < bytes_.size() ? bytes_[position_] : 0U;
    ++position_;
    return byte;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
  std::uint32_t low_ = 0;
  std::uint32_t high_ = 0xffffffffU;
  std::uint32_t value_ = 0;
};

}  // namespace unstep::entropy
