#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

#include "unstep/codec.h"

/// What every fuzz target has. A target is one function over bytes; libFuzzer
/// or standalone_main.cpp calls it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size);

namespace unstep::fuzz {

/// Small enough that no input takes long or much.
inline DecodeLimits limits() { return {1U << 18, 1U << 18, 8U << 20}; }

/// A property of the code under test; libFuzzer keeps the input of an abort.
inline void require(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "property broken: %.*s\n", static_cast<int>(what.size()),
               what.data());
  std::abort();
}

/// Errors are one line with a reason, and never our own fault.
inline void require_sound(const Error& error) {
  require(error.code != ErrorCode::internal, error.message);
  require(!error.message.empty(), "error without a message");
  require(error.message.find('\n') == std::string::npos, "message of lines");
}

}  // namespace unstep::fuzz
