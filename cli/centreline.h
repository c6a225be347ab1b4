#pragma once

#include <string>
#include <vector>

#include "cli/options.h"
#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/deviation.h"
#include "unstep/result.h"
#include "unstep/reverse.h"

/// Ink as strokes along its middle, and how well they draw it.
namespace unstep::cli {

/// A page of ink as a page of strokes within the options' tolerance of their
/// centrelines, step for step without one. Trace::automatic gives what the
/// options say for contours if strokes do not draw the ink: if some of it is
/// more than 2.5 pixels and the tolerance off, or if strokes are no simpler
/// than contours; with the aim of few bytes, no smaller in a .ustp file.
/// REQUIRES: a page of ink, not Trace::contour.
Result<Page> to_strokes(Page page, const LineOptions& options, Effort effort,
                        LineAim aim);

/// Adds a note if strokes draw the ink worse than Trace::automatic accepts.
Status warn_of_strokes(const Bitmap& ink, const Page& strokes,
                       std::vector<std::string>& notes);

/// Whether a page of paths is strokes that stand for ink.
[[nodiscard]] bool is_strokes(const Page& page);

/// "is up to 2.24 px off at (12, 34); 5,678 pixels differ, 9.8 % of the ink".
[[nodiscard]] std::string describe_ink_distance(const InkDistance& distance);

/// An SVG picture of two rasters of the same size: ink of both grey, of the
/// first alone red, of the second alone blue.
[[nodiscard]] std::string overlay_svg(const Bitmap& first,
                                      const Bitmap& second);

}  // namespace unstep::cli
