#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "grid/arc_circle.h"
#include "reverse/tolerance_cone.h"
#include "unstep/grid.h"

namespace unstep::reverse {

/// The points of a chain that an arc shall stand for, and its ends, each
/// within the tolerance of the first and the last point. Path units.
struct ArcTask {
  std::span<const Point> points;
  Point start;
  Point end;
};

/// A ring that is one circle: one full circle, or two or three arcs from
/// point to point of the chain.
struct RingArcs {
  Point start;
  std::vector<Arc> arcs;
};

/// Fits one arc between two given ends. All circles through both ends are a
/// pencil: one number, how far the centre is from the chord, tells them apart,
/// and in good approximation every point of the chain asks for an interval of
/// it. A whole centre near the middle of what is left is then proved or not.
class ArcFitter {
 public:
  /// `unit`: path units per grid unit.
  ArcFitter(PathTolerance tolerance, std::int32_t unit);

  /// An arc with Frechet distance at most the tolerance to the points, proved
  /// in integers; none if none was found or start == end.
  [[nodiscard]] std::optional<Arc> fit(const ArcTask& task) const;

  /// A whole ring, whose last point is its first, as one circle. Full circles
  /// have a whole centre and start at the point that is most nearly on them;
  /// any other centre takes two arcs, or three.
  [[nodiscard]] std::optional<RingArcs> fit_ring(
      std::span<const Point> ring) const;

  /// The proof alone. The walk of the checker, but from one place to one
  /// place: the arc waits for points that are behind it.
  [[nodiscard]] bool proves(const Arc& arc, const ArcTask& task) const;

 private:
  struct Pencil;

  [[nodiscard]] std::optional<RingArcs> full_circle(std::span<const Point> ring,
                                                    Point centre) const;
  [[nodiscard]] std::optional<RingArcs> split_circle(
      std::span<const Point> ring, std::size_t count) const;
  [[nodiscard]] bool decides(const Arc& arc) const;

  std::int64_t numerator_;
  std::int64_t denominator_;
  std::int64_t unit_;
  double t_;
};

}  // namespace unstep::reverse
