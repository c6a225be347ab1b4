#include <algorithm>
#include <string>
#include <utility>

#include "codec/contour_coder.h"
#include "codec/contour_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {

std::uint64_t contour_memory(std::int32_t width, std::int32_t rows) {
  return CrackMap::memory(width, rows) +
         TurnModel::memory(contour_table_bits(width, rows)) + (1 << 20);
}

namespace {

/// `Sink` takes each row of pixels as it is complete.
template <class Sink>
class DecoderSide {
 public:
  DecoderSide(std::span<const std::uint8_t> payload, Sink sink)
      : coder_(payload), sink_(std::move(sink)) {}

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
    sink_(y, pixels);
  }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }

 private:
  entropy::ArithmeticDecoder coder_;
  Sink sink_;
};

template <class Sink>
Status decode_rows(std::span<const std::uint8_t> payload, std::int32_t width,
                   std::int32_t rows, const DecodeLimits& limits,
                   const BlockProgress& progress, Sink sink) {
  const std::uint64_t memory = contour_memory(width, rows);
  if (memory > limits.max_memory) {
    return Error{ErrorCode::limit_exceeded,
                 "contours of " + std::to_string(width) + " x " +
                     std::to_string(rows) + " pixels need " +
                     std::to_string(memory) +
                     " bytes, more than the memory limit"};
  }
  DecoderSide<Sink> side(payload, std::move(sink));
  ContourScan<DecoderSide<Sink>> scan(side, width, rows,
                                      contour_table_bits(width, rows));
  Status status = scan.run(progress);
  if (!status) return status.error();
  if (!side.coder().finished()) {
    return Error{ErrorCode::corrupt,
                 "contour payload does not end where its contours do"};
  }
  return {};
}

}  // namespace

Status decode_contours(std::span<const std::uint8_t> payload, Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       const DecodeLimits& limits,
                       const BlockProgress& progress) {
  return decode_rows(payload, ink.width(), rows, limits, progress,
                     [&](std::int32_t y, const auto& pixels) {
                       std::copy(pixels.begin(), pixels.end(),
                                 ink.row(first_row + y).begin());
                     });
}

Status verify_contours(std::span<const std::uint8_t> payload, const Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       const DecodeLimits& limits,
                       const BlockProgress& progress) {
  std::int32_t differs = -1;
  Status decoded =
      decode_rows(payload, ink.width(), rows, limits, progress,
                  [&](std::int32_t y, const auto& pixels) {
                    const auto truth = ink.row(first_row + y);
                    if (differs < 0 && !std::equal(pixels.begin(), pixels.end(),
                                                   truth.begin())) {
                      differs = y;
                    }
                  });
  if (!decoded) return decoded.error();
  if (differs >= 0) {
    return Error{ErrorCode::internal,
                 "row " + std::to_string(differs) + " decodes to other pixels"};
  }
  return {};
}

}  // namespace unstep::codec
