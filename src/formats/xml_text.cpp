#include "formats/xml_text.h"

#include "formats/text.h"

namespace unstep {

bool append_xml(std::string& out, std::string_view text) {
  const std::string utf8 = to_utf8(text);
  bool complete = true;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    // U+FFFE and U+FFFF are no XML characters either.
    const bool noncharacter = byte == 0xef && i + 2 < utf8.size() &&
                              utf8[i + 1] == '\xbf' &&
                              static_cast<unsigned char>(utf8[i + 2]) >= 0xbe;
    if (noncharacter) {
      complete = false;
      i += 2;
    } else if (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') {
      complete = false;
    } else if (byte == '&') {
      out += "&amp;";
    } else if (byte == '<') {
      out += "&lt;";
    } else if (byte == '>') {
      out += "&gt;";
    } else if (byte == '"') {
      out += "&quot;";
    } else if (byte < 0x20) {  // kept as they are, not as blanks
      out += byte == '\t' ? "&#9;" : byte == '\n' ? "&#10;" : "&#13;";
    } else {
      out += utf8[i];
    }
  }
  return complete;
}

}  // namespace unstep
