#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/block_coder.h"

/// Coder 4: pixels in the order of rows, docs/format.md.
namespace unstep::codec {

/// Few contexts, weighed by what is known of them.
inline constexpr std::uint8_t kPixelsBlended = 0;
/// Four contexts, mixed.
inline constexpr std::uint8_t kPixelsMixed = 1;
/// Eight contexts, mixed and refined.
inline constexpr std::uint8_t kPixelsDeep = 2;
inline constexpr std::uint8_t kPixelTable = 0;

[[nodiscard]] constexpr bool is_pixel_revision(std::uint8_t revision) {
  return revision <= kPixelsDeep;
}

/// Bytes that coding rows of this width allocates.
[[nodiscard]] std::uint64_t pixel_memory(std::int32_t width,
                                         std::uint8_t revision);

/// How the pixels of some rows lie, by one look at every third row.
struct PixelTexture {
  std::uint64_t pixels = 0;
  std::uint64_t edges = 0;     ///< between neighbours of a row
  std::uint64_t straight = 0;  ///< of these, as in the two rows above
  std::uint64_t single = 0;    ///< pixels unlike both neighbours of their row

  /// Drawn by a program: lines along the axes, symbols that repeat exactly.
  [[nodiscard]] bool is_drawn() const { return straight * 8 > edges * 5; }
  /// Strokes of letters go straight down: scans of print 31 to 53 %, coasts 14
  /// to 26 %.
  [[nodiscard]] bool is_printed() const { return straight * 7 > edges * 2; }
  /// An edge in twenty pixels: small print, or noise beside it.
  [[nodiscard]] bool is_crowded() const { return edges * 20 > pixels; }
  /// Halftone, dither or noise: pixels by themselves are a good part of all.
  [[nodiscard]] bool is_dithered() const { return single * 20 > pixels; }
};

[[nodiscard]] PixelTexture pixel_texture(const Bitmap& ink,
                                         std::int32_t first_row,
                                         std::int32_t rows);

/// REQUIRES: is_pixel_revision(revision).
Result<std::vector<std::uint8_t>> encode_pixels(const Bitmap& ink,
                                                std::int32_t first_row,
                                                std::int32_t rows,
                                                std::uint8_t revision,
                                                const BlockProgress& progress);

Status decode_pixels(std::span<const std::uint8_t> payload, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows,
                     std::uint8_t revision, const DecodeLimits& limits,
                     const BlockProgress& progress);

}  // namespace unstep::codec
