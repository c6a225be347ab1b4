#pragma once

#include <cstddef>
#include <vector>

#include "program/arc_fit.h"
#include "program/polyline.h"

namespace unstep {

/// A line or an arc that takes the place of the lines up to a vertex.
struct CoverPiece {
  std::size_t last = 0;
  bool is_arc = false;
  FittedArc arc;
};

struct CoverOptions {
  double tolerance = 0;   ///< of lines, program units
  ArcFitOptions arc;      ///< its own tolerance
  bool arcs = true;       ///< all z of the run may differ otherwise
  double arc_cost = 1.8;  ///< in lines
};

/// The run in few pieces, from its first vertex to its last. Greedy: the
/// longest line, or the longest arc where it does the work of more lines than
/// it costs.
void cover_run(const Polyline& run, const CoverOptions& options,
               std::vector<CoverPiece>& pieces);

}  // namespace unstep
