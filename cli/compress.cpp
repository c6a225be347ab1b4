#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/pack.h"
#include "cli/progress.h"
#include "cli/source.h"
#include "cli/verbs.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

struct CompressOptions {
  std::string input;
  std::string output;
  InputOptions read;
  PackOptions pack;
  ReportOptions report;
  bool force = false;
};

constexpr const char* kCompressExamples =
    "  unstep compress page.tif                writes page.ustp, verified\n"
    "  unstep compress photo.jpg --threshold auto --despeckle 8\n"
    "  unstep compress page.tif --meta title='Plan 7' --meta author=me\n"
    "  unstep compress traced.fc               chain codes, step for step\n"
    "  unstep compress plan.png --tolerance 1  lines and arcs, never more "
    "than\n"
    "                                          1 pixel off\n"
    "  unstep compress plan.png --trace centerline --tolerance 1\n"
    "                                          strokes with the width of the "
    "pen\n"
    "  unstep compress part.svg                vertices as they are\n"
    "  unstep compress part.svg --grid 0.1mm   as unit steps of 0.1 mm\n"
    "  pdftoppm -mono a.pdf | unstep compress - -o a.ustp\n";

/// Of the last page of paths; null if all is exact.
nlohmann::ordered_json tolerance_of(const Packed& packed) {
  if (!packed.fidelity || packed.fidelity->kind == Fidelity::Kind::exact) {
    return nullptr;
  }
  return {packed.fidelity->tolerance.numerator,
          packed.fidelity->tolerance.denominator};
}

nlohmann::ordered_json to_json(const CompressOptions& options,
                               const Source& source, const Packed& packed) {
  return {{"input", options.input},
          {"output", options.output},
          {"format", source.format()},
          {"pages", packed.pages},
          {"pixels", packed.pixels},
          {"chains", packed.chains},
          {"steps", packed.steps},
          {"paths", packed.paths},
          {"lines", packed.lines},
          {"arcs", packed.arcs},
          {"tolerance", tolerance_of(packed)},
          {"input_bytes", source.bytes()},
          {"packed_bytes", packed.packed_bytes},
          {"output_bytes", packed.bytes.size()},
          {"lossless", packed.lossless},
          {"pixel_work", packed.pixel_work},
          {"exact_from_there", packed.exact},
          {"verified", options.pack.verify},
          {"notes", packed.notes}};
}

/// The report goes to stdout unless the file itself does.
void report(const CompressOptions& options, const Source& source,
            const Packed& packed) {
  std::FILE* stream = options.output == "-" ? stderr : stdout;
  if (options.report.json) {
    fmt::print(stream, "{}\n", dump(to_json(options, source, packed)));
  } else if (!options.report.quiet) {
    fmt::print(stream, "{} -> {}: {}\n", input_name(options.input),
               output_name(options.output),
               describe(packed, options.pack.verify));
  }
}

ExitCode compress(CompressOptions options) {
  if (options.output.empty()) {
    if (options.input == "-") {
      return report_usage("compress", "standard input needs -o OUT");
    }
    options.output = std::filesystem::path(options.input)
                         .replace_extension(".ustp")
                         .string();
  }
  const std::string name = input_name(options.input);
  if (const Status free =
          may_write(options.output, options.input, options.force);
      !free) {
    return report_error(output_name(options.output), free.error());
  }
  Result<Source> source = Source::open(options.input, options.read);
  if (!source) return report_error(name, source.error());
  if (source->is_ustp()) {
    return report_error(name,
                        {ErrorCode::unsupported, "is a .ustp file already"});
  }
  ProgressLine line(options.report.quiet);
  const Interruptible interruptible;
  const auto listener = [&](double fraction, std::uint64_t pixels) {
    line.update(name, fraction, pixels);
    return !interrupted();
  };
  const Result<Packed> packed =
      pack(*source, options.pack, options.read.jobs, listener);
  line.finish();
  if (!packed) return report_error(name, packed.error());
  if (!options.report.quiet) {
    for (const std::string& note : packed->notes) report_warning(name, note);
  }
  if (const Status written =
          write_file(options.output, packed->bytes, options.force);
      !written) {
    return report_error(output_name(options.output), written.error());
  }
  report(options, *source, *packed);
  return ExitCode::ok;
}

}  // namespace

void add_compress(CLI::App& app, Context& context) {
  const auto options = std::make_shared<CompressOptions>();
  CLI::App* verb =
      app.add_subcommand("compress", "Write a drawing as a .ustp file");
  add_input(*verb, options->input,
            "The drawing: PBM, PGM, PNG, TIFF, BMP, JPEG, SVG, DXF, HPGL, JSON "
            "or Freeman chain text; - is standard input");
  verb->add_option("-o,--output", options->output,
                   "The .ustp file; - is standard output [IN with .ustp]")
      ->type_name("OUT");
  add_force(*verb, options->force);
  add_input_kind(*verb, options->read);
  add_pack(*verb, options->pack);
  add_jobs(*verb, options->read.jobs);
  add_limits(*verb, options->read.limits);
  add_json(*verb, options->report.json);
  add_quiet(*verb, options->report.quiet);
  finish_verb(*verb, kCompressExamples);
  verb->callback([&context, options] {
    context.run = [options] { return compress(*options); };
  });
}

}  // namespace unstep::cli
