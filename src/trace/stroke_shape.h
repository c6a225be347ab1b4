#pragma once

#include "trace/stroke_route.h"
#include "unstep/bitmap.h"
#include "unstep/trace.h"

namespace unstep::trace {

/// Moves the free ends of a route to where a pen with a round tip reaches as
/// far as the ink: a skeleton ends too early, or bends into a corner.
void fit_ends(const Bitmap& ink, Route& route);

/// A route with its widths, the chain and shift of a stroke.
[[nodiscard]] Stroke shape_of(const Bitmap& ink, const Route& route);

}  // namespace unstep::trace
