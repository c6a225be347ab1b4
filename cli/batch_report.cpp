#include "cli/batch_report.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/message.h"
#include "cli/output.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

using Json = nlohmann::ordered_json;
using JobStatus = JobResult::Status;

std::string_view status_name(JobStatus status) {
  switch (status) {
    case JobStatus::done: return "done";
    case JobStatus::skipped: return "skipped";
    case JobStatus::failed: return "failed";
    case JobStatus::not_run: return "not_run";
  }
  return "";
}

Json to_json(const Error& error) {
  return {{"code", to_string(error.code)}, {"message", error.message}};
}

Json to_json(const BatchInput& input, const JobResult& result) {
  Json json = {{"input", input.path},
               {"outputs", result.outputs},
               {"status", status_name(result.status)},
               {"input_bytes", result.input_bytes},
               {"output_bytes", result.output_bytes},
               {"pages", result.pages},
               {"pixels", result.pixels},
               {"lossless", result.lossless},
               {"pixel_work", result.pixel_work},
               {"notes", result.notes}};
  if (result.status == JobStatus::failed) json["error"] = to_json(result.error);
  return json;
}

}  // namespace

BatchTotals sum_up(const BatchOutcome& outcome) {
  BatchTotals totals;
  totals.files = outcome.inputs.size() + outcome.problems.size();
  totals.failed = outcome.problems.size();
  for (const JobResult& result : outcome.results) {
    switch (result.status) {
      case JobStatus::done:
        ++totals.done;
        totals.input_bytes += result.input_bytes;
        totals.output_bytes += result.output_bytes;
        totals.pixels += result.pixels;
        break;
      case JobStatus::skipped: ++totals.skipped; break;
      case JobStatus::failed: ++totals.failed; break;
      case JobStatus::not_run: ++totals.not_run; break;
    }
  }
  return totals;
}

void print_outcome(const BatchOutcome& outcome, bool quiet) {
  for (std::size_t i = 0; i < outcome.results.size() && !quiet; ++i) {
    for (const std::string& note : outcome.results[i].notes) {
      report_warning(printable(outcome.inputs[i].path), note);
    }
  }
  for (const BatchProblem& problem : outcome.problems) {
    report_error(printable(problem.path), problem.error);
  }
  for (const JobResult& result : outcome.results) {
    if (result.status != JobStatus::failed) continue;
    report_error(printable(result.failed_path), result.error);
  }
  const BatchTotals totals = sum_up(outcome);
  if (outcome.interrupted) {
    fmt::print(stderr,
               "unstep: interrupted; {} not finished, --resume goes on\n",
               counted(totals.not_run, "file"));
  }
  if (quiet) return;
  std::string line = fmt::format(
      "{}: {} {}", counted(totals.files, "file"), grouped(totals.done),
      outcome.decompress ? "decompressed" : "compressed");
  if (totals.skipped > 0) {
    line += fmt::format(", {} finished before", grouped(totals.skipped));
  }
  if (totals.failed > 0)
    line += fmt::format(", {} failed", grouped(totals.failed));
  if (totals.done > 0) {
    line += fmt::format("; {} -> {}", counted(totals.input_bytes, "byte"),
                        counted(totals.output_bytes, "byte"));
  }
  if (totals.done > 0 && !outcome.decompress) {
    line +=
        fmt::format(" ({})", per_cent(totals.output_bytes, totals.input_bytes));
  }
  fmt::print("{}\n", line);
  if (outcome.passed_over > 0) {
    fmt::print("{} of other kinds passed over\n",
               counted(outcome.passed_over, "file"));
  }
}

std::string report_json(const BatchOutcome& outcome,
                        const std::string& output_folder) {
  const BatchTotals totals = sum_up(outcome);
  Json files = Json::array();
  for (const BatchProblem& problem : outcome.problems) {
    files.push_back({{"input", problem.path},
                     {"status", status_name(JobStatus::failed)},
                     {"error", to_json(problem.error)}});
  }
  for (std::size_t i = 0; i < outcome.results.size(); ++i) {
    files.push_back(to_json(outcome.inputs[i], outcome.results[i]));
  }
  const Json report = {{"program", "unstep"},
                       {"version", version()},
                       {"work", outcome.decompress ? "decompress" : "compress"},
                       {"output_folder", output_folder},
                       {"interrupted", outcome.interrupted},
                       {"totals",
                        {{"files", totals.files},
                         {"done", totals.done},
                         {"skipped", totals.skipped},
                         {"failed", totals.failed},
                         {"not_run", totals.not_run},
                         {"passed_over", outcome.passed_over},
                         {"input_bytes", totals.input_bytes},
                         {"output_bytes", totals.output_bytes},
                         {"pixels", totals.pixels}}},
                       {"files", std::move(files)}};
  return dump(report) + '\n';
}

}  // namespace unstep::cli
