#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/gcode_flow_word.h"
#include "formats/gcode_parameters.h"
#include "unstep/result.h"

/// One line of G-code as words with numbers; nothing of what they mean.
namespace unstep {

/// Numbers of words are kept in 1e-7, rounded there.
inline constexpr std::int64_t kGcodeNumberScale = 10'000'000;

/// Bit of a letter's word, 'A' ... 'Z'.
[[nodiscard]] constexpr std::uint32_t letter_bit(char letter) {
  return 1U << static_cast<unsigned>(letter - 'A');
}

struct GcodeBlock {
  enum class Kind : std::uint8_t {
    words,
    blank,
    percent,   ///< the mark of the program's ends
    command,   ///< begins with a word that is no G-code ("$H", "START_PRINT")
    o_number,  ///< names the program
    o_flow     ///< a subroutine, a loop or a branch
  };
  static constexpr std::size_t kMaxCodes = 16;

  Kind kind = Kind::blank;
  bool deleted = false;         ///< begins with "/"
  bool assigns = false;         ///< sets a parameter
  bool assigns_offset = false;  ///< one that LinuxCNC keeps its offsets in
  bool computed = false;        ///< has parameters or expressions
  bool unknown_value = false;   ///< uses a parameter that the program never set
  std::uint32_t values = 0;     ///< letters with a number, but G and M
  std::uint32_t flags = 0;      ///< letters without one
  std::array<std::int64_t, 26> value{};
  /// G and M numbers times ten, in their order.
  std::array<int, kMaxCodes> g{};
  std::array<int, kMaxCodes> m{};
  std::size_t g_count = 0;
  std::size_t m_count = 0;
  int decimals = 0;  ///< the most of any axis word
  /// What a line is when its number and checksum are taken off.
  std::uint32_t body_begin = 0;
  std::uint32_t body_end = 0;
  GcodeFlowWord flow;  ///< of o_flow
  /// First byte and size of each comment.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> comments;

  [[nodiscard]] bool has(char letter) const {
    return (values & letter_bit(letter)) != 0;
  }
  [[nodiscard]] std::int64_t at(char letter) const {
    return value[static_cast<std::size_t>(letter - 'A')];
  }
};

/// Reads lines; keeps the parameters that they set.
class GcodeLineReader {
 public:
  /// Without flow, O words are only told from others: block.flow stays as it
  /// is.
  explicit GcodeLineReader(bool reads_flow) : reads_flow_(reads_flow) {}

  /// `line` without its end. The error has no line number.
  Status read(std::string_view line, GcodeBlock& block);

  /// Sets the parameters of the line read last: if it is carried out, or to
  /// values that are not known if it may be.
  void set_parameters(bool carried_out);

  [[nodiscard]] GcodeParameters& parameters() { return parameters_; }

 private:
  using Number = GcodeNumber;
  using Parameter = GcodeParameter;
  struct Assignment {
    Parameter target;
    Number value;
  };
  static constexpr int kMaxDepth = 64;

  bool read_start(GcodeBlock& block);
  bool read_words(GcodeBlock& block);
  bool read_word(char letter, GcodeBlock& block);
  bool read_code(char letter, std::int64_t value, GcodeBlock& block);
  bool read_comment(GcodeBlock& block);
  bool read_checksum(GcodeBlock& block);
  bool read_assignment(GcodeBlock& block);
  bool read_o_word(GcodeBlock& block);
  bool read_flow(GcodeFlowWord& word);
  bool begins_command() const;

  bool read_value(std::int64_t& fixed, int& decimals, GcodeBlock& block);
  bool read_plain(bool negative, std::int64_t& fixed, int& decimals);

  // Expressions; read_operand is what may stand for a number.
  bool read_operand(Number& result, int depth);
  bool read_bracket(Number& result, int depth);
  bool read_binary(Number& result, int level, int depth);
  bool read_function(Number& result, int depth);
  bool read_exists(Number& result, int depth);
  bool read_parameter(Parameter& parameter, int depth);
  int peek_operator(int& level) const;
  bool apply(int operation, Number& left, const Number& right);
  std::string read_name();

  void skip_blanks() {
    while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t')) {
      ++at_;
    }
  }
  [[nodiscard]] char peek() const {
    return at_ < line_.size() ? line_[at_] : '\0';
  }
  bool fail(ErrorCode code, std::string reason);
  bool fail(std::string reason) {
    return fail(ErrorCode::corrupt, std::move(reason));
  }
  bool expect(char c);

  std::string_view line_;
  std::size_t at_ = 0;
  bool first_word_ = true;
  Error error_;
  std::vector<Assignment> assignments_;
  GcodeParameters parameters_;
  bool reads_flow_;
};

}  // namespace unstep
