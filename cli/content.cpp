#include "cli/content.h"

#include <fmt/format.h>

#include "cli/pack.h"
#include "codec/block_coder.h"
#include "unstep/interpolate.h"

namespace unstep::cli {
namespace {

Method method_of(const Page& page) {
  if (page.fidelity.kind == Fidelity::Kind::device) return Method::device;
  return page.drawing.paint == Paint::fill ? Method::evaluation
                                           : Method::evaluation8;
}

/// Steps stay 0 where there are more than the limit or no grid holds them.
Content count_paths(const Page& page, const DecodeLimits& limits) {
  Content content;
  Drawing one;
  one.canvas = page.drawing.canvas;
  one.scale = page.drawing.scale;
  one.paths.resize(1);
  bool counted = true;
  for (const Path& path : page.drawing.paths) {
    ++content.paths;
    if (page.drawing.paint == Paint::stroke) ++content.pens[path.width];
    for (const Path::Element& element : path.elements) {
      ++(element.kind == Path::Kind::arc ? content.arcs : content.lines);
    }
    if (!counted) continue;
    one.paths[0] = path;
    const Result<Drawing> drawn = step_paths(
        one, {method_of(page), 1.0, limits.max_steps - content.steps});
    counted = static_cast<bool>(drawn);
    if (counted) content.steps += drawn->chains[0].steps.size();
  }
  if (!counted) content.steps = 0;
  return content;
}

}  // namespace

Content& Content::operator+=(const Content& more) {
  pixels += more.pixels;
  chains += more.chains;
  paths += more.paths;
  lines += more.lines;
  arcs += more.arcs;
  steps += more.steps;
  return *this;
}

Result<Contents> contents_of(const UstpReader& reader,
                             const DecodeLimits& limits) {
  Contents contents;
  const std::vector<PageEntry>& pages = reader.info().pages;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const PageEntry& entry = pages[i];
    Content content;
    if (entry.kind == PageKind::paths) {
      const Result<Page> page = reader.read_page(i);
      if (!page) {
        return Error{page.error().code,
                     on_page(i, pages.size(), page.error().message)};
      }
      content = count_paths(*page, limits);
    } else if (entry.kind == PageKind::ink) {
      content.pixels = static_cast<std::uint64_t>(entry.canvas.width) *
                       static_cast<std::uint64_t>(entry.canvas.height);
    }
    for (const PageEntry::Block& block : entry.blocks) {
      content.chains += block.chains;
      content.steps += block.steps;
    }
    contents.pages.push_back(content);
    contents.sum += content;
  }
  return contents;
}

double bits_per(std::uint64_t bytes, std::uint64_t count) {
  return count == 0
             ? 0.0
             : 8.0 * static_cast<double>(bytes) / static_cast<double>(count);
}

std::string coder_name(std::uint8_t coder) {
  switch (coder) {
    case codec::kCoderStored: return "stored";
    case codec::kCoderContours: return "contours";
    case codec::kCoderChains: return "chains";
    case codec::kCoderPaths: return "paths";
    case codec::kCoderStrokes: return "strokes";
    case codec::kCoderProgram: return "program";
    default: return fmt::format("coder {}", coder);
  }
}

std::string_view form_name(FileInfo::Form form) {
  return form == FileInfo::Form::short_form ? "short" : "block";
}

std::string_view kind_name(PageKind kind) {
  if (kind == PageKind::ink) return "ink";
  if (kind == PageKind::program) return "program";
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

}  // namespace unstep::cli
