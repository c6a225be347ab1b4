#pragma once

#include <cstdint>
#include <string_view>

#include "unstep/codec.h"
#include "unstep/result.h"

/// The one syntax of numbers on the command line.
namespace unstep::cli {

/// A length: "12", "12px" (both grid units), "0.5mm", "1.25in".
struct Quantity {
  enum class Unit : std::uint8_t { grid, millimetre, inch };
  double value = 0;
  Unit unit = Unit::grid;
  friend bool operator==(const Quantity&, const Quantity&) = default;
};

/// A decimal number, not negative, and a unit, with or without a space
/// between. invalid_argument otherwise.
Result<Quantity> parse_quantity(std::string_view text);

/// The same with an optional sign before it: a way along an axis.
Result<Quantity> parse_signed_quantity(std::string_view text);

/// A time in seconds: a decimal number, not negative: "0.01", "0.01s", "10ms".
/// invalid_argument otherwise.
Result<double> parse_seconds(std::string_view text);

/// The quantity in grid units along an axis that has `per_unit` of them per
/// `unit`. invalid_argument for mm or in where the resolution is unknown.
Result<double> to_grid_units(const Quantity& quantity, const Rational& per_unit,
                             Resolution::Unit unit);

/// A count: a whole number with an optional suffix K, M, G (powers of 1000) or
/// Ki, Mi, Gi (powers of 1024). invalid_argument if malformed, out_of_range if
/// it does not fit 64 bits.
Result<std::uint64_t> parse_count(std::string_view text);

}  // namespace unstep::cli
