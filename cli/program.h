#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/exit_code.h"
#include "cli/options.h"
#include "unstep/program.h"

namespace CLI {
class App;
}

/// Programs of machines, which are text in and text out.
namespace unstep::cli {

struct ProgramOptions {
  GcodeReadOptions read;
  GcodeWriteOptions write;
  bool quadrants = false;
};

/// True for names that end in .ngc, .nc, .gcode, .gc, .tap or .cnc.
[[nodiscard]] bool names_program(const std::string& path);

/// --profile, --units, --decimals, --arc-words, --quadrants, --strict,
/// --block-delete, --header, --footer and --dense.
void add_program(CLI::App& verb, ProgramOptions& options);

struct ProgramFiles {
  std::string input;
  std::string output;
  bool force = false;
  bool quiet = false;
};

/// Reads a program, shortens it if the lines have a tolerance, reads what it
/// wrote of it and compares the motions, and only then gives it its name.
ExitCode convert_program(const ProgramFiles& files,
                         const ProgramOptions& options,
                         const LineOptions& lines);

}  // namespace unstep::cli
