#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace unstep::codec {

/// The mirror of ByteReader.
class ByteWriter {
 public:
  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void u32(std::uint32_t value) { little_endian(value, 4); }
  void u64(std::uint64_t value) { little_endian(value, 8); }

  void varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) {
      u8(static_cast<std::uint8_t>(value | 0x80));
    }
    u8(static_cast<std::uint8_t>(value));
  }

  /// REQUIRES: within [-kMaxCoord, kMaxCoord].
  void coordinate(std::int32_t value) {
    varint(value >= 0 ? 2 * static_cast<std::uint64_t>(value)
                      : 2 * static_cast<std::uint64_t>(-(value + 1)) + 1);
  }

  void bytes(std::span<const std::uint8_t> more) {
    bytes_.insert(bytes_.end(), more.begin(), more.end());
  }

  [[nodiscard]] std::uint64_t size() const { return bytes_.size(); }
  [[nodiscard]] const std::vector<std::uint8_t>& view() const { return bytes_; }
  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void little_endian(std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) {
      u8(static_cast<std::uint8_t>(value >> (8 * i)));
    }
  }

  std::vector<std::uint8_t> bytes_;
};

}  // namespace unstep::codec
