#include "unstep/program.h"

#include <algorithm>
#include <string>

namespace unstep {

ProgramPosition Program::position(const ProgramItem& item) const {
  ProgramPosition position{};
  std::copy(item.end.begin(), item.end.end(), position.begin());
  const ProgramOtherAxes& rest = others[item.others];
  std::copy(rest.begin(), rest.end(), position.begin() + 3);
  return position;
}

Result<std::vector<ProgramMove>> program_moves(const Program& program,
                                               bool skip_unknown) {
  std::vector<ProgramMove> moves;
  ProgramPosition at{};
  for (const ProgramItem& item : program.items) {
    const ProgramModes& modes = program.modes[item.modes];
    if (item.unknown_effect && !skip_unknown) {
      return Error{ErrorCode::unsupported, "line " + std::to_string(item.line) +
                                               ": its motion is not known"};
    }
    if (!item.is_motion()) continue;
    ProgramMove move;
    move.kind = item.kind;
    move.plane = modes.plane.value_or(ProgramPlane::xy);
    move.turns = item.turns;
    move.line = item.line;
    move.start = at;
    move.end = program.position(item);
    const auto plane = plane_axes(move.plane);
    for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
      move.end[axis] += modes.offset[axis];
    }
    move.centre = {item.centre[0] + modes.offset[plane[0]],
                   item.centre[1] + modes.offset[plane[1]]};
    move.feed = item.feed;
    move.spindle = item.spindle;
    at = move.end;
    moves.push_back(move);
  }
  return moves;
}

}  // namespace unstep
