
#include "codec/centreline_coder.h"
#include "codec/centreline_scan.h"
#include "entropy/arithmetic_encoder.h"
#include "grid/bit_count.h"

namespace unstep::codec {
namespace {

class EncoderSide {
 public:
  EncoderSide(entropy::ArithmeticEncoder& coder, const Bitmap& ink,
              std::int32_t first_row)
      : coder_(coder), ink_(ink), first_(first_row) {}

  entropy::ArithmeticEncoder& coder() { return coder_; }
  [[nodiscard]] bool ink(std::int32_t x, std::int32_t y) const {
    return ink_.get(x, first_ + y);
  }
  [[nodiscard]] std::uint64_t ink_word(std::int32_t y,
                                       std::int32_t word) const {
    return ink_.row(first_ + y)[static_cast<std::size_t>(word)];
  }
  void row(std::int32_t /*y*/, const PixelPlanes& /*planes*/) {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  entropy::ArithmeticEncoder& coder_;
  const Bitmap& ink_;
  std::int32_t first_;
};

using MixedScan =
    CentrelineScan<EncoderSide, CentrelineModel, CentrelineStartModel>;
using DeepScan =
    CentrelineScan<EncoderSide, DeepCentrelineModel, DeepLineStartModel>;

}  // namespace

bool is_thin(const Bitmap& ink, std::int32_t first_row, std::int32_t rows) {
  constexpr std::uint64_t kShare = 8;
  constexpr std::int64_t kSmall = 40'000;
  if (std::int64_t{ink.width()} * rows < kSmall) return false;
  std::uint64_t pixels = 0;
  std::uint64_t squares = 0;  // of 2 x 2 pixels of ink
  for (std::int32_t y = first_row; y < first_row + rows; ++y) {
    const auto row = ink.row(y);
    const auto above = y > first_row ? ink.row(y - 1) : row;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] == 0) continue;
      pixels += static_cast<std::uint64_t>(ones(row[i]));
      if (y == first_row) continue;
      const std::uint64_t both = row[i] & above[i];
      squares += static_cast<std::uint64_t>(ones(both & both << 1));
    }
  }
  return pixels > 0 && squares * kShare < pixels;
}

Result<std::vector<std::uint8_t>> encode_centrelines(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    std::uint8_t revision, const BlockProgress& progress) {
  entropy::ArithmeticEncoder coder;
  EncoderSide side(coder, ink, first_row);
  const std::int32_t width = ink.width();
  const int bits = centreline_table_bits(revision, width, rows);
  const Status status = revision == kCentrelinesDeep
                            ? DeepScan(side, width, rows, bits).run(progress)
                            : MixedScan(side, width, rows, bits).run(progress);
  if (status) return coder.finish();
  if (status.error().code == ErrorCode::corrupt) {
    return std::vector<std::uint8_t>{};  // too many branches wait
  }
  return status.error();
}

Status show_centreline_models(const Bitmap& ink, bool cold,
                              const CentrelineVisitor& visit) {
  entropy::ArithmeticEncoder coder;
  EncoderSide side(coder, ink, 0);
  const int bits = cold ? 16
                        : centreline_table_bits(kCentrelinesMixed, ink.width(),
                                                ink.height());
  MixedScan scan(side, ink.width(), ink.height(), bits,
                 cold ? centreline_warm::Table{} : centreline_warm::kTable);
  Status status = scan.run({});
  if (status) visit(scan.lines(), scan.starts());
  return status;
}

}  // namespace unstep::codec
