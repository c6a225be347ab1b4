#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cli/centreline.h"
#include "cli/compare.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/pack.h"
#include "cli/program_difference.h"
#include "cli/progress.h"
#include "cli/quantity.h"
#include "cli/reshape.h"
#include "cli/source.h"
#include "cli/unpack.h"
#include "cli/verbs.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

struct VerifyOptions {
  std::vector<std::string> inputs;
  InputOptions read;
  bool compare = false;
  std::string overlay;
  double tolerance_mm = 0;  ///< of programs; 0: what the second says
  bool force = false;
  bool quiet = false;
};

constexpr const char* kVerifyExamples =
    "  unstep verify page.ustp                 is the file whole?\n"
    "  unstep verify archive/*.ustp            each of them; goes on after a\n"
    "                                          damaged one\n"
    "  unstep verify page.tif page.ustp        is it the same drawing?\n"
    "  unstep verify plan.png plan.ustp        how far are its lines off?\n"
    "  unstep verify part.ngc part.ustp        how far are its motions off?\n"
    "  unstep verify part.ngc short.ngc --tolerance 0.005mm\n"
    "  unstep verify scan.png strokes.ustp --overlay off.svg\n"
    "  unstep verify --compare old.ustp new.ustp\n";

void say(const VerifyOptions& options, const std::string& line) {
  if (!options.quiet) fmt::print("{}\n", line);
}

/// PBM, PGM and Freeman text have no place for a resolution.
bool carries_resolution(const Source& source) {
  return source.format() != "pbm" && source.format() != "pgm" &&
         source.format() != "freeman";
}

/// The first thing that differs between two pages; `carried`: the first file's
/// format can hold a resolution, so that its lack means something.
std::optional<std::string> page_difference(const Page& a, const Page& b,
                                           bool carried) {
  if (auto drawn = first_difference(a, b)) return drawn;
  const Resolution& in_a = a.info.resolution;
  const Resolution& in_b = b.info.resolution;
  if (same_resolution(in_a, in_b) || !(carried || in_a.known())) {
    return std::nullopt;
  }
  return fmt::format("the resolution is {} in the first and {} in the second",
                     describe_resolution(in_a), describe_resolution(in_b));
}

/// Lines made from ink or chains, and their original.
bool stands_for(const Page& original, const Page& lines) {
  return original.kind != PageKind::paths && lines.kind == PageKind::paths &&
         lines.fidelity.kind != Fidelity::Kind::exact;
}

/// What a program may deviate by from another; 0 if it may not.
double program_bound(const VerifyOptions& options, const Page& a,
                     const Page& b) {
  if (a.kind != PageKind::program || b.kind != PageKind::program) return 0;
  if (options.tolerance_mm > 0) return options.tolerance_mm;
  return b.fidelity.kind == Fidelity::Kind::tolerance ? bound_of(b.fidelity)
                                                      : 0;
}

/// A page, or the message that there is none.
std::optional<Page> read_page(Source& source, std::size_t index,
                              const std::string& name, ExitCode& code) {
  Result<SourcePage> page = source.read(index);
  if (page) return std::move(page->page);
  code = report_error(
      name, {page.error().code,
             on_page(index, source.page_count(), page.error().message)});
  return std::nullopt;
}

/// How far what strokes draw is from the ink that they stand for.
Result<std::string> ink_distance(const VerifyOptions& options,
                                 const Bitmap& ink, const Page& strokes) {
  std::vector<std::string> notes;
  const Result<Bitmap> drawn = to_ink(strokes, options.read.limits, notes);
  if (!drawn) return drawn.error();
  const Result<InkDistance> found = measure_ink(ink, *drawn);
  if (!found) return found.error();
  return describe_ink_distance(*found);
}

/// NAME.svg, or NAME-0001.svg and so on if there are several pages.
Status write_overlay(const VerifyOptions& options, const Page& a, const Page& b,
                     std::size_t index, std::size_t count) {
  std::vector<std::string> notes;
  const Result<Bitmap> first = to_ink(a, options.read.limits, notes);
  if (!first) return first.error();
  const Result<Bitmap> second = to_ink(b, options.read.limits, notes);
  if (!second) return second.error();
  if (first->width() != second->width() ||
      first->height() != second->height()) {
    return Error{ErrorCode::invalid_argument,
                 "pages of different size cannot be laid over each other"};
  }
  const std::string svg = overlay_svg(*first, *second);
  const std::string path =
      count == 1 ? options.overlay : numbered(options.overlay, index + 1);
  return write_file(
      path, {reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size()},
      options.force);
}

/// Two drawings: is the second what the first is?
ExitCode compare(const VerifyOptions& options) {
  const std::string name_a = input_name(options.inputs[0]);
  const std::string name_b = input_name(options.inputs[1]);
  Result<Source> a = Source::open(options.inputs[0], options.read);
  if (!a) return report_error(name_a, a.error());
  InputOptions read_b = options.read;
  read_b.kind = InputOptions::Kind::automatic;
  Result<Source> b = Source::open(options.inputs[1], read_b);
  if (!b) return report_error(name_b, b.error());
  if (a->page_count() != b->page_count()) {
    say(options, fmt::format("{} and {} differ: {} in the first and {} in the "
                             "second",
                             name_a, name_b, counted(a->page_count(), "page"),
                             grouped(b->page_count())));
    return ExitCode::some_failed;
  }
  const std::size_t count = a->page_count();
  std::vector<std::string> deviations;
  bool strokes = false;
  for (std::size_t i = 0; i < count; ++i) {
    ExitCode code = ExitCode::ok;
    const std::optional<Page> page_a = read_page(*a, i, name_a, code);
    if (!page_a) return code;
    const std::optional<Page> page_b = read_page(*b, i, name_b, code);
    if (!page_b) return code;
    if (!options.overlay.empty()) {
      const Status drawn = write_overlay(options, *page_a, *page_b, i, count);
      if (!drawn) {
        return report_error(options.overlay, drawn.error());
      }
    }
    if (page_a->kind == PageKind::ink && is_strokes(*page_b)) {
      const Result<std::string> found =
          ink_distance(options, page_a->ink, *page_b);
      if (!found) return report_error(name_b, found.error());
      deviations.push_back(on_page(i, count, *found));
      strokes = true;
      continue;
    }
    if (stands_for(*page_a, *page_b)) {
      const Result<Deviation> found = page_deviation(*page_a, *page_b);
      if (!found) return report_error(name_b, found.error());
      deviations.push_back(
          on_page(i, count, describe_deviation(*found, page_b->fidelity)));
      if (found->distance <= bound_of(page_b->fidelity)) continue;
      say(options, fmt::format("{} and {} differ: {}", name_a, name_b,
                               deviations.back()));
      return ExitCode::some_failed;
    }
    if (const double bound = program_bound(options, *page_a, *page_b);
        bound > 0) {
      const Result<ProgramVerdict> found =
          judge_program(*page_a, *page_b, bound);
      if (!found) return report_error(name_b, found.error());
      deviations.push_back(on_page(i, count, found->text));
      if (found->within) continue;
      say(options, fmt::format("{} and {} differ: {}", name_a, name_b,
                               deviations.back()));
      return ExitCode::some_failed;
    }
    const auto difference =
        page_difference(*page_a, *page_b, carries_resolution(*a));
    if (!difference) continue;
    say(options, fmt::format("{} and {} differ: {}", name_a, name_b,
                             on_page(i, count, *difference)));
    return ExitCode::some_failed;
  }
  for (const std::string& deviation : deviations) {
    say(options, fmt::format("{}: {}", name_b, deviation));
  }
  say(options, fmt::format("{} and {} are {}: {}", name_a, name_b,
                           deviations.empty() ? "the same"
                           : strokes          ? "comparable"
                                              : "the same within the bound",
                           counted(count, "page")));
  return ExitCode::ok;
}

/// One .ustp file: does everything decode to its checksum?
ExitCode test_file(const VerifyOptions& options, const std::string& path) {
  const std::string name = input_name(path);
  ProgressLine line(options.quiet);
  std::size_t count = 1;
  std::size_t index = 0;
  const auto progress = [&](std::uint64_t done, std::uint64_t total) {
    const double part =
        total == 0 ? 0.0
                   : static_cast<double>(done) / static_cast<double>(total);
    line.update(
        name, (static_cast<double>(index) + part) / static_cast<double>(count),
        0);
    return !interrupted();
  };
  const Result<std::vector<std::uint8_t>> bytes =
      read_file(path, options.read.limits.max_memory);
  if (!bytes) return report_error(name, bytes.error());
  const Result<UstpReader> reader = UstpReader::open(
      *bytes, {options.read.limits, options.read.jobs, progress});
  if (!reader) return report_error(name, reader.error());
  count = reader->info().pages.size();
  for (; index < count; ++index) {
    const Result<Page> page = reader->read_page(index);
    if (!page) {
      line.finish();
      return report_error(name, {page.error().code,
                                 on_page(index, count, page.error().message)});
    }
  }
  line.finish();
  say(options, fmt::format("{}: good, {}", name, counted(count, "page")));
  return ExitCode::ok;
}

/// Two inputs of which the first is not a .ustp file by its name or content.
Result<bool> asks_to_compare(const VerifyOptions& options) {
  if (options.compare || !options.overlay.empty()) return true;
  if (options.inputs.size() != 2) return false;
  if (has_suffix(options.inputs[0], ".ustp")) return false;
  if (options.inputs[0] == "-") return true;
  const Result<std::vector<std::uint8_t>> bytes =
      read_file(options.inputs[0], options.read.limits.max_memory);
  if (!bytes) return bytes.error();
  const Result<UstpReader> reader =
      UstpReader::open(*bytes, {options.read.limits, 1, {}});
  return !reader && reader.error().code == ErrorCode::bad_magic;
}

ExitCode verify(const VerifyOptions& options) {
  if (options.compare && options.inputs.size() != 2) {
    return report_usage("verify", "--compare takes two drawings");
  }
  if (!options.overlay.empty() && options.inputs.size() != 2) {
    return report_usage("verify", "--overlay takes two drawings");
  }
  const Interruptible interruptible;
  const Result<bool> two = asks_to_compare(options);
  if (!two) {
    return report_error(input_name(options.inputs[0]), two.error());
  }
  if (*two) return compare(options);
  Outcome outcome(options.inputs.size());
  for (const std::string& path : options.inputs) {
    outcome.add(test_file(options, path));
    if (interrupted()) return ExitCode::interrupted;
  }
  return outcome.exit_code();
}

}  // namespace

void add_verify(CLI::App& app, Context& context) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* verb = app.add_subcommand(
      "verify", "Test .ustp files, or compare one with a drawing");
  add_inputs(*verb, options->inputs,
             "One or more .ustp files to test, or a drawing of any kind and "
             "the .ustp file to compare it with");
  verb->add_flag("--compare", options->compare,
                 "Compare two files even if both are .ustp");
  verb->add_option("--overlay", options->overlay,
                   "Write an SVG picture of both: ink of both grey, of the "
                   "first alone red, of the second alone blue")
      ->type_name("OUT.svg");
  verb->add_option_function<std::string>(
          "--tolerance",
          [options](const std::string& text) {
            const Result<Quantity> length = parse_quantity(text);
            if (!length || length->unit == Quantity::Unit::grid ||
                !(length->value > 0)) {
              throw CLI::ValidationError(
                  "--tolerance", length
                                     ? "programs have no pixels: give mm or in"
                                     : length.error().message);
            }
            options->tolerance_mm = length->unit == Quantity::Unit::inch
                                        ? length->value * 25.4
                                        : length->value;
          },
          "Of programs: the second may be so far off [what it says]")
      ->type_name("LENGTH");
  add_force(*verb, options->force);
  add_input_kind(*verb, options->read);
  add_jobs(*verb, options->read.jobs);
  add_limits(*verb, options->read.limits);
  add_quiet(*verb, options->quiet);
  finish_verb(*verb, kVerifyExamples);
  verb->callback([&context, options] {
    context.run = [options] { return verify(*options); };
  });
}

}  // namespace unstep::cli
