#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/program.h"
#include "cli/steps_job.h"
#include "cli/verbs.h"

namespace unstep::cli {
namespace {

constexpr const char* kStepsExamples =
    "  unstep steps part.ngc -o part.steps --step 0.005mm\n"
    "  unstep steps part.svg -o part.csv --method device\n"
    "  unstep steps part.ngc -o part.vcd --timed --acceleration 800\n"
    "  unstep steps recorded.vcd -o part.ngc --step 0.01mm   back again\n"
    "  unstep steps part.steps -o part.csv                   another format\n"
    "  unstep steps part.ngc -o part.dev                     for firmware\n";

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
    return reverse_stream(options);
  }
  const std::optional<StepFormat> format =
      step_format_of(options.to, options.output);
  const bool device = is_device(options.to, options.output);
  if (device) {
    if (names_steps(options)) {
      return report_usage("steps", "a device profile is made of paths");
    }
    options.axes = 2;
    options.make.method = Method::evaluation8;
    options.make.timed = false;
    return make_stream(std::move(options), std::nullopt);
  }
  if (!format) {
    return report_usage(
        "steps", fmt::format("{}: the name's ending is not steps, csv, vcd, "
                             "raw, dev or that of a program; say --to FORMAT",
                             options.output));
  }
  return names_steps(options) ? rewrite_stream(options, *format)
                              : make_stream(std::move(options), *format);
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
  verb->get_option("--no-arcs")
      ->description("Recorded steps become lines only")
      ->remove_needs(verb->get_option("--tolerance"));
  add_unit_size(*verb, options->draw);
  add_page(*verb, options->page);
  add_pixels(*verb, options->read);
  add_limits(*verb, options->read.limits);
  add_quiet(*verb, options->quiet);
  finish_verb(*verb, kStepsExamples);
  verb->callback([&context, options] {
    context.run = [options] { return steps(*options); };
  });
}

}  // namespace unstep::cli
