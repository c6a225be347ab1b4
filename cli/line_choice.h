#pragma once

#include "unstep/codec.h"
#include "unstep/grid.h"
#include "unstep/result.h"
#include "unstep/reverse.h"

/// Which lines, if any, make a page's .ustp file smallest.
namespace unstep::cli {

/// A page of what reverse_tolerance() found.
Page page_of_lines(const PageInfo& info, const Rational& tolerance,
                   Drawing lines);

/// A page with these chains as lines within the tolerance, not checked: of one
/// pass at fast effort, otherwise of a search. The page itself if it takes no
/// more bytes at that effort, as it does with noise. To know that the page is
/// coded; of the lines of one pass, if there are very many, first a part, and
/// all only if that leaves doubt.
Result<Page> lines_of_few_bytes(Page page, const Drawing& chains,
                                const ToleranceOptions& options);

}  // namespace unstep::cli
