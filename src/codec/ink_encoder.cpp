#include <utility>
#include <vector>

#include "codec/block_coder.h"
#include "codec/centreline_coder.h"
#include "codec/contour_coder.h"
#include "codec/shape_coder.h"
#include "codec/stored_coder.h"
#include "codec/warm_start.h"

namespace unstep::codec {
namespace {

/// Contours, or rows as they are where these are fewer bytes.
Result<EncodedBlock> encode_by_contours(const Bitmap& ink,
                                        std::int32_t first_row,
                                        std::int32_t rows,
                                        std::uint8_t revision,
                                        const BlockProgress& progress) {
  Result<std::vector<std::uint8_t>> contours =
      encode_contours(ink, first_row, rows, revision, progress);
  if (!contours) return contours.error();
  // Noise has more cracks than pixels; then the packed rows are smaller. Only
  // worth trying where the contours cost a good part of a bit per pixel.
  const std::uint64_t pixels = static_cast<std::uint64_t>(ink.width()) *
                               static_cast<std::uint64_t>(rows);
  if (contours->size() > pixels / 16) {
    Result<std::vector<std::uint8_t>> stored =
        encode_stored(ink, first_row, rows);
    if (!stored) return stored.error();
    if (stored->size() < contours->size()) {
      return EncodedBlock{{kCoderStored, 0, 0}, *std::move(stored)};
    }
  }
  return EncodedBlock{{kCoderContours, revision, warm::kTableId},
                      *std::move(contours)};
}

}  // namespace

Result<EncodedBlock> encode_ink(const Bitmap& ink, std::int32_t first_row,
                                std::int32_t rows, Effort effort,
                                const BlockProgress& progress) {
  const std::uint8_t revision = contour_revision(effort);
  if (effort == Effort::fast) {
    return encode_by_contours(ink, first_row, rows, revision, progress);
  }
  Result<std::vector<std::uint8_t>> shapes =
      encode_shapes(ink, first_row, rows, revision, progress);
  if (!shapes) return shapes.error();
  if (!shapes->empty()) {
    return EncodedBlock{{kCoderShapes, revision, warm::kTableId},
                        *std::move(shapes)};
  }
  Result<EncodedBlock> contours =
      encode_by_contours(ink, first_row, rows, revision, progress);
  if (!contours || !is_thin(ink, first_row, rows)) return contours;
  // What is cheaper depends on branches, loops and corners, which no quick look
  // tells.
  Result<std::vector<std::uint8_t>> lines =
      encode_centrelines(ink, first_row, rows, progress);
  if (!lines) return lines.error();
  if (lines->empty() || lines->size() >= contours->payload.size()) {
    return contours;
  }
  return EncodedBlock{
      {kCoderCentrelines, kCentrelineRevision, kCentrelineTable},
      *std::move(lines)};
}

}  // namespace unstep::codec
