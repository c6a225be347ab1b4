#include "formats/gcode_number.h"

#include <array>

namespace unstep {
namespace {

constexpr std::array<std::int64_t, 8> kPowers{
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000};

}  // namespace

void append_number(std::string& out, std::int64_t number) {
  constexpr std::int64_t kOne = 10'000'000;
  if (number < 0) {
    out += '-';
    number = -number;
  }
  std::array<char, 20> digits{};
  std::size_t count = 0;
  std::int64_t whole = number / kOne;
  do {
    digits[count++] = static_cast<char>('0' + whole % 10);
    whole /= 10;
  } while (whole > 0);
  while (count > 0) out += digits[--count];
  std::int64_t rest = number % kOne;
  if (rest == 0) return;
  out += '.';
  for (std::int64_t unit = kOne / 10; rest > 0; unit /= 10) {
    out += static_cast<char>('0' + rest / unit);
    rest %= unit;
  }
}

std::int64_t round_number(std::int64_t number, int decimals) {
  if (decimals >= 7) return number;
  const std::int64_t grid =
      kPowers[static_cast<std::size_t>(7 - (decimals < 0 ? 0 : decimals))];
  const std::int64_t half = grid / 2;
  return number < 0 ? -((-number + half) / grid * grid)
                    : (number + half) / grid * grid;
}

}  // namespace unstep
