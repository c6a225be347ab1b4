#pragma once

#include <cstdint>

#include "codec/byte_reader.h"
#include "unstep/codec.h"

namespace unstep::codec {

/// Reads a list of metadata (docs/format.md, Metadata lists). Failures stick
/// in `in`. `budget` is what the rest of the file's metadata may cost; it
/// shrinks by the cost of this list.
Metadata read_metadata(ByteReader& in, std::uint64_t& budget);

}  // namespace unstep::codec
