#include <zlib.h>

#include "codec/stored_coder.h"

namespace unstep::codec {

Status decode_stored(std::span<const std::uint8_t> payload, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows) {
  if (payload.size() > 0xffffffffU) {
    return Error{ErrorCode::limit_exceeded, "stored payload above 4 GiB"};
  }
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) {
    return Error{ErrorCode::limit_exceeded, "no memory for inflate"};
  }
  stream.next_in = const_cast<Bytef*>(payload.data());
  stream.avail_in = static_cast<uInt>(payload.size());
  std::vector<std::uint8_t> row((static_cast<std::size_t>(ink.width()) + 7) / 8);
  int state = Z_OK;
  std::int32_t y = 0;
  for (; y < rows; ++y) {
    stream.next_out = row.data();
    stream.avail_out = static_cast<uInt>(row.size());
    while (stream.avail_out > 0 && state == Z_OK) {
      state = inflate(&stream, Z_NO_FLUSH);
    }
    if (stream.avail_out > 0) break;
    ink.set_row_bytes(first_row + y, row, false);
  }
  // The stream must end exactly with the last row and the last byte.
  std::uint8_t extra = 0;
  stream.next_out = &extra;
  stream.avail_out = 1;
  if (y == rows && state == Z_OK) state = inflate(&stream, Z_FINISH);
  const bool exact =
      state == Z_STREAM_END && stream.avail_out == 1 && stream.avail_in == 0;
  inflateEnd(&stream);
  if (y != rows || !exact) {
    return Error{ErrorCode::corrupt, "stored payload is damaged at row " +
                                         std::to_string(first_row + y)};
  }
  return {};
}

}  // namespace unstep::codec
