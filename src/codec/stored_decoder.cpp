#include <zlib.h>

#include <string>

#include "codec/container_format.h"
#include "codec/stored_coder.h"

namespace unstep::codec {
namespace {

class Inflater {
 public:
  explicit Inflater(std::span<const std::uint8_t> bytes) {
    usable_ = inflateInit(&stream_) == Z_OK;
    stream_.next_in = const_cast<Bytef*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  [[nodiscard]] bool usable() const { return usable_; }

  /// False if the stream does not give that many bytes.
  bool fill(std::span<std::uint8_t> out) {
    stream_.next_out = out.data();
    stream_.avail_out = static_cast<uInt>(out.size());
    while (stream_.avail_out > 0 && state_ == Z_OK) {
      state_ = inflate(&stream_, Z_NO_FLUSH);
    }
    return stream_.avail_out == 0;
  }

  /// True if the stream, its check value included, ends right here and
  /// nothing follows.
  bool at_end() {
    std::uint8_t extra = 0;
    return !fill({&extra, 1}) && state_ == Z_STREAM_END &&
           stream_.avail_in == 0;
  }

 private:
  z_stream stream_{};
  bool usable_ = false;
  int state_ = Z_OK;
};

}  // namespace

Status decode_stored(std::span<const std::uint8_t> payload, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows) {
  if (payload.size() > 0xffffffffU) {  // zlib counts in 32 bits
    return Error{ErrorCode::limit_exceeded, "stored payload above 4 GiB"};
  }
  Inflater inflater(payload);
  if (!inflater.usable()) {
    return Error{ErrorCode::limit_exceeded, "no memory for inflate"};
  }
  std::vector<std::uint8_t> row(row_bytes(ink.width()));
  for (std::int32_t y = 0; y < rows; ++y) {
    if (!inflater.fill(row)) {
      return Error{ErrorCode::corrupt, "stored payload is damaged at row " +
                                           std::to_string(first_row + y)};
    }
    ink.set_row_bytes(first_row + y, row, false);
  }
  if (!inflater.at_end()) {
    return Error{ErrorCode::corrupt,
                 "stored payload does not end with the last row"};
  }
  return {};
}

}  // namespace unstep::codec
