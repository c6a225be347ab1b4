#pragma once

#include <optional>
#include <string>

#include "unstep/codec.h"
#include "unstep/deviation.h"

/// Where two drawings differ, in words.
namespace unstep::cli {

/// The first difference in what is drawn: "pixel (17, 203) is ink in A and
/// paper in B; 35 pixels differ". Nothing if every pixel or step is the same.
[[nodiscard]] std::optional<std::string> first_difference(const Page& a,
                                                          const Page& b);

/// The largest deviation of a page of lines from the ink or chains that it was
/// made from, measured by its fidelity: Frechet distance, or the device's own.
/// Above the fidelity's bound only if it breaks it.
/// invalid_argument if the pages cannot stand for each other.
Result<Deviation> page_deviation(const Page& original, const Page& lines);

/// "deviates by up to 0.894 px, of 1 px allowed, at (120.5, 33), contour 12".
[[nodiscard]] std::string describe_deviation(const Deviation& deviation,
                                             const Fidelity& fidelity);

/// The bound that the page's fidelity states, in grid units.
[[nodiscard]] double bound_of(const Fidelity& fidelity);

/// True if both say the same resolution. Formats that count in whole pixels
/// per metre round; a difference that their rounding explains is none.
[[nodiscard]] bool same_resolution(const Resolution& a, const Resolution& b);

/// "300 dpi", "204 x 196 dpi", "118 per cm", "unknown".
[[nodiscard]] std::string describe_resolution(const Resolution& resolution);

}  // namespace unstep::cli
