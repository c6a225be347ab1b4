#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/exit_code.h"
#include "cli/heap.h"
#include "cli/interrupt.h"
#include "cli/verbs.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

struct Verb {
  std::string_view name;
  AddVerb add;
};

/// The verbs, in the order of --help.
constexpr Verb kVerbs[] = {{"compress", add_compress},
                           {"decompress", add_decompress},
                           {"convert", add_convert},
                           {"verify", add_verify},
                           {"info", add_info},
                           {"batch", add_batch},
                           {"interpolate", add_interpolate},
                           {"reverse", add_reverse},
                           {"steps", add_steps},
                           {"simulate", add_simulate}};

/// Adds the verb that the first argument names, or all if it names none: the
/// options of all take longer to make than a small file to compress.
void add_verbs(CLI::App& app, Context& context, std::string_view first) {
  for (const Verb& verb : kVerbs) {
    if (verb.name == first) return verb.add(app, context);
  }
  for (const Verb& verb : kVerbs) verb.add(app, context);
}

/// The name of the verb the user chose, to point at its help.
std::string help_command(const CLI::App& app) {
  std::string command = "unstep";
  for (const CLI::App* verb : app.get_subcommands()) {
    command += ' ' + verb->get_name();
  }
  return command + " --help";
}

/// The arguments, last first as CLI11 takes them. It reads "[a,b]" as a list,
/// but that is a legal file name and a glob; "./" in front changes neither.
std::vector<std::string> reversed_arguments(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  for (std::string& argument : arguments) {
    if (argument.starts_with('[') && argument.ends_with(']')) {
      argument.insert(0, "./");
    }
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

ExitCode run(int argc, char** argv) {
  CLI::App app("Stores line art in small files, without loss.", "unstep");
  app.footer(kExitCodeHelp);
  app.set_version_flag("--version",
                       fmt::format("unstep {} (format {}, pre-release)",
                                   version(), kFormatVersion),
                       "Print the versions of program and file format");
  app.require_subcommand(1);
  Context context;
  add_verbs(app, context, argc > 1 ? argv[1] : "");
  try {
    app.parse(argc > 0 ? reversed_arguments(argc, argv)
                       : std::vector<std::string>());
  } catch (const CLI::Success& success) {
    app.exit(success);
    return ExitCode::ok;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "unstep: {} (see {})\n", error.what(),
               help_command(app));
    return ExitCode::usage;
  }
  install_interrupt_handlers();
  return context.run();
}

/// What was printed may still be in the buffer, and the disk full.
ExitCode flush_output(ExitCode code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  fmt::print(stderr, "unstep: standard output: cannot write: {}\n",
             std::generic_category().message(errno));
  return ExitCode::io;
}

}  // namespace
}  // namespace unstep::cli

int main(int argc, char** argv) {
  using unstep::cli::ExitCode;
  unstep::cli::prepare_heap();
  try {
    return static_cast<int>(
        unstep::cli::flush_output(unstep::cli::run(argc, argv)));
  } catch (const std::system_error& error) {
    fmt::print(stderr, "unstep: {}\n", error.what());
    return static_cast<int>(ExitCode::io);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "unstep: not enough memory\n");
    return static_cast<int>(ExitCode::bad_input);
  } catch (const std::exception& error) {
    fmt::print(stderr, "unstep: {}\n", error.what());
    return static_cast<int>(ExitCode::internal);
  }
}
