#include "cli/draw_program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include "cli/message.h"
#include "cli/output.h"
#include "cli/pack.h"
#include "cli/reshape.h"
#include "cli/source.h"
#include "cli/unpack.h"

namespace unstep::cli {
namespace {

/// A length in mm where a number alone is one.
Result<double> millimetres(const Result<Quantity>& quantity) {
  if (!quantity) return quantity.error();
  return quantity->unit == Quantity::Unit::inch ? quantity->value * 25.4
                                                : quantity->value;
}

void add_length(CLI::App& verb, const char* name, double& length, bool sign,
                const char* help) {
  const auto set = [name, &length, sign](const std::string& text) {
    const Result<double> value =
        millimetres(sign ? parse_signed_quantity(text) : parse_quantity(text));
    if (!value) throw CLI::ValidationError(name, value.error().message);
    length = *value;
  };
  verb.add_option_function<std::string>(name, set, help)->type_name("LENGTH");
}

Result<WrittenProgram> draw_page(Page page, const DrawFiles& files,
                                 const DrawOptions& given,
                                 const ProgramOptions& program,
                                 LineOptions lines,
                                 std::vector<std::string>& notes) {
  DrawOptions options = given;
  options.draw.profile = program.write.profile;
  options.draw.rules.quadrants = program.quadrants;
  if (program.write.decimals >= 0 && !program.write.inches) {
    options.draw.decimals = program.write.decimals;
  }
  Result<Program> made = program_of_page(std::move(page), files, options,
                                         program.read, lines, notes);
  if (!made) return made.error();
  return write_program(*std::move(made), program, lines);
}

}  // namespace

void add_unit_size(CLI::App& verb, DrawOptions& options) {
  const auto set_size = [&options](const std::string& text) {
    const Result<Quantity> size = parse_quantity(text);
    if (!size) throw CLI::ValidationError("--unit-size", size.error().message);
    options.unit_size = *size;
  };
  verb.add_option_function<std::string>(
          "--unit-size", set_size,
          "Drawing to program: how long a grid unit is, where the drawing does "
          "not say")
      ->type_name("LENGTH");
}

void add_draw(CLI::App& verb, DrawOptions& options) {
  add_unit_size(verb, options);
  DrawProgramOptions& draw = options.draw;
  add_length(verb, "--feed", draw.feed, false,
             "Drawing to program: along the paths, a minute [1000mm]");
  add_length(verb, "--plunge-feed", draw.plunge_feed, false,
             "Drawing to program: of the tool going down [300mm]");
  add_length(verb, "--travel-z", draw.travel_z, true,
             "Drawing to program: height between paths [5mm]");
  add_length(verb, "--cut-z", draw.cut_z, true,
             "Drawing to program: height in the paths [-1mm; plotter and "
             "marlin 0]");
  verb.add_option("--spindle", draw.spindle,
                  "Drawing to program: M3 with this speed")
      ->check(CLI::NonNegativeNumber)
      ->type_name("S");
  verb.add_option("--power", draw.power,
                  "Drawing to program: S of the laser [1000]")
      ->check(CLI::NonNegativeNumber)
      ->type_name("S");
  add_program_lines(verb, "--tool-on", draw.tool_on,
                    "Drawing to program: lines before each path instead of "
                    "the profile's; \\n between them");
  add_program_lines(verb, "--tool-off", draw.tool_off,
                    "Drawing to program: lines after each path");
}

Status set_unit_size(DrawOptions& options, const Resolution& resolution,
                     std::vector<std::string>& notes) {
  DrawProgramOptions& draw = options.draw;
  const Quantity millimetre{1, Quantity::Unit::millimetre};
  const Result<double> x =
      to_grid_units(millimetre, resolution.x, resolution.unit);
  const Result<double> y =
      to_grid_units(millimetre, resolution.y, resolution.unit);
  if (x && y && *x > 0 && *y > 0) {
    draw.unit_x = 1 / *x;
    draw.unit_y = 1 / *y;
    if (options.unit_size) {
      notes.emplace_back("--unit-size is not used: the drawing has a size");
    }
    return {};
  }
  if (!options.unit_size || options.unit_size->value <= 0) {
    return Error{ErrorCode::invalid_argument,
                 "how large the drawing is is not known; say how long a grid "
                 "unit is: --unit-size 0.1mm"};
  }
  draw.unit_x = *millimetres(*options.unit_size);
  draw.unit_y = draw.unit_x;
  if (resolution.known()) {
    draw.unit_y *= (static_cast<double>(resolution.x.numerator) /
                    resolution.x.denominator) /
                   (static_cast<double>(resolution.y.numerator) /
                    resolution.y.denominator);
  }
  return {};
}

Result<Program> program_of_page(Page page, const DrawFiles& files,
                                const DrawOptions& given,
                                const GcodeReadOptions& read,
                                LineOptions& lines,
                                std::vector<std::string>& notes) {
  if (page.kind == PageKind::program) {
    Result<Program> program = read_gcode(page.program, read);
    if (!program) return program.error();
    notes.insert(notes.end(), program->notes.begin(), program->notes.end());
    if (lines.travel) {
      const Status ordered = order_page(page, notes);
      if (!ordered) return ordered.error();
    }
    return program;
  }
  DrawOptions options = given;
  Status sized = set_unit_size(options, page.info.resolution, notes);
  if (!sized) return sized.error();
  if (!page.info.resolution.known() && page.kind != PageKind::paths) {
    // Then a tolerance in mm is one in grid units of the size given.
    const double unit = options.draw.unit_x;
    if (lines.tolerance.unit == Quantity::Unit::millimetre) {
      lines.tolerance.value /= unit;
    } else if (lines.tolerance.unit == Quantity::Unit::inch) {
      lines.tolerance.value *= 25.4 / unit;
    }
    lines.tolerance.unit = Quantity::Unit::grid;
  }
  if (page.kind == PageKind::ink || page.kind == PageKind::chains) {
    Result<Page> drawn = to_drawing(std::move(page), lines, files.effort);
    if (!drawn) return drawn.error();
    page = *std::move(drawn);
    lines.method = LineOptions::Method::none;
  }
  if (lines.travel) {
    const Status ordered = order_page(page, notes);
    if (!ordered) return ordered.error();
  }
  if (!page.info.metadata.empty() || !page.info.name.empty()) {
    notes.emplace_back("name and metadata of the page are not in the program");
  }
  Result<Program> made = draw_program(page.drawing, options.draw, &notes);
  if (!made) return made.error();
  notes.insert(notes.end(), made->notes.begin(), made->notes.end());
  return made;
}

ExitCode convert_to_program(const DrawFiles& given, const DrawOptions& draw,
                            const ProgramOptions& program,
                            const LineOptions& lines) {
  const ProgramFiles& files = given.files;
  const std::string name = input_name(files.input);
  Result<Source> source = Source::open(files.input, given.read);
  if (!source) return report_error(name, source.error());
  const std::size_t count = source->page_count();
  if (given.page > count) {
    return report_usage("convert",
                        fmt::format("{} has {}, no page {}", name,
                                    counted(count, "page"), given.page));
  }
  const bool all = given.page == 0 && count > 1;
  if (all && files.output == "-") {
    return report_usage("convert",
                        fmt::format("{} has {}, and standard output takes one "
                                    "program; choose --page N",
                                    name, counted(count, "page")));
  }
  const std::size_t first = given.page == 0 ? 0 : given.page - 1;
  const std::size_t last = all ? count : first + 1;
  for (std::size_t index = first; index < last; ++index) {
    const std::string output =
        all ? numbered(files.output, index + 1) : files.output;
    const Status free = may_write(output, files.input, files.force);
    if (!free) return report_error(output_name(output), free.error());
    Result<SourcePage> page = source->read(index);
    if (!page) return report_error(name, page.error());
    std::vector<std::string> notes = std::move(page->notes);
    const Result<WrittenProgram> made =
        draw_page(std::move(page->page), given, draw, program, lines, notes);
    if (!made) {
      return report_error(name, {made.error().code,
                                 on_page(index, count, made.error().message)});
    }
    const std::span<const std::uint8_t> out(
        reinterpret_cast<const std::uint8_t*>(made->text.data()),
        made->text.size());
    const Status written = write_file(output, out, files.force);
    if (!written) return report_error(output_name(output), written.error());
    if (files.quiet) continue;
    for (const std::string& note : notes) {
      report_warning(name, on_page(index, count, note));
    }
    fmt::print(output == "-" ? stderr : stdout, "{} -> {}: {}, {}\n", name,
               output_name(output), made->summary,
               counted(made->text.size(), "byte"));
  }
  return ExitCode::ok;
}

}  // namespace unstep::cli
