#include "codec/block_coder.h"

namespace unstep::codec {

Result<EncodedBlock> encode_chains(std::span<const Chain> /*chains*/,
                                   const BlockProgress& /*progress*/) {
  return Error{ErrorCode::unsupported, "chains are not coded yet"};
}

}  // namespace unstep::codec
