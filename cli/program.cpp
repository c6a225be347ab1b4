#include "cli/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <span>
#include <vector>

#include "cli/message.h"
#include "cli/output.h"
#include "cli/reshape.h"
#include "unstep/formats.h"

namespace unstep::cli {
namespace {

using BlockDelete = GcodeReadOptions::BlockDelete;
using ArcForm = GcodeWriteOptions::ArcForm;

template <class Value>
void add_choice(CLI::App& verb, const char* name, Value& value,
                const std::map<std::string, Value>& words, const char* help) {
  verb.add_option(name, value, help)
      ->transform(
          CLI::CheckedTransformer(words, CLI::ignore_case).description(""))
      ->type_name("WORD");
}

Result<double> tolerance_mm(const LineOptions& lines) {
  switch (lines.tolerance.unit) {
    case Quantity::Unit::millimetre: return lines.tolerance.value;
    case Quantity::Unit::inch: return lines.tolerance.value * 25.4;
    default:
      return Error{ErrorCode::invalid_argument,
                   "a program has no pixels: give --tolerance in mm or in"};
  }
}

/// The last decimal of what was written, in 1e-7 mm, and a little more.
std::int64_t slack(const GcodeWriteOptions& options) {
  if (options.decimals < 0 && !options.inches) return 254;
  int decimals = options.decimals;
  if (decimals < 0) decimals = *options.inches ? 5 : 4;
  std::int64_t unit = 254'000'000;
  for (int i = 0; i < decimals; ++i) unit /= 10;
  return unit + 254;
}

/// What was written, read again: every motion ends where it should. Arcs that
/// were written in pieces have ends between.
Status check_written(const Program& program, const std::string& text,
                     const ProgramOptions& options) {
  const auto broken = [](const std::string& reason) {
    return Error{ErrorCode::internal, "the written program differs: " + reason};
  };
  const Result<Program> again = read_gcode(text, options.read);
  if (!again) return broken(again.error().message);
  const auto before = program_moves(program, true);
  const auto after = program_moves(*again, true);
  if (!before || !after) return broken("its motions cannot be told");
  const std::int64_t near = slack(options.write);
  const bool pieces = options.write.arcs == ArcForm::radius;
  std::size_t at = 0;
  for (const ProgramMove& move : *before) {
    const auto same = [&](const ProgramMove& other) {
      return move.kind == other.kind &&
             std::equal(move.end.begin(), move.end.end(), other.end.begin(),
                        [near](std::int64_t a, std::int64_t b) {
                          return std::abs(a - b) <= near;
                        });
    };
    while (pieces && at < after->size() && !same((*after)[at])) ++at;
    if (at == after->size() || !same((*after)[at])) {
      return broken(fmt::format("line {} of the input", move.line));
    }
    ++at;
  }
  if (!pieces && at != after->size()) return broken("more motions");
  return {};
}

std::string summary(const CompactReport& report, bool shortened) {
  if (!shortened) return counted(report.lines_before, "motion");
  return fmt::format("{} -> {}, {}", counted(report.lines_before, "motion"),
                     grouped(report.lines_after),
                     counted(report.arcs_after, "arc"));
}

}  // namespace

Result<Rational> program_tolerance(const LineOptions& lines) {
  const Result<double> length = tolerance_mm(lines);
  if (!length) return length.error();
  return to_tolerance({*length, Quantity::Unit::grid}, {});
}

Result<WrittenProgram> write_program(Program program,
                                     const ProgramOptions& options,
                                     const LineOptions& lines) {
  CompactReport report;
  const bool shortened = lines.method == LineOptions::Method::tolerance;
  if (shortened) {
    const Result<double> tolerance = tolerance_mm(lines);
    if (!tolerance) return tolerance.error();
    CompactOptions how;
    how.tolerance_mm = *tolerance;
    how.arcs = lines.arcs;
    how.decimals = options.write.inches ? -1 : options.write.decimals;
    how.rules.quadrants = options.quadrants;
    how.rules.by_radius = options.write.arcs == ArcForm::radius;
    Result<Program> shorter = compact(program, how, &report);
    if (!shorter) return shorter.error();
    program = *std::move(shorter);
  } else {
    report.lines_before = static_cast<std::uint64_t>(std::count_if(
        program.items.begin(), program.items.end(),
        [](const ProgramItem& item) { return item.is_motion(); }));
    if (options.quadrants) {
      ArcRules rules;
      rules.quadrants = true;
      Result<Program> split = split_arcs(program, rules);
      if (!split) return split.error();
      program = *std::move(split);
    }
  }
  const Result<std::string> out = write_gcode(program, options.write);
  if (!out) return out.error();
  const Status checked = check_written(program, *out, options);
  if (!checked) return checked.error();
  return WrittenProgram{*out, summary(report, shortened)};
}

std::string program_lines(const std::string& text) {
  std::string lines;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == 'n') {
      lines += '\n';
      ++i;
    } else {
      lines += text[i];
    }
  }
  return lines;
}

bool names_program(const std::string& path) {
  return format_of_name(path) == OutputFormat::program;
}

void add_program_lines(CLI::App& verb, const char* name, std::string& lines,
                       const char* help) {
  verb.add_option_function<std::string>(
          name,
          [&lines](const std::string& text) { lines = program_lines(text); },
          help)
      ->type_name("TEXT");
}

void add_program(CLI::App& verb, ProgramOptions& options) {
  add_choice<GcodeProfile>(verb, "--profile", options.write.profile,
                           {{"linuxcnc", GcodeProfile::linuxcnc},
                            {"grbl", GcodeProfile::grbl},
                            {"marlin", GcodeProfile::marlin},
                            {"laser", GcodeProfile::laser},
                            {"plotter", GcodeProfile::plotter}},
                           "Programs: linuxcnc, grbl, marlin, laser or "
                           "plotter [linuxcnc]");
  add_choice<ArcForm>(verb, "--arc-words", options.write.arcs,
                      {{"keep", ArcForm::as_read},
                       {"ij", ArcForm::centre},
                       {"r", ArcForm::radius}},
                      "Programs: arcs by ij, by r or as they were: keep "
                      "[keep]");
  const auto set_unit = [&options](const std::string& word) {
    if (word != "mm" && word != "inch") {
      throw CLI::ValidationError("--units",
                                 fmt::format("'{}' is not mm or inch", word));
    }
    options.write.inches = word == "inch";
  };
  verb.add_option_function<std::string>(
          "--units", set_unit,
          "Programs: motions in mm or inch, else as they were")
      ->type_name("WORD");
  verb.add_option("--decimals", options.write.decimals,
                  "Programs: of positions, else all they have")
      ->check(CLI::Range(0, 7))
      ->type_name("N");
  verb.add_flag("--quadrants", options.quadrants,
                "Programs: no arc passes a quadrant's end");
  verb.add_flag("--strict", options.read.strict,
                "Programs: what is not understood is refused, not kept");
  add_choice<BlockDelete>(verb, "--block-delete", options.read.block_delete,
                          {{"keep", BlockDelete::keep},
                           {"on", BlockDelete::skip},
                           {"off", BlockDelete::execute}},
                          "Programs: lines with \"/\" are left out: on, "
                          "carried out: off, kept as they are: keep [keep]");
  add_choice<bool>(verb, "--flow", options.read.execute_flow,
                   {{"run", true}, {"keep", false}},
                   "Programs: subroutines, loops and branches are carried out: "
                   "run, or kept with all that follows: keep [run]");
  verb.add_option("--max-lines", options.read.limits.max_executed_lines,
                  "Programs: lines carried out in loops and subroutines "
                  "[10000000]")
      ->type_name("N");
  add_program_lines(verb, "--header", options.write.header,
                    "Programs: lines before all others; \\n between them");
  add_program_lines(verb, "--footer", options.write.footer,
                    "Programs: lines before the end");
  verb.add_flag(
      "--dense", [&options](std::int64_t) { options.write.blanks = false; },
      "Programs: no blanks between words");
}

ExitCode convert_program(const ProgramFiles& files,
                         const ProgramOptions& options,
                         const LineOptions& lines) {
  const std::string name = input_name(files.input);
  if (lines.method == LineOptions::Method::device) {
    return report_usage("convert", "--reverse is for unit steps");
  }
  if (lines.travel) {
    return report_usage("convert",
                        "--order travel is for drawings; the motions of a "
                        "program keep their order");
  }
  const Status free = may_write(files.output, files.input, files.force);
  if (!free) return report_error(output_name(files.output), free.error());
  const auto bytes = read_file(files.input, options.read.limits.max_bytes);
  if (!bytes) return report_error(name, bytes.error());
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()),
                              bytes->size());
  Result<Program> program = read_gcode(text, options.read);
  if (!program) return report_error(name, program.error());
  const std::vector<std::string> notes = program->notes;
  const Result<WrittenProgram> made =
      write_program(*std::move(program), options, lines);
  if (!made) return report_error(name, made.error());
  const std::span<const std::uint8_t> out(
      reinterpret_cast<const std::uint8_t*>(made->text.data()),
      made->text.size());
  const Status written = write_file(files.output, out, files.force);
  if (!written) return report_error(output_name(files.output), written.error());
  if (files.quiet) return ExitCode::ok;
  for (const std::string& note : notes) report_warning(name, note);
  fmt::print(files.output == "-" ? stderr : stdout, "{} -> {}: {}, {} -> {}\n",
             name, output_name(files.output), made->summary,
             counted(bytes->size(), "byte"), grouped(made->text.size()));
  return ExitCode::ok;
}

}  // namespace unstep::cli
