#pragma once

#include <vector>

#include "unstep/trace.h"

namespace unstep::strokes {

/// Sorts strokes and turns open ones so that what is drawn together stands
/// together and in the same order wherever it comes: groups of strokes that
/// touch in the order of reading, large ones after the others; in a group
/// strokes after those on which they begin.
void order_strokes(std::vector<Stroke>& strokes);

}  // namespace unstep::strokes
