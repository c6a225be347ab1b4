#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "cli/quantity.h"
#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/grid.h"
#include "unstep/result.h"
#include "unstep/reverse.h"

/// Pages of one kind become pages of another.
namespace unstep::cli {

/// A number of grid units exactly, as the user wrote it where that is a
/// decimal of at most five places, and never larger. invalid_argument for mm
/// or in where the page's resolution is unknown; the finer axis counts.
Result<Rational> to_tolerance(const Quantity& length,
                              const Resolution& resolution);

/// Ink or chains as chains: ink by its contours, clockwise around ink.
Result<Drawing> chains_of(const Page& page);

/// Ink or chains become lines by reverse interpolation, checked against the
/// bound of the method before they are given back; `internal` if they break it.
/// Ink becomes strokes if the options ask for centrelines (centreline.h).
/// Pages of paths stay as they are; method none leaves chains alone, and ink
/// whose contours are asked for. With the aim of few bytes a page whose lines
/// would be no smaller in a .ustp file than what it is stays that, too.
Result<Page> to_lines(Page page, const LineOptions& options, Effort effort,
                      LineAim aim);

/// A page as chains or paths: to_lines() for few lines, and of ink that stays
/// ink its edges.
Result<Page> to_drawing(Page page, const LineOptions& options, Effort effort);

/// Orders what a page of chains or paths draws for short travel; the note says
/// how long it is before and after, in metres if the resolution is known.
/// unsupported for a page of ink.
Status order_page(Page& page, std::vector<std::string>& notes);

/// Paths become chains on a grid of this width: 4-connected if all are filled
/// outlines, else 8-connected. The resolution becomes that of the new grid.
Result<Page> to_steps(Page page, const Quantity& grid, std::uint64_t max_steps);

/// The ink of any page. Notes say what had to be decided.
Result<Bitmap> to_ink(const Page& page, const DecodeLimits& limits,
                      std::vector<std::string>& notes);

/// A page of a program as what the program draws.
Result<Page> draw_program_page(const Page& page,
                               std::vector<std::string>& notes);

/// The chains that the segments of a page of Fidelity::Kind::device draw.
Result<Drawing> device_chains(const Drawing& paths);

}  // namespace unstep::cli
