#pragma once

#include <optional>
#include <string>

#include "cli/exit_code.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/quantity.h"
#include "unstep/codec.h"
#include "unstep/program.h"
#include "unstep/result.h"

namespace CLI {
class App;
}

/// Drawings become programs of machines.
namespace unstep::cli {

struct DrawOptions {
  DrawProgramOptions draw;
  std::optional<Quantity> unit_size;  ///< where the drawing does not say
};

/// --unit-size, --feed, --plunge-feed, --travel-z, --cut-z, --spindle, --power,
/// --tool-on and --tool-off.
void add_draw(CLI::App& verb, DrawOptions& options);

/// --unit-size alone.
void add_unit_size(CLI::App& verb, DrawOptions& options);

/// The size of a grid unit in mm, of the resolution unless there is none.
/// invalid_argument if neither it nor --unit-size says.
Status set_unit_size(DrawOptions& options, const Resolution& resolution,
                     std::vector<std::string>& notes);

struct DrawFiles;

/// A page of any kind as a program: a program's own, or what draws the page
/// with options.draw. A tolerance of `lines` that was used is taken from them.
Result<Program> program_of_page(Page page, const DrawFiles& files,
                                const DrawOptions& options,
                                const GcodeReadOptions& read,
                                LineOptions& lines,
                                std::vector<std::string>& notes);

struct DrawFiles {
  ProgramFiles files;
  std::uint64_t page = 0;  ///< from 1; 0: all, a file each
  InputOptions read;
  Effort effort = Effort::standard;
};

/// A drawing of any kind to one program per page.
ExitCode convert_to_program(const DrawFiles& files, const DrawOptions& draw,
                            const ProgramOptions& program,
                            const LineOptions& lines);

}  // namespace unstep::cli
