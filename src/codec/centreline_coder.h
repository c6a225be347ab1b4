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
template <class Decisions>
class LineStartModel;
template <std::size_t kContexts, std::size_t kSets, bool kRefined, bool kKnown>
class DecisionModel;

/// The models, of the standard and the max effort.
inline constexpr std::uint8_t kCentrelinesMixed = 0;
inline constexpr std::uint8_t kCentrelinesDeep = 1;
inline constexpr std::uint8_t kCentrelineTable = 1;

[[nodiscard]] constexpr bool is_centreline_revision(std::uint8_t revision) {
  return revision <= kCentrelinesDeep;
}

/// Pixels of branches that may wait at once: a bound of the format, far above
/// what drawings of lines need.
inline constexpr std::size_t kMostWaiting = std::size_t{1} << 14;

/// log2 of the model's slots per context, a rule of the size only, so that it
/// need not be stored.
[[nodiscard]] constexpr int centreline_table_bits(std::uint8_t revision,
                                                  std::int32_t width,
                                                  std::int32_t rows) {
  const std::int64_t pixels = std::int64_t{width} * rows;
  const int more = revision == kCentrelinesDeep ? 1 : 0;
  return (pixels < 40'000 ? 11 : pixels < 2'000'000 ? 13 : 15) + more;
}

/// Bytes that coding such a block allocates: the pixels and the models.
[[nodiscard]] std::uint64_t centreline_memory(std::uint8_t revision,
                                              std::int32_t width,
                                              std::int32_t rows);

/// Whether this coder is worth trying: lines of one pixel are most of the ink
/// of these rows, and they are no small drawing, of which contours know much
/// from the start. One look at every word.
[[nodiscard]] bool is_thin(const Bitmap& ink, std::int32_t first_row,
                           std::int32_t rows);

/// Empty if too many branches would wait.
Result<std::vector<std::uint8_t>> encode_centrelines(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    std::uint8_t revision, const BlockProgress& progress);

Status decode_centrelines(std::span<const std::uint8_t> payload, Bitmap& ink,
                          std::int32_t first_row, std::int32_t rows,
                          std::uint8_t revision, const DecodeLimits& limits,
                          const BlockProgress& progress);

/// Decodes and compares with those rows of `ink`; internal if they differ.
Status verify_centrelines(std::span<const std::uint8_t> payload,
                          const Bitmap& ink, std::int32_t first_row,
                          std::int32_t rows, std::uint8_t revision,
                          const DecodeLimits& limits,
                          const BlockProgress& progress);

/// For training: encodes and shows the models as they are at the end. `cold`:
/// without the warm start, and with 2^16 slots per context.
using CentrelineVisitor = std::function<void(
    const CentrelineModel& lines,
    const LineStartModel<DecisionModel<5, 3, true, false>>& starts)>;
Status show_centreline_models(const Bitmap& ink, bool cold,
                              const CentrelineVisitor& visit);

}  // namespace unstep::codec
