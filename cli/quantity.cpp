#include "cli/quantity.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace unstep::cli {
namespace {

constexpr double kMillimetresPerInch = 25.4;

Error invalid(std::string_view text, std::string_view reason) {
  return {ErrorCode::invalid_argument,
          "'" + std::string(text) + "' " + std::string(reason)};
}

/// Grid units per millimetre; 0 if unknown.
double per_millimetre(const Rational& per_unit, Resolution::Unit unit) {
  if (per_unit.numerator == 0 || per_unit.denominator == 0) return 0;
  const double rate = static_cast<double>(per_unit.numerator) /
                      static_cast<double>(per_unit.denominator);
  switch (unit) {
    case Resolution::Unit::inch: return rate / kMillimetresPerInch;
    case Resolution::Unit::centimetre: return rate / 10;
    case Resolution::Unit::metre: return rate / 1000;
    case Resolution::Unit::none: return 0;
  }
  return 0;
}

constexpr std::string_view kExpectedLength =
    "is not a length: give a number of grid units, or 3px, 0.5mm, 0.1in";

struct NumberAndUnit {
  double number = 0;
  std::optional<std::string_view> unit;  ///< none if nothing follows
};

/// A decimal number, not negative, and a word, perhaps after a space.
std::optional<NumberAndUnit> split(std::string_view text) {
  NumberAndUnit found;
  const char* end = text.data() + text.size();
  const auto [rest, failure] =
      std::from_chars(text.data(), end, found.number, std::chars_format::fixed);
  if (failure != std::errc() || !std::isfinite(found.number) ||
      std::signbit(found.number)) {
    return std::nullopt;
  }
  if (rest == end) return found;
  found.unit = std::string_view(rest, static_cast<std::size_t>(end - rest));
  if (found.unit->front() == ' ') found.unit->remove_prefix(1);
  return found;
}

}  // namespace

Result<Quantity> parse_quantity(std::string_view text) {
  const std::optional<NumberAndUnit> found = split(text);
  if (!found) return invalid(text, kExpectedLength);
  Quantity quantity{found->number, Quantity::Unit::grid};
  if (found->unit == "mm") {
    quantity.unit = Quantity::Unit::millimetre;
  } else if (found->unit == "in") {
    quantity.unit = Quantity::Unit::inch;
  } else if (found->unit && found->unit != "px") {
    return invalid(text, kExpectedLength);
  }
  return quantity;
}

Result<Quantity> parse_signed_quantity(std::string_view text) {
  const bool sign = text.starts_with('+') || text.starts_with('-');
  Result<Quantity> quantity = parse_quantity(text.substr(sign ? 1 : 0));
  if (!quantity) return invalid(text, kExpectedLength);
  if (text.starts_with('-')) quantity->value = -quantity->value;
  return quantity;
}

Result<double> parse_seconds(std::string_view text) {
  const std::optional<NumberAndUnit> found = split(text);
  if (found && (!found->unit || found->unit == "s")) return found->number;
  if (found && found->unit == "ms") return found->number / 1000;
  return invalid(text,
                 "is not a time: give a number of seconds, or 0.5s, 10ms");
}

Result<double> to_grid_units(const Quantity& quantity, const Rational& per_unit,
                             Resolution::Unit unit) {
  if (quantity.unit == Quantity::Unit::grid) return quantity.value;
  const double rate = per_millimetre(per_unit, unit);
  if (rate == 0) {
    return Error{ErrorCode::invalid_argument,
                 "a length in mm or in needs a resolution, and none is known"};
  }
  return quantity.unit == Quantity::Unit::millimetre
             ? quantity.value * rate
             : quantity.value * kMillimetresPerInch * rate;
}

Result<std::uint64_t> parse_count(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::uint64_t>, 7> kScales{
      {{"", 1},
       {"K", 1'000},
       {"M", 1'000'000},
       {"G", 1'000'000'000},
       {"Ki", std::uint64_t{1} << 10},
       {"Mi", std::uint64_t{1} << 20},
       {"Gi", std::uint64_t{1} << 30}}};
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, number);
  if (failure == std::errc::result_out_of_range) {
    return Error{ErrorCode::out_of_range,
                 "'" + std::string(text) + "' is too large"};
  }
  const std::string_view suffix(rest, static_cast<std::size_t>(end - rest));
  for (const auto& [name, scale] : kScales) {
    if (failure != std::errc() || suffix != name) continue;
    if (number > std::numeric_limits<std::uint64_t>::max() / scale) {
      return Error{ErrorCode::out_of_range,
                   "'" + std::string(text) + "' is too large"};
    }
    return number * scale;
  }
  return invalid(text, "is not a whole number, with K, M, G, Ki, Mi or Gi");
}

}  // namespace unstep::cli
