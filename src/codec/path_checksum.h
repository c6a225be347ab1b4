#pragma once

#include <cstdint>
#include <span>

#include "unstep/codec.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// What checksum.h has for chains, for paths.
namespace unstep::codec {

/// CRC-32 of the canonical bytes (docs/format.md, Checksums).
[[nodiscard]] std::uint32_t crc_paths(std::span<const Path> paths);

/// How many canonical bytes crc_paths takes. No overflow while both are below
/// 2^58.
[[nodiscard]] constexpr std::uint64_t path_bytes(std::uint64_t count,
                                                 std::uint64_t elements) {
  return 21 * count + 17 * elements;
}

/// Where coordinates of paths are and how they are drawn.
struct PathSpace {
  YAxis axis = YAxis::down;
  std::int32_t scale = 1;
  Paint paint = Paint::fill;
};

/// What a walk along paths finds.
struct PathSurvey {
  std::uint64_t elements = 0;
  Box box;  ///< grid units, of all that is drawn
};

/// Walks all paths. invalid_argument, naming path and element, unless every
/// one is valid: kinds known, pen 0..kMaxCoord wide, all vertices and centres
/// of arcs in the coordinate range, no centre on the start of its arc, closed
/// paths that return. REQUIRES: 1 <= scale.
Result<PathSurvey> survey_paths(std::span<const Path> paths,
                                const PathSpace& space);

/// Equal but for the members that an element of its kind does not use.
[[nodiscard]] bool same_paths(std::span<const Path> a, std::span<const Path> b);

}  // namespace unstep::codec
