#pragma once

#include <cstdint>
#include <string>

/// Numbers as text that no locale changes.
namespace unstep {

/// The k of scale == 10^k, or -1 if there is none.
[[nodiscard]] int power_of_ten(std::int32_t scale);

/// Decimals that tell neighbouring multiples of 1 / scale apart, and give them
/// exactly if a decimal number of no more than 7 decimals can.
/// REQUIRES: 1 <= scale <= Drawing::kMaxScale.
[[nodiscard]] int decimals_for(std::int32_t scale);

/// Appends value / 10^decimals without trailing zeros: "12.5", "-0.04", "7".
/// `bare` leaves out the zero before the point.
void append_decimal(std::string& text, std::int64_t value, int decimals,
                    bool bare = false);

/// Appends value / scale with decimals_for(scale) decimals at most, rounded
/// half away from zero. REQUIRES: |value| < 2^38.
void append_ratio(std::string& text, std::int64_t value, std::int32_t scale);

void append_integer(std::string& text, std::int64_t value);

/// Appends the number with that many significant digits at most, without
/// trailing zeros and without an exponent. REQUIRES: |value| < 1e16.
void append_real(std::string& text, double value, int digits);

/// Appends the number with that many decimals at most, likewise.
void append_fixed(std::string& text, double value, int decimals);

/// The shortest text that reads as the same double.
void append_shortest(std::string& text, double value);

}  // namespace unstep
