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

/// An arc in place of the lines from one vertex to another.
struct PathArc {
  std::size_t first = 0;
  std::size_t end = 0;
  Arc arc;
};

/// A path of lines with some of them replaced by arcs, in their order.
struct ArcPath {
  LineVertices vertices;
  std::vector<PathArc> arcs;
  /// The whole ring as one circle; without `arcs`, for the case that it may not
  /// stay.
  std::optional<RingArcs> ring;

  /// Lines and arcs, without those of the ring.
  [[nodiscard]] std::size_t parts() const {
    std::size_t count = vertices.size() - 1;
    for (const PathArc& arc : arcs) count -= arc.end - arc.first - 1;
    return count;
  }
};

/// visit(a, b, arc) for every part from vertex a to vertex b; `arc` is nullptr
/// for lines.
template <class Visit>
void for_parts(const ArcPath& path, const Visit& visit) {
  auto arc = path.arcs.begin();
  for (std::size_t a = 0; a + 1 < path.vertices.size();) {
    const bool is_arc = arc != path.arcs.end() && arc->first == a;
    const std::size_t b = is_arc ? arc->end : a + 1;
    visit(a, b, is_arc ? &arc->arc : nullptr);
    if (is_arc) ++arc;
    a = b;
  }
}

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
/// many paths were. Works in bands of `band_parts` lines and arcs or so, of
/// which there is a copy in memory.
std::uint64_t remove_crossing_arcs(std::span<ArcPath> paths,
                                   const std::vector<bool>& closed,
                                   std::int32_t scale,
                                   std::int64_t band_parts = 1 << 16);

/// Puts lines back for arcs that cost more than those do.
void drop_dear_arcs(ArcPath& path, const LinePrice& price);

/// The path itself.
Path path_of(const ArcPath& path, bool closed);

}  // namespace unstep::reverse
