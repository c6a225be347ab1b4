#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/block_coder.h"

namespace unstep::entropy {
class ArithmeticDecoder;
class ArithmeticEncoder;
}  // namespace unstep::entropy

/// Coder 1: contours under mixed models, docs/format.md.
namespace unstep::codec {

class TrainedTurnModel;
class StartModel;
enum class TurnViews : std::uint8_t;
template <TurnViews>
class MixedTurnModel;
namespace warm {
struct Table;
}

/// The models of turns; they are the revisions of coder 1. The light one is
/// for what is left beside shapes, the deep one for the max effort, that of
/// small drawings is the deep one with a warm start of its own.
inline constexpr std::uint8_t kContourStandard = 0;
inline constexpr std::uint8_t kContourSmall = 1;
inline constexpr std::uint8_t kContourFast = 2;
inline constexpr std::uint8_t kContourLight = 3;
inline constexpr std::uint8_t kContourDeep = 4;

[[nodiscard]] constexpr bool is_contour_revision(std::uint8_t revision) {
  return revision <= kContourDeep;
}

/// log2 of the model's slots per context, a rule of the size only, so that it
/// need not be stored. Larger pages have more contexts to remember; beyond
/// 24 Mpx the cracks need the memory more.
[[nodiscard]] constexpr int contour_table_bits(std::uint8_t revision,
                                               std::int32_t width,
                                               std::int32_t rows) {
  const std::int64_t pixels = std::int64_t{width} * rows;
  if (revision == kContourSmall) return pixels < 40'000 ? 13 : 15;
  if (revision == kContourDeep) {
    return pixels < 40'000 ? 14 : pixels < 2'000'000 ? 16 : 18;
  }
  if (pixels < 40'000) return 13;
  if (pixels < 2'000'000 || pixels > 24'000'000) return 15;
  return revision == kContourLight ? 16 : 17;
}

/// Bytes that coding such a block allocates: the cracks and the models.
[[nodiscard]] std::uint64_t contour_memory(std::uint8_t revision,
                                           std::int32_t width,
                                           std::int32_t rows);

Result<std::vector<std::uint8_t>> encode_contours(
    const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
    std::uint8_t revision, const BlockProgress& progress);

/// Decodes and compares with those rows of `ink`; internal if they differ.
Status verify_contours(std::span<const std::uint8_t> payload, const Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       std::uint8_t revision, const DecodeLimits& limits,
                       const BlockProgress& progress);

/// As a part of another coder's payload: codes those rows, or adds what is
/// decoded to what they hold. The memory limit is for the caller to check.
Status code_contours(entropy::ArithmeticEncoder& coder, const Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows,
                     std::uint8_t revision, const BlockProgress& progress);
Status code_contours(entropy::ArithmeticDecoder& coder, Bitmap& ink,
                     std::int32_t first_row, std::int32_t rows,
                     std::uint8_t revision, const BlockProgress& progress);

/// For training warm starts: encodes from `start` with the standard model and
/// tables of at least 2^16 slots, and shows the models as they are at the end.
inline constexpr int kTrainingBits =
    19;  // some contexts have eight times fewer
using ModelVisitor = std::function<void(
    const MixedTurnModel<TurnViews{0}>& turns, const StartModel& starts)>;
Result<std::vector<std::uint8_t>> encode_and_show(const Bitmap& ink,
                                                  const warm::Table& start,
                                                  const ModelVisitor& visit);
/// The same with the model of small drawings.
inline constexpr int kDeepTrainingBits = 17;
using DeepVisitor = std::function<void(const TrainedTurnModel& turns)>;
Status encode_and_show_deep(const Bitmap& ink, const DeepVisitor& visit);

Status decode_contours(std::span<const std::uint8_t> payload, Bitmap& ink,
                       std::int32_t first_row, std::int32_t rows,
                       std::uint8_t revision, const DecodeLimits& limits,
                       const BlockProgress& progress);

}  // namespace unstep::codec
