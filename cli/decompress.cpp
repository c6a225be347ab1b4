#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <utility>

#include "cli/file_output.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/unpack.h"
#include "cli/verbs.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

struct DecompressOptions {
  std::string input;
  std::string output;
  std::optional<OutputFormat> to;
  std::uint64_t page = 0;  ///< 1-based; 0: all
  std::optional<Box> box;
  DecodeLimits limits;
  int jobs = 1;
  bool quiet = false;
  bool force = false;
};

constexpr const char* kDecompressExamples =
    "  unstep decompress page.ustp             writes page.png, or page.tif "
    "if\n"
    "                                          there are several pages\n"
    "  unstep decompress page.ustp -o scan.tif\n"
    "  unstep decompress book.ustp --to png    writes book-0001.png ...\n"
    "  unstep decompress book.ustp --page 3 -o - --to pbm | pnmtops\n"
    "  unstep decompress traced.ustp           chains: writes traced.fc\n"
    "  unstep decompress plan.ustp --to svg    the lines themselves\n"
    "  unstep decompress map.ustp --box 0,0,500,500 -o corner.png\n";

/// What is to be written, settled before anything is decoded.
struct Plan {
  OutputFormat format = OutputFormat::png;
  std::vector<OutputFile> files;
};

/// NAME.png beside NAME.ustp. One page chosen out of several keeps the name
/// that it would have among all.
std::string default_path(const DecompressOptions& options, const FileInfo& info,
                         OutputFormat format) {
  std::filesystem::path path(options.input);
  if (path.extension() == ".ustp") path.replace_extension();
  const std::string name = path.string() + '.' + std::string(extension(format));
  return options.page != 0 && info.pages.size() > 1
             ? numbered(name, options.page)
             : name;
}

Result<Plan> make_plan(const DecompressOptions& options, const FileInfo& info) {
  std::vector<std::size_t> pages(info.pages.size());
  std::iota(pages.begin(), pages.end(), std::size_t{0});
  if (options.page > pages.size()) {
    return Error{ErrorCode::invalid_argument,
                 fmt::format("has {}, no page {}",
                             counted(pages.size(), "page"), options.page)};
  }
  if (options.page != 0) pages = {options.page - 1};
  Plan plan;
  if (options.to) {
    plan.format = *options.to;
  } else {
    const Result<OutputFormat> natural = natural_format(info, pages);
    if (!natural) return natural.error();
    plan.format = *natural;
  }
  if (const Status fits = check_kinds(info, pages, plan.format); !fits) {
    return fits.error();
  }
  const bool to_stdout = options.output == "-";
  const std::string path = options.output.empty()
                               ? default_path(options, info, plan.format)
                               : options.output;
  plan.files = plan_files(path, pages, plan.format, to_stdout);
  if (to_stdout && plan.files.size() > 1) {
    return Error{
        ErrorCode::invalid_argument,
        fmt::format("has {}, and standard output takes one {} file; "
                    "choose --page N, or --to tif",
                    counted(pages.size(), "page"), extension(plan.format))};
  }
  return plan;
}

/// Draws the progress of the pages decoded so far and of the current one.
class Decoding {
 public:
  Decoding(std::string name, bool quiet)
      : name_(std::move(name)), line_(quiet) {}

  void set_total(const FileInfo& info, const Plan& plan) {
    for (const OutputFile& file : plan.files) {
      for (const std::size_t page : file.pages) {
        sizes_.push_back(pixels_of(info.pages[page]));
        total_ += sizes_.back();
      }
    }
  }

  bool update(std::uint64_t done, std::uint64_t total) {
    const double part =
        total == 0 ? 0.0
                   : static_cast<double>(done) / static_cast<double>(total);
    const double current =
        page_ < sizes_.size() ? part * static_cast<double>(sizes_[page_]) : 0;
    const double pixels = static_cast<double>(before_) + current;
    if (total_ > 0) {
      line_.update(name_, pixels / static_cast<double>(total_),
                   static_cast<std::uint64_t>(pixels));
    }
    return !interrupted();
  }

  bool next_page() {
    if (page_ < sizes_.size()) before_ += sizes_[page_++];
    return update(0, 1);
  }

  void finish() { line_.finish(); }

 private:
  static std::uint64_t pixels_of(const PageEntry& page) {
    return static_cast<std::uint64_t>(page.canvas.width) *
           static_cast<std::uint64_t>(page.canvas.height);
  }

  std::string name_;
  ProgressLine line_;
  std::vector<std::uint64_t> sizes_;
  std::uint64_t total_ = 0;
  std::uint64_t before_ = 0;
  std::size_t page_ = 0;
};

/// "a.ustp -> a-0001.png ... a-0003.png: 3 pages".
std::string describe_files(const DecompressOptions& options, const Plan& plan) {
  std::size_t pages = 0;
  for (const OutputFile& file : plan.files) pages += file.pages.size();
  std::string files = output_name(plan.files.front().path);
  if (plan.files.size() > 1) {
    files += " ... " + output_name(plan.files.back().path);
  }
  return fmt::format("{} -> {}: {}", input_name(options.input), files,
                     counted(pages, "page"));
}

Status write_pages(const DecompressOptions& options, const UstpReader& reader,
                   const OutputFile& file, OutputFormat format,
                   FileOutput& output, Decoding& decoding,
                   std::vector<std::string>& notes) {
  const auto give = [&](std::size_t page) {
    return options.box ? reader.read_page(page, *options.box)
                       : reader.read_page(page);
  };
  Result<PageWriter> writer = PageWriter::create(
      format, output.sink(), {}, Effort::standard, options.limits);
  if (!writer) return writer.error();
  const Status unpacked = unpack(
      give, reader.info().pages.size(), file.pages, std::move(*writer),
      [&] { return decoding.next_page(); }, notes);
  return unpacked ? output.commit() : unpacked;
}

/// Writes the planned files. A damaged page does not keep the other pages of
/// a numbered set from being written.
ExitCode write_files(const DecompressOptions& options, const UstpReader& reader,
                     const Plan& plan, Decoding& decoding) {
  const std::string name = input_name(options.input);
  ExitCode code = ExitCode::ok;
  for (const OutputFile& file : plan.files) {
    std::vector<std::string> notes;
    FileOutput output(file.path, options.force);
    const Status unpacked = write_pages(options, reader, file, plan.format,
                                        output, decoding, notes);
    decoding.finish();
    if (!output.status()) {
      return report_error(output_name(file.path), output.status().error());
    }
    if (!unpacked) {
      code = report_error(name, unpacked.error());
      if (unpacked.error().code == ErrorCode::cancelled) return code;
      continue;
    }
    if (options.quiet) continue;
    for (const std::string& note : notes) report_warning(name, note);
  }
  return code;
}

ExitCode decompress(DecompressOptions options) {
  if (options.output.empty() && options.input == "-") {
    return report_usage("decompress", "standard input needs -o OUT");
  }
  if (!options.to && options.output == "-") {
    return report_usage("decompress", "standard output needs --to FORMAT");
  }
  if (!options.to && !options.output.empty()) {
    options.to = format_of_name(options.output);
    if (!options.to) {
      return report_usage(
          "decompress",
          fmt::format("{}: the name's ending is not {}; say --to FORMAT",
                      options.output, format_words()));
    }
  }
  const std::string name = input_name(options.input);
  const Result<std::vector<std::uint8_t>> bytes =
      read_file(options.input, options.limits.max_memory);
  if (!bytes) return report_error(name, bytes.error());
  Decoding decoding(name, options.quiet);
  const Interruptible interruptible;
  const auto progress = [&](std::uint64_t done, std::uint64_t total) {
    return decoding.update(done, total);
  };
  const Result<UstpReader> reader =
      UstpReader::open(*bytes, {options.limits, options.jobs, progress});
  if (!reader) return report_error(name, reader.error());
  const Result<Plan> plan = make_plan(options, reader->info());
  if (!plan) return report_error(name, plan.error());
  for (const OutputFile& file : plan->files) {
    const Status free = may_write(file.path, options.input, options.force);
    if (!free) return report_error(output_name(file.path), free.error());
  }
  decoding.set_total(reader->info(), *plan);
  const ExitCode code = write_files(options, *reader, *plan, decoding);
  if (code == ExitCode::ok && !options.quiet) {
    fmt::print(options.output == "-" ? stderr : stdout, "{}\n",
               describe_files(options, *plan));
  }
  return code;
}

}  // namespace

void add_decompress(CLI::App& app, Context& context) {
  const auto options = std::make_shared<DecompressOptions>();
  CLI::App* verb = app.add_subcommand(
      "decompress", "Turn a .ustp file back into images, lines or chains");
  add_input(*verb, options->input, "The .ustp file; - is standard input");
  verb->add_option("-o,--output", options->output,
                   "The file to write; - is standard output [IN with .png, "
                   ".tif, .svg or .fc]")
      ->type_name("OUT");
  add_force(*verb, options->force);
  add_to(*verb, options->to);
  add_page(*verb, options->page);
  add_box(*verb, options->box);
  add_jobs(*verb, options->jobs);
  add_limits(*verb, options->limits);
  add_quiet(*verb, options->quiet);
  finish_verb(*verb, kDecompressExamples);
  verb->callback([&context, options] {
    context.run = [options] { return decompress(*options); };
  });
}

}  // namespace unstep::cli
