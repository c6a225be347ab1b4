#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// What the container and the coders of one block agree on. The container
/// knows nothing of a payload but these names and functions.
namespace unstep::codec {

/// Names a payload's coder so that models can improve while old files stay
/// readable.
struct CoderName {
  std::uint8_t coder = 0;
  std::uint8_t revision = 0;
  std::uint8_t table = 0;
  friend bool operator==(const CoderName&, const CoderName&) = default;
};

/// What a decoder says of a name it does not know. `kind`: "ink", "chain" ...
[[nodiscard]] inline Error unknown_coder(std::string_view kind,
                                         const CoderName& name) {
  return {ErrorCode::unsupported_version,
          std::string(kind) + " coder " + std::to_string(name.coder) +
              " revision " + std::to_string(name.revision) + " table " +
              std::to_string(name.table) + " is unknown"};
}

/// Coder ids, docs/format.md.
inline constexpr std::uint8_t kCoderStored = 0;    ///< packed rows, deflated
inline constexpr std::uint8_t kCoderContours = 1;  ///< contours, mixed models
inline constexpr std::uint8_t kCoderShapes = 2;    ///< shapes that repeat
inline constexpr std::uint8_t kCoderCentrelines = 3;  ///< thin lines
inline constexpr std::uint8_t kCoderPixels = 4;       ///< pixels in rows
inline constexpr std::uint8_t kCoderChains = 16;      ///< chains, mixed models
inline constexpr std::uint8_t kCoderPaths = 24;       ///< paths, mixed models
inline constexpr std::uint8_t kCoderStrokes = 25;     ///< paths that repeat
inline constexpr std::uint8_t kCoderProgram = 28;  ///< programs, mixed models

/// The coder of nearly all short files with such a page, which they do not
/// name (docs/format.md, Short form). Part of the format, whatever revisions
/// come.
[[nodiscard]] constexpr CoderName usual_coder(PageKind kind) {
  switch (kind) {
    case PageKind::ink: return {kCoderContours, 1, 1};
    case PageKind::chains: return {kCoderChains, 0, 0};
    case PageKind::paths: return {kCoderPaths, 0, 1};
    case PageKind::program: break;
  }
  return {kCoderProgram, 0, 0};
}

/// The coder of strokes with the usual head, which says so.
inline constexpr CoderName kUsualStrokeCoder{kCoderStrokes, 0, 1};

struct EncodedBlock {
  CoderName name;
  std::vector<std::uint8_t> payload;
};

/// Called now and then with the rows (or chains) done so far; false cancels.
using BlockProgress = std::function<bool(std::uint64_t done)>;

/// Encodes rows [first_row, first_row + rows) of `ink`.
Result<EncodedBlock> encode_ink(const Bitmap& ink, std::int32_t first_row,
                                std::int32_t rows, Effort effort,
                                const BlockProgress& progress);

/// Decodes into those rows of `ink`, which must be all paper. Every payload
/// byte must be consumed. After a failure the rows hold anything.
Status decode_ink(const CoderName& name, std::span<const std::uint8_t> payload,
                  Bitmap& ink, std::int32_t first_row, std::int32_t rows,
                  const DecodeLimits& limits, const BlockProgress& progress);

/// Whether the payload decodes to exactly those rows of `ink`: internal if
/// not, or the decoder's own error. Holds no second copy of the rows where the
/// coder allows.
Status verify_ink(const CoderName& name, std::span<const std::uint8_t> payload,
                  const Bitmap& ink, std::int32_t first_row, std::int32_t rows,
                  const DecodeLimits& limits, const BlockProgress& progress);

/// Encodes chains in their order. invalid_argument for chains that are not
/// valid (grid.h). `axis` is that of the canvas.
Result<EncodedBlock> encode_chains(std::span<const Chain> chains, YAxis axis,
                                   const BlockProgress& progress);

/// Decodes exactly `count` chains of `steps` steps in all; both were checked
/// against the limits by the caller. The chains are valid (grid.h). Every
/// payload byte must be consumed.
Result<std::vector<Chain>> decode_chains(const CoderName& name,
                                         std::span<const std::uint8_t> payload,
                                         std::uint64_t count,
                                         std::uint64_t steps, YAxis axis,
                                         const BlockProgress& progress);

/// Encodes paths in their order. invalid_argument for paths that are not valid
/// (path_checksum.h).
Result<EncodedBlock> encode_paths(std::span<const Path> paths,
                                  const BlockProgress& progress);

/// Decodes exactly `count` paths of `elements` elements in all; both were
/// checked against the limits by the caller. The paths are valid. Every
/// payload byte must be consumed.
Result<std::vector<Path>> decode_paths(const CoderName& name,
                                       std::span<const std::uint8_t> payload,
                                       std::uint64_t count,
                                       std::uint64_t elements,
                                       const BlockProgress& progress);

/// Encodes the lines of a program in the form that write_gcode gives it.
/// invalid_argument if the last line does not end with a newline.
Result<EncodedBlock> encode_program(std::string_view text,
                                    const BlockProgress& progress);

/// Decodes exactly `lines` lines of `bytes` bytes in all, ends of lines
/// included; both were checked against the limits by the caller. Every payload
/// byte must be consumed.
Result<std::string> decode_program(const CoderName& name,
                                   std::span<const std::uint8_t> payload,
                                   std::uint64_t lines, std::uint64_t bytes,
                                   const BlockProgress& progress);

}  // namespace unstep::codec
