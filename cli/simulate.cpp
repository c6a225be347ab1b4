#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/file_output.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/page_writer.h"
#include "cli/simulate_plot.h"
#include "cli/simulate_run.h"
#include "cli/source.h"
#include "cli/verbs.h"

namespace unstep::cli {
namespace {

constexpr const char* kSimulateExamples =
    "  unstep simulate plan.ustp                       drawn at 1 mm/s\n"
    "  unstep simulate part.svg --grid 0.1mm --speed 5 --plot path.svg\n"
    "  unstep simulate scan.png --exposure plate.png   and compared\n"
    "  unstep simulate scan.png --machine esu --exposure film.png\n"
    "  unstep simulate plan.ustp --machine esu --direction write --plot p.svg\n"
    "\n"
    "docs/machines.md says what is modelled.\n";

ExitCode write_plot(const SimulateOptions& options, const Run& run) {
  if (options.plot.empty()) return ExitCode::ok;
  FileOutput output(options.plot, options.force);
  Status status = output.sink()(plot_svg(*run.commanded, *run.followed));
  if (status) status = output.commit();
  return status ? ExitCode::ok
                : report_error(output_name(options.plot), status.error());
}

ExitCode write_exposure(const SimulateOptions& options, OutputFormat format,
                        Run& run) {
  FileOutput output(options.exposure, options.force);
  std::vector<std::string> notes;
  Result<PageWriter> writer = PageWriter::create(
      format, output.sink(), {}, Effort::standard, options.read.limits);
  if (!writer)
    return report_error(output_name(options.exposure), writer.error());
  Page page;
  page.ink = *std::move(run.exposure);
  Status status = writer->add(std::move(page), notes);
  if (status) status = writer->finish();
  if (status) status = output.commit();
  return status ? ExitCode::ok
                : report_error(output_name(options.exposure), status.error());
}

/// What is wrong with the options together; empty if nothing is.
std::string problem(const SimulateOptions& options) {
  if (options.machine != "zenit" && options.machine != "esu")
    return fmt::format("--machine: '{}' is neither zenit nor esu",
                       options.machine);
  if (options.write && options.machine != "esu")
    return "--direction is for esu";
  const auto format = format_of_name(options.exposure);
  if (!options.exposure.empty() && !(format && raster_format(*format)))
    return "--exposure: the name's ending is not .pbm, .png or .tiff";
  return {};
}

ExitCode simulate(const SimulateOptions& options) {
  if (const std::string wrong = problem(options); !wrong.empty())
    return report_usage("simulate", wrong);
  for (const std::string& path : {options.plot, options.exposure}) {
    if (path.empty()) continue;
    const Status free = may_write(path, options.input, options.force);
    if (!free) return report_error(output_name(path), free.error());
  }
  const std::string name = input_name(options.input);
  const Interruptible interruptible;
  Result<Source> source = Source::open(options.input, options.read);
  if (!source) return report_error(name, source.error());
  if (options.page > source->page_count())
    return report_error(
        name,
        {ErrorCode::invalid_argument,
         fmt::format("has {}, no page {}",
                     counted(source->page_count(), "page"), options.page)});
  Result<SourcePage> read = source->read(options.page - 1);
  if (!read) return report_error(name, read.error());
  std::vector<std::string> notes = read->notes;
  const Result<Page> page = as_steps(std::move(read->page), options);
  if (!page) return report_error(name, page.error());
  Result<Run> run = options.machine == "esu" ? run_esu(*page, options, notes)
                                             : run_zenit(*page, options, notes);
  if (!run) return report_error(name, run.error());
  ExitCode code = write_plot(options, *run);
  if (code == ExitCode::ok && !options.exposure.empty())
    code = write_exposure(options, *format_of_name(options.exposure), *run);
  if (code != ExitCode::ok) return code;
  if (!options.quiet)
    for (const std::string& note : notes) report_warning(name, note);
  if (options.json)
    fmt::print("{}\n", dump(run->json));
  else if (!options.quiet)
    fmt::print("{}", run->text);
  return ExitCode::ok;
}

}  // namespace

void add_simulate(CLI::App& app, Context& context) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* verb = app.add_subcommand(
      "simulate", "Let a machine with inertia and noise follow a drawing");
  add_input(*verb, options->input,
            "The drawing, of any format; - is standard input");
  verb->add_option("--machine", options->machine,
                   "zenit, a laser on a carriage, or esu, a scanner [zenit]")
      ->type_name("NAME");
  verb->add_option_function<std::string>(
          "--direction",
          [options](const std::string& way) {
            options->write = way == "write";
          },
          "esu: scan, the drawing is on the film, or write, it is exposed "
          "[scan]")
      ->check(CLI::IsMember({"scan", "write"}))
      ->type_name("WAY");
  verb->add_option("--plot", options->plot,
                   "Commanded and followed path as an SVG file; of esu the "
                   "contours of the drawing and of what was made")
      ->type_name("FILE");
  verb->add_option(
          "--exposure", options->exposure,
          "What was exposed, written or scanned, as a .png, .pbm or .tiff file")
      ->type_name("FILE");
  verb->add_option("--speed", options->speed_mm,
                   "zenit: mm/s along the path, 0.02 to 100; more than 10 is "
                   "above the machine's limit [1]")
      ->check(CLI::Range(0.02, 100.0))
      ->type_name("SPEED");
  verb->add_option("--noise", options->noise,
                   "Noise of the machine, 0 to 10 times the usual [1]")
      ->check(CLI::Range(0.0, 10.0))
      ->type_name("FACTOR");
  add_number(*verb, "--unit", options->unit_um, 2, 1000,
             "zenit: micrometres a grid unit, 2 to 1000 [4]");
  add_number(*verb, "--seed", options->seed, 0, 0x7fffffff,
             "Of the noise; the same seed gives the same run [1]");
  add_page(*verb, options->page);
  add_input_kind(*verb, options->read);
  add_limits(*verb, options->read.limits);
  add_json(*verb, options->json);
  add_force(*verb, options->force);
  add_quiet(*verb, options->quiet);
  finish_verb(*verb, kSimulateExamples);
  verb->callback([&context, options] {
    context.run = [options] { return simulate(*options); };
  });
}

}  // namespace unstep::cli
