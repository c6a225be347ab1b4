#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/exit_code.h"
#include "cli/options.h"
#include "unstep/program.h"
#include "unstep/result.h"

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

/// The text of an option with its "\n" as new lines.
[[nodiscard]] std::string program_lines(const std::string& text);

/// An option whose value goes to `lines` by program_lines().
void add_program_lines(CLI::App& verb, const char* name, std::string& lines,
                       const char* help);

/// --profile, --units, --decimals, --arc-words, --quadrants, --strict,
/// --block-delete, --flow, --max-lines, --header, --footer and --dense.
void add_program(CLI::App& verb, ProgramOptions& options);

/// --tolerance of a program in mm, never more. invalid_argument for pixels.
Result<Rational> program_tolerance(const LineOptions& lines);

/// A program as text, and what was done to it.
struct WrittenProgram {
  std::string text;
  std::string summary;
};

/// Shortens the program if the lines have a tolerance, writes it, reads what
/// it wrote and compares the motions.
Result<WrittenProgram> write_program(Program program,
                                     const ProgramOptions& options,
                                     const LineOptions& lines);

struct ProgramFiles {
  std::string input;
  std::string output;
  bool force = false;
  bool quiet = false;
};

/// Reads a program and gives it its new name once write_program has proven it.
ExitCode convert_program(const ProgramFiles& files,
                         const ProgramOptions& options,
                         const LineOptions& lines);

}  // namespace unstep::cli
