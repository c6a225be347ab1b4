#pragma once

#include <string>
#include <vector>

#include "cli/batch_job.h"
#include "cli/exit_code.h"
#include "cli/file_set.h"

/// What a batch tells at its end.
namespace unstep::cli {

/// The inputs, their results in the same order, and what gave no input.
struct BatchOutcome {
  std::vector<BatchInput> inputs;
  std::vector<JobResult> results;
  std::vector<BatchProblem> problems;
  std::uint64_t passed_over = 0;
  bool decompress = false;
  bool interrupted = false;
};

/// The sums of a batch.
struct BatchTotals {
  std::uint64_t files = 0;
  std::uint64_t done = 0;
  std::uint64_t skipped = 0;
  std::uint64_t failed = 0;  ///< problems included
  std::uint64_t not_run = 0;
  std::uint64_t input_bytes = 0;  ///< of the files done
  std::uint64_t output_bytes = 0;
  std::uint64_t pixels = 0;
};

[[nodiscard]] BatchTotals sum_up(const BatchOutcome& outcome);

/// Warnings and one line per failure on stderr, the sums on stdout.
void print_outcome(const BatchOutcome& outcome, bool quiet);

/// The --report file.
[[nodiscard]] std::string report_json(const BatchOutcome& outcome,
                                      const std::string& output_folder);

}  // namespace unstep::cli
