#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "cli/batch_job.h"
#include "cli/batch_report.h"
#include "cli/file_set.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "codec/thread_heap.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

struct BatchOptions {
  FileSetOptions files;
  JobOptions job;
  std::string report;
  bool decompress = false;
  bool no_record = false;
  bool quiet = false;
};

constexpr const char* kBatchExamples =
    "  unstep batch scans -o packed            the tree of scans/ in packed/\n"
    "  unstep batch 'scans/*/p*.tif' -o packed --resume --report log.json\n"
    "  unstep batch @list.txt -o packed        one path per line\n"
    "  find . -name '*.png' -print0 | unstep batch --list - -o packed\n"
    "  unstep batch --decompress packed -o back\n";

/// The progress of all workers as one line.
class BatchProgress {
 public:
  BatchProgress(const std::vector<BatchInput>& inputs, std::size_t workers,
                bool quiet)
      : files_(inputs.size()), in_flight_(workers), line_(quiet) {
    for (const BatchInput& input : inputs) total_ += input.bytes;
  }

  /// Worker `worker` has done a share of a file.
  bool update(std::size_t worker, double bytes, std::uint64_t pixels) {
    const std::lock_guard lock(mutex_);
    in_flight_[worker] = {bytes, pixels};
    draw();
    return !interrupted();
  }

  void finish_file(std::size_t worker, const JobResult& result) {
    const std::lock_guard lock(mutex_);
    in_flight_[worker] = {};
    ++finished_;
    bytes_ += static_cast<double>(result.input_bytes);
    if (result.status == JobResult::Status::done) pixels_ += result.pixels;
    if (result.status == JobResult::Status::failed) ++failed_;
    draw();
  }

 private:
  struct Share {
    double bytes = 0;
    std::uint64_t pixels = 0;
  };

  void draw() {
    double bytes = bytes_;
    std::uint64_t pixels = pixels_;
    for (const Share& share : in_flight_) {
      bytes += share.bytes;
      pixels += share.pixels;
    }
    std::string label =
        fmt::format("{} of {}", grouped(finished_), counted(files_, "file"));
    if (failed_ > 0) label += fmt::format(", {} failed", grouped(failed_));
    line_.update(label, total_ == 0 ? 0.0 : bytes / static_cast<double>(total_),
                 pixels);
  }

  const std::size_t files_;
  std::uint64_t total_ = 0;
  std::mutex mutex_;
  std::vector<Share> in_flight_;
  std::size_t finished_ = 0;
  std::size_t failed_ = 0;
  double bytes_ = 0;
  std::uint64_t pixels_ = 0;
  ProgressLine line_;
};

JobResult run_job(const BatchInput& input, const BatchOptions& options,
                  Claims& claims, const Listener& listener) {
  try {
    return options.decompress
               ? decompress_job(input, options.job, claims, listener)
               : compress_job(input, options.job, listener);
  } catch (const std::bad_alloc&) {
    JobResult result;
    result.status = JobResult::Status::failed;
    result.failed_path = input.path;
    result.error = {ErrorCode::limit_exceeded, "not enough memory"};
    return result;
  }
}

/// Runs every file once, `workers` at a time; stops early when interrupted.
std::vector<JobResult> run_jobs(const std::vector<BatchInput>& inputs,
                                const BatchOptions& options,
                                std::size_t workers) {
  std::vector<JobResult> results(inputs.size());
  std::atomic<std::size_t> next{0};
  Claims claims;
  BatchProgress progress(inputs, workers, options.quiet);
  const auto work = [&](std::size_t worker) {
    while (!interrupted()) {
      const std::size_t i = next.fetch_add(1);
      if (i >= inputs.size()) return;
      const auto bytes = static_cast<double>(inputs[i].bytes);
      results[i] =
          run_job(inputs[i], options, claims,
                  [&](double fraction, std::uint64_t pixels) {
                    return progress.update(worker, fraction * bytes, pixels);
                  });
      progress.finish_file(worker, results[i]);
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < workers; ++i) {
    threads.emplace_back([&work, i] {
      codec::prepare_thread_heap();
      work(i);
    });
  }
  work(0);
  threads.clear();
  return results;
}

Status check_outputs(const BatchOptions& options) {
  std::error_code ignored;
  const auto status =
      std::filesystem::status(options.job.output_folder, ignored);
  if (std::filesystem::exists(status) &&
      !std::filesystem::is_directory(status)) {
    return Error{ErrorCode::io_error, "is not a folder"};
  }
  return {};
}

ExitCode batch(BatchOptions options) {
  if (options.job.to && !options.decompress) {
    return report_usage("batch", "--to goes with --decompress");
  }
  if (options.files.arguments.empty() && options.files.lists.empty()) {
    return report_usage("batch", "no input is given");
  }
  options.job.record = !options.no_record;
  options.job.read.checksum = options.job.record || options.job.resume;
  options.files.output_folder = options.job.output_folder;
  options.files.ustp = options.decompress;
  if (const Status folder = check_outputs(options); !folder) {
    return report_error(output_name(options.job.output_folder), folder.error());
  }
  const bool renew = options.job.force || options.job.resume;
  if (!options.report.empty()) {
    const Status free = may_write(options.report, "-", renew);
    if (!free) return report_error(output_name(options.report), free.error());
  }
  Result<FileSet> files = collect_files(options.files);
  if (!files) return report_usage("batch", files.error().message);
  if (files->inputs.empty() && files->problems.empty()) {
    return report_usage("batch", options.decompress
                                     ? "there is no .ustp file in the inputs"
                                     : "there is no drawing in the inputs");
  }
  const auto jobs = static_cast<std::size_t>(options.job.read.jobs);
  const std::size_t workers =
      std::clamp<std::size_t>(files->inputs.size(), 1, jobs);
  // Fewer files than threads: the bands of each share what is left.
  options.job.jobs = static_cast<int>(jobs / workers);
  options.job.read.jobs = options.job.jobs;
  const Interruptible interruptible;
  BatchOutcome outcome;
  outcome.results = run_jobs(files->inputs, options, workers);
  outcome.inputs = std::move(files->inputs);
  outcome.problems = std::move(files->problems);
  outcome.passed_over = files->passed_over;
  outcome.decompress = options.decompress;
  const BatchTotals totals = sum_up(outcome);
  outcome.interrupted = interrupted() && totals.not_run > 0;
  print_outcome(outcome, options.quiet || options.report == "-");
  if (!options.report.empty()) {
    const std::string text = report_json(outcome, options.job.output_folder);
    const Status written = write_file(
        options.report,
        {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
        renew);
    if (!written) {
      return report_error(output_name(options.report), written.error());
    }
  }
  if (outcome.interrupted) return ExitCode::interrupted;
  return totals.failed > 0 ? ExitCode::some_failed : ExitCode::ok;
}

void add_batch_options(CLI::App& verb, BatchOptions& options) {
  verb.add_option("IN", options.files.arguments,
                  "Files, folders (with all below), quoted globs, or @LIST")
      ->type_name("");
  verb.add_option("-o,--output", options.job.output_folder,
                  "The folder to write to; made if needed")
      ->required()
      ->type_name("OUT_DIR");
  verb.add_option("--list", options.files.lists,
                  "Read paths from a file, one per line or separated by NUL; "
                  "- is standard input; may be repeated")
      ->type_name("FILE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb.add_flag("-d,--decompress", options.decompress,
                "The way back: .ustp files to the format of their name");
  verb.add_flag("--resume", options.job.resume,
                "Skip what is finished, renew what is damaged or made from "
                "another version of its source");
  verb.add_option("--report", options.report,
                  "Write what happened to each file as JSON; - is standard "
                  "output")
      ->type_name("FILE");
  verb.add_flag("--no-record", options.no_record,
                "Do not store the size and CRC of the source, which --resume "
                "needs; saves about 120 bytes a file");
}

}  // namespace

void add_batch(CLI::App& app, Context& context) {
  const auto options = std::make_shared<BatchOptions>();
  CLI::App* verb = app.add_subcommand(
      "batch", "Compress or decompress many files, on all cores");
  add_batch_options(*verb, *options);
  add_force(*verb, options->job.force);
  add_to(*verb, options->job.to);
  add_pixels(*verb, options->job.read);
  add_pack(*verb, options->job.pack);
  add_jobs(*verb, options->job.read.jobs);
  add_limits(*verb, options->job.read.limits);
  add_quiet(*verb, options->quiet);
  finish_verb(*verb, kBatchExamples);
  verb->callback([&context, options] {
    context.run = [options] { return batch(*options); };
  });
}

}  // namespace unstep::cli
