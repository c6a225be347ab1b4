#pragma once

#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/result.h"

namespace unstep::codec {

/// The part of `ink` inside `box`. out_of_range if there is none.
Result<Bitmap> crop(const Bitmap& ink, const Box& box);

}  // namespace unstep::codec
