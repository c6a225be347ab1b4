#pragma once

#include "codec/block_coder.h"
#include "codec/byte_reader.h"
#include "codec/container_format.h"
#include "unstep/codec.h"

/// The fields that the short and the block form have in common. Failures
/// stick in the ByteReader.
namespace unstep::codec {

/// Where the metadata of a file's lists go.
struct MetadataSink {
  std::uint64_t& budget;        ///< what the rest of the lists may cost
  Metadata* of_file = nullptr;  ///< null if a page head may have none
};

/// Kind, canvas, details and path head (docs/format.md, Page head). `flags` is
/// the byte already read; bits 0, 1 and 4 are the caller's. Only a short
/// form may say more of the coder than that it is named.
HeadCoder read_page_head(std::uint8_t flags, ByteReader& in,
                         MetadataSink metadata, PageEntry& page);

/// Coder, revision and table; in a short form, which does not name the usual
/// one.
void read_coder_name(ByteReader& in, PageEntry::Block& block);
void read_short_coder_name(HeadCoder said, ByteReader& in,
                           const PageEntry& page, PageEntry::Block& block);

/// How many chains and steps, or paths and elements, a payload holds; ink has
/// neither. Gives the canonical bytes of such a payload, 0 for ink.
std::uint64_t read_counts(ByteReader& in, PageKind kind,
                          PageEntry::Block& block);

Box read_box(ByteReader& in);

}  // namespace unstep::codec
