
#include "codec/pixel_coder.h"
#include "codec/pixel_models.h"
#include "codec/pixel_scan.h"
#include "entropy/arithmetic_encoder.h"
#include "grid/bit_count.h"

namespace unstep::codec {
namespace {

class EncoderSide {
 public:
  EncoderSide(const Bitmap& ink, std::int32_t first_row)
      : ink_(ink), first_(first_row) {}

  entropy::ArithmeticEncoder& coder() { return coder_; }
  [[nodiscard]] const std::uint64_t* truth(std::int32_t y) const {
    return ink_.row(first_ + y).data();
  }
  void row(std::int32_t /*y*/, const std::uint64_t* /*words*/) {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  entropy::ArithmeticEncoder coder_;
  const Bitmap& ink_;
  std::int32_t first_;
};

template <class Model>
Result<std::vector<std::uint8_t>> encode_with(const Bitmap& ink,
                                              std::int32_t first_row,
                                              std::int32_t rows,
                                              const BlockProgress& progress) {
  EncoderSide side(ink, first_row);
  PixelScan<EncoderSide, Model> scan(side, ink.width(), rows);
  const Status status = scan.run(progress);
  if (!status) return status.error();
  return side.coder().finish();
}

std::uint64_t count(std::uint64_t bits) {
  return static_cast<std::uint64_t>(ones(bits));
}

}  // namespace

PixelTexture pixel_texture(const Bitmap& ink, std::int32_t first_row,
                           std::int32_t rows) {
  PixelTexture texture;
  // Three has no factor in common with the periods of ordered dither.
  for (std::int32_t y = first_row + 2; y < first_row + rows; y += 3) {
    texture.pixels += static_cast<std::uint64_t>(ink.width());
    const auto row = ink.row(y);
    const auto above = ink.row(y - 1);
    const auto top = ink.row(y - 2);
    // Edges between words are left out.
    constexpr std::uint64_t kInner = ~std::uint64_t{0} >> 1;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] == 0) continue;
      const std::uint64_t edges = (row[i] ^ row[i] >> 1) & kInner;
      texture.edges += count(edges);
      texture.straight +=
          count(edges & (above[i] ^ above[i] >> 1) & (top[i] ^ top[i] >> 1));
      texture.single += count(edges & edges << 1);
    }
  }
  return texture;
}

Result<std::vector<std::uint8_t>> encode_pixels(const Bitmap& ink,
                                                std::int32_t first_row,
                                                std::int32_t rows,
                                                std::uint8_t revision,
                                                const BlockProgress& progress) {
  switch (revision) {
    case kPixelsBlended:
      return encode_with<BlendedPixels>(ink, first_row, rows, progress);
    case kPixelsMixed:
      return encode_with<MixedPixels>(ink, first_row, rows, progress);
    default: return encode_with<DeepPixels>(ink, first_row, rows, progress);
  }
}

}  // namespace unstep::codec
