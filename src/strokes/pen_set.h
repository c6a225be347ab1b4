#pragma once

#include <vector>

#include "unstep/trace.h"

namespace unstep::strokes {

/// Gives the same pen to strokes of about the same width: drawings are made
/// with a few pens, and measured widths scatter about theirs. The width that
/// most steps have becomes a pen and takes those within a quarter of it, half a
/// pixel at least and two at most; so on with the others.
void share_pens(std::vector<Stroke>& strokes);

}  // namespace unstep::strokes
