#pragma once

#include <cstdint>

#include "unstep/grid.h"

/// Coder 24: paths under mixed models, docs/format.md.
namespace unstep::codec {

inline constexpr std::uint8_t kPathRevision = 0;

/// Everything of a path but its elements.
struct PathHead {
  Point origin;
  bool closed = false;
  std::int32_t width = 0;
  std::uint64_t elements = 0;
};

}  // namespace unstep::codec
