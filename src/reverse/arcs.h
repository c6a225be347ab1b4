#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reverse/arc_fit.h"
#include "reverse/line_price.h"
#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// Part of a path: one line or one arc, from where the last part ended to the
/// vertex `end` of the path of lines.
struct PathPart {
  std::size_t end = 0;
  bool is_arc = false;
  Arc arc;
};
using PathParts = std::vector<PathPart>;

/// A path of lines with some of them replaced by arcs.
struct ArcPath {
  LineVertices vertices;
  PathParts parts;
  /// The whole ring as one circle; `parts` are then lines, for the case that
  /// it may not stay.
  std::optional<RingArcs> ring;
};

/// An arc is taken if it stands for at least so many lines: it has two numbers
/// more than a line, and it must be worth them.
inline constexpr std::size_t kLeastLines = 3;

/// Replaces lines by arcs, from each vertex the longest that is found by
/// doubling and halving. Every arc is proved (ArcFitter). A ring may start at
/// another of its vertices, and is one circle if it can be. Time O(steps
/// log steps) at most, O(steps) for the usual short arcs.
ArcPath fit_arcs(const ChainWalk& chain, const ArcFitter& fitter,
                 LineVertices vertices);

/// The lines as they are.
ArcPath without_arcs(LineVertices vertices);

/// Puts lines back for arcs that meet other parts of the drawing, but for the
/// joints of neighbours; and arcs that only touch or come within 2^-10 path
/// units, to be sure. `paths` without their arcs are not changed. Returns how
/// many paths were.
std::uint64_t remove_crossing_arcs(std::span<ArcPath> paths,
                                   const std::vector<bool>& closed,
                                   std::int32_t scale);

/// Puts lines back for arcs that cost more than those do.
void drop_dear_arcs(ArcPath& path, const LinePrice& price);

/// The path itself.
Path path_of(const ArcPath& path, bool closed);

}  // namespace unstep::reverse
