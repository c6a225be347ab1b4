#include <algorithm>
#include <string>

#include "codec/contour_coder.h"
#include "codec/shape_coder.h"
#include "codec/shape_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {

namespace {

class DecoderSide {
 public:
  static constexpr bool kKnows = false;

  DecoderSide(entropy::ArithmeticDecoder& coder, Bitmap& ink,
              std::int32_t first_row)
      : coder_(coder), ink_(ink), first_(first_row) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  static const PlacedShape* next() { return nullptr; }
  bool place(const PlacedShape& shape) {
    merge_shape(ink_, first_, shape,
                [](std::uint64_t& to, std::uint64_t bits) { to |= bits; });
    return true;
  }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }

 private:
  entropy::ArithmeticDecoder& coder_;
  Bitmap& ink_;
  std::int32_t first_;
};

std::uint64_t scan_memory(std::uint8_t revision, std::int32_t width,
                          std::int32_t rows) {
  const int bits = shape_table_bits(revision, width, rows);
  return revision == kShapesDeep
             ? ShapeScan<DecoderSide, DeepShapeModels>::memory(width, rows,
                                                               bits)
             : ShapeScan<DecoderSide, MixedShapeModels>::memory(width, rows,
                                                                bits);
}

template <class Models>
Status tell(DecoderSide& side, std::int32_t width, std::int32_t rows, int bits,
            std::uint64_t memory, const BlockProgress& progress) {
  ShapeScan<DecoderSide, Models> scan(side, width, rows, bits, memory);
  return scan.run(progress);
}

}  // namespace

std::uint64_t shape_memory(std::uint8_t revision, std::int32_t width,
                           std::int32_t rows) {
  // One part is over when the other begins.
  return std::max(scan_memory(revision, width, rows),
                  contour_memory(rest_revision(revision), width, rows));
}

BlockProgress first_half(const BlockProgress& progress) {
  if (!progress) return {};
  return [&progress](std::uint64_t done) { return progress(done / 2); };
}

BlockProgress second_half(const BlockProgress& progress, std::int32_t rows) {
  if (!progress) return {};
  const auto all = static_cast<std::uint64_t>(rows);
  return [&progress, all](std::uint64_t done) {
    return progress(all / 2 + done / 2);
  };
}

Status decode_shapes(std::span<const std::uint8_t> payload, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows,
                     std::uint8_t revision, const DecodeLimits& limits,
                     const BlockProgress& progress) {
  const std::uint64_t memory = shape_memory(revision, ink.width(), rows);
  if (memory > limits.max_memory) {
    return Error{ErrorCode::limit_exceeded,
                 "shapes of " + std::to_string(ink.width()) + " x " +
                     std::to_string(rows) + " pixels need " +
                     std::to_string(memory) +
                     " bytes, more than the memory limit"};
  }
  entropy::ArithmeticDecoder coder(payload);
  DecoderSide side(coder, ink, first_row);
  const std::int32_t width = ink.width();
  const int bits = shape_table_bits(revision, width, rows);
  const std::uint64_t left =
      limits.max_memory - scan_memory(revision, width, rows);
  const BlockProgress first = first_half(progress);
  const Status told =
      revision == kShapesDeep
          ? tell<DeepShapeModels>(side, width, rows, bits, left, first)
          : tell<MixedShapeModels>(side, width, rows, bits, left, first);
  if (!told) return told.error();
  Status status =
      code_contours(coder, ink, first_row, rows, rest_revision(revision),
                    second_half(progress, rows));
  if (!status) return status;
  if (!coder.finished()) {
    return Error{ErrorCode::corrupt,
                 "shape payload does not end where its contours do"};
  }
  return {};
}

}  // namespace unstep::codec
