#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "codec/container_format.h"
#include "unstep/codec.h"

/// What the golden tests compare: the header of a file as text and its ink
/// pages as one concatenated PBM.
namespace unstep::testing {

inline std::string text_of(const Resolution& resolution) {
  const auto ratio = [](const Rational& r) {
    return std::to_string(r.numerator) + "/" + std::to_string(r.denominator);
  };
  return ratio(resolution.x) + " " + ratio(resolution.y) + " unit " +
         std::to_string(static_cast<int>(resolution.unit));
}

inline std::string text_of(const Metadata& metadata,
                           const std::string& indent) {
  std::string text;
  for (const auto& [key, value] : metadata) {
    text += indent + key + "=" + value + "\n";
  }
  return text;
}

inline std::string text_of(const PageEntry::Block& block) {
  return "  coder " + std::to_string(block.coder) + "." +
         std::to_string(block.revision) + "." + std::to_string(block.table) +
         " at " + std::to_string(block.offset) + " + " +
         std::to_string(block.bytes) + " rows " +
         std::to_string(block.first_row) + " + " + std::to_string(block.rows) +
         " chains " + std::to_string(block.chains) + " steps " +
         std::to_string(block.steps) +
         (block.coder == 28 ? " lines " + std::to_string(block.lines) +
                                  " bytes " + std::to_string(block.text_bytes)
          : block.coder < 24
              ? ""
              : " paths " + std::to_string(block.paths) + " elements " +
                    std::to_string(block.elements)) +
         "\n";
}

/// What only pages of paths have.
inline std::string text_of_paths_head(const PageEntry& page) {
  if (page.kind != PageKind::paths) return "";
  return " fidelity " + std::to_string(static_cast<int>(page.fidelity.kind)) +
         " tolerance " + std::to_string(page.fidelity.tolerance.numerator) +
         "/" + std::to_string(page.fidelity.tolerance.denominator) + " scale " +
         std::to_string(page.scale) + " paint " +
         std::to_string(static_cast<int>(page.paint));
}

inline std::string text_of(const FileInfo& info) {
  std::string text =
      std::string(info.form == FileInfo::Form::short_form ? "short" : "block") +
      " form, version " + std::to_string(info.version) + "\n" +
      text_of(info.metadata, "");
  for (const PageEntry& page : info.pages) {
    text += std::string("page ") +
            (page.kind == PageKind::ink       ? "ink "
             : page.kind == PageKind::chains  ? "chains "
             : page.kind == PageKind::program ? "program "
                                              : "paths ") +
            std::to_string(page.canvas.width) + " x " +
            std::to_string(page.canvas.height) +
            (page.canvas.y_axis == YAxis::up ? " y up" : "") +
            text_of_paths_head(page) + " checksum " +
            std::to_string(page.checksum) + " name '" + page.info.name +
            "' resolution " + text_of(page.info.resolution) + "\n" +
            text_of(page.info.metadata, "  ");
    for (const PageEntry::Block& block : page.blocks) text += text_of(block);
  }
  return text;
}

/// One line a path, then one an element.
inline std::string text_of(const std::vector<Path>& paths) {
  const auto text = [](const Point& p) {
    return " " + std::to_string(p.x) + " " + std::to_string(p.y);
  };
  std::string lines;
  for (const Path& path : paths) {
    lines += std::string(path.closed ? "closed" : "open") + text(path.origin) +
             " width " + std::to_string(path.width) + "\n";
    for (const Path::Element& element : path.elements) {
      if (element.kind == Path::Kind::segment) {
        lines +=
            "  line" + text({element.segment.dx, element.segment.dy}) + "\n";
      } else {
        lines += "  arc" + text(element.arc.end) + " centre" +
                 text(element.arc.centre) +
                 (element.arc.clockwise ? " clockwise" : " counterclockwise") +
                 "\n";
      }
    }
  }
  return lines;
}

/// REQUIRES: an ink page.
inline std::vector<std::uint8_t> pbm_of(const Bitmap& ink) {
  const std::string head = "P4\n" + std::to_string(ink.width()) + " " +
                           std::to_string(ink.height()) + "\n";
  std::vector<std::uint8_t> bytes(head.begin(), head.end());
  std::vector<std::uint8_t> row(codec::row_bytes(ink.width()));
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    ink.get_row_bytes(y, row, false);
    bytes.insert(bytes.end(), row.begin(), row.end());
  }
  return bytes;
}

}  // namespace unstep::testing
