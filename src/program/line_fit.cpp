#include "program/line_fit.h"

#include <algorithm>
#include <cmath>

#include "program/gallop.h"

namespace unstep {
namespace {

/// A line from the written vertex `first` to the written vertex `last`.
/// Positions along it are times its length: 0 ... square.
struct Line {
  RunPoint a;
  double dx, dy, dz;
  double square;
  double most;  ///< of away(), for points within the tolerance

  Line(const Polyline& run, std::size_t first, std::size_t last,
       double tolerance)
      : a(run.written[first]),
        dx(run.written[last].x - a.x),
        dy(run.written[last].y - a.y),
        dz(run.written[last].z - a.z),
        square(dx * dx + dy * dy + dz * dz),
        most(tolerance * tolerance * square) {}

  [[nodiscard]] double along(const RunPoint& p) const {
    return (p.x - a.x) * dx + (p.y - a.y) * dy + (p.z - a.z) * dz;
  }
  /// Squared distance from the infinite line, times square.
  [[nodiscard]] double away(const RunPoint& p) const {
    const double x = p.x - a.x;
    const double y = p.y - a.y;
    const double z = p.z - a.z;
    const double cx = y * dz - z * dy;
    const double cy = z * dx - x * dz;
    const double cz = x * dy - y * dx;
    return cx * cx + cy * cy + cz * cz;
  }
};

bool all_near(const Polyline& run, std::size_t first, std::size_t last,
              double tolerance) {
  const RunPoint& a = run.written[first];
  for (std::size_t i = first; i <= last; ++i) {
    const double x = run.vertex[i].x - a.x;
    const double y = run.vertex[i].y - a.y;
    const double z = run.vertex[i].z - a.z;
    if (x * x + y * y + z * z > tolerance * tolerance) return false;
  }
  return true;
}

// The points of the line that are near enough to a vertex are an interval of
// it, and it must be possible to visit the intervals of all vertices without
// turning back. Edges need no check: both ends of an edge are near, so all
// between is. (Alt and Godau, Computing the Frechet distance between two
// polygonal curves, 1995.)
bool intervals_in_order(const Polyline& run, std::size_t first,
                        std::size_t last, const Line& line) {
  double reached = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const double along = line.along(run.vertex[i]);
    const double half = std::sqrt(line.most - line.away(run.vertex[i]));
    // The ends of the line belong to the ends of the polyline.
    if (i == first && along - half > 0) return false;
    if (i == last && along + half < line.square) return false;
    if (along + half < reached || along - half > line.square) return false;
    reached = std::max(reached, along - half);
  }
  return true;
}

}  // namespace

bool line_fits(const Polyline& run, std::size_t first, std::size_t last,
               double tolerance) {
  const Line line(run, first, last, tolerance);
  if (line.square == 0) return all_near(run, first, last, tolerance);
  // Vertices that come in order along the line need no roots.
  double peak = 0;
  bool ordered = true;
  for (std::size_t i = first; i <= last; ++i) {
    const RunPoint& p = run.vertex[i];
    if (line.away(p) > line.most) return false;
    const double along = line.along(p);
    ordered = ordered && along >= peak && along <= line.square;
    peak = std::max(peak, along);
  }
  const bool same_ends = line.along(run.vertex[first]) == 0 &&
                         line.along(run.vertex[last]) == line.square;
  return (ordered && same_ends) || intervals_in_order(run, first, last, line);
}

std::size_t line_reach(const Polyline& run, std::size_t first,
                       double tolerance) {
  return gallop(first + 1, run.size() - 1, [&](std::size_t last) {
    return line_fits(run, first, last, tolerance);
  });
}

}  // namespace unstep
