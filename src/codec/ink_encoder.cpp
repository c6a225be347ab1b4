#include "codec/block_coder.h"
#include "codec/stored_coder.h"

namespace unstep::codec {

Result<EncodedBlock> encode_ink(const Bitmap& ink, std::int32_t first_row,
                                std::int32_t rows,
                                const BlockProgress& progress) {
  Result<std::vector<std::uint8_t>> stored =
      encode_stored(ink, first_row, rows);
  if (!stored) return stored.error();
  if (progress && !progress(static_cast<std::uint64_t>(rows))) {
    return Error{ErrorCode::cancelled, "cancelled"};
  }
  return EncodedBlock{{kCoderStored, 0, 0}, std::move(*stored)};
}

}  // namespace unstep::codec
