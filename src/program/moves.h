#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "unstep/program.h"
#include "unstep/result.h"

namespace unstep {

/// program_moves() one by one: take(const ProgramMove&) returns a Status, whose
/// error ends the walk.
template <class Take>
Status visit_moves(const Program& program, bool skip_unknown, Take&& take) {
  ProgramMove move;
  for (const ProgramItem& item : program.items) {
    if (item.unknown_effect && !skip_unknown) {
      return Error{ErrorCode::unsupported, "line " + std::to_string(item.line) +
                                               ": its motion is not known"};
    }
    if (!item.is_motion()) continue;
    const ProgramModes& modes = program.modes[item.modes];
    move.kind = item.kind;
    move.plane = modes.plane.value_or(ProgramPlane::xy);
    move.turns = item.turns;
    move.line = item.line;
    move.start = move.end;
    move.end = program.position(item);
    const auto plane = plane_axes(move.plane);
    for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
      move.end[axis] += modes.offset[axis];
    }
    move.centre = {item.centre[0] + modes.offset[plane[0]],
                   item.centre[1] + modes.offset[plane[1]]};
    move.feed = item.feed;
    move.spindle = item.spindle;
    if (Status taken = take(std::as_const(move)); !taken) return taken;
  }
  return {};
}

}  // namespace unstep
