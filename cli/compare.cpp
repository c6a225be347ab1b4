#include "cli/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "cli/message.h"

namespace unstep::cli {
namespace {

std::string_view kind_name(PageKind kind) {
  return kind == PageKind::ink ? "ink" : "chains";
}

std::optional<std::string> first_pixel(const Bitmap& a, const Bitmap& b) {
  std::uint64_t differing = 0;
  std::int32_t first_x = 0;
  std::int32_t first_y = 0;
  for (std::int32_t y = 0; y < a.height(); ++y) {
    const std::span<const std::uint64_t> row_a = a.row(y);
    const std::span<const std::uint64_t> row_b = b.row(y);
    for (std::size_t i = 0; i < row_a.size(); ++i) {
      const std::uint64_t changed = row_a[i] ^ row_b[i];
      if (changed == 0) continue;
      if (differing == 0) {
        first_x = static_cast<std::int32_t>(i * 64) + std::countl_zero(changed);
        first_y = y;
      }
      differing += static_cast<std::uint64_t>(std::popcount(changed));
    }
  }
  if (differing == 0) return std::nullopt;
  const bool ink = a.get(first_x, first_y);
  return fmt::format(
      "pixel ({}, {}) is {} in the first and {} in the second; "
      "{} {}",
      first_x, first_y, ink ? "ink" : "paper", ink ? "paper" : "ink",
      counted(differing, "pixel"), differing == 1 ? "differs" : "differ");
}

std::optional<std::string> chain_difference(const Chain& a, const Chain& b) {
  if (a == b) return std::nullopt;
  if (a.origin != b.origin) {
    return fmt::format("starts at ({}, {}) and at ({}, {})", a.origin.x,
                       a.origin.y, b.origin.x, b.origin.y);
  }
  if (a.connectivity != b.connectivity) {
    return fmt::format("is {}-connected and {}-connected",
                       static_cast<int>(a.connectivity),
                       static_cast<int>(b.connectivity));
  }
  if (a.closed != b.closed) {
    return fmt::format("is {} and {}", a.closed ? "closed" : "open",
                       b.closed ? "closed" : "open");
  }
  const auto [in_a, in_b] = std::mismatch(a.steps.begin(), a.steps.end(),
                                          b.steps.begin(), b.steps.end());
  const auto step = static_cast<std::uint64_t>(in_a - a.steps.begin()) + 1;
  if (in_a == a.steps.end() || in_b == b.steps.end()) {
    return fmt::format("has {} and {}", counted(a.steps.size(), "step"),
                       counted(b.steps.size(), "step"));
  }
  return fmt::format("step {} is {} and {}", grouped(step),
                     static_cast<int>(*in_a), static_cast<int>(*in_b));
}

std::optional<std::string> first_step(const Drawing& a, const Drawing& b) {
  const std::size_t common = std::min(a.chains.size(), b.chains.size());
  for (std::size_t i = 0; i < common; ++i) {
    const auto difference = chain_difference(a.chains[i], b.chains[i]);
    if (difference) {
      return fmt::format("chain {} {} in the second", grouped(i + 1),
                         *difference);
    }
  }
  if (a.chains.size() != b.chains.size()) {
    return fmt::format("{} in the first and {} in the second",
                       counted(a.chains.size(), "chain"),
                       grouped(b.chains.size()));
  }
  if (a.canvas != b.canvas) {
    return fmt::format("the canvas is {} x {} and {} x {} in the second",
                       a.canvas.width, a.canvas.height, b.canvas.width,
                       b.canvas.height);
  }
  return std::nullopt;
}

/// Pixels per metre; per unknown unit where the unit is none.
double rate(const Rational& value, Resolution::Unit unit) {
  if (value.denominator == 0) return 0;
  const double number = static_cast<double>(value.numerator) /
                        static_cast<double>(value.denominator);
  switch (unit) {
    case Resolution::Unit::inch: return number / 0.0254;
    case Resolution::Unit::centimetre: return number * 100;
    case Resolution::Unit::none:
    case Resolution::Unit::metre: return number;
  }
  return number;
}

bool same_rate(const Rational& a, Resolution::Unit unit_a, const Rational& b,
               Resolution::Unit unit_b) {
  if (unit_a == unit_b) {
    return std::uint64_t{a.numerator} * b.denominator ==
           std::uint64_t{b.numerator} * a.denominator;
  }
  const bool whole_metres =
      unit_a == Resolution::Unit::metre || unit_b == Resolution::Unit::metre;
  const double slack = whole_metres ? 0.5 : 1e-6;
  return std::abs(rate(a, unit_a) - rate(b, unit_b)) <= slack;
}

}  // namespace

std::optional<std::string> first_difference(const Page& a, const Page& b) {
  if (a.kind != b.kind) {
    return fmt::format("{} in the first and {} in the second",
                       kind_name(a.kind), kind_name(b.kind));
  }
  if (a.kind == PageKind::chains) return first_step(a.drawing, b.drawing);
  if (a.ink.width() != b.ink.width() || a.ink.height() != b.ink.height()) {
    return fmt::format("{} x {} px in the first and {} x {} px in the second",
                       a.ink.width(), a.ink.height(), b.ink.width(),
                       b.ink.height());
  }
  return first_pixel(a.ink, b.ink);
}

bool same_resolution(const Resolution& a, const Resolution& b) {
  if (!a.known() || !b.known()) return a.known() == b.known();
  const bool ratio_only = a.unit == Resolution::Unit::none;
  if (ratio_only != (b.unit == Resolution::Unit::none)) return false;
  return same_rate(a.x, a.unit, b.x, b.unit) &&
         same_rate(a.y, a.unit, b.y, b.unit);
}

std::string describe_resolution(const Resolution& resolution) {
  if (!resolution.known()) return "unknown";
  const auto number = [](const Rational& value) {
    const double denominator = std::max(value.denominator, 1U);
    return fmt::format("{:.6g}",
                       static_cast<double>(value.numerator) / denominator);
  };
  const std::string x = number(resolution.x);
  const std::string y = number(resolution.y);
  const std::string both = x == y ? x : x + " x " + y;
  switch (resolution.unit) {
    case Resolution::Unit::inch: return both + " dpi";
    case Resolution::Unit::centimetre: return both + " px/cm";
    case Resolution::Unit::metre: return both + " px/m";
    case Resolution::Unit::none: return "ratio " + x + " : " + y;
  }
  return both;
}

}  // namespace unstep::cli
