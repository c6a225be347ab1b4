#pragma once

#include <cstdint>
#include <span>

#include "unstep/formats.h"

namespace unstep {

/// The only page of a BMP file through the OpenCV module. The sides
/// are those that the file's header claims; limits are checked with them.
Result<RasterPage> read_opencv_page(std::span<const std::uint8_t> bytes,
                                    std::uint64_t width, std::uint64_t height,
                                    const RasterReadOptions& options);

}  // namespace unstep
