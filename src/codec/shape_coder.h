#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "codec/block_coder.h"
#include "codec/contour_coder.h"

/// Coder 2: shapes that repeat, then the contours of what is left,
/// docs/format.md.
namespace unstep::codec {

struct PlacedShape;
class MixedShapePixels;
class MixedShapeSequence;
template <class Model>
class ShapePixelOrder;

/// The models; they are the revisions of coder 2. The deep ones are for the max
/// effort.
inline constexpr std::uint8_t kShapesMixed = 0;
inline constexpr std::uint8_t kShapesDeep = 1;

[[nodiscard]] constexpr bool is_shape_revision(std::uint8_t revision) {
  return revision <= kShapesDeep;
}
/// That of coder 1 for what is left, which has many contours and few bytes.
[[nodiscard]] constexpr std::uint8_t rest_revision(std::uint8_t revision) {
  return revision == kShapesDeep ? kContourDeep : kContourLight;
}

/// log2 of the slots per context of the pixels' models, a rule of the size
/// only. They may be more than the second caches hold: a pixel's are on their
/// way while the one before is coded.
[[nodiscard]] constexpr int shape_table_bits(std::uint8_t revision,
                                             std::int32_t width,
                                             std::int32_t rows) {
  const bool small = std::int64_t{width} * rows < 1'000'000;
  if (revision == kShapesDeep) return small ? 16 : 18;
  return small ? 14 : 17;
}

/// The shapes pass for one half of the work, the contours after them for the
/// other. The results must not outlive `progress`.
[[nodiscard]] BlockProgress first_half(const BlockProgress& progress);
[[nodiscard]] BlockProgress second_half(const BlockProgress& progress,
                                        std::int32_t rows);

/// Bytes that coding such a block allocates beside what is remembered of
/// shapes, which is counted as they come.
[[nodiscard]] std::uint64_t shape_memory(std::uint8_t revision,
                                         std::int32_t width, std::int32_t rows);

/// Codes those of the shapes of match_shapes() or find_shapes() first.
Result<std::vector<std::uint8_t>> encode_shapes(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    std::uint8_t revision, const std::vector<PlacedShape>& shapes,
    const BlockProgress& progress);

/// For training: encodes the shapes and shows the models as they are then.
using ShapeVisitor =
    std::function<void(const ShapePixelOrder<MixedShapePixels>& pixels,
                       const MixedShapeSequence& numbers)>;
Status show_shape_models(const Bitmap& ink,
                         const std::vector<PlacedShape>& shapes,
                         const ShapeVisitor& visit);

Status decode_shapes(std::span<const std::uint8_t> payload, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows,
                     std::uint8_t revision, const DecodeLimits& limits,
                     const BlockProgress& progress);

}  // namespace unstep::codec
