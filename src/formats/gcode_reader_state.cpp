#include "formats/gcode_reader_state.h"

namespace unstep {

void GcodeState::forget() {
  const ProgramPosition offset = modes.offset;
  modes = {};
  modes.offset = offset;
  mode.reset();
  known = 0;
  feed = 0;
  spindle = -1;
  system = -1;
  systems_known = {};
  shift_known = 0;
}

void GcodeState::update_offset() {
  const std::uint16_t before = modes.offset_known;
  const std::uint16_t after =
      system < 0
          ? std::uint16_t{0}
          : static_cast<std::uint16_t>(
                systems_known[static_cast<std::size_t>(system)] & shift_known);
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    const std::int64_t selected =
        system < 0 ? 0 : systems[static_cast<std::size_t>(system)][axis];
    const std::int64_t offset = selected + shift[axis];
    position[axis] += modes.offset[axis] - offset;
    modes.offset[axis] = offset;
  }
  // The program position follows from the machine's only where both offsets
  // are known.
  forget_position(static_cast<std::uint16_t>(~(before & after)));
  modes.offset_known = after;
}

void GcodeState::select_system(int index) {
  if (system == index) return;
  system = index;
  update_offset();
}

void GcodeState::set_system(int index, std::uint16_t axes,
                            const ProgramPosition& to) {
  const auto i = static_cast<std::size_t>(index);
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    if ((axes >> axis & 1) != 0) systems[i][axis] = to[axis];
  }
  systems_known[i] = static_cast<std::uint16_t>(systems_known[i] | axes);
  if (system == index) {
    const std::uint16_t kept = known;
    update_offset();
    known = static_cast<std::uint16_t>(known | (kept & ~axes));
  } else if (system < 0) {
    forget_position(axes);
  }
}

void GcodeState::set_position(std::uint16_t axes, const ProgramPosition& to) {
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    if ((axes >> axis & 1) == 0) continue;
    const std::int64_t moved = position[axis] - to[axis];
    shift[axis] += moved;
    modes.offset[axis] += moved;
    position[axis] = to[axis];
    // The offset is as well known as the position was.
    if ((known >> axis & 1) == 0) {
      const auto bit = static_cast<std::uint16_t>(1U << axis);
      shift_known = static_cast<std::uint16_t>(shift_known & ~bit);
      modes.offset_known =
          static_cast<std::uint16_t>(modes.offset_known & ~bit);
    }
  }
  known = static_cast<std::uint16_t>(known | axes);
}

void GcodeState::clear_shift() {
  shift = {};
  shift_known = kAllProgramAxes;
  update_offset();
}

}  // namespace unstep
