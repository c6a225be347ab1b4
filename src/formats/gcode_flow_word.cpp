#include "formats/gcode_flow_word.h"

#include <array>
#include <cmath>

#include "formats/characters.h"
#include "formats/gcode_reader_block.h"

namespace unstep {
namespace {

struct KeyName {
  GcodeFlowKey key;
  std::string_view name;
};
constexpr std::array<KeyName, 15> kKeys{{{GcodeFlowKey::sub, "sub"},
                                         {GcodeFlowKey::endsub, "endsub"},
                                         {GcodeFlowKey::call, "call"},
                                         {GcodeFlowKey::back, "return"},
                                         {GcodeFlowKey::loop, "do"},
                                         {GcodeFlowKey::check_while, "while"},
                                         {GcodeFlowKey::endwhile, "endwhile"},
                                         {GcodeFlowKey::repeat, "repeat"},
                                         {GcodeFlowKey::endrepeat, "endrepeat"},
                                         {GcodeFlowKey::check_if, "if"},
                                         {GcodeFlowKey::elseif, "elseif"},
                                         {GcodeFlowKey::otherwise, "else"},
                                         {GcodeFlowKey::endif, "endif"},
                                         {GcodeFlowKey::leave, "break"},
                                         {GcodeFlowKey::next, "continue"}}};

bool is_space(char c) { return c == ' ' || c == '\t'; }

std::size_t skip_blanks_of(std::string_view text, std::size_t at) {
  while (at < text.size() && is_space(text[at])) ++at;
  return at;
}
std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

/// How many numbers stand after a word.
struct FlowNumbers {
  std::size_t least;
  std::size_t most;
};
FlowNumbers numbers_of(GcodeFlowKey key) {
  switch (key) {
    case GcodeFlowKey::check_while:
    case GcodeFlowKey::check_if:
    case GcodeFlowKey::elseif:
    case GcodeFlowKey::repeat: return {1, 1};
    case GcodeFlowKey::endsub:
    case GcodeFlowKey::back: return {0, 1};
    case GcodeFlowKey::call: return {0, GcodeParameters::kArguments};
    default: return {0, 0};
  }
}

}  // namespace

std::size_t read_flow_label(std::string_view text, std::string& label) {
  label.clear();
  const std::size_t digits = skip_digits(text, 0);
  if (digits > 0) {
    std::size_t first = 0;
    while (first + 1 < digits && text[first] == '0') ++first;
    label = text.substr(first, digits - first);
    return digits;
  }
  if (!text.starts_with('<')) return 0;
  const std::size_t end = text.find('>');
  if (end == std::string_view::npos) return 0;
  for (const char c : text.substr(0, end)) {
    if (!is_space(c)) label += to_upper(c);
  }
  return label.size() > 1 ? end + 1 : 0;
}

std::size_t read_flow_key(std::string_view text, GcodeFlowKey& key) {
  constexpr std::size_t kMost = 12;
  std::string word;
  std::size_t at = skip_blanks_of(text, 0);
  while (at < text.size() && word.size() < kMost) {
    const char c = static_cast<char>(text[at] | 0x20);
    if (c < 'a' || c > 'z') break;
    word += c;
    at = skip_blanks_of(text, at + 1);
  }
  key = GcodeFlowKey::unknown;
  for (const KeyName& known : kKeys) {
    if (known.name == word) key = known.key;
  }
  return at;
}

GcodeFlowWord find_flow_word(std::string_view line) {
  GcodeFlowWord word;
  std::size_t at = skip_blanks_of(line, 0);
  const auto letter = [&] {
    return at < line.size() ? static_cast<char>(line[at] | 0x20) : '\0';
  };
  if (at < line.size() && line[at] == '/') at = skip_blanks_of(line, at + 1);
  if (letter() == 'n') {
    at = skip_blanks_of(line, skip_digits(line, skip_blanks_of(line, at + 1)));
  }
  if (letter() != 'o') return word;
  at = skip_blanks_of(line, at + 1);
  if (at < line.size() && (line[at] == '[' || line[at] == '#')) {
    GcodeBlock block;
    if (GcodeLineReader(true).read(line, block) &&
        block.kind == GcodeBlock::Kind::o_flow) {
      word = block.flow;
    }
    return word;
  }
  const std::size_t size = read_flow_label(line.substr(at), word.label);
  if (size > 0) read_flow_key(line.substr(at + size), word.key);
  return word;
}

std::string_view flow_key_name(GcodeFlowKey key) {
  for (const KeyName& known : kKeys) {
    if (known.key == key) return known.name;
  }
  return "";
}

bool GcodeLineReader::read_o_word(GcodeBlock& block) {
  skip_blanks();
  const bool numbered = is_digit(peek());
  if (!numbered && peek() != '<' && peek() != '[' && peek() != '#') {
    return fail("expected a number or a name after O");
  }
  if (numbered) {
    const std::size_t end = skip_blanks_of(line_, skip_digits(line_, at_));
    if (end == line_.size() || line_[end] == ';' || line_[end] == '(') {
      at_ = end;
      block.kind = GcodeBlock::Kind::o_number;
      return true;
    }
  }
  block.kind = GcodeBlock::Kind::o_flow;
  if (reads_flow_) return read_flow(block.flow);
  at_ = line_.size();
  return true;
}

/// Label, word and numbers, then the end or a comment.
bool GcodeLineReader::read_flow(GcodeFlowWord& word) {
  word.known = true;
  word.label_known = true;
  word.numbers.clear();
  const std::size_t size = read_flow_label(line_.substr(at_), word.label);
  at_ += size;
  if (size == 0) {
    Number label;
    if (peek() == '<') return fail("a name after O is not closed");
    if (!read_operand(label, 0)) return false;
    word.known = label.known && std::abs(label.value) < 1e9;
    word.label_known = word.known;
    word.label = std::to_string(std::lround(word.known ? label.value : 0));
  }
  at_ += read_flow_key(line_.substr(at_), word.key);
  if (word.key == GcodeFlowKey::unknown) {
    at_ = line_.size();
    return true;
  }
  const FlowNumbers takes = numbers_of(word.key);
  for (skip_blanks(); peek() == '['; skip_blanks()) {
    Number number;
    if (word.numbers.size() == takes.most) break;
    if (!read_bracket(number, 0)) return false;
    word.known = word.known && number.known;
    word.numbers.push_back(number.value);
  }
  if (word.numbers.size() < takes.least) return fail("expected \"[\"");
  if (peek() == '\0' || peek() == ';' || peek() == '(') return true;
  return fail("more on a line of " + std::string(flow_key_name(word.key)) +
              " than belongs to it");
}

}  // namespace unstep
