#pragma once

#include <cstdint>

#include "unstep/grid.h"

/// Coder 16: chains under mixed models, docs/format.md.
namespace unstep::codec {

inline constexpr std::uint8_t kChainRevision = 1;  ///< of the encoder

/// log2 of the model's slots per context, a rule of the payload's steps only,
/// so that it need not be stored.
[[nodiscard]] constexpr int chain_table_bits(std::uint64_t steps) {
  return steps < 5'000 ? 10 : steps < 50'000 ? 12 : 16;
}

/// Everything of a chain but its steps.
struct ChainHead {
  Point origin;
  Connectivity connectivity = Connectivity::eight;
  bool closed = false;
  std::uint64_t steps = 0;
};

}  // namespace unstep::codec
