#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/draw_program.h"
#include "cli/exit_code.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/quantity.h"
#include "unstep/step_stream.h"

/// What the verb steps does, once its options are known.
namespace unstep::cli {

struct StepsOptions {
  std::string input;
  std::string output;
  std::string from;
  std::string to;
  Quantity step{0.01, Quantity::Unit::millimetre};
  int axes = 0;  ///< 0: 3 where a program moves z
  std::string method = "evaluation8";
  StepMakeOptions make;
  StepReverseOptions back;
  bool skip_unknown = false;
  DrawOptions draw;
  ProgramOptions program;
  LineOptions lines;
  InputOptions read;
  std::uint64_t page = 1;
  bool quiet = false;
  bool force = false;
};

/// The format of an option's word or, if it is empty, of a name's ending.
[[nodiscard]] std::optional<StepFormat> step_format_of(const std::string& word,
                                                       const std::string& path);

/// The same for a device profile (src/firmware/unstep_steps.h).
[[nodiscard]] bool is_device(const std::string& word, const std::string& path);

/// In 1e-7 mm.
Result<std::int64_t> step_length(const Quantity& step);

/// Whether the input is a stream of steps.
[[nodiscard]] bool names_steps(const StepsOptions& options);

/// Any path to steps; without a format to a device profile.
ExitCode make_stream(StepsOptions options, std::optional<StepFormat> format);

/// A recorded stream to a program, proven by making the steps again.
ExitCode reverse_stream(const StepsOptions& options);

/// A stream to another format.
ExitCode rewrite_stream(const StepsOptions& options, StepFormat format);

}  // namespace unstep::cli
