#pragma once

#include <string>
#include <string_view>

namespace unstep {

/// Appends UTF-8 text as XML character data, fit for attributes in double
/// quotes too. False if characters that XML has no place for were left out.
bool append_xml(std::string& out, std::string_view text);

}  // namespace unstep
