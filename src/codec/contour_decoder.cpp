#include <algorithm>
#include <string>

#include "codec/contour_coder.h"
#include "codec/contour_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {
namespace {

class DecoderSide {
 public:
  DecoderSide(std::span<const std::uint8_t> payload, Bitmap& ink,
              std::int32_t first_row)
      : coder_(payload), ink_(ink), first_(first_row) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  [[nodiscard]] static std::uint64_t starts(std::int32_t /*y*/,
                                            std::int32_t /*word*/,
                                            const CrackMap& /*cracks*/) {
    return 0;
  }
  [[nodiscard]] static Turn turn(std::int32_t /*x*/, std::int32_t /*y*/,
                                 Quarter /*direction*/, bool /*ink*/) {
    return kStraight;
  }
  void row(std::int32_t y, const std::vector<std::uint64_t>& pixels) {
    std::copy(pixels.begin(), pixels.end(), ink_.row(first_ + y).begin());
  }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }

 private:
  entropy::ArithmeticDecoder coder_;
  Bitmap& ink_;
  std::int32_t first_;
};

}  // namespace

Status decode_contours(std::span<const std::uint8_t> payload, Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       const DecodeLimits& limits,
                       const BlockProgress& progress) {
  if (CrackMap::memory(ink.width(), rows) > limits.max_memory) {
    return Error{ErrorCode::limit_exceeded,
                 "contours of " + std::to_string(ink.width()) + " x " +
                     std::to_string(rows) + " pixels need " +
                     std::to_string(CrackMap::memory(ink.width(), rows)) +
                     " bytes, more than the memory limit"};
  }
  DecoderSide side(payload, ink, first_row);
  ContourScan<DecoderSide> scan(side, ink.width(), rows,
                                contour_table_bits(ink.width(), rows));
  Status status = scan.run(progress);
  if (!status) return status.error();
  if (!side.coder().finished()) {
    return Error{ErrorCode::corrupt, "contour payload has unused bytes"};
  }
  return {};
}

}  // namespace unstep::codec
