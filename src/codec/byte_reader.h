#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "unstep/result.h"

namespace unstep::codec {

/// Reads fields of foreign bytes. The first failure sticks: later reads give
/// zeros, and error() says what was wrong where. So a whole record is read
/// and tested once.
///
///     ByteReader in(bytes, 0, ErrorCode::truncated);
///     const std::uint64_t width = in.varint("width", kMax);
///     if (!in.ok()) return in.error();
class ByteReader {
 public:
  /// `origin` is the file offset of bytes[0], for messages and position().
  /// `at_end` is what running out of bytes means here.
  ByteReader(std::span<const std::uint8_t> bytes, std::uint64_t origin,
             ErrorCode at_end)
      : bytes_(bytes), origin_(origin), at_end_(at_end) {}

  std::uint8_t u8(std::string_view what);
  std::uint32_t u32(std::string_view what);  ///< little-endian
  std::uint64_t u64(std::string_view what);  ///< little-endian

  /// Canonical LEB128 (docs/format.md, Numbers), at most `max`.
  std::uint64_t varint(std::string_view what, std::uint64_t max);

  /// Zigzag of a varint, within [-kMaxCoord, kMaxCoord].
  std::int32_t coordinate(std::string_view what);

  std::span<const std::uint8_t> bytes(std::string_view what,
                                      std::uint64_t count);
  std::span<const std::uint8_t> rest();

  /// Fails if bytes are left over.
  void expect_end(std::string_view what);

  /// Fails as `code`; `at` is a file offset.
  void fail(ErrorCode code, std::uint64_t at, std::string_view reason);

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] const Error& error() const { return error_; }
  [[nodiscard]] std::uint64_t position() const { return origin_ + at_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::uint64_t little_endian(std::string_view what, int bytes);

  std::span<const std::uint8_t> bytes_;
  std::uint64_t origin_;
  ErrorCode at_end_;
  std::size_t at_ = 0;
  bool ok_ = true;
  Error error_;
};

/// "byte 123: reason"
[[nodiscard]] Error error_at(ErrorCode code, std::uint64_t offset,
                             std::string_view reason);

}  // namespace unstep::codec
