#include "cli/output_format.h"

#include <algorithm>
#include <array>
#include <string>

namespace unstep::cli {

std::string_view extension(OutputFormat format) {
  switch (format) {
    case OutputFormat::pbm: return "pbm";
    case OutputFormat::png: return "png";
    case OutputFormat::tiff: return "tif";
    case OutputFormat::freeman: return "fc";
  }
  return "";
}

std::optional<OutputFormat> format_of_word(std::string_view word) {
  if (word == "pbm") return OutputFormat::pbm;
  if (word == "png") return OutputFormat::png;
  if (word == "tif" || word == "tiff") return OutputFormat::tiff;
  if (word == "fc") return OutputFormat::freeman;
  return std::nullopt;
}

std::optional<OutputFormat> format_of_name(std::string_view path) {
  constexpr std::array<std::string_view, 5> kWords{"pbm", "png", "tif", "tiff",
                                                   "fc"};
  for (const std::string_view word : kWords) {
    if (has_suffix(path, '.' + std::string(word))) return format_of_word(word);
  }
  return std::nullopt;
}

bool has_suffix(std::string_view path, std::string_view suffix) {
  if (path.size() < suffix.size()) return false;
  const std::string_view end = path.substr(path.size() - suffix.size());
  return std::equal(end.begin(), end.end(), suffix.begin(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b;
  });
}

}  // namespace unstep::cli
