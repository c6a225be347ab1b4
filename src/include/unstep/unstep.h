#pragma once

#include <string_view>

#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/deviation.h"
#include "unstep/formats.h"
#include "unstep/grid.h"
#include "unstep/interpolate.h"
#include "unstep/program.h"
#include "unstep/result.h"
#include "unstep/reverse.h"
#include "unstep/step_stream.h"
#include "unstep/trace.h"

/// Everything at once, and the version.
namespace unstep {

/// The library's version, "major.minor.patch".
[[nodiscard]] std::string_view version();

/// The .ustp format version that is written. 0 is pre-release: files of
/// format 0 may become unreadable to later releases.
inline constexpr int kFormatVersion = 0;

}  // namespace unstep
