#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "codec/block_coder.h"

/// Coder 3: lines one pixel thin, docs/format.md.
namespace unstep::codec {

class CentrelineModel;
class CentrelineStartModel;

inline constexpr std::uint8_t kCentrelineRevision = 0;
inline constexpr std::uint8_t kCentrelineTable = 0;

/// Pixels of branches that may wait at once: a bound of the format, far above
/// what drawings of lines need.
inline constexpr std::size_t kMostWaiting = std::size_t{1} << 14;

/// log2 of the model's slots per context, a rule of the size only, so that it
/// need not be stored.
[[nodiscard]] constexpr int centreline_table_bits(std::int32_t width,
                                                  std::int32_t rows) {
  const std::int64_t pixels = std::int64_t{width} * rows;
  return pixels < 40'000 ? 11 : pixels < 2'000'000 ? 13 : 15;
}

/// Bytes that coding such a block allocates: the pixels and the models.
[[nodiscard]] std::uint64_t centreline_memory(std::int32_t width,
                                              std::int32_t rows);

/// Whether this coder is worth trying: lines of one pixel are most of the ink
/// of these rows, and they are no small drawing, of which contours know much
/// from the start. One look at every word.
[[nodiscard]] bool is_thin(const Bitmap& ink, std::int32_t first_row,
                           std::int32_t rows);

/// Empty if too many branches would wait.
Result<std::vector<std::uint8_t>> encode_centrelines(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    const BlockProgress& progress);

Status decode_centrelines(std::span<const std::uint8_t> payload, Bitmap& ink,
                          std::int32_t first_row, std::int32_t rows,
                          const DecodeLimits& limits,
                          const BlockProgress& progress);

/// Decodes and compares with those rows of `ink`; internal if they differ.
Status verify_centrelines(std::span<const std::uint8_t> payload,
                          const Bitmap& ink, std::int32_t first_row,
                          std::int32_t rows, const DecodeLimits& limits,
                          const BlockProgress& progress);

/// For training: encodes and shows the models as they are at the end.
using CentrelineVisitor = std::function<void(
    const CentrelineModel& lines, const CentrelineStartModel& starts)>;
Status show_centreline_models(const Bitmap& ink,
                              const CentrelineVisitor& visit);

}  // namespace unstep::codec
