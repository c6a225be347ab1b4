#pragma once

#include "unstep/program.h"

namespace unstep {

/// Arcs that follow each other on one circle, with nothing between and the same
/// feed, spindle and modes, become one of at most a full turn. The distance
/// between the paths (Frechet) is at most `tolerance`, in program units; the
/// arcs satisfy the rules.
void merge_arcs(Program& program, double tolerance, const ArcRules& rules);

}  // namespace unstep
