#pragma once

#include "unstep/bitmap.h"
#include "unstep/result.h"

namespace unstep::trace {

/// Takes away what noise adds to the edges of ink three pixels wide or more,
/// which would make spurs and rings of the skeleton. Within three pixels of a
/// square of 3 x 3 ink: holes of up to four pixels are filled, single pixels
/// off the edge go, and a pixel becomes what most of the 3 x 3 pixels around it
/// are, if that changes neither the pieces of ink nor the holes. Thin letters
/// keep their holes, and no edge moves by more than a pixel.
/// limit_exceeded if there is no memory for two bitmaps more.
Status smooth_edges(Bitmap& ink);

}  // namespace unstep::trace
