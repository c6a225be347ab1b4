#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "unstep/codec.h"

/// Text of foreign files to UTF-8 metadata and back.
namespace unstep {

[[nodiscard]] bool is_utf8(std::string_view text);
[[nodiscard]] std::string latin1_to_utf8(std::string_view text);

/// Nothing if a character is not in Latin-1. REQUIRES: is_utf8(text).
[[nodiscard]] std::optional<std::string> utf8_to_latin1(std::string_view text);

/// The text if it is UTF-8, else read as Latin-1.
[[nodiscard]] std::string to_utf8(std::string_view text);

/// REQUIRES: is_utf8(text).
[[nodiscard]] std::u32string code_points(std::string_view text);

/// Keys are unique: the value of a repeated key is appended after a newline.
void add_metadata(Metadata& metadata, const std::string& key,
                  const std::string& value);

}  // namespace unstep
