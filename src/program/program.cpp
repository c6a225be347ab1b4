#include "unstep/program.h"

#include <algorithm>

#include "program/moves.h"

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
  const Status done =
      visit_moves(program, skip_unknown, [&moves](const ProgramMove& move) {
        moves.push_back(move);
        return Status();
      });
  if (!done) return done.error();
  return moves;
}

}  // namespace unstep
