#include <algorithm>
#include <string>

#include "codec/pixel_coder.h"
#include "codec/pixel_models.h"
#include "codec/pixel_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {
namespace {

class DecoderSide {
 public:
  DecoderSide(std::span<const std::uint8_t> payload, Bitmap& ink,
              std::int32_t first_row)
      : coder_(payload), ink_(ink), first_(first_row) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  [[nodiscard]] static const std::uint64_t* truth(std::int32_t /*y*/) {
    return nullptr;
  }
  void row(std::int32_t y, const std::uint64_t* words) {
    const auto to = ink_.row(first_ + y);
    std::copy_n(words, to.size(), to.begin());
  }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }

 private:
  entropy::ArithmeticDecoder coder_;
  Bitmap& ink_;
  std::int32_t first_;
};

template <class Model>
Status decode_with(std::span<const std::uint8_t> payload, Bitmap& ink,
                   std::int32_t first_row, std::int32_t rows,
                   const BlockProgress& progress) {
  DecoderSide side(payload, ink, first_row);
  PixelScan<DecoderSide, Model> scan(side, ink.width(), rows);
  Status status = scan.run(progress);
  if (status && !side.coder().finished()) {
    return Error{ErrorCode::corrupt,
                 "pixel payload does not end where its pixels do"};
  }
  return status;
}

}  // namespace

std::uint64_t pixel_memory(std::int32_t width, std::uint8_t revision) {
  switch (revision) {
    case kPixelsBlended:
      return PixelScan<DecoderSide, BlendedPixels>::memory(width);
    case kPixelsMixed:
      return PixelScan<DecoderSide, MixedPixels>::memory(width);
    default: return PixelScan<DecoderSide, DeepPixels>::memory(width);
  }
}

Status decode_pixels(std::span<const std::uint8_t> payload, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows,
                     std::uint8_t revision, const DecodeLimits& limits,
                     const BlockProgress& progress) {
  const std::uint64_t memory = pixel_memory(ink.width(), revision);
  if (memory > limits.max_memory) {
    return Error{ErrorCode::limit_exceeded,
                 "pixels of rows of " + std::to_string(ink.width()) + " need " +
                     std::to_string(memory) +
                     " bytes, more than the memory limit"};
  }
  switch (revision) {
    case kPixelsBlended:
      return decode_with<BlendedPixels>(payload, ink, first_row, rows,
                                        progress);
    case kPixelsMixed:
      return decode_with<MixedPixels>(payload, ink, first_row, rows, progress);
    default:
      return decode_with<DeepPixels>(payload, ink, first_row, rows, progress);
  }
}

}  // namespace unstep::codec
