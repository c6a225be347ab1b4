#pragma once

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "unstep/result.h"

/// One pass over a PNG file in memory with libpng's errors as values.
namespace unstep {

/// Where libpng's callbacks write. Plain data: they must not throw, and an
/// error leaves them by longjmp.
struct PngCallbackState {
  std::span<const std::uint8_t> bytes;
  std::size_t position = 0;
  bool past_end = false;
  std::array<char, 160> error{};
  std::array<char, 160> warning{};  ///< the first one
};

/// Calls `body` (only libpng calls; nothing in it may have a destructor,
/// because an error jumps out of it). False after an error.
template <class Body>
bool guard_png(png_structp png, const Body& body) {
  // The only automatic objects between setjmp and longjmp are references.
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  body();
  return true;
}

void png_keep_error(png_structp png, png_const_charp message);
void png_keep_warning(png_structp png, png_const_charp message);

/// A reader at some point of the file. Not copyable: libpng holds its address.
class PngFile {
 public:
  explicit PngFile(std::span<const std::uint8_t> bytes);
  ~PngFile();
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  /// Reads up to the first IDAT chunk.
  Status read_header();

  template <class Body>
  Status call(const Body& body) {
    if (guard_png(png_, body)) return {};
    return error();
  }

  [[nodiscard]] png_structp png() const { return png_; }
  [[nodiscard]] png_infop info() const { return info_; }
  [[nodiscard]] std::string warning() const { return state_.warning.data(); }
  [[nodiscard]] std::size_t bytes_left() const {
    return state_.bytes.size() - state_.position;
  }

 private:
  [[nodiscard]] Error error() const;

  PngCallbackState state_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace unstep
