#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "unstep/codec.h"

/// Resolutions between the units of foreign formats.
namespace unstep {

/// A rational and whether it is the exact value or the nearest one.
struct RoundedRational {
  Rational value;
  bool exact = true;
};

/// value * numerator / denominator, reduced; the nearest rational with both
/// parts in uint32 if it does not fit. REQUIRES: value.denominator != 0,
/// 0 < numerator, denominator < 2^31.
[[nodiscard]] RoundedRational scale(const Rational& value,
                                    std::uint32_t numerator,
                                    std::uint32_t denominator);

/// The nearest whole number.
[[nodiscard]] std::uint64_t round_to_integer(const Rational& value);

/// "204/1 x 98/1 per inch", for notes.
[[nodiscard]] std::string to_string(const Resolution& resolution);

/// The value with x and y exchanged.
[[nodiscard]] Resolution transposed(const Resolution& resolution);

/// Units of 1 / `per_inch` inch that a grid unit takes along x and y. Nothing
/// without a unit of length. REQUIRES: is_usable(resolution).
struct GridUnit {
  double x = 1;
  double y = 1;
};
[[nodiscard]] std::optional<GridUnit> grid_unit(const Resolution& resolution,
                                                double per_inch);

/// True if both parts of both rationals make numbers above 0.
[[nodiscard]] bool is_usable(const Resolution& resolution);

}  // namespace unstep
