#include "formats/page_limits.h"

#include <string>

#include "unstep/bitmap.h"

namespace unstep {

std::uint64_t bitmap_bytes(std::uint64_t width, std::uint64_t height) {
  return (width + 63) / 64 * 8 * height;
}

Status check_page(const DecodeLimits& limits, std::uint64_t width,
                  std::uint64_t height, std::uint64_t other_bytes) {
  const std::string size =
      std::to_string(width) + " x " + std::to_string(height) + " pixels";
  constexpr auto kMax = static_cast<std::uint64_t>(Bitmap::kMaxSide);
  if (width < 1 || height < 1 || width > kMax || height > kMax) {
    return Error{
        ErrorCode::out_of_range,
        "image of " + size + "; sides are 1 to " + std::to_string(kMax)};
  }
  if (width * height > limits.max_pixels) {
    return Error{ErrorCode::limit_exceeded,
                 "image of " + size + "; the limit is " +
                     std::to_string(limits.max_pixels) + " pixels"};
  }
  // Sides < 2^30: the bitmap is below 2^58 bytes, no overflow.
  const std::uint64_t bitmap = bitmap_bytes(width, height);
  if (bitmap > limits.max_memory || other_bytes > limits.max_memory - bitmap) {
    return Error{ErrorCode::limit_exceeded,
                 "image of " + size + " needs more memory than the limit of " +
                     std::to_string(limits.max_memory) + " bytes"};
  }
  return {};
}

}  // namespace unstep
