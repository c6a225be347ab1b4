#include "cli/output_format.h"

#include <algorithm>
#include <array>

namespace unstep::cli {
namespace {

struct Ending {
  std::string_view word;
  OutputFormat format;
};

/// The first of a format is its usual one.
constexpr std::array<Ending, 19> kEndings{{{"png", OutputFormat::png},
                                           {"pbm", OutputFormat::pbm},
                                           {"tif", OutputFormat::tiff},
                                           {"svg", OutputFormat::svg},
                                           {"dxf", OutputFormat::dxf},
                                           {"pdf", OutputFormat::pdf},
                                           {"hpgl", OutputFormat::hpgl},
                                           {"json", OutputFormat::json},
                                           {"fc", OutputFormat::freeman},
                                           {"ngc", OutputFormat::program},
                                           {"tiff", OutputFormat::tiff},
                                           {"plt", OutputFormat::hpgl},
                                           {"hpg", OutputFormat::hpgl},
                                           {"hgl", OutputFormat::hpgl},
                                           {"nc", OutputFormat::program},
                                           {"gcode", OutputFormat::program},
                                           {"gc", OutputFormat::program},
                                           {"tap", OutputFormat::program},
                                           {"cnc", OutputFormat::program}}};
constexpr std::size_t kFormats = 10;

}  // namespace

std::string_view extension(OutputFormat format) {
  for (const Ending& ending : kEndings) {
    if (ending.format == format) return ending.word;
  }
  return "";
}

std::optional<OutputFormat> format_of_word(std::string_view word) {
  for (const Ending& ending : kEndings) {
    if (ending.word == word) return ending.format;
  }
  return std::nullopt;
}

std::optional<OutputFormat> format_of_name(std::string_view path) {
  for (const Ending& ending : kEndings) {
    if (has_suffix(path, '.' + std::string(ending.word))) return ending.format;
  }
  return std::nullopt;
}

const std::string& format_words() {
  static const std::string words = [] {
    std::string text;
    for (std::size_t i = 0; i < kFormats; ++i) {
      if (i > 0) text += i + 1 == kFormats ? " or " : ", ";
      text += kEndings[i].word;
    }
    return text;
  }();
  return words;
}

std::optional<RasterFormat> raster_format(OutputFormat format) {
  switch (format) {
    case OutputFormat::pbm: return RasterFormat::pbm;
    case OutputFormat::png: return RasterFormat::png;
    case OutputFormat::tiff: return RasterFormat::tiff;
    default: return std::nullopt;
  }
}

std::optional<VectorFormat> vector_format(OutputFormat format) {
  switch (format) {
    case OutputFormat::svg: return VectorFormat::svg;
    case OutputFormat::dxf: return VectorFormat::dxf;
    case OutputFormat::hpgl: return VectorFormat::hpgl;
    case OutputFormat::pdf: return VectorFormat::pdf;
    case OutputFormat::json: return VectorFormat::json;
    case OutputFormat::freeman: return VectorFormat::freeman;
    default: return std::nullopt;
  }
}

bool holds_pages(OutputFormat format) {
  return format == OutputFormat::tiff || format == OutputFormat::pdf ||
         format == OutputFormat::json;
}

bool has_suffix(std::string_view path, std::string_view suffix) {
  if (path.size() < suffix.size()) return false;
  const std::string_view end = path.substr(path.size() - suffix.size());
  return std::equal(end.begin(), end.end(), suffix.begin(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b;
  });
}

}  // namespace unstep::cli
