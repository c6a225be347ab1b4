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

  /// Whether the payload ends exactly as ArithmeticEncoder::finish() would end
  /// it after the bits decoded so far: nothing appended, nothing cut off, no
  /// other tail. Every payload thus has one spelling.
  [[nodiscard]] bool finished() const {
    std::size_t end = position_ - 4;  // bytes that have left the interval
    for (int keep = 0; keep <= 4; ++keep) {
      const std::uint64_t unit = std::uint64_t{1} << (32 - 8 * keep);
      const std::uint64_t value = (low_ + unit - 1) / unit * unit;
      if (value > high_) continue;
      if (value != value_) return false;
      end += static_cast<std::size_t>(keep);
      break;
    }
    std::size_t dropped = 0;
    while (dropped < 8 && end > dropped && byte_at(end - 1 - dropped) == 0) {
      ++dropped;
    }
    return bytes_.size() == end - dropped;
  }

  /// Whether more was read past the end than an encoder can have dropped (8
  /// zero bytes, and 4 that the interval looks ahead): the payload is damaged.
  [[nodiscard]] bool overrun() const { return position_ > bytes_.size() + 12; }

 private:
  [[nodiscard]] std::uint32_t byte_at(std::size_t at) const {
    return at < bytes_.size() ? bytes_[at] : 0U;
  }
  std::uint32_t next() { return byte_at(position_++); }

  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
  std::uint32_t low_ = 0;
  std::uint32_t high_ = 0xffffffffU;
  std::uint32_t value_ = 0;
};

}  // namespace unstep::entropy
