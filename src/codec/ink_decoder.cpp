#include <string>

#include "codec/block_coder.h"
#include "codec/contour_coder.h"
#include "codec/stored_coder.h"

namespace unstep::codec {

Status decode_ink(const CoderName& name, std::span<const std::uint8_t> payload,
                  Bitmap& ink, std::int32_t first_row, std::int32_t rows,
                  const DecodeLimits& limits, const BlockProgress& progress) {
  if (name == CoderName{kCoderStored, 0, 0}) {
    return decode_stored(payload, ink, first_row, rows);
  }
  if (name == CoderName{kCoderContours, kContourRevision, 0}) {
    return decode_contours(payload, ink, first_row, rows, limits, progress);
  }
  return Error{ErrorCode::unsupported_version,
               "ink coder " + std::to_string(name.coder) + " revision " +
                   std::to_string(name.revision) + " table " +
                   std::to_string(name.table) + " is unknown"};
}

}  // namespace unstep::codec
