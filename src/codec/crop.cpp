#include "codec/crop.h"

#include <algorithm>
#include <cstdint>

namespace unstep::codec {

Result<Bitmap> crop(const Bitmap& ink, const Box& box) {
  const std::int64_t left = std::max(box.x, 0);
  const std::int64_t top = std::max(box.y, 0);
  const std::int64_t right =
      std::min<std::int64_t>(std::int64_t{box.x} + box.width, ink.width());
  const std::int64_t bottom =
      std::min<std::int64_t>(std::int64_t{box.y} + box.height, ink.height());
  if (left >= right || top >= bottom) {
    return Error{ErrorCode::out_of_range, "the box misses the page"};
  }
  Result<Bitmap> part = Bitmap::create(right - left, bottom - top);
  if (!part) return part;
  const auto shift = static_cast<unsigned>(left % 64);
  const auto first = static_cast<std::size_t>(left / 64);
  for (std::int32_t y = 0; y < part->height(); ++y) {
    const auto from = ink.row(static_cast<std::int32_t>(top) + y);
    const auto to = part->row(y);
    for (std::size_t i = 0; i < to.size(); ++i) {
      to[i] = from[first + i] << shift;
      if (shift != 0 && first + i + 1 < from.size()) {
        to[i] |= from[first + i + 1] >> (64 - shift);
      }
    }
    to.back() &= part->last_word_mask();
  }
  return part;
}

}  // namespace unstep::codec
