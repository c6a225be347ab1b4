#include <algorithm>
#include <string>
#include <utility>

#include "codec/contour_coder.h"
#include "codec/contour_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {

std::uint64_t contour_memory(std::uint8_t revision, std::int32_t width,
                             std::int32_t rows) {
  const int bits = contour_table_bits(revision, width, rows);
  const std::uint64_t model =
      revision == kContourFast    ? FastTurnModel::memory(bits)
      : revision == kContourLight ? LightTurnModel::memory(bits)
      : revision == kContourSmall ? SmallTurnModel::memory(bits)
      : revision == kContourDeep
          ? DeepTurnModel::memory(bits) + DeepStartModel::memory(width)
          : TurnModel::memory(bits);
  return CrackMap::memory(width, rows) + model + (1 << 20);
}

namespace {

/// `Sink` takes each row of pixels as it is complete.
template <class Sink>
class DecoderSide {
 public:
  DecoderSide(entropy::ArithmeticDecoder& coder, Sink sink)
      : coder_(coder), sink_(std::move(sink)) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  [[nodiscard]] static std::uint64_t starts(std::int32_t /*y*/,
                                            std::int32_t /*word*/,
                                            const CrackMap& /*cracks*/) {
    return 0;
  }
  [[nodiscard]] static bool any_start(std::int32_t /*y*/, std::int32_t /*word*/,
                                      std::int32_t /*count*/,
                                      const CrackMap& /*cracks*/) {
    return false;
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
  entropy::ArithmeticDecoder& coder_;
  Sink sink_;
};

template <class Turns, class Sink>
Status decode_with(entropy::ArithmeticDecoder& coder, std::int32_t width,
                   std::int32_t rows, int table_bits,
                   const BlockProgress& progress, Sink sink) {
  DecoderSide<Sink> side(coder, std::move(sink));
  ContourScan<DecoderSide<Sink>, Turns> scan(side, width, rows, table_bits,
                                             first_table<Turns>(width, rows));
  return scan.run(progress);
}

template <class Sink>
Status decode_part(entropy::ArithmeticDecoder& coder, std::int32_t width,
                   std::int32_t rows, std::uint8_t revision,
                   const BlockProgress& progress, Sink sink) {
  const int bits = contour_table_bits(revision, width, rows);
  switch (revision) {
    case kContourFast:
      return decode_with<FastTurnModel>(coder, width, rows, bits, progress,
                                        std::move(sink));
    case kContourLight:
      return decode_with<LightTurnModel>(coder, width, rows, bits, progress,
                                         std::move(sink));
    case kContourSmall:
      return decode_with<SmallTurnModel>(coder, width, rows, bits, progress,
                                         std::move(sink));
    case kContourDeep:
      return decode_with<DeepTurnModel>(coder, width, rows, bits, progress,
                                        std::move(sink));
    default:
      return decode_with<TurnModel>(coder, width, rows, bits, progress,
                                    std::move(sink));
  }
}

template <class Sink>
Status decode_rows(std::span<const std::uint8_t> payload, std::int32_t width,
                   std::int32_t rows, std::uint8_t revision,
                   const DecodeLimits& limits, const BlockProgress& progress,
                   Sink sink) {
  const std::uint64_t memory = contour_memory(revision, width, rows);
  if (memory > limits.max_memory) {
    return Error{ErrorCode::limit_exceeded,
                 "contours of " + std::to_string(width) + " x " +
                     std::to_string(rows) + " pixels need " +
                     std::to_string(memory) +
                     " bytes, more than the memory limit"};
  }
  entropy::ArithmeticDecoder coder(payload);
  Status status =
      decode_part(coder, width, rows, revision, progress, std::move(sink));
  if (!status) return status.error();
  if (!coder.finished()) {
    return Error{ErrorCode::corrupt,
                 "contour payload does not end where its contours do"};
  }
  return {};
}

}  // namespace

Status code_contours(entropy::ArithmeticDecoder& coder, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows,
                     std::uint8_t revision, const BlockProgress& progress) {
  return decode_part(coder, ink.width(), rows, revision, progress,
                     [&](std::int32_t y, const auto& row) {
                       const auto to = ink.row(first_row + y);
                       for (std::size_t i = 0; i < row.size(); ++i) {
                         to[i] |= row[i];
                       }
                     });
}

Status decode_contours(std::span<const std::uint8_t> payload, Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       std::uint8_t revision, const DecodeLimits& limits,
                       const BlockProgress& progress) {
  return decode_rows(payload, ink.width(), rows, revision, limits, progress,
                     [&](std::int32_t y, const auto& pixels) {
                       std::copy(pixels.begin(), pixels.end(),
                                 ink.row(first_row + y).begin());
                     });
}

Status verify_contours(std::span<const std::uint8_t> payload, const Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       std::uint8_t revision, const DecodeLimits& limits,
                       const BlockProgress& progress) {
  std::int32_t differs = -1;
  Status decoded =
      decode_rows(payload, ink.width(), rows, revision, limits, progress,
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
