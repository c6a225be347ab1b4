#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "unstep/grid.h"

namespace unstep::codec {

/// Paths that follow each other and come as the same group elsewhere, or one
/// that stands alone.
struct PathGroup {
  std::uint64_t first = 0;
  std::uint64_t count = 1;
  std::uint32_t kind = 0;   ///< groups of a kind are alike but for their place
  std::uint32_t times = 1;  ///< how many of the kind there are
};

/// Divides a sequence of paths into groups: pairs that come more than once
/// become groups, the most frequent first, and pairs of groups so on (N. J.
/// Larsson and A. Moffat, Re-Pair, 1999). Only what touches is put together.
std::vector<PathGroup> find_groups(std::span<const Path> paths);

}  // namespace unstep::codec
