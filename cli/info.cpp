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
};

Content content_of(const PageEntry& page) {
  Content content;
  if (page.kind == PageKind::ink) {
    content.pixels = static_cast<std::uint64_t>(page.canvas.width) *
                     static_cast<std::uint64_t>(page.canvas.height);
  }
  for (const PageEntry::Block& block : page.blocks)
    content.steps += block.steps;
  return content;
}

Content content_of(const FileInfo& info) {
  Content sum;
  for (const PageEntry& page : info.pages) {
    const Content content = content_of(page);
    sum.pixels += content.pixels;
    sum.steps += content.steps;
  }
  return sum;
}

double bits_per(std::uint64_t bytes, std::uint64_t count) {
  return count == 0
             ? 0.0
             : 8.0 * static_cast<double>(bytes) / static_cast<double>(count);
}

/// ", 0.1234 bits per pixel" where the file holds pixels alone.
std::string density(std::uint64_t bytes, const Content& content) {
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

std::string describe_canvas(const PageEntry& page) {
  const Canvas& canvas = page.canvas;
  std::string text;
  if (page.kind == PageKind::ink) {
    text = fmt::format("ink, {} x {} px", canvas.width, canvas.height);
  } else if (canvas.width == 0 && canvas.height == 0) {
    text = "chains, no canvas";
  } else {
    text = fmt::format("chains, {} x {} px", canvas.width, canvas.height);
  }
  if (page.kind == PageKind::chains) {
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
    const std::string what =
        page.kind == PageKind::ink
            ? fmt::format("rows {} to {}", block.first_row,
                          block.first_row + block.rows - 1)
            : fmt::format("{}, {}", counted(block.chains, "chain"),
                          counted(block.steps, "step"));
    fmt::print("    block {}: {}, {}, {} revision {} table {}\n", i + 1, what,
               counted(block.bytes, "byte"), coder_name(block.coder),
               block.revision, block.table);
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
    json["chains"] = block.chains;
    json["steps"] = block.steps;
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
  return {{"kind", page.kind == PageKind::ink ? "ink" : "chains"},
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
