#pragma once

#include <cstdint>

#include "formats/binarise.h"
#include "unstep/bitmap.h"
#include "unstep/result.h"

/// What the module of image processing does (imaging_module.h), with the types
/// of the library. The module is loaded by the first call; unsupported if it
/// cannot be had, limit_exceeded if it runs out of memory.
namespace unstep {

/// What a page tells of its light.
struct PageLight {
  double noise = 0;
  double contrast = 0;  ///< 0: a blank page
  double darkest = 0;   ///< paper
  double lightest = 0;
  bool fits = false;
};

namespace imaging {

struct Removed {
  std::uint64_t pieces = 0;
  std::uint64_t pixels = 0;
};

/// Fills the ink by Threshold::Kind sauvola, local, or automatic, which leaves
/// the ink alone unless the light fits or the page is blank.
Result<PageLight> threshold(GreyPage& grey, Threshold::Kind kind, Bitmap& ink);

/// Degrees counter-clockwise as seen; luminance below `level` is dark.
Result<double> skew(GreyPage& grey, int level);

Status turn(GreyPage& grey, double degrees, std::uint8_t paper, GreyPage& out);

Result<Removed> remove_small_pieces(Bitmap& ink, std::uint64_t area,
                                    bool of_paper);

}  // namespace imaging
}  // namespace unstep
