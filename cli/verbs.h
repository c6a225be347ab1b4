#pragma once

#include <functional>

#include "cli/exit_code.h"

namespace CLI {
class App;
}

namespace unstep::cli {

/// What a verb leaves behind when it was chosen: the work to do once the
/// command line is known to be right.
struct Context {
  std::function<ExitCode()> run;
};

/// Adds a verb: its options, help and examples. The callback of the added
/// subcommand sets Context::run. One function per verb, in a file of its name.
using AddVerb = void (*)(CLI::App& app, Context& context);

void add_compress(CLI::App& app, Context& context);
void add_convert(CLI::App& app, Context& context);
void add_decompress(CLI::App& app, Context& context);
void add_verify(CLI::App& app, Context& context);
void add_info(CLI::App& app, Context& context);
void add_batch(CLI::App& app, Context& context);
void add_interpolate(CLI::App& app, Context& context);
void add_steps(CLI::App& app, Context& context);
void add_reverse(CLI::App& app, Context& context);
void add_simulate(CLI::App& app, Context& context);

}  // namespace unstep::cli
