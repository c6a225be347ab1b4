#pragma once

#include "unstep/grid.h"
#include "unstep/result.h"
#include "unstep/reverse.h"

/// `unstep reverse --method tolerance`.
namespace unstep::cli {

/// Prints the lines and arcs that stand for the chain, y up from its start at
/// 0, 0, after the check that they are within the tolerance. `where`: the place
/// at which each starts comes first.
/// limit_exceeded if the chain leaves the range of coordinates; io_error if
/// they cannot be written.
Status print_lines(Chain chain, const ToleranceOptions& options, bool where);

}  // namespace unstep::cli
