#include "formats/deflater.h"

#include <zlib.h>

#include <array>

namespace unstep {

struct Deflater::Stream {
  z_stream state{};
  Stream() { ready = deflateInit(&state, Z_BEST_COMPRESSION) == Z_OK; }
  ~Stream() {
    if (ready) deflateEnd(&state);
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  bool ready = false;
};

Deflater::Deflater() = default;
Deflater::~Deflater() = default;

Status Deflater::add(std::string_view bytes, std::string& out) {
  return run(bytes, Z_NO_FLUSH, out);
}

Status Deflater::finish(std::string& out) {
  Status done = run({}, Z_FINISH, out);
  stream_.reset();
  return done;
}

/// REQUIRES: bytes.size() < 2^32.
Status Deflater::run(std::string_view bytes, int flush, std::string& out) {
  if (!stream_) stream_ = std::make_unique<Stream>();
  if (!stream_->ready) {
    return Error{ErrorCode::limit_exceeded, "no memory to compress"};
  }
  z_stream& state = stream_->state;
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  state.avail_in = static_cast<uInt>(bytes.size());
  std::array<char, 1 << 14> buffer;
  do {
    state.next_out = reinterpret_cast<Bytef*>(buffer.data());
    state.avail_out = buffer.size();
    if (deflate(&state, flush) == Z_STREAM_ERROR) {
      return Error{ErrorCode::internal, "zlib refused to compress"};
    }
    out.append(buffer.data(), buffer.size() - state.avail_out);
  } while (state.avail_out == 0);
  return {};
}

}  // namespace unstep
