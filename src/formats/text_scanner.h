#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "formats/characters.h"

namespace unstep {

/// False if the text is not one number to its end.
template <class Number>
bool parse_whole(std::string_view text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, number);
  return failed == std::errc{} && stop == end;
}

/// Takes numbers and words off the front of a text, independent of any locale.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : text_(text), rest_(text) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  /// 0 at the end.
  [[nodiscard]] char peek() const { return rest_.empty() ? '\0' : rest_[0]; }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  /// Characters taken so far.
  [[nodiscard]] std::size_t position() const {
    return text_.size() - rest_.size();
  }
  void skip(std::size_t count) { rest_.remove_prefix(count); }

  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_[0])) rest_.remove_prefix(1);
  }
  /// Blanks with at most one comma among them.
  void skip_separator() {
    skip_blanks();
    if (peek() == ',') {
      rest_.remove_prefix(1);
      skip_blanks();
    }
  }
  bool take(char c) {
    if (peek() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::string_view take_word() {
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) ++length;
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

  /// A decimal number with an optional sign and exponent. Nothing, and nothing
  /// taken, if there is none or it is beyond the range of a double.
  std::optional<double> number() {
    std::string_view text = rest_;
    if (!text.empty() && text[0] == '+') text.remove_prefix(1);
    std::string_view digits = text;
    if (text.size() == rest_.size() && !digits.empty() && digits[0] == '-') {
      digits.remove_prefix(1);
    }
    const bool starts =
        !digits.empty() &&
        (is_digit(digits[0]) ||
         (digits[0] == '.' && digits.size() > 1 && is_digit(digits[1])));
    if (!starts) return std::nullopt;
    double value = 0;
    const auto [end, failed] =
        std::from_chars(text.data(), text.data() + text.size(), value);
    if (failed != std::errc{} || !std::isfinite(value)) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

 private:
  std::string_view text_;
  std::string_view rest_;
};

}  // namespace unstep
