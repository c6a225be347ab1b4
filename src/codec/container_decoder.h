#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "codec/container_format.h"
#include "unstep/codec.h"
#include "unstep/result.h"

/// Takes the bytes of a file apart without decoding a payload.
namespace unstep::codec {

/// What a decoded payload block must agree with.
struct BlockProof {
  std::uint32_t checksum = 0;
  std::optional<Box> box;  ///< if the file has an index
};

struct ParsedFile {
  FileInfo info;
  std::vector<std::vector<BlockProof>> proofs;  ///< [page][block]
};

/// Checks everything that can be checked without decoding: structure, ranges,
/// the CRC of every block, that bands tile their page, that the index tells
/// the truth. Memory stays proportional to the file's size plus its metadata
/// (kMaxMetadataTotal).
Result<ParsedFile> parse_file(std::span<const std::uint8_t> file);

}  // namespace unstep::codec
