#pragma once

#include <vector>

#include "trace/skeleton_graph.h"
#include "unstep/bitmap.h"
#include "unstep/result.h"
#include "unstep/trace.h"

namespace unstep::strokes {

/// Adds dots to strokes until no ink is farther than 2.3 pixels from what they
/// draw, nor more than three pixels of it than two: those that cover most of it
/// first. `spots` are the places tried,
/// beside the missing pixels themselves.
Status cover_missing(const Bitmap& ink, const std::vector<trace::Spot>& spots,
                     std::vector<Stroke>& strokes);

/// What counts as missing: ink farther than this from what is drawn, in
/// squared pixels, and so many pixels of it for a dot.
struct Missing {
  std::int64_t near = 4;
  std::uint64_t least = 1;
};

/// Adds dots for the ink that is missing.
Status dot_missing(const Bitmap& ink, const Bitmap& drawn,
                   const Missing& missing, std::vector<trace::Spot> spots,
                   std::vector<Stroke>& dots);

}  // namespace unstep::strokes
