#include "codec/byte_reader.h"

#include <string>

#include "unstep/grid.h"

namespace unstep::codec {

Error error_at(ErrorCode code, std::uint64_t offset, std::string_view reason) {
  return Error{code,
               "byte " + std::to_string(offset) + ": " + std::string(reason)};
}

void ByteReader::fail(ErrorCode code, std::uint64_t at,
                      std::string_view reason) {
  if (!ok_) return;
  ok_ = false;
  error_ = error_at(code, at, reason);
}

std::span<const std::uint8_t> ByteReader::bytes(std::string_view what,
                                                std::uint64_t count) {
  if (ok_ && count > left()) {
    fail(at_end_, origin_ + bytes_.size(),
         "data ends inside " + std::string(what));
  }
  if (!ok_) return {};
  const auto found = bytes_.subspan(at_, static_cast<std::size_t>(count));
  at_ += found.size();
  return found;
}

std::span<const std::uint8_t> ByteReader::rest() {
  return bytes("the rest", left());
}

std::uint64_t ByteReader::little_endian(std::string_view what, int count) {
  std::uint64_t value = 0;
  int shift = 0;
  for (const std::uint8_t byte :
       bytes(what, static_cast<std::uint64_t>(count))) {
    value |= std::uint64_t{byte} << shift;
    shift += 8;
  }
  return value;
}

std::uint8_t ByteReader::u8(std::string_view what) {
  return static_cast<std::uint8_t>(little_endian(what, 1));
}

std::uint32_t ByteReader::u32(std::string_view what) {
  return static_cast<std::uint32_t>(little_endian(what, 4));
}

std::uint64_t ByteReader::u64(std::string_view what) {
  return little_endian(what, 8);
}

std::uint64_t ByteReader::varint(std::string_view what, std::uint64_t max) {
  const std::uint64_t start = position();
  std::uint64_t value = 0;
  for (int shift = 0; ok_; shift += 7) {
    const std::uint8_t byte = u8(what);
    if (!ok_) break;
    // The tenth byte holds bit 63 alone.
    if (shift == 63 && byte > 1) {
      fail(ErrorCode::corrupt, start, std::string(what) + " exceeds 64 bits");
    } else if (byte == 0 && shift > 0) {
      fail(ErrorCode::corrupt, start,
           std::string(what) + " has superfluous bytes");
    }
    value |= std::uint64_t{byte & 0x7fU} << shift;
    if (byte < 0x80) break;
  }
  if (ok_ && value > max) {
    fail(ErrorCode::corrupt, start,
         std::string(what) + " is " + std::to_string(value) + ", at most " +
             std::to_string(max) + " is possible");
  }
  return ok_ ? value : 0;
}

std::int32_t ByteReader::coordinate(std::string_view what) {
  const std::uint64_t value =
      varint(what, 2 * static_cast<std::uint64_t>(kMaxCoord));
  const auto half = static_cast<std::int32_t>(value >> 1);
  return (value & 1) != 0 ? -half - 1 : half;
}

void ByteReader::expect_end(std::string_view what) {
  if (ok_ && left() != 0) {
    fail(ErrorCode::corrupt, position(),
         std::to_string(left()) + " bytes too many in " + std::string(what));
  }
}

}  // namespace unstep::codec
