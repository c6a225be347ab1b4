#pragma once

#include "codec/byte_writer.h"
#include "unstep/codec.h"
#include "unstep/result.h"

namespace unstep::codec {

/// Appends a list of metadata (docs/format.md, Metadata lists).
/// invalid_argument: an empty or repeated key, text that is no UTF-8 or holds
/// a zero byte; limit_exceeded: more than the format allows.
Status write_metadata(const Metadata& metadata, ByteWriter& out);

/// The bytes a list has before it is deflated.
[[nodiscard]] std::uint64_t metadata_bytes(const Metadata& metadata);

}  // namespace unstep::codec
