#include "unstep/result.h"

namespace unstep {

std::string_view to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::truncated: return "truncated";
    case ErrorCode::bad_magic: return "bad_magic";
    case ErrorCode::unsupported_version: return "unsupported_version";
    case ErrorCode::unsupported: return "unsupported";
    case ErrorCode::corrupt: return "corrupt";
    case ErrorCode::checksum_mismatch: return "checksum_mismatch";
    case ErrorCode::limit_exceeded: return "limit_exceeded";
    case ErrorCode::out_of_range: return "out_of_range";
    case ErrorCode::io_error: return "io_error";
    case ErrorCode::output_exists: return "output_exists";
    case ErrorCode::invalid_argument: return "invalid_argument";
    case ErrorCode::cancelled: return "cancelled";
    case ErrorCode::internal: return "internal";
  }
  return "unknown";
}

}  // namespace unstep
