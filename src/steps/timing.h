#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "steps/grid_moves.h"

/// When the steps of moves come.
namespace unstep::steps {

/// A move's speeds in mm/s: at its start, its end, and the most between.
struct MoveSpeed {
  double first = 0;
  double last = 0;
  double most = 0;
};

/// Looks ahead over all moves: no speed is above what the corners, the feeds
/// and the acceleration allow, and every one can be braked in time. The first
/// move starts and the last ends at rest, and so does each change between
/// rapids and feeds.
[[nodiscard]] std::vector<MoveSpeed> plan_speeds(
    std::span<const GridMove> moves, const StepTiming& timing);

}  // namespace unstep::steps
