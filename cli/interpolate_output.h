#pragma once

#include "unstep/interpolate.h"

/// What an interpolator does, on standard output.
namespace unstep::cli {

/// Freeman codes (or increments, a line each), or a row per tick with the
/// registers after it.
enum class TickForm { steps, table, csv, json };

/// Runs the interpolator to its end. False if standard output takes no more.
bool write_ticks(Interpolator& run, const MethodInfo& info, TickForm form);

}  // namespace unstep::cli
