#pragma once

#include <string>

#include "unstep/grid.h"

namespace unstep::cli {

/// An SVG of the chains that were commanded, grey, and the paths that were
/// followed, red (segments in 1 / followed.scale of a unit; or chains), one
/// unit of the drawing a pixel.
[[nodiscard]] std::string plot_svg(const Drawing& commanded,
                                   const Drawing& followed);

}  // namespace unstep::cli
