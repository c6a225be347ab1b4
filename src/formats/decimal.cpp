#include "formats/decimal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace unstep {
namespace {

constexpr int kMaxDecimals = 7;

std::int64_t ten_to(int exponent) {
  std::int64_t power = 1;
  for (; exponent > 0; --exponent) power *= 10;
  return power;
}

/// Removes zeros after the point, and the point if nothing is left after it.
void trim(std::string& text, std::size_t begin) {
  if (text.find('.', begin) == std::string::npos) return;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
}

}  // namespace

int power_of_ten(std::int32_t scale) {
  for (int k = 0; k <= kMaxDecimals; ++k) {
    if (ten_to(k) == scale) return k;
  }
  return -1;
}

int decimals_for(std::int32_t scale) {
  for (int k = 0; k <= kMaxDecimals; ++k) {
    if (ten_to(k) % scale == 0) return k;
  }
  int decimals = 4;
  while (ten_to(decimals) < std::int64_t{scale} * 10 &&
         decimals < kMaxDecimals) {
    ++decimals;
  }
  return decimals;
}

void append_integer(std::string& text, std::int64_t value) {
  std::array<char, 24> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end.ptr);
}

void append_decimal(std::string& text, std::int64_t value, int decimals,
                    bool bare) {
  if (value < 0) {
    text += '-';
    value = -value;
  }
  const std::int64_t power = ten_to(decimals);
  const std::int64_t whole = value / power;
  const std::int64_t part = value % power;
  if (whole != 0 || part == 0 || !bare) append_integer(text, whole);
  if (part == 0) return;
  text += '.';
  const std::size_t begin = text.size();
  append_integer(text, part);
  const std::size_t digits = text.size() - begin;
  text.insert(begin, static_cast<std::size_t>(decimals) - digits, '0');
  while (text.back() == '0') text.pop_back();
}

void append_ratio(std::string& text, std::int64_t value, std::int32_t scale) {
  const int decimals = decimals_for(scale);
  // |value| * 10^7 < 2^38 * 2^24 fits.
  const std::int64_t scaled = value * ten_to(decimals);
  const std::int64_t half = scaled < 0 ? -(scale / 2) : scale / 2;
  append_decimal(text, (scaled + half) / scale, decimals);
}

void append_real(std::string& text, double value, int digits) {
  if (value == 0 || !std::isfinite(value)) {
    text += '0';
    return;
  }
  const auto magnitude =
      static_cast<int>(std::floor(std::log10(std::fabs(value))));
  append_fixed(text, value, digits - 1 - magnitude);
}

void append_fixed(std::string& text, double value, int decimals) {
  std::array<char, 80> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                    std::isfinite(value) ? value : 0.0,
                    std::chars_format::fixed, std::clamp(decimals, 0, 40));
  const std::size_t begin = text.size();
  text.append(buffer.data(), end.ptr);
  trim(text, begin);
  if (text.compare(begin, std::string::npos, "-0") == 0) text.erase(begin, 1);
}

void append_shortest(std::string& text, double value) {
  std::array<char, 40> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end.ptr);
}

}  // namespace unstep
