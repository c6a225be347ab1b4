#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <utility>

#include "cli/draw_program.h"
#include "cli/file_output.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/source.h"
#include "cli/unpack.h"
#include "cli/verbs.h"

namespace unstep::cli {
namespace {

struct ConvertOptions {
  std::string input;
  std::string output;
  std::optional<OutputFormat> to;
  std::uint64_t page = 0;  ///< 1-based; 0: all
  InputOptions read;
  LineOptions lines;
  ProgramOptions program;
  DrawOptions draw;
  Effort effort = Effort::standard;
  bool quiet = false;
  bool force = false;
};

constexpr const char* kConvertExamples =
    "  unstep convert scan.png scan.svg               contours, pixel for "
    "pixel\n"
    "  unstep convert scan.png scan.svg --tolerance 1 lines and arcs\n"
    "  unstep convert part.svg part.dxf               vertices as they are\n"
    "  unstep convert part.dxf part.png --grid 0.1mm  drawn, 0.1 mm a pixel\n"
    "  unstep convert plan.ustp plan.pdf\n"
    "  unstep convert in.ngc out.ngc --tolerance 0.005mm  fewer, longer moves\n"
    "  unstep convert logo.svg logo.nc --profile laser --feed 1500mm\n"
    "  unstep convert in.ngc in.svg                   what a program draws\n"
    "  unstep convert - - --to hpgl --tolerance 1 < scan.pbm > scan.plt\n";

/// Warnings are about the file that they come from.
void warn(const ConvertOptions& options,
          const std::vector<std::string>& notes) {
  if (options.quiet) return;
  for (const std::string& note : notes) {
    report_warning(input_name(options.input), note);
  }
}

/// One output file: reads, turns and writes its pages.
Status write_file_of(const ConvertOptions& options, Source& source,
                     const OutputFile& file, FileOutput& output,
                     ProgressLine& line, std::vector<std::string>& notes) {
  const std::size_t count = source.page_count();
  std::size_t done = 0;
  const auto give = [&](std::size_t index) -> Result<Page> {
    Result<SourcePage> page = source.read(index);
    if (!page) return page.error();
    for (const std::string& note : page->notes) {
      notes.push_back(on_page(index, count, note));
    }
    if (index + 1 == count) source.release();
    return std::move(page->page);
  };
  const auto next = [&] {
    ++done;
    line.update(
        input_name(options.input),
        static_cast<double>(done) / static_cast<double>(file.pages.size()), 0);
    return !interrupted();
  };
  Result<PageWriter> writer =
      PageWriter::create(*options.to, output.sink(), options.lines,
                         options.effort, options.read.limits);
  if (!writer) return writer.error();
  const Status unpacked =
      unpack(give, count, file.pages, std::move(*writer), next, notes);
  return unpacked ? output.commit() : unpacked;
}

Result<std::vector<OutputFile>> plan_output(const ConvertOptions& options,
                                            const Source& source) {
  std::vector<std::size_t> pages(source.page_count());
  std::iota(pages.begin(), pages.end(), std::size_t{0});
  if (options.page > pages.size()) {
    return Error{ErrorCode::invalid_argument,
                 fmt::format("has {}, no page {}",
                             counted(pages.size(), "page"), options.page)};
  }
  if (options.page != 0) pages = {options.page - 1};
  const bool to_stdout = options.output == "-";
  std::vector<OutputFile> files =
      plan_files(options.output, pages, *options.to, to_stdout);
  if (to_stdout && files.size() > 1) {
    return Error{
        ErrorCode::invalid_argument,
        fmt::format("has {}, and standard output takes one {} file; "
                    "choose --page N",
                    counted(pages.size(), "page"), extension(*options.to))};
  }
  return files;
}

ExitCode write_files(const ConvertOptions& options, Source& source,
                     const std::vector<OutputFile>& files) {
  const std::string name = input_name(options.input);
  ProgressLine line(options.quiet);
  for (const OutputFile& file : files) {
    FileOutput output(file.path, options.force);
    std::vector<std::string> notes;
    const Status written =
        write_file_of(options, source, file, output, line, notes);
    line.finish();
    if (!output.status()) {
      return report_error(output_name(file.path), output.status().error());
    }
    if (!written) return report_error(name, written.error());
    warn(options, notes);
  }
  return ExitCode::ok;
}

ExitCode convert(ConvertOptions options) {
  if (names_program(options.input) && names_program(options.output)) {
    return convert_program(
        {options.input, options.output, options.force, options.quiet},
        options.program, options.lines);
  }
  if (names_program(options.output) && !options.to) {
    return convert_to_program(
        {{options.input, options.output, options.force, options.quiet},
         options.page,
         options.read,
         options.effort},
        options.draw, options.program, options.lines);
  }
  if (!options.to) {
    if (options.output == "-") {
      return report_usage("convert", "standard output needs --to FORMAT");
    }
    if (has_suffix(options.output, ".ustp")) {
      return report_usage("convert", ".ustp files are made by compress");
    }
    options.to = format_of_name(options.output);
    if (!options.to) {
      return report_usage(
          "convert",
          fmt::format("{}: the name's ending is not {}; say --to FORMAT",
                      options.output, format_words()));
    }
  }
  const std::string name = input_name(options.input);
  const Interruptible interruptible;
  Result<Source> source = Source::open(options.input, options.read);
  if (!source) return report_error(name, source.error());
  const Result<std::vector<OutputFile>> files = plan_output(options, *source);
  if (!files) return report_error(name, files.error());
  for (const OutputFile& file : *files) {
    const Status free = may_write(file.path, options.input, options.force);
    if (!free) return report_error(output_name(file.path), free.error());
  }
  const ExitCode code = write_files(options, *source, *files);
  if (code == ExitCode::ok && !options.quiet) {
    std::string written = output_name(files->front().path);
    if (files->size() > 1) {
      written += " ... " + output_name(files->back().path);
    }
    std::size_t pages = 0;
    for (const OutputFile& file : *files) pages += file.pages.size();
    fmt::print(options.output == "-" ? stderr : stdout, "{} -> {}: {}\n", name,
               written, counted(pages, "page"));
  }
  return code;
}

}  // namespace

void add_convert(CLI::App& app, Context& context) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* verb = app.add_subcommand(
      "convert", "Turn a drawing of any format into another format");
  add_input(*verb, options->input,
            "The drawing: a raster, SVG, DXF, HPGL, JSON, Freeman text, a "
            "program or .ustp; - is standard input");
  verb->add_option("OUT", options->output,
                   "The file to write; - is standard output")
      ->required()
      ->type_name("");
  add_force(*verb, options->force);
  add_to(*verb, options->to);
  add_page(*verb, options->page);
  add_lines(*verb, options->lines);
  add_effort(*verb, options->effort);
  add_program(*verb, options->program);
  add_draw(*verb, options->draw);
  add_input_kind(*verb, options->read);
  add_jobs(*verb, options->read.jobs);
  add_limits(*verb, options->read.limits);
  add_quiet(*verb, options->quiet);
  finish_verb(*verb, kConvertExamples);
  verb->callback([&context, options] {
    context.run = [options] { return convert(*options); };
  });
}

}  // namespace unstep::cli
