#pragma once

#include <string_view>

#include "formats/affine.h"
#include "unstep/result.h"

namespace unstep {

/// The transform attribute of an SVG element. corrupt if it is none.
Result<Affine> parse_svg_transform(std::string_view text);

}  // namespace unstep
