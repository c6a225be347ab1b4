#pragma once

#include <pugixml.hpp>
#include <string_view>

#include "formats/affine.h"
#include "unstep/result.h"

namespace unstep {

/// What percentages are of.
struct SvgViewport {
  double width = 100;
  double height = 100;
  [[nodiscard]] double diagonal() const {
    return std::sqrt((width * width + height * height) / 2);
  }
};

/// Whether draw_svg_shape knows an element of that name.
[[nodiscard]] bool is_svg_shape(std::string_view name);

/// path, line, polyline, polygon, rect, circle, ellipse.
Status draw_svg_shape(const pugi::xml_node& node, std::string_view name,
                      const SvgViewport& viewport, FigurePen& pen);

}  // namespace unstep
