#include "unstep/bitmap.h"

#include <zlib.h>

#include <bit>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "grid/bit_count.h"

namespace unstep {
namespace {

constexpr std::size_t kWord = sizeof(std::uint64_t);

/// The word whose bytes in memory are those of `word`, the highest first.
std::uint64_t most_significant_first(std::uint64_t word) {
  return std::endian::native == std::endian::little ? __builtin_bswap64(word)
                                                    : word;
}

/// The first of `count` bytes highest, zeros after them.
std::uint64_t load_word(const std::uint8_t* bytes, std::size_t count) {
  std::uint64_t word = 0;
  if (count != 0) std::memcpy(&word, bytes, count);
  return most_significant_first(word);
}

}  // namespace

Result<Bitmap> Bitmap::create(std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    return Error{ErrorCode::out_of_range, "raster of " + std::to_string(width) +
                                              " x " + std::to_string(height) +
                                              " pixels; sides are 1 to " +
                                              std::to_string(kMaxSide)};
  }
  Bitmap bitmap;
  bitmap.width_ = static_cast<std::int32_t>(width);
  bitmap.height_ = static_cast<std::int32_t>(height);
  bitmap.words_per_row_ = (static_cast<std::size_t>(width) + 63) / 64;
  try {
    // < 2^24 words a row times < 2^30 rows: no overflow in 64 bits.
    bitmap.words_.resize(bitmap.words_per_row_ *
                         static_cast<std::size_t>(height));
  } catch (const std::exception&) {  // bad_alloc or length_error
    return Error{ErrorCode::limit_exceeded,
                 "no memory for a raster of " + std::to_string(width) + " x " +
                     std::to_string(height) + " pixels"};
  }
  return bitmap;
}

void Bitmap::set_row_bytes(std::int32_t y, std::span<const std::uint8_t> bytes,
                           bool invert) {
  const std::span<std::uint64_t> words = row(y);
  const std::uint64_t flip = invert ? ~std::uint64_t{0} : 0;
  const std::size_t whole = bytes.size() / kWord;
  // A copy of a fixed size is one instruction, not a call.
  for (std::size_t i = 0; i < whole; ++i) {
    words[i] = load_word(bytes.data() + kWord * i, kWord) ^ flip;
  }
  if (whole < words.size()) {
    words[whole] =
        load_word(bytes.data() + kWord * whole, bytes.size() % kWord) ^ flip;
  }
  words.back() &= last_word_mask();
}

void Bitmap::get_row_bytes(std::int32_t y, std::span<std::uint8_t> bytes,
                           bool invert) const {
  const std::span<const std::uint64_t> words = row(y);
  const std::uint64_t flip = invert ? ~std::uint64_t{0} : 0;
  const std::size_t last = words.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const std::uint64_t word = most_significant_first(words[i] ^ flip);
    std::memcpy(bytes.data() + kWord * i, &word, kWord);
  }
  const std::uint64_t word =
      most_significant_first((words[last] ^ flip) & last_word_mask());
  std::memcpy(bytes.data() + kWord * last, &word, bytes.size() - kWord * last);
}

std::uint32_t Bitmap::crc32() const {
  std::vector<std::uint8_t> bytes((static_cast<std::size_t>(width_) + 7) / 8);
  uLong crc = ::crc32(0L, nullptr, 0);
  for (std::int32_t y = 0; y < height_; ++y) {
    get_row_bytes(y, bytes, false);
    crc = ::crc32_z(crc, bytes.data(), bytes.size());
  }
  return static_cast<std::uint32_t>(crc);
}

std::uint64_t Bitmap::ink() const {
  std::uint64_t count = 0;
  for (const std::uint64_t word : words_) {
    count += static_cast<std::uint64_t>(ones(word));
  }
  return count;
}

}  // namespace unstep
