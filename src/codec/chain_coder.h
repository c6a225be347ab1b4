#pragma once

#include <cstdint>

#include "unstep/grid.h"

/// Coder 16: chains under mixed models, docs/format.md.
namespace unstep::codec {

inline constexpr std::uint8_t kChainRevision = 0;

/// Everything of a chain but its steps.
struct ChainHead {
  Point origin;
  Connectivity connectivity = Connectivity::eight;
  bool closed = false;
  std::uint64_t steps = 0;
};

}  // namespace unstep::codec
