#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "formats/gcode_number.h"
#include "program/arc_geometry.h"
#include "program/units.h"
#include "unstep/program.h"

/// Items to lines of G-code. docs/cnc.md, "What is written".
namespace unstep {
namespace {

using Kind = ProgramItem::Kind;
using ArcForm = GcodeWriteOptions::ArcForm;

constexpr double kPerUnit = static_cast<double>(kProgramUnitsPerMm);

/// A text that no control acts upon.
bool is_remark(std::string_view text) {
  if (text.empty()) return true;
  if (text[0] == ';') return true;
  if (text[0] != '(' || text.find(')') != text.size() - 1) return false;
  // "(MSG, ...)", "(PRINT, ...)", "(LOG, ...)" are acted upon.
  return text.find(',') == std::string_view::npos;
}

std::string_view word_of(Kind kind) {
  switch (kind) {
    case Kind::rapid: return "G0";
    case Kind::line: return "G1";
    case Kind::clockwise: return "G2";
    case Kind::counter: return "G3";
    default: return "G80";
  }
}

class Writer {
 public:
  Writer(const Program& program, const GcodeWriteOptions& options)
      : program_(program), options_(options) {
    const ProgramItem& start = program.start;
    inches_ = program.modes[start.modes].inches;
    accept(start);
  }

  Result<std::string> write() {
    const ProgramItem* before = &program_.start;
    // The mark of the begin stays the first line.
    has_mark_ = !program_.items.empty() &&
                program_.text_of(program_.items[0]).starts_with('%');
    if (!has_mark_) add_lines(options_.header);
    for (const ProgramItem& item : program_.items) {
      const bool ends = item.ends_program && !ended_;
      if (ends) add_lines(options_.footer);
      if (ends && !has_mark_ && options_.add_end &&
          program_.text_of(item) == "%") {
        // LinuxCNC refuses a mark at the end alone.
        add_end();
      } else if (item.is_motion() && !item.keep_text) {
        write_motion(item);
      } else {
        write_text(item, *before);
      }
      if (has_mark_ && before == &program_.start) add_lines(options_.header);
      ended_ = ended_ || ends;
      before = &item;
    }
    if (!ended_) {
      add_lines(options_.footer);
      add_end();
    }
    return std::move(out_);
  }

 private:
  void add_lines(std::string_view lines) {
    if (lines.empty()) return;
    out_ += lines;
    if (out_.back() != '\n') out_ += '\n';
  }

  void add_end() {
    if (options_.add_end && options_.profile != GcodeProfile::marlin) {
      add_lines("M2");
    }
  }

  /// What the item says is in force.
  void accept(const ProgramItem& item) {
    const ProgramModes& modes = program_.modes[item.modes];
    feed_ = item.feed;
    spindle_ = item.spindle;
    known_ = item.known;
    at_ = program_.position(item);
    use_unit(modes.inches);
  }

  void use_unit(std::optional<bool> inches) {
    inches_ = inches;
    for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
      number_[axis] = to_number(axis, at_[axis]);
    }
  }

  void write_text(const ProgramItem& item, const ProgramItem& before) {
    const std::string_view text = program_.text_of(item);
    if (!is_remark(text)) reconcile(item, before);
    if (options_.profile == GcodeProfile::marlin && text.size() >= 2 &&
        text[0] == '(' && text.find(')') == text.size() - 1) {
      out_ += ';';
      out_ += text.substr(1, text.size() - 2);
    } else {
      out_ += text;
    }
    out_ += '\n';
    if (is_remark(text)) return;
    if (item.names_mode || item.keep_text || item.unknown_effect ||
        item.mode != before.mode) {
      mode_ = item.mode;
    }
    accept(item);
  }

  /// Brings the machine into the state that the source had at this place.
  void reconcile(const ProgramItem& item, const ProgramItem& before) {
    const ProgramModes& modes = program_.modes[before.modes];
    begin_line();
    if (modes.inches && inches_ != modes.inches) {
      word(*modes.inches ? "G20" : "G21");
      use_unit(modes.inches);
    }
    const bool moves = item.keep_text || item.unknown_effect;
    if (moves && before.mode && mode_ != before.mode) {
      word(word_of(*before.mode));
      mode_ = before.mode;
    }
    write_feed(before);
    write_spindle(before);
    end_line();
  }

  void write_feed(const ProgramItem& item) {
    if (item.feed <= 0 || item.feed == feed_) return;
    const double scale = inches_ == true ? 25.4 : 1;
    word("F");
    append_number(out_,
                  round_number(std::llround(item.feed / scale * kPerUnit), 4));
    feed_ = item.feed;
  }

  void write_spindle(const ProgramItem& item) {
    if (item.spindle < 0 || item.spindle == spindle_) return;
    word("S");
    append_number(out_, std::llround(item.spindle * kPerUnit));
    spindle_ = item.spindle;
  }

  void write_motion(const ProgramItem& item) {
    const ProgramModes& modes = program_.modes[item.modes];
    begin_line();
    const std::optional<bool> inches =
        options_.inches ? options_.inches : modes.inches;
    if (inches && inches_ != inches) {
      word(*inches ? "G20" : "G21");
      use_unit(inches);
    }
    if (mode_ != item.kind || options_.profile == GcodeProfile::marlin) {
      word(word_of(item.kind));
      mode_ = item.kind;
    }
    const ProgramPosition start = at_;
    write_axes(item, modes);
    if (item.is_arc()) write_arc(item, modes, start);
    write_feed(item);
    write_spindle(item);
    known_ = item.known;
    end_line();
  }

  void write_axes(const ProgramItem& item, const ProgramModes& modes) {
    const ProgramPosition end = program_.position(item);
    bool wrote = false;
    for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
      const bool incremental = axis == kAxisE
                                   ? modes.incremental_e.value_or(false)
                                   : modes.incremental.value_or(false);
      const std::uint16_t bit = static_cast<std::uint16_t>(1U << axis);
      const std::int64_t number = to_number(axis, end[axis]);
      const bool is_there =
          number_[axis] == number && ((known_ ^ item.known) & bit) == 0;
      if (is_there) continue;
      word(kProgramAxisLetters.substr(axis, 1));
      append_number(out_, incremental ? number - number_[axis] : number);
      number_[axis] = number;
      wrote = true;
    }
    at_ = end;
    if (!wrote && !item.is_arc()) write_rest(item, modes);
  }

  /// A motion that goes nowhere needs a word all the same.
  void write_rest(const ProgramItem& item, const ProgramModes& modes) {
    std::size_t axis = 0;
    while (axis + 1 < kProgramAxes && (item.words >> axis & 1) == 0) ++axis;
    const bool incremental = axis == kAxisE
                                 ? modes.incremental_e.value_or(false)
                                 : modes.incremental.value_or(false);
    word(kProgramAxisLetters.substr(axis, 1));
    append_number(out_, incremental ? 0 : number_[axis]);
  }

  void write_arc(const ProgramItem& item, const ProgramModes& modes,
                 const ProgramPosition& start) {
    const auto plane = plane_axes(modes.plane.value_or(ProgramPlane::xy));
    const bool radius =
        options_.arcs == ArcForm::radius ||
        (options_.arcs == ArcForm::as_read && item.radius != 0 && !rounds());
    if (radius) {
      word("R");
      append_number(out_, exact_number(radius_of(item, start, plane)));
      return;
    }
    constexpr std::string_view kLetters = "IJK";
    for (std::size_t i = 0; i < 2; ++i) {
      const bool absolute = modes.absolute_centres.value_or(false);
      const std::int64_t length =
          absolute ? item.centre[i] : item.centre[i] - start[plane[i]];
      const std::int64_t number = exact_number(length);
      if (number == 0 && !absolute) continue;
      word(kLetters.substr(plane[i], 1));
      append_number(out_, number);
    }
  }

  /// R would make much of the rounding of its ends.
  [[nodiscard]] bool rounds() const {
    return options_.decimals >= 0 || options_.inches.has_value();
  }

  /// As given, or of the circle in the middle between start and end; below 0
  /// for more than a half turn.
  [[nodiscard]] static std::int64_t radius_of(
      const ProgramItem& item, const ProgramPosition& start,
      const std::array<std::size_t, 3>& plane) {
    if (item.radius != 0) return item.radius;
    const PlanePoint from{start[plane[0]], start[plane[1]]};
    const PlanePoint to{item.end[plane[0]], item.end[plane[1]]};
    const std::int64_t radius = std::llround(
        (distance(from, item.centre) + distance(to, item.centre)) / 2);
    const bool counter = item.kind == Kind::counter;
    const bool large =
        arc_sweep(from, to, item.centre, counter) > std::numbers::pi;
    return large ? -radius : radius;
  }

  /// Program units to the unit in force, 1e-7 of it, with all decimals.
  [[nodiscard]] std::int64_t exact_number(std::int64_t length) const {
    if (inches_ != true) return length;
    // |length| is at most twice 1e15, so ten of it fit.
    const std::int64_t ten = length * 10;
    return (ten + (ten < 0 ? -127 : 127)) / 254;
  }

  /// The same for a position: rounded if the options say so.
  [[nodiscard]] std::int64_t to_number(std::size_t axis,
                                       std::int64_t length) const {
    const bool angle = (kAngles >> axis & 1) != 0;
    if (angle) return length;
    const bool inches = inches_ == true;
    const std::int64_t number = exact_number(length);
    int decimals = options_.decimals;
    if (decimals < 0 && options_.inches) decimals = inches ? 5 : 4;
    return decimals < 0 ? number : round_number(number, decimals);
  }

  void begin_line() { line_begin_ = out_.size(); }
  void end_line() {
    if (out_.size() > line_begin_) out_ += '\n';
  }
  void word(std::string_view letters) {
    if (options_.blanks && out_.size() > line_begin_) out_ += ' ';
    out_ += letters;
  }

  const Program& program_;
  const GcodeWriteOptions& options_;
  std::string out_;
  std::size_t line_begin_ = 0;
  // What is in force where the text ends.
  bool has_mark_ = false;  ///< "%" at the begin
  bool ended_ = false;
  std::optional<bool> inches_;
  std::optional<Kind> mode_;
  double feed_ = 0;
  double spindle_ = -1;
  std::uint16_t known_ = 0;
  ProgramPosition at_{};
  std::array<std::int64_t, kProgramAxes> number_{};  ///< of at_, as written
};

}  // namespace

Result<std::string> write_gcode(const Program& program,
                                const GcodeWriteOptions& options) {
  if (options.arcs != ArcForm::radius) return Writer(program, options).write();
  ArcRules rules;
  rules.by_radius = true;
  const Result<Program> split = split_arcs(program, rules);
  if (!split) return split.error();
  return Writer(*split, options).write();
}

}  // namespace unstep
