#include "cli/info_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace unstep::cli {
namespace {

using Json = nlohmann::ordered_json;

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
  if (kind == PageKind::program) {
    json["lines"] = block.lines;
    json["text_bytes"] = block.text_bytes;
  } else if (kind == PageKind::ink) {
    json["first_row"] = block.first_row;
    json["rows"] = block.rows;
  } else {
    json["box"] = {block.box.x, block.box.y, block.box.width, block.box.height};
    if (kind == PageKind::chains) {
      json["chains"] = block.chains;
      json["steps"] = block.steps;
    } else {
      json["paths"] = block.paths;
      json["elements"] = block.elements;
    }
  }
  json["coder"] = block.coder;
  json["coder_name"] = coder_name(block.coder);
  json["revision"] = block.revision;
  json["table"] = block.table;
  return json;
}

/// Width in grid units and number of paths, the thinnest first.
Json pens_of(const PageEntry& page, const Content& held) {
  Json pens = Json::array();
  for (const auto& [width, paths] : held.pens) {
    pens.push_back(
        {{"width", static_cast<double>(width) / page.scale}, {"paths", paths}});
  }
  return pens;
}

Json to_json(const PageEntry& page, const Content& held) {
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
          {"paths", held.paths},
          {"lines", held.lines},
          {"arcs", held.arcs},
          {"steps", held.steps},
          {"pens", pens_of(page, held)},
          {"checksum", fmt::format("{:08x}", page.checksum)},
          {"blocks", std::move(blocks)}};
}

}  // namespace

Json to_json(const std::string& path, const FileInfo& info,
             const Contents& held, std::uint64_t bytes) {
  const Content& content = held.sum;
  Json pages = Json::array();
  for (std::size_t i = 0; i < info.pages.size(); ++i) {
    pages.push_back(to_json(info.pages[i], held.pages[i]));
  }
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
      {"lines", content.lines},
      {"arcs", content.arcs},
      {"metadata", to_json(info.metadata)},
      {"pages", std::move(pages)}};
}

}  // namespace unstep::cli
