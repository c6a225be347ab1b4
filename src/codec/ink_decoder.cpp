#include <algorithm>
#include <string>

#include "codec/block_coder.h"
#include "codec/centreline_coder.h"
#include "codec/contour_coder.h"
#include "codec/pixel_coder.h"
#include "codec/shape_coder.h"
#include "codec/stored_coder.h"
#include "codec/warm_start.h"

namespace unstep::codec {

namespace {

constexpr CoderName kStored{kCoderStored, 0, 0};

bool is_contours(const CoderName& name) {
  return name.coder == kCoderContours && name.table == warm::kTableId &&
         is_contour_revision(name.revision);
}

bool is_shapes(const CoderName& name) {
  return name.coder == kCoderShapes && name.table == warm::kTableId &&
         is_shape_revision(name.revision);
}

bool is_centrelines(const CoderName& name) {
  return name.coder == kCoderCentrelines && name.table == kCentrelineTable &&
         is_centreline_revision(name.revision);
}

bool is_pixels(const CoderName& name) {
  return name.coder == kCoderPixels && name.table == kPixelTable &&
         is_pixel_revision(name.revision);
}

}  // namespace

Status decode_ink(const CoderName& name, std::span<const std::uint8_t> payload,
                  Bitmap& ink, std::int32_t first_row, std::int32_t rows,
                  const DecodeLimits& limits, const BlockProgress& progress) {
  if (name == kStored) return decode_stored(payload, ink, first_row, rows);
  if (is_contours(name)) {
    return decode_contours(payload, ink, first_row, rows, name.revision, limits,
                           progress);
  }
  if (is_shapes(name)) {
    return decode_shapes(payload, ink, first_row, rows, name.revision, limits,
                         progress);
  }
  if (is_centrelines(name)) {
    return decode_centrelines(payload, ink, first_row, rows, name.revision,
                              limits, progress);
  }
  if (is_pixels(name)) {
    return decode_pixels(payload, ink, first_row, rows, name.revision, limits,
                         progress);
  }
  return unknown_coder("ink", name);
}

Status verify_ink(const CoderName& name, std::span<const std::uint8_t> payload,
                  const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
                  const DecodeLimits& limits, const BlockProgress& progress) {
  if (is_contours(name)) {
    return verify_contours(payload, ink, first_row, rows, name.revision, limits,
                           progress);
  }
  if (is_centrelines(name)) {
    return verify_centrelines(payload, ink, first_row, rows, name.revision,
                              limits, progress);
  }
  Result<Bitmap> decoded = Bitmap::create(ink.width(), rows);
  if (!decoded) return decoded.error();
  Status status =
      decode_ink(name, payload, *decoded, 0, rows, limits, progress);
  if (!status) return status;
  for (std::int32_t y = 0; y < rows; ++y) {
    const auto truth = ink.row(first_row + y);
    if (!std::equal(truth.begin(), truth.end(), decoded->row(y).begin())) {
      return Error{ErrorCode::internal,
                   "row " + std::to_string(y) + " decodes to other pixels"};
    }
  }
  return {};
}

}  // namespace unstep::codec
