#include "formats/svg_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "formats/real_resolution.h"
#include "formats/svg_style.h"
#include "formats/text_scanner.h"

namespace unstep {
namespace {

int decimals_of(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return 0;
  int decimals = 0;
  for (std::size_t i = point + 1; i < text.size() && is_digit(text[i]); ++i) {
    ++decimals;
  }
  return decimals;
}

/// The unit of a length and the grid units per unit, if it has a physical one.
struct Physical {
  Resolution::Unit unit = Resolution::Unit::none;
  std::uint32_t per = 1;  ///< of these in the unit
  double length = 0;
};
Physical physical(std::string_view text) {
  TextScanner scanner(text);
  scanner.skip_blanks();
  const std::optional<double> length = scanner.number();
  if (!length || *length <= 0) return {};
  const std::string_view unit = scanner.rest();
  if (unit == "in") return {Resolution::Unit::inch, 1, *length};
  if (unit == "pt") return {Resolution::Unit::inch, 72, *length};
  if (unit == "pc") return {Resolution::Unit::inch, 6, *length};
  if (unit == "cm") return {Resolution::Unit::centimetre, 1, *length};
  if (unit == "mm") return {Resolution::Unit::metre, 1000, *length};
  return {};
}

/// Unknown unless width and height are lengths of one unit.
Resolution resolution_of(const pugi::xml_node& root, const SvgViewBox& box) {
  const std::string_view width = root.attribute("width").value();
  const std::string_view height = root.attribute("height").value();
  const Physical x = physical(width);
  const Physical y = physical(height);
  if (x.unit == Resolution::Unit::none || y.unit != x.unit || x.per != y.per) {
    return {};
  }
  const std::string_view ratio = root.attribute("preserveAspectRatio").value();
  const bool stretched = ratio == "none";
  Resolution resolution;
  resolution.unit = x.unit;
  resolution.x = density(box.width, x.length, decimals_of(width));
  resolution.y = density(box.height, y.length, decimals_of(height));
  if (!stretched) {
    // One factor for both: the side that fits.
    const double along_x = box.width / x.length;
    const double along_y = box.height / y.length;
    if (std::fabs(along_x / along_y - 1) < 1e-4) {
      const bool simpler = resolution.y.denominator < resolution.x.denominator;
      resolution.x = resolution.y = simpler ? resolution.y : resolution.x;
    } else if (along_x > along_y) {
      resolution.y = resolution.x;
    } else {
      resolution.x = resolution.y;
    }
  }
  for (Rational* side : {&resolution.x, &resolution.y}) {
    const std::uint64_t numerator = std::uint64_t{side->numerator} * x.per;
    if (side->numerator == 0 || numerator > UINT32_MAX) return {};
    const auto whole = static_cast<std::uint32_t>(numerator);
    const std::uint32_t common = std::gcd(whole, side->denominator);
    *side = {whole / common, side->denominator / common};
  }
  return resolution;
}

}  // namespace

std::optional<SvgViewBox> svg_view_box(const pugi::xml_node& node) {
  TextScanner scanner(node.attribute("viewBox").value());
  std::array<double, 4> values{};
  for (double& value : values) {
    scanner.skip_separator();
    const std::optional<double> number = scanner.number();
    if (!number) return std::nullopt;
    value = *number;
  }
  if (values[2] <= 0 || values[3] <= 0) return std::nullopt;
  return SvgViewBox{values[0], values[1], values[2], values[3]};
}

/// The canvas in user units, the resolution from the physical size.
SvgSize read_svg_size(const pugi::xml_node& root) {
  SvgSize size;
  const std::string_view width = root.attribute("width").value();
  const std::string_view height = root.attribute("height").value();
  std::optional<SvgViewBox> box = svg_view_box(root);
  if (!box) {
    const auto w = svg_length(width, 0);
    const auto h = svg_length(height, 0);
    if (!w || !h || *w <= 0 || *h <= 0) return size;
    box = SvgViewBox{0, 0, *w, *h};
    if (physical(width).unit != Resolution::Unit::none) {
      size.resolution = {{96, 1}, {96, 1}, Resolution::Unit::inch};
    }
  } else {
    size.to_canvas = {1, 0, 0, 1, -box->x, -box->y};
    size.resolution = resolution_of(root, *box);
  }
  size.viewport = {box->width, box->height};
  if (!(box->width < kMaxCoord && box->height < kMaxCoord)) return size;
  const auto up = [](double side) {
    return static_cast<std::int32_t>(std::ceil(side - 1e-6));
  };
  size.canvas = {std::max(up(box->width), 1), std::max(up(box->height), 1),
                 YAxis::down};
  if (size.canvas.width - box->width > 1e-6 ||
      size.canvas.height - box->height > 1e-6) {
    size.notes.push_back("the canvas is rounded up to " +
                         std::to_string(size.canvas.width) + " x " +
                         std::to_string(size.canvas.height));
  }
  return size;
}

}  // namespace unstep
