#include "codec/block_coder.h"

namespace unstep::codec {

Result<std::vector<Chain>> decode_chains(
    const CoderName& /*name*/, std::span<const std::uint8_t> /*payload*/,
    std::uint64_t /*count*/, std::uint64_t /*steps*/,
    const DecodeLimits& /*limits*/, const BlockProgress& /*progress*/) {
  return Error{ErrorCode::unsupported, "chains are not coded yet"};
}

}  // namespace unstep::codec
