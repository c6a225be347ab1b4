#pragma once

#include <optional>
#include <string>

#include "unstep/codec.h"

/// Where two drawings differ, in words.
namespace unstep::cli {

/// The first difference in what is drawn: "pixel (17, 203) is ink in A and
/// paper in B; 35 pixels differ". Nothing if every pixel or step is the same.
[[nodiscard]] std::optional<std::string> first_difference(const Page& a,
                                                          const Page& b);

/// True if both say the same resolution. Formats that count in whole pixels
/// per metre round; a difference that their rounding explains is none.
[[nodiscard]] bool same_resolution(const Resolution& a, const Resolution& b);

/// "300 dpi", "204 x 196 dpi", "118 per cm", "unknown".
[[nodiscard]] std::string describe_resolution(const Resolution& resolution);

}  // namespace unstep::cli
