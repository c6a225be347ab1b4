#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace unstep::codec {

/// The pixels of a raster that are known so far, which of these are ink, and
/// which have been passed: three bit planes with a margin that is known to be
/// paper. As in Bitmap the first bit of a word is the highest. A pixel is
/// addressed by one number, so that a neighbour is a constant away.
class PixelPlanes {
 public:
  using Address = std::ptrdiff_t;
  static constexpr std::int32_t kMargin = 3;  ///< rows; 64 columns

  /// Bytes that the constructor allocates. No overflow: sides < 2^30.
  static std::uint64_t memory(std::int32_t width, std::int32_t height) {
    return 3 * plane_bytes(width, height);
  }

  PixelPlanes(std::int32_t width, std::int32_t height)
      : width_(width),
        height_(height),
        stride_(static_cast<Address>(stride_words(width) * 64)),
        known_(plane_bytes(width, height), 0xff),
        ink_(plane_bytes(width, height)),
        passed_(plane_bytes(width, height)) {
    const std::int32_t words = (width + 63) / 64;
    const int spare = words * 64 - width;
    for (std::int32_t y = 0; y < height; ++y) {
      for (std::int32_t w = 0; w < words; ++w) {
        store(
            known_, y, w,
            w + 1 < words || spare == 0 ? 0 : (std::uint64_t{1} << spare) - 1);
      }
    }
  }

  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }
  [[nodiscard]] Address stride() const { return stride_; }
  [[nodiscard]] Address at(std::int32_t x, std::int32_t y) const {
    return (Address{y} + kMargin) * stride_ + x + 64;
  }

  /// The aligned word of pixels (64 word .., y); margins can be read.
  [[nodiscard]] std::uint64_t known_word(std::int32_t y,
                                         std::int32_t word) const {
    return load(known_, byte_of(y, word));
  }
  [[nodiscard]] std::uint64_t ink_word(std::int32_t y,
                                       std::int32_t word) const {
    return load(ink_, byte_of(y, word));
  }
  /// These pixels of a word are paper.
  void mark_paper(std::int32_t y, std::int32_t word, std::uint64_t pixels) {
    store(known_, y, word, known_word(y, word) | pixels);
  }
  void mark(Address pixel, bool ink) {
    set(known_, pixel);
    if (ink) set(ink_, pixel);
  }
  /// Where the head of a line has been.
  void pass(Address pixel) { set(passed_, pixel); }
  [[nodiscard]] bool passed(Address pixel) const {
    return window(passed_, pixel) >> 63 != 0;
  }

  /// The eight neighbours of a pixel, bit d for the one in direction d.
  struct Ring {
    unsigned unknown = 0;
    unsigned open = 0;  ///< ink that is not passed
  };
  [[nodiscard]] Ring around(Address pixel) const {
    const unsigned ink = ring(ink_, pixel);
    return {~ring(known_, pixel) & 255U, ink & ~ring(passed_, pixel)};
  }

  /// At least 57 pixels from `pixel` on, the first in the highest place.
  [[nodiscard]] std::uint64_t known_window(Address pixel) const {
    return window(known_, pixel);
  }
  [[nodiscard]] std::uint64_t ink_window(Address pixel) const {
    return window(ink_, pixel);
  }

 private:
  using Plane = std::vector<std::uint8_t>;

  static std::uint64_t stride_words(std::int32_t width) {
    return (static_cast<std::uint64_t>(width) + 63) / 64 + 2;
  }
  static std::uint64_t plane_bytes(std::int32_t width, std::int32_t height) {
    return stride_words(width) * 8 *
           (static_cast<std::uint64_t>(height) + 2 * kMargin);
  }
  [[nodiscard]] std::size_t byte_of(std::int32_t y, std::int32_t word) const {
    return static_cast<std::size_t>(at(0, y) / 8 + Address{word} * 8);
  }
  static std::uint64_t swapped(std::uint64_t word) {
    if constexpr (std::endian::native == std::endian::little) {
      return __builtin_bswap64(word);
    }
    return word;
  }
  static std::uint64_t load(const Plane& plane, std::size_t byte) {
    std::uint64_t word = 0;
    std::memcpy(&word, plane.data() + byte, 8);
    return swapped(word);
  }
  void store(Plane& plane, std::int32_t y, std::int32_t word,
             std::uint64_t pixels) const {
    pixels = swapped(pixels);
    std::memcpy(plane.data() + byte_of(y, word), &pixels, 8);
  }
  static std::uint64_t window(const Plane& plane, Address pixel) {
    const auto u = static_cast<std::size_t>(pixel);
    return load(plane, u / 8) << (u % 8);
  }
  [[nodiscard]] unsigned ring(const Plane& plane, Address pixel) const {
    const auto above =
        static_cast<unsigned>(window(plane, pixel - stride_ - 1) >> 61);
    const auto here = static_cast<unsigned>(window(plane, pixel - 1) >> 61);
    const auto below =
        static_cast<unsigned>(window(plane, pixel + stride_ - 1) >> 61);
    return (here & 1) | (above & 1) << 1 | (above & 2) << 1 | (above & 4) << 1 |
           (here & 4) << 2 | (below & 4) << 3 | (below & 2) << 5 |
           (below & 1) << 7;
  }
  static void set(Plane& plane, Address pixel) {
    const auto u = static_cast<std::size_t>(pixel);
    plane[u / 8] = static_cast<std::uint8_t>(plane[u / 8] | 0x80U >> u % 8);
  }

  std::int32_t width_;
  std::int32_t height_;
  Address stride_;
  Plane known_;
  Plane ink_;
  Plane passed_;
};

/// What is known of the 5 x 5 pixels around one, turned by quarters so that a
/// walk always heads east (or north-east). Bit 5 (v + 2) + u + 2 is the pixel u
/// to the east and v to the south.
struct PixelPatch {
  std::uint32_t known = 0;
  std::uint32_t ink = 0;
};

namespace pixel_patch {

constexpr unsigned bit(int u, int v) { return 1U << (5 * (v + 2) + u + 2); }

inline constexpr unsigned kMiddle = bit(0, 0);
inline constexpr unsigned kRing = bit(-1, -1) | bit(0, -1) | bit(1, -1) |
                                  bit(-1, 0) | bit(1, 0) | bit(-1, 1) |
                                  bit(0, 1) | bit(1, 1);
inline constexpr unsigned kOuter = ((1U << 25) - 1) & ~(kRing | kMiddle);

/// [quarter][row][pixels of a row of the raster]
using Table = std::array<std::array<std::array<std::uint32_t, 32>, 5>, 4>;

constexpr Table make_table() {
  Table table{};
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    for (std::size_t row = 0; row < 5; ++row) {
      for (std::size_t pixels = 0; pixels < 32; ++pixels) {
        for (int column = 0; column < 5; ++column) {
          if ((pixels >> (4 - column) & 1) == 0) continue;
          int u = column - 2;
          int v = static_cast<int>(row) - 2;
          for (std::size_t q = 0; q < quarter; ++q) {
            const int t = u;
            u = -v;
            v = t;
          }
          table[quarter][row][pixels] |= bit(u, v);
        }
      }
    }
  }
  return table;
}

inline constexpr Table kTable = make_table();

/// Around `pixel`, for a walk that heads to `quarter` (0: east, 1: north).
[[nodiscard]] inline PixelPatch at(const PixelPlanes& planes,
                                   PixelPlanes::Address pixel,
                                   unsigned quarter) {
  const auto& table = kTable[quarter];
  PixelPatch patch;
  PixelPlanes::Address first = pixel - 2 * planes.stride() - 2;
  for (std::size_t row = 0; row < 5; ++row, first += planes.stride()) {
    patch.known |= table[row][planes.known_window(first) >> 59];
    patch.ink |= table[row][planes.ink_window(first) >> 59];
  }
  return patch;
}

/// The eight pixels around the middle, as a number for contexts.
[[nodiscard]] inline std::uint64_t near(const PixelPatch& patch) {
  return std::uint64_t{patch.known & kRing} << 25 | (patch.ink & kRing);
}
/// All of them.
[[nodiscard]] inline std::uint64_t all(const PixelPatch& patch) {
  return std::uint64_t{patch.known} << 25 | patch.ink;
}

}  // namespace pixel_patch
}  // namespace unstep::codec
