#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cli/compare.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/pack.h"
#include "cli/verbs.h"
#include "codec/block_coder.h"
#include "unstep/unstep.h"

namespace unstep::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::vector<std::string> inputs;
  DecodeLimits limits;
  bool json = false;
};

constexpr const char* kExamples =
    "  unstep info page.ustp                   pages, checksums, coders, "
    "bytes\n"
    "  unstep info --json archive/*.ustp | jq '.[].pages[].checksum'\n";

std::string coder_name(std::uint8_t coder) {
  switch (coder) {
    case codec::kCoderStored: return "stored";
    case codec::kCoderContours: return "contours";
    case codec::kCoderChains: return "chains";
    case codec::kCoderPaths: return "paths";
    default: return fmt::format("coder {}", coder);
  }
}

std::string_view form_name(FileInfo::Form form) {
  return form == FileInfo::Form::short_form ? "short" : "block";
}

/// What the bits of a file are shared among.
struct Content {
  std::uint64_t pixels = 0;
  std::uint64_t steps = 0;
  std::uint64_t elements = 0;
};

Content content_of(const PageEntry& page) {
  Content content;
  if (page.kind == PageKind::ink) {
    content.pixels = static_cast<std::uint64_t>(page.canvas.width) *
                     static_cast<std::uint64_t>(page.canvas.height);
  }
  for (const PageEntry::Block& block : page.blocks) {
    content.steps += block.steps;
    content.elements += block.elements;
  }
  return content;
}

Content content_of(const FileInfo& info) {
  Content sum;
  for (const PageEntry& page : info.pages) {
    const Content content = content_of(page);
    sum.pixels += content.pixels;
    sum.steps += content.steps;
    sum.elements += content.elements;
  }
  return sum;
}

double bits_per(std::uint64_t bytes, std::uint64_t count) {
  return count == 0
             ? 0.0
             : 8.0 * static_cast<double>(bytes) / static_cast<double>(count);
}

/// ", 0.1234 bits per pixel" where the file holds one kind of things alone.
std::string density(std::uint64_t bytes, const Content& content) {
  if (content.elements > 0) {
    if (content.pixels > 0) return "";
    std::string text;
    if (content.steps > 0) {
      text =
          fmt::format(", {:.3f} bits per step", bits_per(bytes, content.steps));
    }
    return text + fmt::format(", {:.2f} bits per line or arc",
                              bits_per(bytes, content.elements));
  }
  if (content.pixels > 0 && content.steps == 0) {
    return fmt::format(", {:.4f} bits per pixel",
                       bits_per(bytes, content.pixels));
  }
  if (content.steps > 0 && content.pixels == 0) {
    return fmt::format(", {:.3f} bits per step",
                       bits_per(bytes, content.steps));
  }
  return "";
}

void print_metadata(const Metadata& metadata, std::string_view indent) {
  for (const auto& [key, value] : metadata) {
    fmt::print("{}{} = {}\n", indent, printable(key), printable(value));
  }
}

std::string_view kind_name(PageKind kind) {
  if (kind == PageKind::ink) return "ink";
  return kind == PageKind::chains ? "chains" : "paths";
}

std::string_view fidelity_name(const Fidelity& fidelity) {
  switch (fidelity.kind) {
    case Fidelity::Kind::exact: return "exact";
    case Fidelity::Kind::tolerance: return "tolerance";
    case Fidelity::Kind::device: return "device";
  }
  return "";
}

/// ", within 1 px".
std::string fidelity_text(const Fidelity& fidelity) {
  const std::string bound = describe_bound(fidelity);
  return bound.empty() ? bound : "," + bound;
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
    case PageKind::paths: break;
  }
  std::string text = fmt::format("{}, {}", counted(block.paths, "path"),
                                 counted(block.elements - block.arcs, "line"));
  if (block.arcs > 0) text += ", " + counted(block.arcs, "arc");
  if (block.steps > 0) text += " for " + counted(block.steps, "step");
  return text;
}

std::string describe_canvas(const PageEntry& page) {
  const Canvas& canvas = page.canvas;
  std::string text(kind_name(page.kind));
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

void print_page(const PageEntry& page, std::size_t number) {
  fmt::print("  page {}: {}\n", number, describe_canvas(page));
  if (!page.info.name.empty()) {
    fmt::print("    name: {}\n", printable(page.info.name));
  }
  print_metadata(page.info.metadata, "    metadata: ");
  fmt::print("    checksum: {:08x}\n", page.checksum);
  for (std::size_t i = 0; i < page.blocks.size(); ++i) {
    const PageEntry::Block& block = page.blocks[i];
    fmt::print("    block {}: {}, {}, {} revision {} table {}\n", i + 1,
               describe_block(page, block), counted(block.bytes, "byte"),
               coder_name(block.coder), block.revision, block.table);
  }
}

void print_file(const std::string& name, const FileInfo& info,
                std::uint64_t bytes) {
  fmt::print("{}\n", name);
  fmt::print("  format: {}{}, {} form\n", info.version,
             info.version == 0 ? ", pre-release" : "", form_name(info.form));
  fmt::print("  size: {}{}\n", counted(bytes, "byte"),
             density(bytes, content_of(info)));
  print_metadata(info.metadata, "  metadata: ");
  fmt::print("  pages: {}\n", grouped(info.pages.size()));
  for (std::size_t i = 0; i < info.pages.size(); ++i) {
    print_page(info.pages[i], i + 1);
  }
}

Json to_json(const Metadata& metadata) {
  Json json = Json::object();
  for (const auto& [key, value] : metadata) json[key] = value;
  return json;
}

Json to_json(const Resolution& resolution) {
  if (!resolution.known()) return nullptr;
  const auto unit = [&] {
    switch (resolution.unit) {
      case Resolution::Unit::inch: return "inch";
      case Resolution::Unit::centimetre: return "centimetre";
      case Resolution::Unit::metre: return "metre";
      case Resolution::Unit::none: break;
    }
    return "none";
  };
  return {
      {"x", Json::array({resolution.x.numerator, resolution.x.denominator})},
      {"y", Json::array({resolution.y.numerator, resolution.y.denominator})},
      {"unit", unit()}};
}

Json to_json(const PageEntry::Block& block, PageKind kind) {
  Json json = {{"offset", block.offset}, {"bytes", block.bytes}};
  if (kind == PageKind::ink) {
    json["first_row"] = block.first_row;
    json["rows"] = block.rows;
  } else {
    json["box"] = {block.box.x, block.box.y, block.box.width, block.box.height};
    json["steps"] = block.steps;
    if (kind == PageKind::chains) {
      json["chains"] = block.chains;
    } else {
      json["paths"] = block.paths;
      json["lines"] = block.elements - block.arcs;
      json["arcs"] = block.arcs;
    }
  }
  json["coder"] = block.coder;
  json["coder_name"] = coder_name(block.coder);
  json["revision"] = block.revision;
  json["table"] = block.table;
  return json;
}

Json to_json(const PageEntry& page) {
  Json blocks = Json::array();
  for (const PageEntry::Block& block : page.blocks) {
    blocks.push_back(to_json(block, page.kind));
  }
  return {{"kind", kind_name(page.kind)},
          {"fidelity", fidelity_name(page.fidelity)},
          {"tolerance", page.fidelity.kind == Fidelity::Kind::exact
                            ? Json(nullptr)
                            : Json({page.fidelity.tolerance.numerator,
                                    page.fidelity.tolerance.denominator})},
          {"scale", page.scale},
          {"width", page.canvas.width},
          {"height", page.canvas.height},
          {"y_axis", page.canvas.y_axis == YAxis::up ? "up" : "down"},
          {"resolution", to_json(page.info.resolution)},
          {"name", page.info.name},
          {"metadata", to_json(page.info.metadata)},
          {"checksum", fmt::format("{:08x}", page.checksum)},
          {"blocks", std::move(blocks)}};
}

Json to_json(const std::string& path, const FileInfo& info,
             std::uint64_t bytes) {
  const Content content = content_of(info);
  Json pages = Json::array();
  for (const PageEntry& page : info.pages) pages.push_back(to_json(page));
  return {
      {"file", path},
      {"version", info.version},
      {"prerelease", info.version == 0},
      {"form", form_name(info.form)},
      {"bytes", bytes},
      {"pixels", content.pixels},
      {"bits_per_pixel", content.pixels > 0
                             ? Json(bits_per(bytes, content.pixels))
                             : Json(nullptr)},
      {"steps", content.steps},
      {"bits_per_step", content.steps > 0 ? Json(bits_per(bytes, content.steps))
                                          : Json(nullptr)},
      {"elements", content.elements},
      {"metadata", to_json(info.metadata)},
      {"pages", std::move(pages)}};
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
    } else if (options.json) {
      files.push_back(to_json(path, reader->info(), bytes->size()));
    } else {
      print_file(name, reader->info(), bytes->size());
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
  finish_verb(*verb, kExamples);
  verb->callback([&context, options] {
    context.run = [options] { return info(*options); };
  });
}

}  // namespace unstep::cli
