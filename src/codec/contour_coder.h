#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/block_coder.h"

/// Coder 1: contours under mixed models, docs/format.md.
namespace unstep::codec {

/// The payload's first byte: log2 of the slots per context.
inline constexpr int kMinTableBits = 8;
inline constexpr int kMaxTableBits = 20;

Result<std::vector<std::uint8_t>> encode_contours(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    const BlockProgress& progress);

Status decode_contours(std::span<const std::uint8_t> payload, Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       const DecodeLimits& limits,
                       const BlockProgress& progress);

}  // namespace unstep::codec
