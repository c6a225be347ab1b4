#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "formats/gcode_reader_arc.h"
#include "formats/gcode_reader_class.h"
#include "program/units.h"

/// Lines that move.
namespace unstep {
namespace {

constexpr std::uint16_t axis_bit(std::size_t axis) {
  return static_cast<std::uint16_t>(1U << axis);
}

}  // namespace

std::uint16_t GcodeReader::axes_of(std::uint32_t letters) const {
  std::uint16_t axes = 0;
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    if ((letters & letter_bit(kProgramAxisLetters[axis])) != 0) {
      axes = static_cast<std::uint16_t>(axes | axis_bit(axis));
    }
  }
  return axes;
}

/// REQUIRES: the number is at most kMaxProgramLength, so that 254 of it fit.
std::int64_t GcodeReader::length_of(std::size_t axis,
                                    std::int64_t number) const {
  const bool angle = (kAngles >> axis & 1) != 0;
  if (angle || state_.modes.inches != true) return number;
  const std::int64_t scaled = number * 254;
  return (scaled + (scaled < 0 ? -5 : 5)) / 10;
}

/// Where the motion ends, and which axes are known there.
bool GcodeReader::find_end(bool machine, ProgramPosition& end,
                           std::uint16_t& known) {
  const ProgramModes& modes = state_.modes;
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    const char letter = kProgramAxisLetters[axis];
    if (!block_.has(letter)) continue;
    const std::int64_t number = block_.at(letter);
    if (std::abs(number) > kMaxProgramLength) {
      return fail(ErrorCode::out_of_range,
                  std::string(1, letter) + " beyond 100 km");
    }
    const std::int64_t length = length_of(axis, number);
    const bool incremental =
        axis == kAxisE ? *modes.incremental_e : *modes.incremental;
    if (machine) {
      end[axis] = length - modes.offset[axis];
      known = static_cast<std::uint16_t>((known & ~axis_bit(axis)) |
                                         (modes.offset_known & axis_bit(axis)));
    } else if (incremental) {
      end[axis] += length;
    } else {
      end[axis] = length;
      known = static_cast<std::uint16_t>(known | axis_bit(axis));
    }
    if (std::abs(end[axis]) > kMaxProgramLength) {
      return fail(ErrorCode::out_of_range,
                  std::string(1, letter) + " leads beyond 100 km");
    }
  }
  return true;
}

bool GcodeReader::run_motion(const LineCodes& codes, bool plain) {
  const ProgramModes& modes = state_.modes;
  const std::uint16_t axes = axes_of(block_.values);
  if (!state_.mode || *state_.mode == Kind::text) {
    state_.forget_position(kAllProgramAxes);
    return not_understood("axis words in a motion mode that is not known") &&
           add_text(true);
  }
  const Kind kind = *state_.mode;
  const bool arc = kind == Kind::clockwise || kind == Kind::counter;
  const std::uint32_t arc_words = block_.values & kArcLetters;
  const std::uint32_t others =
      block_.values & ~(kMotionLetters | letter_bit('T') | letter_bit('P'));
  const bool spiral_turns = block_.has('P') && arc;
  const bool modes_known =
      modes.inches && (axes == 0 || modes.incremental) &&
      ((axes & axis_bit(kAxisE)) == 0 || modes.incremental_e) &&
      (!arc || (modes.plane && modes.absolute_centres));
  if (!modes_known || (!arc && arc_words != 0) || (!arc && block_.has('P')) ||
      (others != 0 && block_.m_count == 0)) {
    state_.forget_position(axes == 0 ? kAllProgramAxes : axes);
    return not_understood("a motion with words or modes that are not known") &&
           add_text(true);
  }
  ProgramItem motion = item(kind);
  ProgramPosition end = state_.position;
  std::uint16_t known = state_.known;
  if (!find_end(codes.machine, end, known)) return false;
  motion.words = axes;
  bool assumed = false;
  if (arc) {
    const auto plane = plane_axes(*modes.plane);
    const auto both =
        static_cast<std::uint16_t>(axis_bit(plane[0]) | axis_bit(plane[1]));
    if ((known & both) != (state_.known & both)) {
      // Its start is not known in the coordinates of its end. Where it can
      // be an arc, it is taken for the one it seems to be.
      assumed = true;
      if (!find_arc(motion, end)) {
        error_ = {};
        state_.position = end;
        state_.known = known;
        return not_understood("an arc from a position that is not known") &&
               add_text(true);
      }
    }
    if (!assumed && !find_arc(motion, end)) return false;
  }
  state_.position = end;
  state_.known = known;
  if (spiral_turns) state_.forget_position(kAllProgramAxes);
  ProgramItem made = item(kind);
  made.words = axes;
  made.turns = motion.turns;
  made.centre = motion.centre;
  made.radius = motion.radius;
  made.keep_text = !plain || spiral_turns || assumed;
  if (made.keep_text) {
    made.ends_program = ended_;
    give_text(made);
  } else {
    program_.decimals = std::max(program_.decimals, block_.decimals);
    if (!block_.comments.empty() && !add_comments()) return false;
  }
  return add(made);
}

bool GcodeReader::find_arc(ProgramItem& motion, const ProgramPosition& end) {
  const ProgramModes& modes = state_.modes;
  const auto plane = plane_axes(*modes.plane);
  GcodeArc arc;
  arc.start = {state_.position[plane[0]], state_.position[plane[1]]};
  arc.end = {end[plane[0]], end[plane[1]]};
  arc.counter = *state_.mode == Kind::counter;
  constexpr std::string_view kCentreLetters = "IJK";
  for (const char letter : std::string_view("IJKRP")) {
    if (block_.has(letter) && std::abs(block_.at(letter)) > kMaxProgramLength) {
      return fail(ErrorCode::out_of_range,
                  std::string(1, letter) + " beyond 100 km");
    }
  }
  if (block_.has(kCentreLetters[plane[2]])) {
    return fail(ErrorCode::corrupt, std::string("arc: ") +
                                        kCentreLetters[plane[2]] +
                                        " is not of its plane");
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const char letter = kCentreLetters[plane[i]];
    const bool given = block_.has(letter);
    const std::int64_t length =
        given ? length_of(plane[i], block_.at(letter)) : 0;
    arc.has_centre = arc.has_centre || given;
    if (*modes.absolute_centres && given) {
      arc.centre[i] = length;
    } else {
      arc.centre[i] = arc.start[i] + length;
    }
  }
  if (*modes.absolute_centres && arc.has_centre &&
      !(block_.has(kCentreLetters[plane[0]]) &&
        block_.has(kCentreLetters[plane[1]])) &&
      !block_.has('R')) {
    return fail(ErrorCode::corrupt, "arc: half of its centre is missing");
  }
  if (block_.has('R')) arc.radius = length_of(0, block_.at('R'));
  const std::string reason = solve_arc(arc, options_.arc_tolerance_mm,
                                       options_.arc_tolerance_relative);
  if (!reason.empty()) return fail(ErrorCode::corrupt, "arc: " + reason);
  motion.centre = arc.centre;
  motion.radius = arc.radius;
  motion.turns = 1;
  if (block_.has('P')) {
    const std::int64_t turns = block_.at('P') / kGcodeNumberScale;
    if (turns < 1 || turns > 1'000'000 ||
        block_.at('P') % kGcodeNumberScale != 0) {
      return fail(ErrorCode::corrupt, "arc: P is no number of turns");
    }
    motion.turns = static_cast<std::uint32_t>(turns);
  }
  return true;
}

/// Offsets add up over lines; positions do not leave the range by them.
bool GcodeReader::in_range() {
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    if (std::abs(state_.position[axis]) > kMaxProgramLength ||
        std::abs(state_.modes.offset[axis]) > kMaxProgramLength ||
        std::abs(state_.shift[axis]) > kMaxProgramLength) {
      return fail(ErrorCode::out_of_range, "offsets lead beyond 100 km");
    }
  }
  return true;
}

}  // namespace unstep
