#pragma once

#include <string_view>

namespace unstep {

/// Page metadata of a page of several whose 0 is black, so that it is written
/// so again; alone it would not be worth its bytes.
inline constexpr std::string_view kPhotometricKey = "tiff:Photometric";
inline constexpr std::string_view kZeroIsBlack = "MinIsBlack";

}  // namespace unstep
