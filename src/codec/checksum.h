#pragma once

#include <cstdint>
#include <span>

#include "codec/container_format.h"
#include "unstep/bitmap.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// CRC-32 (zlib, IEEE 802.3) of the decoded data in its canonical bytes
/// (docs/format.md, Checksums), and what must hold before it is taken.
namespace unstep::codec {

[[nodiscard]] std::uint32_t crc_bytes(std::span<const std::uint8_t> bytes,
                                      std::uint32_t seed = 0);

/// The CRC of two strings joined, from the CRC of each.
[[nodiscard]] std::uint32_t crc_join(std::uint32_t first, std::uint32_t second,
                                     std::uint64_t second_bytes);

/// The inverse of crc_join: the CRC of the second string.
[[nodiscard]] std::uint32_t crc_split(std::uint32_t joined, std::uint32_t first,
                                      std::uint64_t second_bytes);

/// REQUIRES: the rows are inside the raster.
[[nodiscard]] std::uint32_t crc_rows(const Bitmap& ink, std::int32_t first_row,
                                     std::int32_t rows);

[[nodiscard]] std::uint32_t crc_chains(std::span<const Chain> chains);

/// How many canonical bytes crc_chains takes. No overflow while both are below
/// 2^58.
[[nodiscard]] constexpr std::uint64_t chain_bytes(std::uint64_t count,
                                                  std::uint64_t steps) {
  return 17 * count + steps;
}

/// What a walk along chains finds.
struct ChainSurvey {
  std::uint64_t steps = 0;
  Box box;
};

/// Walks all chains. invalid_argument, naming chain and step, unless every one
/// is valid (grid.h): steps that fit the connectivity, points in range, closed
/// chains that return.
Result<ChainSurvey> survey_chains(std::span<const Chain> chains, YAxis axis);

}  // namespace unstep::codec
