#pragma once

#include <string_view>

/// How often lines of drawings are what, made by tests/bench/train_lines.cpp
/// from lines within tolerances of 1 and 2: one character for each turn after
/// each class of line before, and one for each class of length. See
/// LinePrice::LinePrice for what a character means.
namespace unstep::reverse::prior {

extern const std::string_view kTurns;
extern const std::string_view kLengths;

}  // namespace unstep::reverse::prior
