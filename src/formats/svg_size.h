#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "formats/affine.h"
#include "formats/svg_shapes.h"
#include "unstep/codec.h"
#include "unstep/grid.h"

namespace unstep {

/// A viewBox attribute.
struct SvgViewBox {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};
/// Nothing if there is none or it has no area.
[[nodiscard]] std::optional<SvgViewBox> svg_view_box(
    const pugi::xml_node& node);

/// What the root element says of the page.
struct SvgSize {
  Canvas canvas;     ///< 0 x 0 if it says nothing
  Affine to_canvas;  ///< moves the viewBox to (0, 0)
  SvgViewport viewport;
  Resolution resolution;
  std::vector<std::string> notes;
};
[[nodiscard]] SvgSize read_svg_size(const pugi::xml_node& root);

}  // namespace unstep
