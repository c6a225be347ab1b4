#pragma once

#include <string_view>

#include "formats/affine.h"
#include "unstep/result.h"

namespace unstep {

/// Draws the d attribute of an SVG path. corrupt, naming the character, at the
/// first fault.
Status draw_svg_path(std::string_view data, FigurePen& pen);

}  // namespace unstep
