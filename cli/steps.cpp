#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "cli/draw_program.h"
#include "cli/file_output.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/program.h"
#include "cli/reshape.h"
#include "cli/source.h"
#include "cli/verbs.h"
#include "unstep/step_stream.h"

namespace unstep::cli {
namespace {

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

constexpr const char* kExamples =
    "  unstep steps part.ngc -o part.steps --step 0.005mm\n"
    "  unstep steps part.svg -o part.csv --method device\n"
    "  unstep steps part.ngc -o part.vcd --timed --acceleration 800\n"
    "  unstep steps recorded.vcd -o part.ngc --step 0.01mm   back again\n"
    "  unstep steps part.steps -o part.csv                   another format\n"
    "  unstep steps part.ngc -o part.dev                     for firmware\n";

/// A device profile (src/firmware/unstep_steps.h).
bool is_device(const std::string& word, const std::string& path) {
  return word == "device" || (word.empty() && has_suffix(path, ".dev"));
}

std::optional<StepFormat> format_of(const std::string& word,
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

/// What was written.
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

/// Any path to steps.
ExitCode make(StepsOptions options, std::optional<StepFormat> format) {
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
      format_of(options.from, options.input);
  return read_steps(text, named ? *named : recognise_steps(text), how);
}

/// A recorded stream to a program, proven by making the steps again.
ExitCode reverse(const StepsOptions& options) {
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

/// A stream to another format.
ExitCode rewrite(const StepsOptions& options, StepFormat format) {
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

bool names_steps(const StepsOptions& options) {
  return !options.from.empty() || is_device("", options.input) ||
         format_of("", options.input).has_value();
}

ExitCode steps(StepsOptions options) {
  const std::optional<Method> method = find_method(options.method);
  if (!method) {
    return report_usage("steps",
                        fmt::format("unknown method '{}'; unstep interpolate "
                                    "--list shows them",
                                    options.method));
  }
  options.make.method = *method;
  const Result<std::int64_t> step = step_length(options.step);
  if (!step) return report_usage("steps", step.error().message);
  options.make.step = *step;
  const Status free = may_write(options.output, options.input, options.force);
  if (!free) return report_error(output_name(options.output), free.error());
  if (names_program(options.output) || options.to == "ngc") {
    if (names_program(options.input)) {
      return report_usage("steps", "both files are programs");
    }
    return reverse(options);
  }
  const std::optional<StepFormat> format =
      format_of(options.to, options.output);
  const bool device = is_device(options.to, options.output);
  if (device) {
    if (names_steps(options)) {
      return report_usage("steps", "a device profile is made of paths");
    }
    options.axes = 2;
    options.make.method = Method::evaluation8;
    options.make.timed = false;
    return make(std::move(options), std::nullopt);
  }
  if (!format) {
    return report_usage(
        "steps", fmt::format("{}: the name's ending is not steps, csv, vcd, "
                             "raw, dev or that of a program; say --to FORMAT",
                             options.output));
  }
  return names_steps(options) ? rewrite(options, *format)
                              : make(std::move(options), *format);
}

void add_number_of(CLI::App& verb, const char* name, double& value,
                   const char* help) {
  verb.add_option(name, value, help)->type_name("NUMBER");
}

void add_timing(CLI::App& verb, StepsOptions& options) {
  StepTiming& timing = options.make.timing;
  verb.add_flag("--timed", options.make.timed,
                "Steps come when a machine with these limits makes them");
  verb.add_option("--clock", timing.clock, "Ticks per second [1000000]")
      ->type_name("HZ");
  verb.add_option_function<double>(
          "--feed",
          [&options](double feed) {
            options.make.timing.feed = options.back.feed = feed;
          },
          "mm/min where the path has none; of programs from untimed steps "
          "[1000]")
      ->type_name("NUMBER");
  add_number_of(verb, "--rapid", timing.rapid, "mm/min of rapids [5000]");
  add_number_of(verb, "--acceleration", timing.acceleration,
                "mm/s^2, 0 without a limit [500]");
  add_number_of(verb, "--corner", timing.corner,
                "mm by which a corner may be thought cut [0.01]");
}

}  // namespace

void add_steps(CLI::App& app, Context& context) {
  const auto options = std::make_shared<StepsOptions>();
  CLI::App* verb = app.add_subcommand(
      "steps", "Turn a path into step and direction pulses, and back");
  add_input(*verb, options->input,
            "A program, a drawing, or a stream of steps (.steps, .csv, .vcd, "
            ".raw, .dev)");
  verb->add_option("-o,--output", options->output,
                   "The file to write: .steps, .csv, .vcd, .raw, .dev, or a "
                   "program")
      ->required()
      ->type_name("OUT");
  add_force(*verb, options->force);
  verb->add_option("--from", options->from,
                   "IN is a stream: binary, csv, vcd, raw or device")
      ->check(CLI::IsMember({"binary", "csv", "vcd", "raw", "device"}))
      ->type_name("FORMAT");
  verb->add_option("--to", options->to, "binary, csv, vcd, raw, device or ngc")
      ->check(CLI::IsMember({"binary", "csv", "vcd", "raw", "device", "ngc"}))
      ->type_name("FORMAT");
  verb->add_option_function<std::string>(
          "--step",
          [options](const std::string& text) {
            const Result<Quantity> step = parse_quantity(text);
            if (!step) {
              throw CLI::ValidationError("--step", step.error().message);
            }
            options->step = *step;
          },
          "Length of a step [0.01mm]")
      ->type_name("LENGTH");
  verb->add_option("--axes", options->axes,
                   "2 or 3 [3 where a program moves Z]")
      ->check(CLI::Range(2, 3))
      ->type_name("N");
  verb->add_option("--method", options->method,
                   "Interpolator of lines of 2 axes [evaluation8]")
      ->type_name("NAME");
  verb->add_flag("--skip-unknown", options->skip_unknown,
                 "Programs: leave out what is not understood");
  add_timing(*verb, *options);
  add_lines(*verb, options->lines);
  add_unit_size(*verb, options->draw);
  add_page(*verb, options->page);
  add_threshold(*verb, options->read.threshold);
  add_limits(*verb, options->read.limits);
  add_quiet(*verb, options->quiet);
  finish_verb(*verb, kExamples);
  verb->callback([&context, options] {
    context.run = [options] { return steps(*options); };
  });
}

}  // namespace unstep::cli
