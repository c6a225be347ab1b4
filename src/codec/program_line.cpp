#include "codec/program_line.h"

namespace unstep::codec {
namespace {

constexpr std::int64_t kOne = 10'000'000;

void append_value(std::string& out, std::int64_t value) {
  if (value < 0) out += '-';
  const std::uint64_t size =
      static_cast<std::uint64_t>(value < 0 ? -value : value);
  out += std::to_string(size / static_cast<std::uint64_t>(kOne));
  std::uint64_t rest = size % static_cast<std::uint64_t>(kOne);
  if (rest == 0) return;
  out += '.';
  for (auto unit = static_cast<std::uint64_t>(kOne / 10); rest > 0;
       unit /= 10) {
    out += static_cast<char>('0' + rest / unit);
    rest %= unit;
  }
}

/// Takes digits from the front; false if there are none or too many.
bool take_digits(std::string_view& text, std::int64_t& value, int& count) {
  count = 0;
  while (!text.empty() && text[0] >= '0' && text[0] <= '9' && count < 18) {
    value = value * 10 + (text[0] - '0');
    text.remove_prefix(1);
    ++count;
  }
  return count > 0;
}

bool take_value(std::string_view& text, std::int64_t& value) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  std::int64_t whole = 0;
  int digits = 0;
  if (!take_digits(text, whole, digits) || digits > 9) return false;
  value = whole * kOne;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    std::int64_t part = 0;
    if (!take_digits(text, part, digits) || digits > kMaxProgramDecimals) {
      return false;
    }
    for (; digits < kMaxProgramDecimals; ++digits) part *= 10;
    value += part;
  }
  if (value > kMaxProgramNumber) return false;
  if (negative) value = -value;
  return true;
}

bool take_line(std::string_view text, ProgramLine& line) {
  if (text.size() >= 2 && text[0] == 'G' && text[1] >= '0' && text[1] <= '3') {
    line.motion = text[1] - '0';
    text.remove_prefix(2);
    if (text.empty()) return true;
    if (text[0] != ' ') return false;
    text.remove_prefix(1);
  }
  std::size_t next = 0;
  while (!text.empty()) {
    const std::size_t word = kProgramLetters.find(text[0], next);
    if (word == std::string_view::npos) return false;
    next = word + 1;
    text.remove_prefix(1);
    line.words |= 1U << word;
    if (!take_value(text, line.value[word])) return false;
    if (text.empty()) return true;
    if (text[0] != ' ' || text.size() == 1) return false;
    text.remove_prefix(1);
  }
  return line.words != 0;
}

}  // namespace

std::optional<ProgramLine> parse_line(std::string_view text) {
  ProgramLine line;
  if (!take_line(text, line)) return std::nullopt;
  std::string again;
  append_line(again, line);
  if (again != text) return std::nullopt;
  return line;
}

void append_line(std::string& out, const ProgramLine& line) {
  if (line.motion >= 0) {
    out += 'G';
    out += static_cast<char>('0' + line.motion);
  }
  bool first = line.motion < 0;
  for (std::size_t word = 0; word < kProgramWords; ++word) {
    if (!line.has(word)) continue;
    if (!first) out += ' ';
    first = false;
    out += kProgramLetters[word];
    append_value(out, line.value[word]);
  }
}

int decimals_of(std::int64_t value) {
  int decimals = kMaxProgramDecimals;
  while (decimals > 0 && value % 10 == 0) {
    value /= 10;
    --decimals;
  }
  return decimals;
}

}  // namespace unstep::codec
