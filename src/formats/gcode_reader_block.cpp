#include "formats/gcode_reader_block.h"

#include <algorithm>
#include <cmath>

#include "formats/characters.h"

namespace unstep {
namespace {

constexpr std::string_view kLengthLetters = "XYZUVW";
constexpr std::uint32_t kLengths = [] {
  std::uint32_t bits = 0;
  for (const char letter : kLengthLetters) bits |= letter_bit(letter);
  return bits;
}();

/// Marlin's commands that take the rest of their line as text.
bool takes_text(int m_code) {
  return m_code == 230 || m_code == 280 || m_code == 320 || m_code == 1170 ||
         m_code == 1180 || m_code == 9280;
}

std::string quoted(char c) {
  constexpr std::string_view kHex = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte < 0x7f) return std::string("\"") + c + "\"";
  return std::string("byte 0x") + kHex[byte >> 4] + kHex[byte & 15];
}

}  // namespace

bool GcodeLineReader::fail(ErrorCode code, std::string reason) {
  error_ = {code, std::move(reason)};
  return false;
}

bool GcodeLineReader::expect(char c) {
  skip_blanks();
  if (peek() != c) return fail(std::string("expected ") + quoted(c));
  ++at_;
  return true;
}

Status GcodeLineReader::read(std::string_view line, GcodeBlock& block) {
  line_ = line;
  at_ = 0;
  first_word_ = true;
  assignments_.clear();
  block.kind = GcodeBlock::Kind::blank;
  block.deleted = block.assigns = block.assigns_offset = false;
  block.computed = block.unknown_value = false;
  block.values = block.flags = 0;
  block.g_count = block.m_count = 0;
  block.decimals = 0;
  block.body_begin = 0;
  block.body_end = static_cast<std::uint32_t>(line.size());
  block.comments.clear();
  if (!read_start(block) || !read_words(block)) return error_;
  return {};
}

void GcodeLineReader::set_parameters(bool carried_out) {
  for (Assignment& assignment : assignments_) {
    if (!carried_out) assignment.value.known = false;
    parameters_.assign(assignment.target, assignment.value);
  }
}

bool GcodeLineReader::read_start(GcodeBlock& block) {
  skip_blanks();
  if (peek() == '/') {
    block.deleted = true;
    ++at_;
    skip_blanks();
  }
  const char c = peek();
  if (c == '%') {
    block.kind = GcodeBlock::Kind::percent;
    at_ = line_.size();
  } else if (c == '$' || c == '!' || c == '~' || c == '?' || c == '@' ||
             begins_command()) {
    block.kind = GcodeBlock::Kind::command;
    at_ = line_.size();
  }
  return true;
}

/// Three letters or underscores in a row open no word of G-code.
bool GcodeLineReader::begins_command() const {
  std::size_t end = at_;
  while (end < line_.size() && (is_letter(line_[end]) || line_[end] == '_')) {
    ++end;
  }
  return end - at_ >= 3;
}

bool GcodeLineReader::read_words(GcodeBlock& block) {
  while (at_ < line_.size()) {
    const char c = line_[at_];
    if (c == ' ' || c == '\t') {
      ++at_;
    } else if (is_letter(c)) {
      ++at_;
      if (block.kind == GcodeBlock::Kind::blank) {
        block.kind = GcodeBlock::Kind::words;
      }
      if (!read_word(to_upper(c), block)) return false;
    } else if (c == '(' || c == ';') {
      if (!read_comment(block)) return false;
    } else if (c == '#') {
      block.kind = GcodeBlock::Kind::words;
      if (!read_assignment(block)) return false;
    } else if (c == '*') {
      if (!read_checksum(block)) return false;
    } else {
      return fail("expected a letter, not " + quoted(c));
    }
  }
  return true;
}

bool GcodeLineReader::read_word(char letter, GcodeBlock& block) {
  if (letter == 'O') return read_o_word(block);
  skip_blanks();
  const char c = peek();
  const bool begins_number =
      is_digit(c) || c == '.' || c == '-' || c == '+' || c == '[' || c == '#';
  // A function's name looks like a word, so only its bracket tells.
  bool function = false;
  if (is_letter(c)) {
    std::size_t end = at_;
    while (end < line_.size() && is_letter(line_[end])) ++end;
    function = end - at_ >= 2 && end < line_.size() && line_[end] == '[';
  }
  const std::uint32_t bit = letter_bit(letter);
  if (!begins_number && !function) {
    if (((block.values | block.flags) & bit) != 0) {
      return fail(std::string(1, letter) + " stands twice on the line");
    }
    if (letter == 'G' || letter == 'M' || letter == 'N') {
      return fail(std::string("expected a number after ") + letter);
    }
    block.flags |= bit;
    return true;
  }
  std::int64_t value = 0;
  int decimals = 0;
  if (!read_value(value, decimals, block)) return false;
  if (letter == 'G' || letter == 'M') return read_code(letter, value, block);
  if (letter == 'N' && first_word_) {
    block.body_begin = static_cast<std::uint32_t>(at_);
  }
  first_word_ = false;
  if (((block.values | block.flags) & bit) != 0) {
    return fail(std::string(1, letter) + " stands twice on the line");
  }
  if ((kLengths & bit) != 0) {
    block.decimals = std::max(block.decimals, decimals);
  }
  block.values |= bit;
  block.value[static_cast<std::size_t>(letter - 'A')] = value;
  return true;
}

bool GcodeLineReader::read_code(char letter, std::int64_t value,
                                GcodeBlock& block) {
  first_word_ = false;
  constexpr std::int64_t kTenth = kGcodeNumberScale / 10;
  if (value < 0 || value % kTenth != 0 || value > 100'000 * kTenth) {
    if (block.unknown_value) return true;
    return fail(std::string("no such ") + letter + " number");
  }
  auto& codes = letter == 'G' ? block.g : block.m;
  std::size_t& count = letter == 'G' ? block.g_count : block.m_count;
  if (count == codes.size()) {
    return fail(std::string("too many ") + letter + " words");
  }
  const int code = static_cast<int>(value / kTenth);
  codes[count++] = code;
  if (letter == 'M' && block.m_count == 1 && block.g_count == 0 &&
      takes_text(code)) {
    at_ = line_.size();
  }
  return true;
}

bool GcodeLineReader::read_comment(GcodeBlock& block) {
  const std::size_t begin = at_;
  if (line_[at_] == ';') {
    at_ = line_.size();
  } else {
    const std::size_t end = line_.find(')', at_);
    if (end == std::string_view::npos) return fail("a comment is not closed");
    at_ = end + 1;
  }
  block.comments.emplace_back(static_cast<std::uint32_t>(begin),
                              static_cast<std::uint32_t>(at_ - begin));
  return true;
}

/// "*71": the exclusive or of the bytes before it.
bool GcodeLineReader::read_checksum(GcodeBlock& block) {
  unsigned sum = 0;
  for (const char c : line_.substr(0, at_))
    sum ^= static_cast<unsigned char>(c);
  block.body_end = static_cast<std::uint32_t>(at_);
  ++at_;
  skip_blanks();
  unsigned said = 0;
  const std::size_t begin = at_;
  for (; is_digit(peek()) && at_ - begin < 4; ++at_) {
    said = said * 10 + static_cast<unsigned>(peek() - '0');
  }
  if (at_ == begin) return fail("expected a checksum after \"*\"");
  if (said != sum) {
    return fail(ErrorCode::checksum_mismatch,
                "checksum " + std::to_string(said) + " does not fit, " +
                    std::to_string(sum) + " does");
  }
  skip_blanks();
  if (at_ < line_.size() && peek() != ';') {
    return fail("words after the checksum");
  }
  return true;
}

bool GcodeLineReader::read_value(std::int64_t& fixed, int& decimals,
                                 GcodeBlock& block) {
  skip_blanks();
  bool negative = false;
  if (peek() == '-' || peek() == '+') {
    negative = peek() == '-';
    ++at_;
    skip_blanks();
    if (peek() == '-' || peek() == '+') return fail("a number with two signs");
  }
  if (is_digit(peek()) || peek() == '.') {
    return read_plain(negative, fixed, decimals);
  }
  Number number;
  block.computed = true;
  if (!read_operand(number, 0)) return false;
  if (!number.known) {
    block.unknown_value = true;
    fixed = 0;
    return true;
  }
  const double scaled = number.value * static_cast<double>(kGcodeNumberScale);
  if (!(std::abs(scaled) < 9e18)) {
    return fail(ErrorCode::out_of_range, "number too large");
  }
  fixed = std::llround(negative ? -scaled : scaled);
  decimals = 7;
  for (std::int64_t rest = fixed; decimals > 0 && rest % 10 == 0; rest /= 10) {
    --decimals;
  }
  return true;
}

/// Digits with at most one point; seven decimals are exact, more are rounded.
bool GcodeLineReader::read_plain(bool negative, std::int64_t& fixed,
                                 int& decimals) {
  std::uint64_t digits = 0;
  std::size_t begin = at_;
  const char* const text = line_.data();
  const std::size_t size = line_.size();
  // 11 digits times 1e7 stay below 1e18.
  constexpr std::uint64_t kMost = 100'000'000'000;
  for (; at_ < size && is_digit(text[at_]); ++at_) {
    digits = digits * 10 + static_cast<std::uint64_t>(text[at_] - '0');
    if (digits >= kMost) {
      return fail(ErrorCode::out_of_range, "number too large");
    }
  }
  std::size_t count = at_ - begin;
  decimals = 0;
  if (at_ < size && text[at_] == '.') {
    ++at_;
    begin = at_;
    for (; at_ < size && is_digit(text[at_]); ++at_) {
      if (decimals == 7) continue;
      digits = digits * 10 + static_cast<std::uint64_t>(text[at_] - '0');
      ++decimals;
    }
    if (at_ - begin > 7 && text[begin + 7] >= '5') ++digits;
    count += at_ - begin;
  }
  if (count == 0) return fail("expected a number");
  if (at_ < size && text[at_] == '.') return fail("a number with two points");
  constexpr std::array<std::uint64_t, 8> kPowers{
      10'000'000, 1'000'000, 100'000, 10'000, 1'000, 100, 10, 1};
  const auto value = static_cast<std::int64_t>(
      digits * kPowers[static_cast<std::size_t>(decimals)]);
  fixed = negative ? -value : value;
  return true;
}

}  // namespace unstep
