#include <string>

#include "codec/contour_coder.h"
#include "codec/contour_scan.h"
#include "entropy/arithmetic_encoder.h"

namespace unstep::codec {
namespace {

class EncoderSide {
 public:
  EncoderSide(entropy::ArithmeticEncoder& coder, const Bitmap& ink,
              std::int32_t first_row, std::int32_t rows)
      : coder_(coder), ink_(ink), first_(first_row), rows_(rows) {}

  entropy::ArithmeticEncoder& coder() { return coder_; }

  /// Unknown horizontal cracks whose western neighbour is not one.
  [[nodiscard]] std::uint64_t starts(std::int32_t y, std::int32_t word,
                                     const CrackMap& cracks) const {
    const std::uint64_t open =
        horizontal(y, word) & ~cracks.horizontal_word(y, word);
    const std::uint64_t before =
        word == 0
            ? 0
            : horizontal(y, word - 1) & ~cracks.horizontal_word(y, word - 1);
    return open & ~(open >> 1 | before << 63);
  }

  [[nodiscard]] bool any_start(std::int32_t y, std::int32_t word,
                               std::int32_t count,
                               const CrackMap& cracks) const {
    std::uint64_t any = 0;
    for (std::int32_t i = 0; i < count; ++i) any |= starts(y, word + i, cracks);
    return any != 0;
  }

  [[nodiscard]] Turn turn(std::int32_t x, std::int32_t y, Quarter direction,
                          bool ink) const {
    const auto at = [this](std::int32_t px, std::int32_t py) {
      return pixel(px, py);
    };
    return trace::true_turn(at, x, y, direction, ink);
  }

  void row(std::int32_t /*y*/, const std::vector<std::uint64_t>& /*pixels*/) {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  [[nodiscard]] bool pixel(std::int32_t x, std::int32_t y) const {
    return x >= 0 && y >= 0 && x < ink_.width() && y < rows_ &&
           ink_.get(x, first_ + y);
  }
  [[nodiscard]] std::uint64_t horizontal(std::int32_t y,
                                         std::int32_t word) const {
    const auto w = static_cast<std::size_t>(word);
    const std::uint64_t below = ink_.row(first_ + y)[w];
    return y == 0 ? below : below ^ ink_.row(first_ + y - 1)[w];
  }

  entropy::ArithmeticEncoder& coder_;
  const Bitmap& ink_;
  std::int32_t first_;
  std::int32_t rows_;
};

template <class Turns>
Status encode_with(entropy::ArithmeticEncoder& coder, const Bitmap& ink,
                   std::int32_t first_row, std::int32_t rows, int table_bits,
                   const BlockProgress& progress) {
  EncoderSide side(coder, ink, first_row, rows);
  ContourScan<EncoderSide, Turns> scan(side, ink.width(), rows, table_bits,
                                       first_table<Turns>(ink.width(), rows));
  return scan.run(progress);
}

}  // namespace

Status code_contours(entropy::ArithmeticEncoder& coder, const Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows,
                     std::uint8_t revision, const BlockProgress& progress) {
  const int bits = contour_table_bits(revision, ink.width(), rows);
  switch (revision) {
    case kContourFast:
      return encode_with<FastTurnModel>(coder, ink, first_row, rows, bits,
                                        progress);
    case kContourLight:
      return encode_with<LightTurnModel>(coder, ink, first_row, rows, bits,
                                         progress);
    case kContourSmall:
      return encode_with<SmallTurnModel>(coder, ink, first_row, rows, bits,
                                         progress);
    case kContourDeep:
      return encode_with<DeepTurnModel>(coder, ink, first_row, rows, bits,
                                        progress);
    default:
      return encode_with<TurnModel>(coder, ink, first_row, rows, bits,
                                    progress);
  }
}

Result<std::vector<std::uint8_t>> encode_contours(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    std::uint8_t revision, const BlockProgress& progress) {
  entropy::ArithmeticEncoder coder;
  Status status =
      code_contours(coder, ink, first_row, rows, revision, progress);
  if (!status) return status.error();
  return coder.finish();
}

Result<std::vector<std::uint8_t>> encode_and_show(const Bitmap& ink,
                                                  const warm::Table& start,
                                                  const ModelVisitor& visit) {
  entropy::ArithmeticEncoder coder;
  EncoderSide side(coder, ink, 0, ink.height());
  ContourScan<EncoderSide, TurnModel> scan(side, ink.width(), ink.height(),
                                           kTrainingBits, start);
  Status status = scan.run({});
  if (!status) return status.error();
  visit(scan.turns(), scan.starts());
  return coder.finish();
}

Status encode_and_show_deep(const Bitmap& ink, const DeepVisitor& visit) {
  entropy::ArithmeticEncoder coder;
  EncoderSide side(coder, ink, 0, ink.height());
  ContourScan<EncoderSide, TrainedTurnModel> scan(
      side, ink.width(), ink.height(), kDeepTrainingBits, warm::kSmall);
  Status status = scan.run({});
  if (status) visit(scan.turns());
  return status;
}

}  // namespace unstep::codec
