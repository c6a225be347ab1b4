#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/block_coder.h"

/// Coder 1: contours under mixed models, docs/format.md.
namespace unstep::codec {

inline constexpr std::uint8_t kContourRevision = 0;

/// log2 of the model's slots per context, a rule of the size only, so that it
/// need not be stored: larger pages have more contexts to remember.
[[nodiscard]] constexpr int contour_table_bits(std::int32_t width,
                                               std::int32_t rows) {
  const std::int64_t pixels = std::int64_t{width} * rows;
  return pixels < 40'000 ? 12 : pixels < 1'000'000 ? 14 : 16;
}

Result<std::vector<std::uint8_t>> encode_contours(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    const BlockProgress& progress);

Status decode_contours(std::span<const std::uint8_t> payload, Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       const DecodeLimits& limits,
                       const BlockProgress& progress);

}  // namespace unstep::codec
