#include "formats/text.h"

#include <cstddef>
#include <cstdint>

namespace unstep {
namespace {

/// Length of the well-formed UTF-8 sequence at the start, 0 if there is none
/// (RFC 3629: no overlong forms, no surrogates, at most U+10FFFF).
std::size_t sequence_length(std::string_view text) {
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto tail = [byte](std::size_t i) { return (byte(i) & 0xc0U) == 0x80; };
  const unsigned b0 = byte(0);
  const unsigned b1 = byte(1);
  if (b0 < 0x80) return 1;
  if (b0 >= 0xc2 && b0 <= 0xdf) return tail(1) ? 2 : 0;
  if ((b0 & 0xf0U) == 0xe0) {
    const bool overlong = b0 == 0xe0 && b1 < 0xa0;
    const bool surrogate = b0 == 0xed && b1 > 0x9f;
    return tail(1) && tail(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (b0 >= 0xf0 && b0 <= 0xf4) {
    const bool overlong = b0 == 0xf0 && b1 < 0x90;
    const bool beyond = b0 == 0xf4 && b1 > 0x8f;
    return tail(1) && tail(2) && tail(3) && !overlong && !beyond ? 4 : 0;
  }
  return 0;
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string latin1_to_utf8(std::string_view text) {
  std::string utf8;
  utf8.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xc0 | byte >> 6);
      utf8 += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return utf8;
}

std::optional<std::string> utf8_to_latin1(std::string_view text) {
  std::string latin1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x80) {
      latin1 += text[i];
    } else if (byte <= 0xc3 && i + 1 < text.size()) {
      const auto next = static_cast<unsigned char>(text[++i]);
      latin1 += static_cast<char>((byte & 3) << 6 | (next & 0x3f));
    } else {
      return std::nullopt;
    }
  }
  return latin1;
}

std::string to_utf8(std::string_view text) {
  return is_utf8(text) ? std::string(text) : latin1_to_utf8(text);
}

std::u32string code_points(std::string_view text) {
  std::u32string points;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    // The lead byte keeps 7, 5, 4 or 3 bits.
    char32_t point = length == 1 ? first : first & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i) {
      point = point << 6 | (static_cast<unsigned char>(text[i]) & 0x3fU);
    }
    points += point;
    text.remove_prefix(length);
  }
  return points;
}

void add_metadata(Metadata& metadata, const std::string& key,
                  const std::string& value) {
  for (auto& [known, text] : metadata) {
    if (known == key) {
      text += "\n" + value;
      return;
    }
  }
  metadata.emplace_back(key, value);
}

}  // namespace unstep
