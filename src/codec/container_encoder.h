#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/block_coder.h"
#include "codec/container_format.h"
#include "unstep/codec.h"
#include "unstep/result.h"

/// Puts encoded blocks into the bytes of a file. Knows nothing of coders, so
/// that tests can pack any payload.
namespace unstep::codec {

struct BlockParts {
  EncodedBlock encoded;
  std::uint32_t checksum = 0;  ///< of what the payload decodes to
  Box box;
  std::int32_t first_row = 0;  ///< ink
  std::int32_t rows = 0;
  std::uint64_t chains = 0;  ///< chains
  std::uint64_t steps = 0;
  std::uint64_t paths = 0;       ///< paths
  std::uint64_t lines = 0;       ///< program
  std::uint64_t text_bytes = 0;  ///< program
  std::uint64_t elements = 0;
};

struct PageParts {
  PageKind kind = PageKind::ink;
  Canvas canvas;
  Fidelity fidelity;  ///< paths
  std::int32_t scale = 1;
  Paint paint = Paint::fill;
  PageInfo info;
  std::uint32_t checksum = 0;
  std::vector<BlockParts> blocks;
};

/// What the format cannot hold of a page, its blocks aside: invalid_argument,
/// out_of_range or limit_exceeded.
Status check_page(const PageParts& page);

/// True if the short form can hold it.
[[nodiscard]] bool fits_short_form(std::span<const PageParts> pages);

/// `metadata`: the file's. Both forms fail as write_metadata does, and with
/// limit_exceeded if there is too much metadata in all.
/// REQUIRES: fits_short_form, a checked page.
Result<std::vector<std::uint8_t>> short_form(const PageParts& page,
                                             const Metadata& metadata);

/// REQUIRES: at least one page, each checked and with at least one block.
Result<std::vector<std::uint8_t>> block_form(std::span<const PageParts> pages,
                                             const Metadata& metadata);

}  // namespace unstep::codec
