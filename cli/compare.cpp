#include "cli/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "cli/content.h"
#include "cli/message.h"
#include "cli/program_difference.h"
#include "cli/reshape.h"

namespace unstep::cli {
namespace {

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

std::string describe(const Path::Element& element) {
  if (element.kind == Path::Kind::segment) {
    return fmt::format("a line by ({}, {})", element.segment.dx,
                       element.segment.dy);
  }
  const Arc& arc = element.arc;
  return fmt::format("an arc by ({}, {}) about ({}, {}), {}", arc.end.x,
                     arc.end.y, arc.centre.x, arc.centre.y,
                     arc.clockwise ? "clockwise" : "counter-clockwise");
}

std::optional<std::string> path_difference(const Path& a, const Path& b) {
  if (a == b) return std::nullopt;
  if (a.origin != b.origin) {
    return fmt::format("starts at ({}, {}) and at ({}, {})", a.origin.x,
                       a.origin.y, b.origin.x, b.origin.y);
  }
  if (a.closed != b.closed) {
    return fmt::format("is {} and {}", a.closed ? "closed" : "open",
                       b.closed ? "closed" : "open");
  }
  if (a.width != b.width) {
    return fmt::format("has a pen of {} and {}", a.width, b.width);
  }
  const std::size_t common = std::min(a.elements.size(), b.elements.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (a.elements[i] == b.elements[i]) continue;
    return fmt::format("has as element {} {} and {}", grouped(i + 1),
                       describe(a.elements[i]), describe(b.elements[i]));
  }
  return fmt::format("has {} and {}", counted(a.elements.size(), "element"),
                     grouped(b.elements.size()));
}

std::optional<std::string> first_element(const Drawing& a, const Drawing& b) {
  if (a.scale != b.scale || a.paint != b.paint) {
    return a.scale != b.scale
               ? fmt::format("{} and {} units per pixel", a.scale, b.scale)
               : std::string("one is filled, the other drawn by pens");
  }
  const std::size_t common = std::min(a.paths.size(), b.paths.size());
  for (std::size_t i = 0; i < common; ++i) {
    const auto difference = path_difference(a.paths[i], b.paths[i]);
    if (difference) {
      return fmt::format("path {} {} in the second", grouped(i + 1),
                         *difference);
    }
  }
  if (a.paths.size() == b.paths.size()) return std::nullopt;
  return fmt::format("{} in the first and {} in the second",
                     counted(a.paths.size(), "path"), grouped(b.paths.size()));
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
  if (a.kind == PageKind::program && b.kind == PageKind::program) {
    return first_motion(a, b);
  }
  if (a.kind != b.kind) {
    return fmt::format("{} in the first and {} in the second",
                       kind_name(a.kind), kind_name(b.kind));
  }
  if (a.kind == PageKind::chains) return first_step(a.drawing, b.drawing);
  if (a.kind == PageKind::paths) return first_element(a.drawing, b.drawing);
  if (a.ink.width() != b.ink.width() || a.ink.height() != b.ink.height()) {
    return fmt::format("{} x {} px in the first and {} x {} px in the second",
                       a.ink.width(), a.ink.height(), b.ink.width(),
                       b.ink.height());
  }
  return first_pixel(a.ink, b.ink);
}

Result<Deviation> page_deviation(const Page& original, const Page& lines) {
  const Result<Drawing> chains = chains_of(original);
  if (!chains) return chains.error();
  if (lines.fidelity.kind == Fidelity::Kind::device) {
    return measure_device_deviation(*chains, lines.drawing);
  }
  Result<Deviation> found = measure_deviation(*chains, lines.drawing);
  if (!found) return found;
  // The measure is rounded up; whether the bound holds is decided exactly.
  const double bound = bound_of(lines.fidelity);
  if (found->distance > bound &&
      check_deviation(*chains, lines.drawing, lines.fidelity.tolerance)) {
    found->distance = bound;
  }
  return found;
}

double bound_of(const Fidelity& fidelity) {
  if (fidelity.kind == Fidelity::Kind::device) return 1;
  return static_cast<double>(fidelity.tolerance.numerator) /
         fidelity.tolerance.denominator;
}

std::string describe_deviation(const Deviation& deviation,
                               const Fidelity& fidelity) {
  const bool device = fidelity.kind == Fidelity::Kind::device;
  return fmt::format(
      "deviates by up to {:.4g} px{}, of {:.6g} px allowed, at ({:.6g}, "
      "{:.6g}), contour {}, step {}",
      deviation.distance, device ? " on an axis" : "", bound_of(fidelity),
      deviation.x, deviation.y, grouped(deviation.path + 1),
      grouped(deviation.step));
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
