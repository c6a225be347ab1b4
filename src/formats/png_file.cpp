#include "formats/png_file.h"

#include <cstdio>
#include <cstring>

#include "unstep/bitmap.h"

namespace unstep {
namespace {

/// Text chunks may inflate to this much each, and there may be this many of
/// them: 64 MiB at most, whatever the file claims.
constexpr png_alloc_size_t kMaxChunkBytes = 256 << 10;
constexpr png_uint_32 kMaxChunks = 256;

void read_bytes(png_structp png, png_bytep out, std::size_t count) {
  auto* state = static_cast<PngCallbackState*>(png_get_io_ptr(png));
  if (count > state->bytes.size() - state->position) {
    state->past_end = true;
    png_error(png, "the file ends inside the image");
  }
  std::memcpy(out, state->bytes.data() + state->position, count);
  state->position += count;
}

}  // namespace

void png_keep_error(png_structp png, png_const_charp message) {
  auto* state = static_cast<PngCallbackState*>(png_get_error_ptr(png));
  std::snprintf(state->error.data(), state->error.size(), "%s", message);
  png_longjmp(png, 1);
}

void png_keep_warning(png_structp png, png_const_charp message) {
  auto* state = static_cast<PngCallbackState*>(png_get_error_ptr(png));
  if (state->warning[0] != '\0') return;
  std::snprintf(state->warning.data(), state->warning.size(), "%s", message);
}

PngFile::PngFile(std::span<const std::uint8_t> bytes) {
  state_.bytes = bytes;
  png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &state_, png_keep_error,
                                png_keep_warning);
  if (png_ != nullptr) info_ = png_create_info_struct(png_);
}

PngFile::~PngFile() { png_destroy_read_struct(&png_, &info_, nullptr); }

Status PngFile::read_header() {
  if (png_ == nullptr || info_ == nullptr) {
    return Error{ErrorCode::limit_exceeded, "no memory for libpng"};
  }
  return call([this] {
    png_set_read_fn(png_, &state_, read_bytes);
    png_set_user_limits(png_, Bitmap::kMaxSide, Bitmap::kMaxSide);
    png_set_chunk_malloc_max(png_, kMaxChunkBytes);
    png_set_chunk_cache_max(png_, kMaxChunks);
    // A damaged chunk of any kind is an error: nothing is dropped silently.
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(png_, info_);
  });
}

Error PngFile::error() const {
  return {
      state_.past_end ? ErrorCode::truncated : ErrorCode::corrupt,
      "byte " + std::to_string(state_.position) + ": " + state_.error.data()};
}

}  // namespace unstep
