#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

/// The formats that a .ustp file can be turned back into, and their names.
namespace unstep::cli {

enum class OutputFormat : std::uint8_t { pbm, png, tiff, freeman };

/// "pbm", "png", "tif" or "fc", the name's ending and --to's word.
[[nodiscard]] std::string_view extension(OutputFormat format);

/// The format of --to: pbm, png, tif, tiff or fc.
[[nodiscard]] std::optional<OutputFormat> format_of_word(std::string_view word);

/// The format that a file name's ending asks for, in any case.
[[nodiscard]] std::optional<OutputFormat> format_of_name(std::string_view path);

/// True for a name that ends in the suffix, in any case. The suffix is lower
/// case.
[[nodiscard]] bool has_suffix(std::string_view path, std::string_view suffix);

}  // namespace unstep::cli
