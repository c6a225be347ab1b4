#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cli/compare.h"
#include "cli/content.h"
#include "cli/info_json.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/pack.h"
#include "cli/verbs.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::vector<std::string> inputs;
  DecodeLimits limits;
  bool json = false;
};

constexpr const char* kInfoExamples =
    "  unstep info page.ustp                   pages, checksums, coders, "
    "bytes\n"
    "  unstep info --json archive/*.ustp | jq '.[].pages[].checksum'\n";

/// ", 0.1234 bits per pixel" where the file holds one kind of things alone.
std::string density(std::uint64_t bytes, const Content& content) {
  const std::uint64_t elements = content.lines + content.arcs;
  if (content.pixels > 0) {
    if (content.steps > 0 || elements > 0) return "";
    return fmt::format(", {:.4f} bits per pixel",
                       bits_per(bytes, content.pixels));
  }
  std::string text;
  if (content.steps > 0) {
    text +=
        fmt::format(", {:.3f} bits per step", bits_per(bytes, content.steps));
  }
  if (elements > 0) {
    text +=
        fmt::format(", {:.2f} bits per line or arc", bits_per(bytes, elements));
  }
  return text;
}

void print_metadata(const Metadata& metadata, std::string_view indent) {
  for (const auto& [key, value] : metadata) {
    fmt::print("{}{} = {}\n", indent, printable(key), printable(value));
  }
}

/// ", within 1 px".
std::string fidelity_text(const Fidelity& fidelity) {
  const std::string bound = describe_bound(fidelity);
  return bound.empty() ? bound : "," + bound;
}

std::string describe_lines(const Content& content) {
  std::string text = fmt::format("{}, {}", counted(content.paths, "path"),
                                 counted(content.lines, "line"));
  if (content.arcs > 0) text += ", " + counted(content.arcs, "arc");
  if (content.steps > 0) {
    text += " that draw " + counted(content.steps, "step");
  }
  return text;
}

std::string describe_block(const PageEntry& page,
                           const PageEntry::Block& block) {
  switch (page.kind) {
    case PageKind::ink:
      return fmt::format("rows {} to {}", block.first_row,
                         block.first_row + block.rows - 1);
    case PageKind::chains:
      return fmt::format("{}, {}", counted(block.chains, "chain"),
                         counted(block.steps, "step"));
    case PageKind::program:
      return fmt::format("{}, {} of text", counted(block.lines, "line"),
                         counted(block.text_bytes, "byte"));
    case PageKind::paths: break;
  }
  return fmt::format("{}, {}", counted(block.paths, "path"),
                     counted(block.elements, "element"));
}

std::string describe_canvas(const PageEntry& page) {
  const Canvas& canvas = page.canvas;
  std::string text(kind_name(page.kind));
  if (page.kind == PageKind::program) {
    const std::string bound = describe_bound(page.fidelity, "mm");
    return bound.empty() ? text : text + "," + bound;
  }
  if (page.kind != PageKind::ink && canvas.width == 0 && canvas.height == 0) {
    text += ", no canvas";
  } else {
    text += fmt::format(", {} x {} px", canvas.width, canvas.height);
  }
  if (page.kind == PageKind::paths) {
    text += page.paint == Paint::fill ? ", filled" : ", drawn by pens";
    text += fidelity_text(page.fidelity);
    if (page.scale != 1) {
      text += fmt::format(", {} units per pixel",
                          grouped(static_cast<std::uint64_t>(page.scale)));
    }
  }
  if (page.kind != PageKind::ink) {
    text += canvas.y_axis == YAxis::up ? ", y up" : ", y down";
  }
  if (page.info.resolution.known()) {
    text += ", " + describe_resolution(page.info.resolution);
  }
  return text;
}

/// The most used first, eight at most.
void print_pens(const PageEntry& page, const Content& content) {
  if (content.pens.empty()) return;
  std::vector<std::pair<std::uint64_t, std::int32_t>> pens;
  for (const auto& [width, paths] : content.pens) {
    pens.push_back({paths, width});
  }
  std::ranges::stable_sort(pens, std::ranges::greater{},
                           [](const auto& pen) { return pen.first; });
  std::string text;
  const std::size_t shown = std::min<std::size_t>(pens.size(), 8);
  for (std::size_t i = 0; i < shown; ++i) {
    const double width = static_cast<double>(pens[i].second) / page.scale;
    text += fmt::format("{}{:.4g} px ({})", i == 0 ? "" : ", ", width,
                        counted(pens[i].first, "path"));
  }
  if (shown < pens.size()) {
    text += fmt::format(", {} more", pens.size() - shown);
  }
  fmt::print("    pens: {}\n", text);
}

void print_page(const PageEntry& page, const Content& content,
                std::size_t number) {
  fmt::print("  page {}: {}\n", number, describe_canvas(page));
  if (!page.info.name.empty()) {
    fmt::print("    name: {}\n", printable(page.info.name));
  }
  print_metadata(page.info.metadata, "    metadata: ");
  if (page.kind == PageKind::paths) {
    fmt::print("    lines: {}\n", describe_lines(content));
    print_pens(page, content);
  }
  fmt::print("    checksum: {:08x}\n", page.checksum);
  for (std::size_t i = 0; i < page.blocks.size(); ++i) {
    const PageEntry::Block& block = page.blocks[i];
    fmt::print("    block {}: {}, {}, {} revision {} table {}\n", i + 1,
               describe_block(page, block), counted(block.bytes, "byte"),
               coder_name(block.coder), block.revision, block.table);
  }
}

void print_file(const std::string& name, const FileInfo& info,
                const Contents& held, std::uint64_t bytes) {
  fmt::print("{}\n", name);
  fmt::print("  format: {}{}, {} form\n", info.version,
             info.version == 0 ? ", pre-release" : "", form_name(info.form));
  fmt::print("  size: {}{}\n", counted(bytes, "byte"),
             density(bytes, held.sum));
  print_metadata(info.metadata, "  metadata: ");
  fmt::print("  pages: {}\n", grouped(info.pages.size()));
  for (std::size_t i = 0; i < info.pages.size(); ++i) {
    print_page(info.pages[i], held.pages[i], i + 1);
  }
}

ExitCode info(const InfoOptions& options) {
  Json files = Json::array();
  Outcome outcome(options.inputs.size());
  for (const std::string& path : options.inputs) {
    const std::string name = input_name(path);
    const Result<std::vector<std::uint8_t>> bytes =
        read_file(path, options.limits.max_memory);
    if (!bytes) {
      outcome.add(report_error(name, bytes.error()));
      continue;
    }
    const Result<UstpReader> reader =
        UstpReader::open(*bytes, {options.limits, 1, {}});
    if (!reader) {
      outcome.add(report_error(name, reader.error()));
      continue;
    }
    const Result<Contents> held = contents_of(*reader, options.limits);
    if (!held) {
      outcome.add(report_error(name, held.error()));
    } else if (options.json) {
      files.push_back(to_json(path, reader->info(), *held, bytes->size()));
    } else {
      print_file(name, reader->info(), *held, bytes->size());
    }
  }
  if (options.json) fmt::print("{}\n", dump(files));
  return outcome.exit_code();
}

}  // namespace

void add_info(CLI::App& app, Context& context) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* verb = app.add_subcommand("info", "Show what .ustp files hold");
  add_inputs(*verb, options->inputs, "The .ustp files; - is standard input");
  verb->add_flag("--json", options->json,
                 "A JSON list with one object for each readable file");
  add_limits(*verb, options->limits);
  finish_verb(*verb, kInfoExamples);
  verb->callback([&context, options] {
    context.run = [options] { return info(*options); };
  });
}

}  // namespace unstep::cli
