#pragma once

#include <cstdint>
#include <span>

#include "codec/container_decoder.h"
#include "unstep/result.h"

namespace unstep::codec {

/// parse_file for the block form (docs/format.md, Block form). The first block
/// begins at `start`.
Result<ParsedFile> parse_block_form(std::span<const std::uint8_t> file,
                                    std::uint64_t start);

}  // namespace unstep::codec
