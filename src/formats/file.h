#pragma once

namespace unstep {

/// Unlinks the temporary files that write_file has open at this moment. Async-
/// signal-safe: for a handler that is about to end the process.
void remove_temporaries() noexcept;

}  // namespace unstep
