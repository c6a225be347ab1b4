#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "codec/block_coder.h"
#include "codec/centreline_coder.h"
#include "codec/contour_coder.h"
#include "codec/pixel_coder.h"
#include "codec/shape_coder.h"
#include "codec/shape_matcher.h"
#include "codec/stored_coder.h"
#include "codec/warm_start.h"
#include "grid/bit_count.h"

namespace unstep::codec {
namespace {

/// Pixels from which on the fast effort codes pixels, and any effort dither.
constexpr std::int64_t kSmallestFastPixels = 1'000'000;
constexpr std::int64_t kSmallestDither = 40'000;
/// Pixels from which on a page is a scan: small drawings are over in no time.
constexpr std::int64_t kSmallestScan = 2'000'000;

/// Drawings of fewer pixels, and of no more cracks, have deep turns.
constexpr std::int64_t kSmallestFlatTurns = 1'000'000;
constexpr std::uint64_t kMostDeepCracks = 32768;

/// Small drawings end before pixels have learned anything.
bool is_small(const Bitmap& ink, std::int32_t rows, std::int64_t pixels) {
  return std::int64_t{ink.width()} * rows < pixels;
}

/// Between ink and paper, those at the left and lower borders not counted.
std::uint64_t count_cracks(const Bitmap& ink, std::int32_t first_row,
                           std::int32_t rows) {
  std::uint64_t cracks = 0;
  for (std::int32_t y = first_row; y < first_row + rows; ++y) {
    const auto row = ink.row(y);
    std::uint64_t left = 0;  // the pixel before the word, in the highest bit
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::uint64_t above = y > first_row ? ink.row(y - 1)[i] : 0;
      cracks += static_cast<std::uint64_t>(ones(row[i] ^ (row[i] >> 1 | left)) +
                                           ones(row[i] ^ above));
      left = row[i] << 63;
    }
  }
  return cracks;
}

/// The payload, or rows as they are where these are fewer bytes.
Result<EncodedBlock> or_stored(CoderName name,
                               Result<std::vector<std::uint8_t>> payload,
                               const Bitmap& ink, std::int32_t first_row,
                               std::int32_t rows) {
  if (!payload) return payload.error();
  // Of noise the packed rows are smaller. Only worth trying where the payload
  // costs a good part of a bit per pixel.
  const std::uint64_t pixels = static_cast<std::uint64_t>(ink.width()) *
                               static_cast<std::uint64_t>(rows);
  if (payload->size() > pixels / 16) {
    Result<std::vector<std::uint8_t>> stored =
        encode_stored(ink, first_row, rows);
    if (!stored) return stored.error();
    if (stored->size() < payload->size()) {
      return EncodedBlock{{kCoderStored, 0, 0}, *std::move(stored)};
    }
  }
  return EncodedBlock{name, *std::move(payload)};
}

Result<EncodedBlock> encode_by_contours(const Bitmap& ink,
                                        std::int32_t first_row,
                                        std::int32_t rows,
                                        std::uint8_t revision,
                                        const BlockProgress& progress) {
  return or_stored({kCoderContours, revision, warm::kTableId},
                   encode_contours(ink, first_row, rows, revision, progress),
                   ink, first_row, rows);
}

Result<EncodedBlock> encode_by_pixels(const Bitmap& ink, std::int32_t first_row,
                                      std::int32_t rows, std::uint8_t revision,
                                      const BlockProgress& progress) {
  return or_stored({kCoderPixels, revision, kPixelTable},
                   encode_pixels(ink, first_row, rows, revision, progress), ink,
                   first_row, rows);
}

struct Rows {
  std::int32_t first = 0;
  std::int32_t count = 0;
};

/// Those that hold a sixteenth of the ink, from two fifths of it on; all if
/// there is little.
Rows sample_of(const Bitmap& ink, std::int32_t first_row, std::int32_t rows) {
  constexpr std::uint64_t kLittle = 32768;
  std::vector<std::uint64_t> until(static_cast<std::size_t>(rows) + 1);
  for (std::size_t y = 0; y + 1 < until.size(); ++y) {
    until[y + 1] = until[y];
    for (const std::uint64_t word :
         ink.row(first_row + static_cast<std::int32_t>(y))) {
      until[y + 1] += static_cast<std::uint64_t>(ones(word));
    }
  }
  const std::uint64_t all = until.back();
  if (all < kLittle) return {first_row, rows};
  const auto row = [&](std::uint64_t pixels) {
    return static_cast<std::int32_t>(
        std::lower_bound(until.begin(), until.end(), pixels) - until.begin());
  };
  const std::int32_t first = row(all * 2 / 5);
  const std::int32_t end = row(all * 2 / 5 + all / 16);
  return {first_row + first, std::max(end - first, 1)};
}

/// What is cheaper depends on branches, loops and corners, which no quick look
/// tells: a part is coded both ways. Contours learn more from the rest.
Result<bool> lines_pay(const Bitmap& ink, Rows sample, std::uint8_t revision) {
  constexpr std::size_t kPercent = 96;
  const Result<std::vector<std::uint8_t>> lines = encode_centrelines(
      ink, sample.first, sample.count, kCentrelinesMixed, {});
  if (!lines) return lines.error();
  const Result<std::vector<std::uint8_t>> contours =
      encode_contours(ink, sample.first, sample.count, revision, {});
  if (!contours) return contours.error();
  return !lines->empty() && lines->size() * 100 < contours->size() * kPercent;
}

EncodedBlock as_lines(std::uint8_t revision,
                      std::vector<std::uint8_t> payload) {
  return {{kCoderCentrelines, revision, kCentrelineTable}, std::move(payload)};
}

/// The model of contours that suits a drawing. Deep models take 4 us a turn,
/// ten times as much as others: small drawings are over before that matters.
std::uint8_t contour_revision(const Bitmap& ink, std::int32_t first_row,
                              std::int32_t rows) {
  if (is_small(ink, rows, kSmallestFlatTurns) &&
      count_cracks(ink, first_row, rows) <= kMostDeepCracks) {
    return kContourSmall;
  }
  return kContourStandard;
}

/// Lines or contours, what is smaller as far as that is known.
Result<EncodedBlock> encode_thin(const Bitmap& ink, std::int32_t first_row,
                                 std::int32_t rows,
                                 const BlockProgress& progress) {
  const Rows sample = sample_of(ink, first_row, rows);
  const bool sure = sample.count == rows;
  const std::uint8_t revision = contour_revision(ink, first_row, rows);
  if (!sure) {
    const Result<bool> pay = lines_pay(ink, sample, kContourStandard);
    if (!pay) return pay.error();
    if (!*pay) {
      return encode_by_contours(ink, first_row, rows, revision, progress);
    }
  }
  Result<std::vector<std::uint8_t>> lines =
      encode_centrelines(ink, first_row, rows, kCentrelinesMixed, progress);
  if (!lines) return lines.error();
  if (sure || lines->empty()) {
    Result<EncodedBlock> contours =
        encode_by_contours(ink, first_row, rows, revision, progress);
    if (!contours) return contours.error();
    if (lines->empty() || contours->payload.size() <= lines->size()) {
      return contours;
    }
  }
  return as_lines(kCentrelinesMixed, *std::move(lines));
}

Result<EncodedBlock> encode_by_shapes(const Bitmap& ink, std::int32_t first_row,
                                      std::int32_t rows, std::uint8_t revision,
                                      const std::vector<PlacedShape>& shapes,
                                      const BlockProgress& progress) {
  Result<std::vector<std::uint8_t>> payload =
      encode_shapes(ink, first_row, rows, revision, shapes, progress);
  if (!payload) return payload.error();
  return EncodedBlock{{kCoderShapes, revision, warm::kTableId},
                      *std::move(payload)};
}

/// Bytes in a file: a coder that is not the usual one is named, in one byte or
/// in three.
std::size_t cost(const EncodedBlock& block) {
  const std::size_t name = block.name == usual_coder(PageKind::ink) ? 0
                           : block.name.revision <= 2               ? 1
                                                                    : 3;
  return block.payload.size() + name;
}

/// Of all ways that may be it the one that takes the fewest bytes: never more
/// than the standard effort, whose ways are among them. The deep model of
/// contours costs most of the time; where shapes repeat they are smaller by
/// some per cent.
Result<EncodedBlock> encode_smallest(const Bitmap& ink, std::int32_t first_row,
                                     std::int32_t rows,
                                     const BlockProgress& progress) {
  const bool small = is_small(ink, rows, kSmallestScan);
  Result<EncodedBlock> best = encode_by_contours(
      ink, first_row, rows, small ? kContourSmall : kContourStandard, progress);
  const auto keep = [&](Result<EncodedBlock> block) {
    if (!best) return;
    if (!block || (!block->payload.empty() && cost(*block) < cost(*best))) {
      best = std::move(block);
    }
  };
  if (small) {
    keep(encode_by_contours(ink, first_row, rows, kContourStandard, progress));
  }
  keep(encode_by_contours(ink, first_row, rows, kContourLight, progress));
  const std::vector<PlacedShape> shapes =
      find_shapes(ink, first_row, rows, kShapesPay);
  if (!shapes.empty()) {
    keep(
        encode_by_shapes(ink, first_row, rows, kShapesMixed, shapes, progress));
  }
  const bool repeats = best && best->name.coder == kCoderShapes;
  if (repeats) {
    keep(encode_by_shapes(ink, first_row, rows, kShapesDeep, shapes, progress));
  } else {
    keep(encode_by_contours(ink, first_row, rows, kContourDeep, progress));
  }
  keep(encode_by_pixels(ink, first_row, rows, kPixelsDeep, progress));
  if (is_thin(ink, first_row, rows)) {
    for (const std::uint8_t revision : {kCentrelinesMixed, kCentrelinesDeep}) {
      Result<std::vector<std::uint8_t>> lines =
          encode_centrelines(ink, first_row, rows, revision, progress);
      if (!lines) return lines.error();
      keep(as_lines(revision, *std::move(lines)));
    }
  }
  return best;
}

Result<EncodedBlock> encode_fast(const Bitmap& ink, std::int32_t first_row,
                                 std::int32_t rows, const PixelTexture& texture,
                                 const BlockProgress& progress) {
  if (is_small(ink, rows, kSmallestFastPixels)) {
    return encode_by_contours(ink, first_row, rows, kContourFast, progress);
  }
  return encode_by_pixels(ink, first_row, rows,
                          texture.is_drawn() ? kPixelsMixed : kPixelsBlended,
                          progress);
}

/// Scans of print or drawings with letters that hardly repeat. Where they are
/// crowded, pixels take half the time of shapes for one or two per cent more
/// bytes; contours under the light model take half of the full one for 4 %.
Result<EncodedBlock> encode_scan(const Bitmap& ink, std::int32_t first_row,
                                 std::int32_t rows, const PixelTexture& texture,
                                 const BlockProgress& progress) {
  return texture.is_crowded()
             ? encode_by_pixels(ink, first_row, rows, kPixelsDeep, progress)
             : encode_by_contours(ink, first_row, rows, kContourLight,
                                  progress);
}

Result<EncodedBlock> encode_standard(const Bitmap& ink, std::int32_t first_row,
                                     std::int32_t rows,
                                     const PixelTexture& texture,
                                     const BlockProgress& progress) {
  const bool scan = texture.is_printed() && !is_small(ink, rows, kSmallestScan);
  const std::vector<PlacedShape> shapes =
      find_shapes(ink, first_row, rows,
                  scan && texture.is_crowded() ? kShapesPayWell : kShapesPay);
  if (!shapes.empty()) {
    return encode_by_shapes(ink, first_row, rows, kShapesMixed, shapes,
                            progress);
  }
  if (is_thin(ink, first_row, rows)) {
    return encode_thin(ink, first_row, rows, progress);
  }
  if (scan) return encode_scan(ink, first_row, rows, texture, progress);
  return encode_by_contours(ink, first_row, rows,
                            contour_revision(ink, first_row, rows), progress);
}

}  // namespace

Result<EncodedBlock> encode_ink(const Bitmap& ink, std::int32_t first_row,
                                std::int32_t rows, Effort effort,
                                const BlockProgress& progress) {
  const PixelTexture texture = pixel_texture(ink, first_row, rows);
  if (texture.is_dithered() && !is_small(ink, rows, kSmallestDither)) {
    return encode_by_pixels(ink, first_row, rows,
                            effort == Effort::fast ? kPixelsMixed : kPixelsDeep,
                            progress);
  }
  if (effort == Effort::fast) {
    return encode_fast(ink, first_row, rows, texture, progress);
  }
  if (effort == Effort::max) {
    return encode_smallest(ink, first_row, rows, progress);
  }
  return encode_standard(ink, first_row, rows, texture, progress);
}

}  // namespace unstep::codec
