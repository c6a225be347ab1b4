#pragma once

#include <cstdint>

#include "unstep/codec.h"
#include "unstep/result.h"

namespace unstep {

/// Bytes of a Bitmap of this size. REQUIRES: both sides <= 2^32.
[[nodiscard]] std::uint64_t bitmap_bytes(std::uint64_t width,
                                         std::uint64_t height);

/// Whether a page may be read, before anything of its size is allocated:
/// out_of_range if a side is not in 1..Bitmap::kMaxSide, limit_exceeded if the
/// pixels, or the Bitmap and `other_bytes` together, are above the limits.
Status check_page(const DecodeLimits& limits, std::uint64_t width,
                  std::uint64_t height, std::uint64_t other_bytes);

}  // namespace unstep
