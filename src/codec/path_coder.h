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
  /// Closed paths are coded from their topmost vertex (smallest y, then x):
  /// the true origin comes after so many elements, counted on or, if negative,
  /// back from there. |turn| <= elements / 2.
  std::int64_t turn = 0;
};

/// log2 of the models' counters per context.
inline constexpr int kPathTableBits = 16;

}  // namespace unstep::codec
