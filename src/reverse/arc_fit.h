#pragma once

#include <cstddef>
#include <optional>
#include <span>

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

/// A ring that is one circle.
struct FullCircle {
  Point start;
  Arc arc;
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

  /// One circle for a whole ring, whose last point is its first, started at
  /// the point that is most nearly on it. Its centre is a whole point.
  [[nodiscard]] std::optional<FullCircle> fit_circle(
      std::span<const Point> ring) const;

  /// The proof alone. The walk of the checker, but from one place to one
  /// place: the arc waits for points that are behind it.
  [[nodiscard]] bool proves(const Arc& arc, const ArcTask& task) const;

 private:
  struct Pencil;

  [[nodiscard]] bool decides(const Arc& arc) const;

  std::int64_t numerator_;
  std::int64_t denominator_;
  std::int64_t unit_;
  double t_;
};

}  // namespace unstep::reverse
