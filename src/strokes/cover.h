#pragma once

#include <vector>

#include "trace/skeleton_graph.h"
#include "unstep/bitmap.h"
#include "unstep/result.h"
#include "unstep/trace.h"

namespace unstep::strokes {

/// Adds dots to strokes until no ink is farther than two pixels from what they
/// draw: those that cover most of it first. `spots` are the places tried,
/// beside the missing pixels themselves.
Status cover_missing(const Bitmap& ink, std::vector<trace::Spot> spots,
                     std::vector<Stroke>& strokes);

/// Adds dots for the ink whose squared distance from what is drawn is above
/// `near`.
Status dot_missing(const Bitmap& ink, const Bitmap& drawn, std::int64_t near,
                   std::vector<trace::Spot> spots, std::vector<Stroke>& dots);

}  // namespace unstep::strokes
