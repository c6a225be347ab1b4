#include "codec/text_rules.h"

#include <cstddef>
#include <cstdint>

namespace unstep::codec {
namespace {

/// Length of the sequence that a lead byte begins, 0 if none.
std::size_t sequence_length(std::uint8_t lead) {
  if (lead < 0x80) return lead == 0 ? 0 : 1;
  if (lead < 0xc2) return 0;
  if (lead < 0xe0) return 2;
  if (lead < 0xf0) return 3;
  return lead < 0xf5 ? 4 : 0;
}

/// The second byte of a few lead bytes is bounded more tightly (RFC 3629, 4).
bool fits_lead(std::uint8_t lead, std::uint8_t second) {
  switch (lead) {
    case 0xe0: return second >= 0xa0;
    case 0xed: return second < 0xa0;
    case 0xf0: return second >= 0x90;
    case 0xf4: return second < 0x90;
    default: return true;
  }
}

}  // namespace

bool is_text(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto lead = static_cast<std::uint8_t>(bytes[i]);
    const std::size_t length = sequence_length(lead);
    if (length == 0 || length > bytes.size() - i) return false;
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<std::uint8_t>(bytes[i + k]);
      if ((next & 0xc0) != 0x80) return false;
      if (k == 1 && !fits_lead(lead, next)) return false;
    }
    i += length;
  }
  return true;
}

}  // namespace unstep::codec
