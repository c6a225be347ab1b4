#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <new>
#include <string>
#include <utility>

#include "formats/gcode_reader_arc.h"
#include "formats/gcode_reader_block.h"
#include "formats/gcode_reader_codes.h"
#include "formats/gcode_reader_state.h"
#include "unstep/program.h"

/// Lines of G-code to items. docs/cnc.md says what each word does.
namespace unstep {
namespace {

using Kind = ProgramItem::Kind;

constexpr std::uint32_t kAxisLetters = [] {
  std::uint32_t bits = 0;
  for (const char letter : kProgramAxisLetters) bits |= letter_bit(letter);
  return bits;
}();
constexpr std::uint32_t kArcLetters =
    letter_bit('I') | letter_bit('J') | letter_bit('K') | letter_bit('R');
constexpr std::uint32_t kMotionLetters = kAxisLetters | kArcLetters |
                                         letter_bit('N') | letter_bit('F') |
                                         letter_bit('S');

constexpr std::uint16_t axis_bit(std::size_t axis) {
  return static_cast<std::uint16_t>(1U << axis);
}
constexpr std::size_t kAxisE = 9;
constexpr std::uint16_t kAngles = 7U << 3;

/// What the codes of a line ask for.
struct LineCodes {
  int motion = -1;
  int once = -1;
  bool machine = false;   ///< G53
  bool settings = false;  ///< words that change a mode
  bool unknown = false;
  bool position_lost = false;
  bool end = false;
  std::string unknown_word;
};

class Reader {
 public:
  Reader(std::string_view text, const GcodeReadOptions& options)
      : options_(options) {
    program_.text = text;
    ProgramModes& modes = state_.modes;
    modes.inches = options.inches;
    modes.incremental = modes.absolute_centres = modes.incremental_e = false;
    modes.plane = ProgramPlane::xy;
    modes.per_minute = true;
    modes.compensated = false;
    program_.modes[0] = modes;
    program_.start = item(Kind::text);
  }

  Result<Program> read();

 private:
  [[nodiscard]] Error error(ErrorCode code, const std::string& reason) const {
    return {code, "line " + std::to_string(line_) + ": " + reason};
  }
  bool fail(ErrorCode code, const std::string& reason) {
    error_ = error(code, reason);
    return false;
  }

  bool run_line(std::string_view line);
  bool run_words();
  bool sort_codes(LineCodes& codes);
  bool sort_g(int code, std::uint32_t& seen, LineCodes& codes);
  bool check_flags(const LineCodes& codes);
  bool is_plain(const LineCodes& codes) const;
  bool is_redundant(int code) const;
  bool apply_settings(const LineCodes& codes);
  void apply_g(int code);
  bool apply_once(int code, bool& unknown_effect);
  bool apply_g10(bool& unknown_effect);
  bool run_motion(const LineCodes& codes, bool plain);
  bool find_end(bool machine, ProgramPosition& end, std::uint16_t& known);
  bool find_arc(ProgramItem& motion, const ProgramPosition& end);
  bool set_motion_mode(int code);
  bool in_range();

  [[nodiscard]] std::uint16_t axes_of(std::uint32_t letters) const;
  [[nodiscard]] std::int64_t length_of(std::size_t axis,
                                       std::int64_t number) const;
  ProgramItem item(Kind kind);
  bool add(ProgramItem made);
  void give_text(ProgramItem& made) const;
  bool add_text(bool unknown_effect = false);
  bool add_comments();
  bool add_unknown(const std::string& what);
  bool not_understood(const std::string& what);
  bool within_memory();

  GcodeReadOptions options_;
  Program program_;
  GcodeState state_;
  GcodeLineReader lines_;
  GcodeBlock block_;
  std::uint32_t line_ = 0;
  std::size_t begin_ = 0;    ///< of the line in the text
  bool started_ = false;     ///< a line with anything on it was met
  bool ended_ = false;       ///< M2, M30 or the second %
  bool flow_ = false;        ///< control flow: the rest is kept
  bool names_mode_ = false;  ///< the line has a motion word
  Error error_;
  struct Note {
    std::string reason;
    std::uint32_t line = 0;
    std::uint64_t count = 0;
  };
  std::vector<Note> notes_;
};

Result<Program> Reader::read() {
  if (program_.text.size() > options_.limits.max_bytes) {
    return Error{ErrorCode::limit_exceeded,
                 "more than the limit of " +
                     std::to_string(options_.limits.max_bytes) + " bytes"};
  }
  const std::string_view text = program_.text;
  std::size_t at = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  while (at < text.size()) {
    const std::size_t newline = std::min(text.find('\n', at), text.size());
    std::size_t end = newline;
    ++line_;
    if (end - at > options_.limits.max_line_bytes) {
      return error(ErrorCode::limit_exceeded,
                   "longer than the limit of " +
                       std::to_string(options_.limits.max_line_bytes) +
                       " bytes");
    }
    while (end > at && (text[end - 1] == '\r' || text[end - 1] == ' ' ||
                        text[end - 1] == '\t')) {
      --end;
    }
    begin_ = at;
    if (!run_line(text.substr(at, end - at))) return error_;
    at = newline + 1;
  }
  for (const Note& note : notes_) {
    std::string message = "line " + std::to_string(note.line);
    if (note.count > 1) {
      message += " and " + std::to_string(note.count - 1) + " more";
    }
    program_.notes.push_back(message + ": " + note.reason +
                             ": kept as it stands");
  }
  return std::move(program_);
}

bool Reader::run_line(std::string_view line) {
  if (ended_ || flow_) {
    block_.comments.clear();
    block_.body_begin = 0;
    block_.body_end = static_cast<std::uint32_t>(line.size());
    return line.empty() || add_text(flow_ && !ended_);
  }
  names_mode_ = false;
  const Status read = lines_.read(line, block_);
  if (!read) return fail(read.error().code, read.error().message);
  using BlockDelete = GcodeReadOptions::BlockDelete;
  const bool optional_line =
      block_.deleted && options_.block_delete == BlockDelete::keep;
  const bool skipped =
      block_.deleted && options_.block_delete == BlockDelete::skip;
  if (!skipped) lines_.set_parameters(!optional_line);
  if (skipped) return true;
  const bool first = !started_;
  started_ = started_ || block_.kind != GcodeBlock::Kind::blank;
  if (optional_line) return add_unknown("\"/\" may leave the line out");
  switch (block_.kind) {
    case GcodeBlock::Kind::blank:
      if (block_.comments.empty() &&
          (program_.items.empty() || program_.items.back().is_motion())) {
        return true;
      }
      return add_text();
    case GcodeBlock::Kind::percent: ended_ = !first; return add_text();
    case GcodeBlock::Kind::command:
      return add_unknown("a command that is no G-code");
    case GcodeBlock::Kind::o_number: return add_text();
    case GcodeBlock::Kind::o_flow:
      flow_ = true;
      return add_unknown("control flow, and all that follows it");
    case GcodeBlock::Kind::words: return run_words();
  }
  return true;
}

bool Reader::run_words() {
  LineCodes codes;
  if (!sort_codes(codes)) return false;
  if (block_.unknown_value) {
    return add_unknown("a parameter that the program does not set");
  }
  if (block_.assigns_offset) {
    return add_unknown("parameters of the control are set");
  }
  if (codes.unknown) return add_unknown(codes.unknown_word);
  if (!check_flags(codes)) return false;
  const bool plain = is_plain(codes);
  if (!apply_settings(codes)) return false;
  if (codes.motion >= 0 && !set_motion_mode(codes.motion)) return false;
  const std::uint32_t moving = kAxisLetters | kArcLetters;
  names_mode_ = codes.motion >= 0;
  ended_ = codes.end;
  bool done = false;
  if (codes.once >= 0) {
    bool unknown_effect = false;
    if (!apply_once(codes.once, unknown_effect)) return false;
    done = add_text(unknown_effect);
  } else if ((block_.values & moving) != 0) {
    done = run_motion(codes, plain);
  } else {
    done = add_text();
  }
  return done && in_range();
}

bool Reader::sort_codes(LineCodes& codes) {
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

bool Reader::sort_g(int code, std::uint32_t& seen, LineCodes& codes) {
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
bool Reader::check_flags(const LineCodes& codes) {
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
bool Reader::is_redundant(int code) const {
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
bool Reader::is_plain(const LineCodes& codes) const {
  const ProgramModes& modes = state_.modes;
  return block_.m_count == 0 && (block_.values & ~kMotionLetters) == 0 &&
         !block_.assigns && !codes.settings && !codes.machine &&
         codes.once < 0 && modes.per_minute == true &&
         modes.compensated == false &&
         (!block_.has('F') || block_.at('F') > 0) &&
         (!block_.has('S') || block_.at('S') >= 0);
}

void Reader::apply_g(int code) {
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
bool Reader::apply_settings(const LineCodes& codes) {
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

bool Reader::set_motion_mode(int code) {
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

std::uint16_t Reader::axes_of(std::uint32_t letters) const {
  std::uint16_t axes = 0;
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    if ((letters & letter_bit(kProgramAxisLetters[axis])) != 0) {
      axes = static_cast<std::uint16_t>(axes | axis_bit(axis));
    }
  }
  return axes;
}

/// REQUIRES: the number is at most kMaxProgramLength, so that 254 of it fit.
std::int64_t Reader::length_of(std::size_t axis, std::int64_t number) const {
  const bool angle = (kAngles >> axis & 1) != 0;
  if (angle || state_.modes.inches != true) return number;
  const std::int64_t scaled = number * 254;
  return (scaled + (scaled < 0 ? -5 : 5)) / 10;
}

bool Reader::apply_once(int code, bool& unknown_effect) {
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

bool Reader::apply_g10(bool& unknown_effect) {
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

/// Where the motion ends, and which axes are known there.
bool Reader::find_end(bool machine, ProgramPosition& end,
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

bool Reader::run_motion(const LineCodes& codes, bool plain) {
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

bool Reader::find_arc(ProgramItem& motion, const ProgramPosition& end) {
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
bool Reader::in_range() {
  for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
    if (std::abs(state_.position[axis]) > kMaxProgramLength ||
        std::abs(state_.modes.offset[axis]) > kMaxProgramLength ||
        std::abs(state_.shift[axis]) > kMaxProgramLength) {
      return fail(ErrorCode::out_of_range, "offsets lead beyond 100 km");
    }
  }
  return true;
}

/// An item with the state of this moment.
ProgramItem Reader::item(Kind kind) {
  ProgramItem made;
  made.kind = kind;
  made.mode = state_.mode;
  made.known = state_.known;
  made.line = line_;
  made.feed = state_.feed;
  made.spindle = state_.spindle;
  std::copy_n(state_.position.begin(), 3, made.end.begin());
  if (program_.modes.back() != state_.modes) {
    program_.modes.push_back(state_.modes);
  }
  made.modes = static_cast<std::uint32_t>(program_.modes.size() - 1);
  if (!std::equal(program_.others.back().begin(), program_.others.back().end(),
                  state_.position.begin() + 3)) {
    std::copy_n(state_.position.begin() + 3, kProgramAxes - 3,
                program_.others.emplace_back().begin());
  }
  made.others = static_cast<std::uint32_t>(program_.others.size() - 1);
  return made;
}

bool Reader::add(ProgramItem made) {
  if (!within_memory()) return false;
  program_.items.push_back(made);
  return true;
}

/// Vectors may hold twice what they need, and both sizes while they grow.
bool Reader::within_memory() {
  const std::uint64_t memory =
      program_.text.size() +
      3 * (program_.items.size() * sizeof(ProgramItem) +
           program_.modes.size() * sizeof(ProgramModes) +
           program_.others.size() * sizeof(ProgramOtherAxes));
  if (memory <= options_.limits.max_memory) return true;
  return fail(ErrorCode::limit_exceeded,
              "more than the memory limit of " +
                  std::to_string(options_.limits.max_memory) + " bytes");
}

/// A line's number and checksum are of no use among other lines.
void Reader::give_text(ProgramItem& made) const {
  std::size_t begin = begin_;
  std::size_t end = begin_ + block_.body_end;
  if (block_.body_end < program_.text.size() - begin_ &&
      program_.text[end] == '*') {
    begin += block_.body_begin;
  }
  while (begin < end && program_.text[begin] == ' ') ++begin;
  while (begin < end && program_.text[end - 1] == ' ') --end;
  made.text_begin = begin;
  made.text_size = static_cast<std::uint32_t>(end - begin);
}

bool Reader::add_text(bool unknown_effect) {
  ProgramItem made = item(Kind::text);
  made.unknown_effect = unknown_effect;
  made.names_mode = names_mode_;
  made.ends_program = ended_;
  give_text(made);
  return add(made);
}

bool Reader::add_comments() {
  for (const auto& [begin, size] : block_.comments) {
    ProgramItem comment =
        program_.items.empty() ? program_.start : program_.items.back();
    comment.kind = Kind::text;
    comment.keep_text = comment.unknown_effect = false;
    comment.line = line_;
    comment.words = 0;
    comment.names_mode = comment.ends_program = false;
    comment.text_begin = begin_ + begin;
    comment.text_size = size;
    if (!add(comment)) return false;
  }
  return true;
}

/// False if the options refuse it.
bool Reader::not_understood(const std::string& what) {
  if (options_.strict) {
    return fail(ErrorCode::unsupported, what + " is not understood");
  }
  const auto found =
      std::find_if(notes_.begin(), notes_.end(),
                   [&what](const Note& note) { return note.reason == what; });
  if (found != notes_.end()) {
    ++found->count;
  } else if (notes_.size() < 100) {
    notes_.push_back({what, line_, 1});
  }
  return true;
}

bool Reader::add_unknown(const std::string& what) {
  if (!not_understood(what)) return false;
  state_.forget();
  return add_text(true);
}

}  // namespace

Result<Program> read_gcode(std::string_view text,
                           const GcodeReadOptions& options) {
  try {
    return Reader(text, options).read();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the program"};
  }
}

}  // namespace unstep
