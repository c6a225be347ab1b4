#pragma once

#include <cstdint>
#include <span>

#include "codec/block_coder.h"

/// Coder 25: paths that begin on each other, in groups that repeat,
/// docs/format.md.
namespace unstep::codec {

inline constexpr std::uint8_t kStrokeRevision = 0;

/// Encodes paths as encode_paths() does. REQUIRES: they are valid.
Result<EncodedBlock> encode_strokes(std::span<const Path> paths,
                                    const BlockProgress& progress);

/// decode_paths() of a payload of this coder.
Result<std::vector<Path>> decode_strokes(const CoderName& name,
                                         std::span<const std::uint8_t> payload,
                                         std::uint64_t count,
                                         std::uint64_t elements,
                                         const BlockProgress& progress);

}  // namespace unstep::codec
