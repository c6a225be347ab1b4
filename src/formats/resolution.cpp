#include "formats/resolution.h"

#include <numeric>

namespace unstep {
namespace {

std::string to_string(const Rational& value) {
  std::string text = std::to_string(value.numerator);
  if (value.denominator != 1) text += "/" + std::to_string(value.denominator);
  return text;
}

}  // namespace

RoundedRational scale(const Rational& value, std::uint32_t numerator,
                      std::uint32_t denominator) {
  // Both products are below 2^32 * 2^31.
  std::uint64_t n = std::uint64_t{value.numerator} * numerator;
  std::uint64_t d = std::uint64_t{value.denominator} * denominator;
  const std::uint64_t common = std::gcd(n, d);
  n /= common;
  d /= common;
  bool exact = true;
  while (n > UINT32_MAX || d > UINT32_MAX) {
    exact = false;
    n = (n + 1) / 2;
    d = (d + 1) / 2;
  }
  return {{static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(d)},
          exact};
}

std::uint64_t round_to_integer(const Rational& value) {
  return (std::uint64_t{value.numerator} + value.denominator / 2) /
         value.denominator;
}

std::string to_string(const Resolution& resolution) {
  const std::string sides =
      to_string(resolution.x) + " x " + to_string(resolution.y);
  switch (resolution.unit) {
    case Resolution::Unit::none: return sides + " (no unit)";
    case Resolution::Unit::inch: return sides + " per inch";
    case Resolution::Unit::centimetre: return sides + " per centimetre";
    case Resolution::Unit::metre: return sides + " per metre";
  }
  return sides;
}

std::optional<GridUnit> grid_unit(const Resolution& resolution,
                                  double per_inch) {
  double units = 0;
  switch (resolution.unit) {
    case Resolution::Unit::none: return std::nullopt;
    case Resolution::Unit::inch: units = per_inch; break;
    case Resolution::Unit::centimetre: units = per_inch / 2.54; break;
    case Resolution::Unit::metre: units = per_inch / 0.0254; break;
  }
  const auto units_at = [units](const Rational& density) {
    return units * density.denominator / density.numerator;
  };
  return GridUnit{units_at(resolution.x), units_at(resolution.y)};
}

Resolution transposed(const Resolution& resolution) {
  return {resolution.y, resolution.x, resolution.unit};
}

bool is_usable(const Resolution& resolution) {
  return resolution.x.numerator != 0 && resolution.x.denominator != 0 &&
         resolution.y.numerator != 0 && resolution.y.denominator != 0;
}

}  // namespace unstep
