#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gcode_flow.h"
#include "formats/gcode_reader_block.h"
#include "formats/gcode_reader_codes.h"
#include "formats/gcode_reader_state.h"
#include "unstep/program.h"

/// Reads a program line by line. One class in four files: lines and items
/// (gcode_reader.cpp, gcode_reader_items.cpp), words that change modes
/// (gcode_reader_modes.cpp), motions (gcode_reader_motion.cpp).
namespace unstep {

inline constexpr std::uint32_t kAxisLetters = [] {
  std::uint32_t bits = 0;
  for (const char letter : kProgramAxisLetters) bits |= letter_bit(letter);
  return bits;
}();
inline constexpr std::uint32_t kArcLetters =
    letter_bit('I') | letter_bit('J') | letter_bit('K') | letter_bit('R');
inline constexpr std::uint32_t kMotionLetters =
    kAxisLetters | kArcLetters | letter_bit('N') | letter_bit('F') |
    letter_bit('S');

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

class GcodeReader {
 public:
  GcodeReader(std::string_view text, const GcodeReadOptions& options);

  Result<Program> read();

  /// After read() has failed: control flow could not be followed.
  [[nodiscard]] bool flow_failed() const { return flow_failed_; }

 private:
  using Kind = ProgramItem::Kind;

  [[nodiscard]] Error error(ErrorCode code, const std::string& reason) const {
    return {code, "line " + std::to_string(line_) + ": " + reason};
  }
  bool fail(ErrorCode code, const std::string& reason) {
    error_ = error(code, reason);
    return false;
  }

  bool run_line(std::string_view line);
  bool run_flow();
  bool refuse_flow(const std::string& reason);
  bool count_line();
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
  void give_text(ProgramItem& made);
  [[nodiscard]] std::string evaluated_line() const;
  bool add_text(bool unknown_effect = false);
  bool add_comments();
  bool add_unknown(const std::string& what);
  bool not_understood(const std::string& what);
  bool within_memory();

  GcodeReadOptions options_;
  std::string_view text_;
  Program program_;
  GcodeState state_;
  GcodeLineReader lines_;
  GcodeBlock block_;
  std::uint32_t line_ = 0;
  std::size_t begin_ = 0;  ///< of the line in the text
  GcodePlace next_;        ///< where the program goes on
  GcodeFlow flow_;
  bool follows_ = false;        ///< control flow was met and is carried out
  bool flow_failed_ = false;    ///< it cannot be
  std::uint64_t executed_ = 0;  ///< lines, since it was met
  bool started_ = false;        ///< a line with anything on it was met
  bool ended_ = false;          ///< M2, M30 or the second %
  bool flow_kept_ = false;      ///< control flow: the rest is kept
  bool names_mode_ = false;     ///< the line has a motion word
  Error error_;
  struct Note {
    std::string reason;
    std::uint32_t line = 0;
    std::uint64_t count = 0;
  };
  std::vector<Note> notes_;
};

}  // namespace unstep
