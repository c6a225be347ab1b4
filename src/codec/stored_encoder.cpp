#include <zlib.h>

#include "codec/stored_coder.h"

namespace unstep::codec {

Result<std::vector<std::uint8_t>> encode_stored(const Bitmap& ink,
                                                std::int32_t first_row,
                                                std::int32_t rows) {
  z_stream stream{};
  if (deflateInit(&stream, 9) != Z_OK) {
    return Error{ErrorCode::limit_exceeded, "no memory for deflate"};
  }
  std::vector<std::uint8_t> row((static_cast<std::size_t>(ink.width()) + 7) / 8);
  std::vector<std::uint8_t> out;
  std::vector<std::uint8_t> buffer(1 << 14);
  for (std::int32_t y = 0; y < rows; ++y) {
    ink.get_row_bytes(first_row + y, row, false);
    stream.next_in = row.data();
    stream.avail_in = static_cast<uInt>(row.size());
    do {
      stream.next_out = buffer.data();
      stream.avail_out = static_cast<uInt>(buffer.size());
      deflate(&stream, y + 1 == rows ? Z_FINISH : Z_NO_FLUSH);
      out.insert(out.end(), buffer.data(), stream.next_out);
    } while (stream.avail_out == 0);
  }
  deflateEnd(&stream);
  return out;
}

}  // namespace unstep::codec
