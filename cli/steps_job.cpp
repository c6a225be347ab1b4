#include "cli/steps_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include "cli/file_output.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/source.h"

namespace unstep::cli {
namespace {

//// What was written.
struct Written {
  std::uint64_t steps = 0;
  double ticks = 0;
  std::uint64_t bytes = 0;
  void add(const StepRun& run) {
    steps += run.words.size();
    for (const std::uint32_t wait : run.waits) ticks += wait;
  }
};

void report(const StepsOptions& options, const StepHead& head,
            const Written& written, const std::vector<std::string>& notes) {
  if (options.quiet) return;
  for (const std::string& note : notes) {
    report_warning(input_name(options.input), note);
  }
  std::string line =
      fmt::format("{} -> {}: {}, {} axes, {}", input_name(options.input),
                  output_name(options.output), counted(written.steps, "step"),
                  head.axes, counted(written.bytes, "byte"));
  if (head.clock > 0) {
    line += fmt::format(", {:.3f} s", written.ticks / head.clock);
  }
  fmt::print(options.output == "-" ? stderr : stdout, "{}\n", line);
}

bool moves_z(const Program& program) {
  const auto moves = program_moves(program, true);
  if (!moves) return false;
  for (const ProgramMove& move : *moves) {
    if (move.start[2] != move.end[2]) return true;
  }
  return false;
}

/// What firmware draws itself; proven by drawing it here.
ExitCode write_device(const StepsOptions& options, const Program& program,
                      const std::vector<std::string>& notes) {
  const std::string name = input_name(options.input);
  const Result<std::string> bytes = write_device_profile(program, options.make);
  if (!bytes) return report_error(name, bytes.error());
  StepReadOptions how;
  how.head = step_head(options.make);
  how.max_steps = options.make.max_steps;
  const Result<StepStream> drawn = read_device_profile(*bytes, how);
  if (!drawn) {
    return report_error(name, {ErrorCode::internal, drawn.error().message});
  }
  const Status written = write_file(
      options.output,
      {reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()},
      options.force);
  if (!written) {
    return report_error(output_name(options.output), written.error());
  }
  Written all;
  for (const StepRun& run : drawn->runs) all.add(run);
  all.bytes = bytes->size();
  report(options, drawn->head, all, notes);
  return ExitCode::ok;
}

Result<StepStream> read_stream(const StepsOptions& options) {
  const Result<std::vector<std::uint8_t>> bytes =
      read_file(options.input, options.read.limits.max_memory);
  if (!bytes) return bytes.error();
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()),
                              bytes->size());
  StepReadOptions how;
  how.head.step = options.make.step;
  how.head.axes = options.axes == 0 ? 2 : options.axes;
  how.max_steps = std::min(options.read.limits.max_steps,
                           options.read.limits.max_memory / 8);
  if (is_device(options.from, options.input)) {
    return read_device_profile(text, how);
  }
  const std::optional<StepFormat> named =
      step_format_of(options.from, options.input);
  return read_steps(text, named ? *named : recognise_steps(text), how);
}

}  // namespace

// A device profile (src/firmware/unstep_steps.h).
bool is_device(const std::string& word, const std::string& path) {
  return word == "device" || (word.empty() && has_suffix(path, ".dev"));
}

std::optional<StepFormat> step_format_of(const std::string& word,
                                         const std::string& path) {
  const auto is = [&](const char* name, const char* ending) {
    return word == name || (word.empty() && has_suffix(path, ending));
  };
  if (is("binary", ".steps")) return StepFormat::binary;
  if (is("csv", ".csv")) return StepFormat::csv;
  if (is("vcd", ".vcd")) return StepFormat::vcd;
  if (is("raw", ".raw")) return StepFormat::raw;
  return std::nullopt;
}

/// 1e-7 mm.
Result<std::int64_t> step_length(const Quantity& step) {
  if (step.unit == Quantity::Unit::grid) {
    return Error{ErrorCode::invalid_argument, "give --step in mm or in"};
  }
  const double mm =
      step.unit == Quantity::Unit::inch ? step.value * 25.4 : step.value;
  if (!(mm >= 1e-7) || !(mm <= 1e5)) {
    return Error{ErrorCode::invalid_argument,
                 "a step is 0.0000001 mm to 100 m long"};
  }
  return std::llround(mm * static_cast<double>(kProgramUnitsPerMm));
}

bool names_steps(const StepsOptions& options) {
  return !options.from.empty() || is_device("", options.input) ||
         step_format_of("", options.input).has_value();
}

ExitCode make_stream(StepsOptions options, std::optional<StepFormat> format) {
  const std::string name = input_name(options.input);
  Result<Source> source = Source::open(options.input, options.read);
  if (!source) return report_error(name, source.error());
  if (options.page < 1 || options.page > source->page_count()) {
    return report_usage("steps",
                        fmt::format("{} has no page {}", name, options.page));
  }
  Result<SourcePage> page = source->read(options.page - 1);
  if (!page) return report_error(name, page.error());
  std::vector<std::string> notes = std::move(page->notes);
  options.draw.draw.profile = GcodeProfile::laser;
  options.draw.draw.decimals = 7;
  const bool is_program = page->page.kind == PageKind::program;
  Result<Program> program = program_of_page(
      std::move(page->page), {{}, 0, options.read, Effort::standard},
      options.draw, options.program.read, options.lines, notes);
  if (!program) return report_error(name, program.error());
  options.make.axes = options.axes != 0                 ? options.axes
                      : is_program && moves_z(*program) ? 3
                                                        : 2;
  if (options.make.axes == 2 && is_program && moves_z(*program)) {
    notes.emplace_back("Z is not in steps of 2 axes");
  }
  options.make.skip_unknown = options.skip_unknown;
  if (!format) return write_device(options, *program, notes);
  FileOutput output(options.output, options.force);
  Written written;
  const ByteSink sink = output.sink();
  const StepHead head = step_head(options.make);
  Result<StepWriter> made =
      StepWriter::create(*format, head, [&](std::string_view bytes) {
        written.bytes += bytes.size();
        return sink(bytes);
      });
  if (!made) return report_error(name, made.error());
  const Status done =
      make_steps(*program, options.make, [&](const StepRun& run) {
        written.add(run);
        return made->add(run);
      });
  Status ended = done ? made->finish() : done;
  if (ended) ended = output.commit();
  if (!output.status()) {
    return report_error(output_name(options.output), output.status().error());
  }
  if (!ended) return report_error(name, ended.error());
  report(options, head, written, notes);
  return ExitCode::ok;
}

ExitCode reverse_stream(const StepsOptions& options) {
  const std::string name = input_name(options.input);
  const Result<StepStream> stream = read_stream(options);
  if (!stream) return report_error(name, stream.error());
  StepReverseOptions how = options.back;
  how.method = options.make.method;
  how.arcs = options.lines.arcs;
  const Result<Program> program = reverse_steps(*stream, how);
  if (!program) return report_error(name, program.error());
  StepMakeOptions again;
  again.step = stream->head.step;
  again.axes = stream->head.axes;
  again.method = how.method;
  again.origin = stream->head.origin;
  const Result<StepStream> same = make_steps(*program, again);
  if (!same) return report_error(name, same.error());
  std::vector<StepRun> given = stream->runs;
  for (StepRun& run : given) run.waits.clear();
  if (same->runs != given) {
    return report_error(
        name, {ErrorCode::internal, "the program does not make these steps"});
  }
  const Result<WrittenProgram> made =
      write_program(*program, options.program, options.lines);
  if (!made) return report_error(name, made.error());
  const std::span<const std::uint8_t> out(
      reinterpret_cast<const std::uint8_t*>(made->text.data()),
      made->text.size());
  const Status written = write_file(options.output, out, options.force);
  if (!written)
    return report_error(output_name(options.output), written.error());
  if (options.quiet) return ExitCode::ok;
  Written all;
  for (const StepRun& run : stream->runs) all.add(run);
  fmt::print(options.output == "-" ? stderr : stdout,
             "{} -> {}: {} -> {}, {}\n", name, output_name(options.output),
             counted(all.steps, "step"), made->summary,
             counted(made->text.size(), "byte"));
  return ExitCode::ok;
}

ExitCode rewrite_stream(const StepsOptions& options, StepFormat format) {
  const std::string name = input_name(options.input);
  const Result<StepStream> stream = read_stream(options);
  if (!stream) return report_error(name, stream.error());
  const Result<std::string> bytes = write_steps(*stream, format);
  if (!bytes) return report_error(name, bytes.error());
  const Status written = write_file(
      options.output,
      {reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()},
      options.force);
  if (!written)
    return report_error(output_name(options.output), written.error());
  Written all;
  for (const StepRun& run : stream->runs) all.add(run);
  all.bytes = bytes->size();
  report(options, stream->head, all, {});
  return ExitCode::ok;
}

}  // namespace unstep::cli
