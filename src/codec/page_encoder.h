#pragma once

#include <string_view>

#include "codec/container_encoder.h"
#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/result.h"

/// Encodes what a page holds into the blocks of `page`, with their checksums
/// and that of the page. With options.verify every block is decoded and
/// compared: internal if it is not what was given.
namespace unstep::codec {

Status encode_ink_page(const Bitmap& ink, const EncodeOptions& options,
                       PageParts& page);

/// As page.kind says: the chains of `drawing`, or its paths.
Status encode_drawing_page(const Drawing& drawing, const EncodeOptions& options,
                           PageParts& page);

/// The text of a program, in one block.
Status encode_program_page(std::string_view text, const EncodeOptions& options,
                           PageParts& page);

}  // namespace unstep::codec
