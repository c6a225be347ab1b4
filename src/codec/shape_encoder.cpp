#include <algorithm>
#include <limits>
#include <vector>

#include "codec/contour_coder.h"
#include "codec/shape_coder.h"
#include "codec/shape_matcher.h"
#include "codec/shape_scan.h"
#include "entropy/arithmetic_encoder.h"

namespace unstep::codec {
namespace {

class EncoderSide {
 public:
  static constexpr bool kKnows = true;

  /// Shapes are taken off `rest`.
  EncoderSide(entropy::ArithmeticEncoder& coder,
              const std::vector<PlacedShape>& shapes, Bitmap& rest)
      : coder_(coder), shapes_(shapes), rest_(rest) {}

  entropy::ArithmeticEncoder& coder() { return coder_; }
  const PlacedShape* next() {
    return next_ < shapes_.size() ? &shapes_[next_] : nullptr;
  }
  bool place(const PlacedShape& shape) {
    merge_shape(rest_, 0, shape,
                [](std::uint64_t& to, std::uint64_t bits) { to &= ~bits; });
    ++next_;
    return true;
  }
  [[nodiscard]] static bool damaged() { return false; }

 private:
  entropy::ArithmeticEncoder& coder_;
  const std::vector<PlacedShape>& shapes_;
  Bitmap& rest_;
  std::size_t next_ = 0;
};

template <class Models>
Status tell(EncoderSide& side, std::int32_t width, std::int32_t rows, int bits,
            const BlockProgress& progress) {
  ShapeScan<EncoderSide, Models> scan(
      side, width, rows, bits, std::numeric_limits<std::uint64_t>::max());
  return scan.run(progress);
}

Result<Bitmap> copy_rows(const Bitmap& ink, std::int32_t first_row,
                         std::int32_t rows) {
  Result<Bitmap> copy = Bitmap::create(ink.width(), rows);
  for (std::int32_t y = 0; copy && y < rows; ++y) {
    const auto from = ink.row(first_row + y);
    std::copy(from.begin(), from.end(), copy->row(y).begin());
  }
  return copy;
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_shapes(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    std::uint8_t revision, const std::vector<PlacedShape>& shapes,
    const BlockProgress& progress) {
  Result<Bitmap> rest = copy_rows(ink, first_row, rows);
  if (!rest) return rest.error();
  entropy::ArithmeticEncoder coder;
  EncoderSide side(coder, shapes, *rest);
  const int bits = shape_table_bits(revision, ink.width(), rows);
  const BlockProgress first = first_half(progress);
  const Status told =
      revision == kShapesDeep
          ? tell<DeepShapeModels>(side, ink.width(), rows, bits, first)
          : tell<MixedShapeModels>(side, ink.width(), rows, bits, first);
  if (!told) return told.error();
  Status status = code_contours(coder, *rest, 0, rows, rest_revision(revision),
                                second_half(progress, rows));
  if (!status) return status.error();
  return coder.finish();
}

Status show_shape_models(const Bitmap& ink,
                         const std::vector<PlacedShape>& shapes,
                         const ShapeVisitor& visit) {
  Result<Bitmap> rest = copy_rows(ink, 0, ink.height());
  if (!rest) return rest.error();
  entropy::ArithmeticEncoder coder;
  EncoderSide side(coder, shapes, *rest);
  ShapeScan<EncoderSide, MixedShapeModels> scan(
      side, ink.width(), ink.height(),
      shape_table_bits(kShapesMixed, ink.width(), ink.height()),
      std::numeric_limits<std::uint64_t>::max());
  Status status = scan.run({});
  if (status) visit(scan.pixels(), scan.sequence());
  return status;
}

}  // namespace unstep::codec
