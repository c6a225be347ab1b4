#pragma once

#include "unstep/result.h"

/// What the program says to the shell.
namespace unstep::cli {

enum class ExitCode : int {
  ok = 0,
  some_failed = 1,  ///< some of several inputs failed, or two drawings differ
  usage = 2,
  bad_input = 3,  ///< a bad input file, or one above a limit
  io = 4,         ///< cannot read or write; the output exists
  internal = 5,   ///< our bug; the check after encoding failed
  interrupted = 130,
};

/// The lines of every --help.
inline constexpr const char* kExitCodeHelp =
    "Exit codes:\n"
    "  0    done\n"
    "  1    some of several inputs failed, or the drawings differ\n"
    "  2    wrong usage\n"
    "  3    bad input file, or a limit exceeded\n"
    "  4    cannot read or write, or the output exists\n"
    "  5    internal error: the check after encoding failed\n"
    "  130  interrupted\n";

[[nodiscard]] constexpr ExitCode exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::io_error:
    case ErrorCode::output_exists: return ExitCode::io;
    case ErrorCode::invalid_argument: return ExitCode::usage;
    case ErrorCode::cancelled: return ExitCode::interrupted;
    case ErrorCode::internal: return ExitCode::internal;
    default: return ExitCode::bad_input;
  }
}

}  // namespace unstep::cli
