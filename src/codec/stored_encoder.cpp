#include <zlib.h>

#include "codec/container_format.h"
#include "codec/stored_coder.h"

namespace unstep::codec {
namespace {

class Deflater {
 public:
  Deflater() { usable_ = deflateInit(&stream_, Z_BEST_COMPRESSION) == Z_OK; }
  ~Deflater() { deflateEnd(&stream_); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  [[nodiscard]] bool usable() const { return usable_; }

  void add(std::span<std::uint8_t> bytes, bool last,
           std::vector<std::uint8_t>& out) {
    stream_.next_in = bytes.data();
    stream_.avail_in = static_cast<uInt>(bytes.size());
    do {
      stream_.next_out = buffer_.data();
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      deflate(&stream_, last ? Z_FINISH : Z_NO_FLUSH);
      out.insert(out.end(), buffer_.data(), stream_.next_out);
    } while (stream_.avail_out == 0);
  }

 private:
  z_stream stream_{};
  bool usable_ = false;
  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(1 << 14);
};

}  // namespace

Result<std::vector<std::uint8_t>> encode_stored(const Bitmap& ink,
                                                std::int32_t first_row,
                                                std::int32_t rows) {
  Deflater deflater;
  if (!deflater.usable()) {
    return Error{ErrorCode::limit_exceeded, "no memory for deflate"};
  }
  std::vector<std::uint8_t> row(row_bytes(ink.width()));
  std::vector<std::uint8_t> out;
  for (std::int32_t y = 0; y < rows; ++y) {
    ink.get_row_bytes(first_row + y, row, false);
    deflater.add(row, y + 1 == rows, out);
  }
  return out;
}

}  // namespace unstep::codec
