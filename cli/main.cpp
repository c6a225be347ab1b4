#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <initializer_list>
#include <string>

#include "cli/exit_code.h"
#include "cli/verbs.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

/// The verbs, in the order of --help.
constexpr std::initializer_list<AddVerb> kVerbs = {};

/// The name of the verb the user chose, to point at its help.
std::string help_command(const CLI::App& app) {
  std::string command = "unstep";
  for (const CLI::App* verb : app.get_subcommands()) {
    command += ' ' + verb->get_name();
  }
  return command + " --help";
}

ExitCode run(int argc, char** argv) {
  CLI::App app("Stores line art in small files, without loss.", "unstep");
  app.footer(kExitCodeHelp);
  app.set_version_flag(
      "--version",
      fmt::format("unstep {} (format {}, pre-release)", version(),
                  kFormatVersion),
      "Print the version of the program and of the file format");
  app.require_subcommand(1);
  Context context;
  for (const AddVerb add_verb : kVerbs) add_verb(app, context);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success);
    return ExitCode::ok;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "unstep: {} (see {})\n", error.what(),
               help_command(app));
    return ExitCode::usage;
  }
  return context.run();
}

}  // namespace
}  // namespace unstep::cli

int main(int argc, char** argv) {
  using unstep::cli::ExitCode;
  try {
    return static_cast<int>(unstep::cli::run(argc, argv));
  } catch (const std::exception& error) {
    // Nothing in the library throws; what arrives here is memory running out.
    fmt::print(stderr, "unstep: {}\n", error.what());
    return static_cast<int>(ExitCode::internal);
  }
}
