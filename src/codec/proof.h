#pragma once

#include "unstep/result.h"

namespace unstep::codec {

/// What a failed comparison of the encoded with the given becomes: internal,
/// or `why` itself if the caller cancelled.
[[nodiscard]] Error proof_failed(const Error& why);

}  // namespace unstep::codec
