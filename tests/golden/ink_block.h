#pragma once

#include <cstdint>

#include "codec/block_coder.h"
#include "codec/centreline_coder.h"
#include "codec/contour_coder.h"
#include "codec/pixel_coder.h"
#include "codec/shape_coder.h"
#include "codec/shape_finder.h"
#include "codec/shape_matcher.h"
#include "codec/stored_coder.h"

namespace unstep::testing {

/// Rows of a page by the coder and revision of that name, whatever the encoder
/// would choose.
inline Result<std::vector<std::uint8_t>> encode_rows(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    const codec::CoderName& name) {
  switch (name.coder) {
    case codec::kCoderContours:
      return codec::encode_contours(ink, first_row, rows, name.revision, {});
    case codec::kCoderShapes:
      return codec::encode_shapes(
          ink, first_row, rows, name.revision,
          codec::find_shapes(ink, first_row, rows, codec::kShapesPay), {});
    case codec::kCoderCentrelines:
      return codec::encode_centrelines(ink, first_row, rows, name.revision, {});
    case codec::kCoderPixels:
      return codec::encode_pixels(ink, first_row, rows, name.revision, {});
    default: return codec::encode_stored(ink, first_row, rows);
  }
}

}  // namespace unstep::testing
