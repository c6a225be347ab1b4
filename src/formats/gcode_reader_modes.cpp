#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

#include "formats/gcode_reader_class.h"

/// Words that change modes, and those that act once.
namespace unstep {

bool GcodeReader::sort_codes(LineCodes& codes) {
  std::uint32_t seen = 0;
  for (std::size_t i = 0; i < block_.g_count; ++i) {
    if (!sort_g(block_.g[i], seen, codes)) return false;
  }
  for (std::size_t i = 0; i < block_.m_count; ++i) {
    const int code = block_.m[i];
    switch (mcode_effect(code)) {
      case McodeEffect::none: break;
      case McodeEffect::position_lost: codes.position_lost = true; break;
      case McodeEffect::end: codes.end = true; break;
      case McodeEffect::absolute_e:
      case McodeEffect::incremental_e: codes.settings = true; break;
      case McodeEffect::unknown:
        codes.unknown = true;
        codes.unknown_word = "M" + std::to_string(code / 10);
        if (code % 10 != 0)
          codes.unknown_word += "." + std::to_string(code % 10);
        break;
    }
  }
  return true;
}

bool GcodeReader::sort_g(int code, std::uint32_t& seen, LineCodes& codes) {
  const GcodeGroup group = gcode_group(code);
  const auto name = [code] {
    std::string text = "G" + std::to_string(code / 10);
    if (code % 10 != 0) text += "." + std::to_string(code % 10);
    return text;
  };
  if (group == GcodeGroup::unknown) {
    codes.unknown = true;
    codes.unknown_word = name();
    return true;
  }
  const std::uint32_t bit = 1U << static_cast<unsigned>(group);
  if ((seen & bit) != 0) {
    return fail(ErrorCode::corrupt,
                name() + " and another word of its group on one line");
  }
  seen |= bit;
  switch (group) {
    case GcodeGroup::once: codes.once = code; break;
    case GcodeGroup::motion: codes.motion = code; break;
    case GcodeGroup::machine: codes.machine = true; break;
    default: codes.settings = codes.settings || !is_redundant(code); break;
  }
  return true;
}

/// Words without a number belong to commands that take them so.
bool GcodeReader::check_flags(const LineCodes& codes) {
  if (block_.flags == 0) return true;
  const bool taken =
      codes.once == 280 || codes.once == 300 || block_.m_count > 0;
  if (taken && codes.motion < 0) return true;
  char letter = 'A';
  while ((block_.flags & letter_bit(letter)) == 0) ++letter;
  return fail(ErrorCode::corrupt,
              std::string("expected a number after ") + letter);
}

/// A modal word that says what is in force.
bool GcodeReader::is_redundant(int code) const {
  const ProgramModes& modes = state_.modes;
  switch (code) {
    case 170: return modes.plane == ProgramPlane::xy;
    case 180: return modes.plane == ProgramPlane::zx;
    case 190: return modes.plane == ProgramPlane::yz;
    case 200: return modes.inches == true;
    case 210: return modes.inches == false;
    case 900: return modes.incremental == false && modes.incremental_e == false;
    case 910: return modes.incremental == true && modes.incremental_e == true;
    case 901: return modes.absolute_centres == true;
    case 911: return modes.absolute_centres == false;
    case 940: return modes.per_minute == true;
    case 400: return modes.compensated == false;
    default: return false;
  }
}

/// A motion and nothing else that would have to stay on its line.
bool GcodeReader::is_plain(const LineCodes& codes) const {
  const ProgramModes& modes = state_.modes;
  return block_.m_count == 0 && (block_.values & ~kMotionLetters) == 0 &&
         !block_.assigns && !codes.settings && !codes.machine &&
         codes.once < 0 && modes.per_minute == true &&
         modes.compensated == false &&
         (!block_.has('F') || block_.at('F') > 0) &&
         (!block_.has('S') || block_.at('S') >= 0);
}

void GcodeReader::apply_g(int code) {
  ProgramModes& modes = state_.modes;
  switch (code) {
    case 170: modes.plane = ProgramPlane::xy; break;
    case 180: modes.plane = ProgramPlane::zx; break;
    case 190: modes.plane = ProgramPlane::yz; break;
    case 200:
    case 210:
      // Controls differ in whether a feed in force is converted.
      if (modes.inches != (code == 200)) state_.feed = 0;
      modes.inches = code == 200;
      break;
    case 900:
    case 910: modes.incremental = modes.incremental_e = code == 910; break;
    case 901: modes.absolute_centres = true; break;
    case 911: modes.absolute_centres = false; break;
    case 930:
    case 940:
    case 950:
      if (modes.per_minute != (code == 940)) state_.feed = 0;
      modes.per_minute = code == 940;
      break;
    case 400: modes.compensated = false; break;
    case 410:
    case 411:
    case 420:
    case 421: modes.compensated = true; break;
    case 430:
    case 431:
    case 432:
    case 490: {
      // Lengths of tools live in the control.
      modes.offset_known = 0;
      state_.shift_known = 0;
      break;
    }
    case 540:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590: state_.select_system((code - 540) / 10); break;
    case 591:
    case 592:
    case 593: state_.select_system(5 + code - 590); break;
    default: break;
  }
}

/// In the order in which controls do it: feed, spindle, tool, then modes.
bool GcodeReader::apply_settings(const LineCodes& codes) {
  const std::optional<bool> inches_before = state_.modes.inches;
  for (std::size_t i = 0; i < block_.g_count; ++i) apply_g(block_.g[i]);
  for (std::size_t i = 0; i < block_.m_count; ++i) {
    const McodeEffect effect = mcode_effect(block_.m[i]);
    if (effect == McodeEffect::absolute_e) state_.modes.incremental_e = false;
    if (effect == McodeEffect::incremental_e) state_.modes.incremental_e = true;
  }
  // S and F of a command that is no motion may be its own (M106 S255).
  const bool own = block_.m_count > 0 && !block_.has('F');
  if (block_.has('F')) {
    const double number =
        static_cast<double>(block_.at('F')) / double{kGcodeNumberScale};
    const bool sure = state_.modes.inches.has_value() &&
                      state_.modes.per_minute == true && number > 0 &&
                      inches_before == state_.modes.inches;
    state_.feed = !sure ? 0 : *state_.modes.inches ? number * 25.4 : number;
  }
  if (block_.has('S')) {
    bool spindle = !own;
    for (std::size_t i = 0; i < block_.m_count; ++i) {
      const int code = block_.m[i];
      if (code == 30 || code == 40 || code == 50) spindle = true;
    }
    if (spindle) {
      state_.spindle =
          static_cast<double>(block_.at('S')) / double{kGcodeNumberScale};
    }
  }
  if (codes.position_lost || block_.has('T')) {
    state_.forget_position(kAllProgramAxes);
  }
  return true;
}

bool GcodeReader::set_motion_mode(int code) {
  switch (code) {
    case 0: state_.mode = Kind::rapid; break;
    case 10: state_.mode = Kind::line; break;
    case 20: state_.mode = Kind::clockwise; break;
    case 30: state_.mode = Kind::counter; break;
    case 800: state_.mode = Kind::text; break;
    default: state_.mode.reset(); break;
  }
  return true;
}

bool GcodeReader::apply_once(int code, bool& unknown_effect) {
  const std::uint16_t axes = axes_of(block_.values | block_.flags);
  const bool lengths_known = state_.modes.inches.has_value();
  ProgramPosition to{};
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    if ((axes >> axis & 1) == 0) continue;
    const std::int64_t number = block_.at(kProgramAxisLetters[axis]);
    if (std::abs(number) > kMaxProgramLength) {
      return fail(ErrorCode::out_of_range, "a position beyond 100 km");
    }
    to[axis] = length_of(axis, number);
  }
  switch (code) {
    case 40:
      // "G4 X1" is a time on some controls and a motion on others.
      unknown_effect = axes != 0;
      state_.forget_position(axes);
      break;
    case 100: return apply_g10(unknown_effect);
    case 280:
    case 300:
      unknown_effect = true;
      state_.forget_position(axes == 0 ? kAllProgramAxes : axes);
      break;
    case 281:
    case 301: break;
    case 920:
      if (!lengths_known) {
        unknown_effect = true;
        state_.forget_position(axes);
      } else {
        state_.set_position(axes, to);
      }
      break;
    case 921:
    case 922: state_.clear_shift(); break;
    default:
      unknown_effect = true;
      state_.shift_known = state_.modes.offset_known = 0;
      state_.forget_position(kAllProgramAxes);
      break;
  }
  return !unknown_effect ||
         not_understood("G" + std::to_string(code / 10) +
                        " leads to a position that is not known");
}

bool GcodeReader::apply_g10(bool& unknown_effect) {
  constexpr std::int64_t kOne = kGcodeNumberScale;
  const std::int64_t kind = block_.has('L') ? block_.at('L') / kOne : 0;
  const std::int64_t system = block_.has('P') ? block_.at('P') / kOne : -1;
  const std::uint16_t axes = axes_of(block_.values);
  const bool tool = kind == 1 || kind == 10 || kind == 11;
  const bool plain = kind == 2 && system >= 0 && system <= kCoordinateSystems &&
                     !block_.has('R') && state_.modes.inches.has_value() &&
                     (system > 0 || state_.system >= 0);
  if (plain) {
    ProgramPosition to{};
    for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
      if ((axes >> axis & 1) == 0) continue;
      to[axis] = length_of(axis, block_.at(kProgramAxisLetters[axis]));
    }
    const int index =
        system == 0 ? state_.system : static_cast<int>(system) - 1;
    state_.set_system(index, axes, to);
    return true;
  }
  if (tool) return true;
  unknown_effect = true;
  state_.systems_known = {};
  state_.modes.offset_known = 0;
  state_.forget_position(kAllProgramAxes);
  return not_understood("this G10");
}

}  // namespace unstep
