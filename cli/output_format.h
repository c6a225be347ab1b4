#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "unstep/formats.h"

/// The formats that a drawing can be turned into, and their names.
namespace unstep::cli {

enum class OutputFormat : std::uint8_t {
  pbm,
  png,
  tiff,
  svg,
  dxf,
  hpgl,
  pdf,
  json,
  freeman,
  program
};

/// "pbm", "png", "tif", "fc" ..., the usual ending of names and --to's word.
[[nodiscard]] std::string_view extension(OutputFormat format);

/// The format of --to: an ending, without its dot.
[[nodiscard]] std::optional<OutputFormat> format_of_word(std::string_view word);

/// The format that a file name's ending asks for, in any case.
[[nodiscard]] std::optional<OutputFormat> format_of_name(std::string_view path);

/// "png, pbm, tif, svg, ..." for messages and help.
[[nodiscard]] const std::string& format_words();

/// How the library calls it; nothing for vectors.
[[nodiscard]] std::optional<RasterFormat> raster_format(OutputFormat format);

/// How the library calls it; nothing for rasters.
[[nodiscard]] std::optional<VectorFormat> vector_format(OutputFormat format);

/// True if one file of the format holds several pages. PBM does so only as a
/// stream.
[[nodiscard]] bool holds_pages(OutputFormat format);

/// True for a name that ends in the suffix, in any case. The suffix is lower
/// case.
[[nodiscard]] bool has_suffix(std::string_view path, std::string_view suffix);

}  // namespace unstep::cli
