#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace unstep {

/// What an O word does.
enum class GcodeFlowKey : std::uint8_t {
  unknown,
  sub,
  endsub,
  call,
  back,  ///< return
  loop,  ///< do
  check_while,
  endwhile,
  repeat,
  endrepeat,
  check_if,
  elseif,
  otherwise,  ///< else
  endif,
  leave,  ///< break
  next    ///< continue
};

/// A line of control flow: "o100 if [#1 GT 2]".
struct GcodeFlowWord {
  GcodeFlowKey key = GcodeFlowKey::unknown;
  std::string label;  ///< "100", or "<NAME"
  bool label_known = true;
  /// Whether the label and the numbers follow from the program alone.
  bool known = true;
  std::vector<double> numbers;  ///< of a condition, a count, or arguments
};

/// The digits or the "<name>" of an O word, which `text` begins with; blanks
/// and case mean nothing. Bytes read, 0 if there is none.
std::size_t read_flow_label(std::string_view text, std::string& label);

/// The letters after it, blanks among them. Bytes read.
std::size_t read_flow_key(std::string_view text, GcodeFlowKey& key);

/// The word of a line, its numbers not evaluated; unknown where the line has
/// none or cannot be read. An expression for a label is known if it has no
/// parameters.
GcodeFlowWord find_flow_word(std::string_view line);

/// As it is written: "endwhile".
std::string_view flow_key_name(GcodeFlowKey key);

}  // namespace unstep
