#pragma once

#include <string_view>

namespace unstep::codec {

/// Names and metadata are UTF-8 (RFC 3629: no surrogates, shortest form, up to
/// U+10FFFF) without the byte 0.
[[nodiscard]] bool is_text(std::string_view bytes);

}  // namespace unstep::codec
