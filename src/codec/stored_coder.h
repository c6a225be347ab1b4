#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/result.h"

/// Coder 0: the rows as PBM holds them, deflated (zlib stream). The fallback
/// that keeps noise from growing.
namespace unstep::codec {

Result<std::vector<std::uint8_t>> encode_stored(const Bitmap& ink,
                                                std::int32_t first_row,
                                                std::int32_t rows);

Status decode_stored(std::span<const std::uint8_t> payload, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows);

}  // namespace unstep::codec
