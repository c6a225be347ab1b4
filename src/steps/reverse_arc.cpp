#include "steps/reverse_arc.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "steps/arc_rule.h"
#include "steps/arc_search.h"
#include "steps/centre_region.h"

namespace unstep::steps {
namespace {

/// How far around a centre that points say is looked: along the arc, and
/// towards it, where a flat arc says less.
constexpr double kAside = 1.6;
constexpr double kAlong = 8.5;

/// Regions of centres that are tried: of the longest way, and of shorter ones.
constexpr int kRegions = 12;

/// A bend is taken for one of a circle if it is seen over so many steps, and
/// so far from straight.
constexpr std::size_t kLeastBend = 24;
constexpr double kLeastSagitta = 2;

double way(Point a, Point b) {
  return std::hypot(double{1} * a.x - b.x, double{1} * a.y - b.y);
}

/// Above 0: q lies to the left of the way from a to p.
double side(Point a, Point p, Point q) {
  return (double{1} * p.x - a.x) * (double{1} * q.y - a.y) -
         (double{1} * p.y - a.y) * (double{1} * q.x - a.x);
}

/// The centre of the circle through three points, rounded.
std::optional<Point> centre_of(Point origin, Point a, Point b) {
  const double ax = double{1} * a.x - origin.x;
  const double ay = double{1} * a.y - origin.y;
  const double bx = double{1} * b.x - origin.x;
  const double by = double{1} * b.y - origin.y;
  const double cross = 2 * (ax * by - ay * bx);
  if (cross == 0) return std::nullopt;
  const double aa = ax * ax + ay * ay;
  const double bb = bx * bx + by * by;
  const double x = (by * aa - ay * bb) / cross;
  const double y = (ax * bb - bx * aa) / cross;
  constexpr double kMost = 1 << 26;
  if (!(std::abs(x) < kMost) || !(std::abs(y) < kMost)) return std::nullopt;
  return Point{origin.x + static_cast<std::int32_t>(std::lround(x)),
               origin.y + static_cast<std::int32_t>(std::lround(y))};
}

/// Points on the way, spread evenly.
constexpr std::size_t kSamples = 9;
using Samples = std::array<Point, kSamples>;
Samples samples_of(std::span<const Point> points, std::size_t reach) {
  Samples samples;
  for (std::size_t i = 0; i < kSamples; ++i) {
    samples[i] = points[i * reach / (kSamples - 1)];
  }
  return samples;
}

/// The nearest and the farthest of samples from a centre.
struct Ring {
  double low = 0;
  double high = 0;
};
Ring ring_of(const Samples& samples, Point centre) {
  Ring ring{1e300, 0};
  for (const Point p : samples) {
    ring.low = std::min(ring.low, way(p, centre));
    ring.high = std::max(ring.high, way(p, centre));
  }
  return ring;
}

/// One step of Gauss and Newton from a centre towards the circle nearest to
/// many points of the way, in the mean of squares: what rounding to the grid
/// has moved them by cancels.
Point refined(std::span<const Point> points, std::size_t reach, Point centre) {
  const std::size_t count = std::min<std::size_t>(reach + 1, 1024);
  // The normal equations of the centre, the radius eliminated.
  double sx = 0, sy = 0, sr = 0, xx = 0, xy = 0, yy = 0, xr = 0, yr = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = points[i * reach / (count - 1)];
    const double dx = double{1} * p.x - centre.x;
    const double dy = double{1} * p.y - centre.y;
    const double r = std::max(std::hypot(dx, dy), 1e-9);
    const double ux = dx / r;
    const double uy = dy / r;
    sx += ux, sy += uy, sr += r;
    xx += ux * ux, xy += ux * uy, yy += uy * uy;
    xr += ux * r, yr += uy * r;
  }
  const auto n = static_cast<double>(count);
  xx -= sx * sx / n, xy -= sx * sy / n, yy -= sy * sy / n;
  xr -= sx * sr / n, yr -= sy * sr / n;
  const double determinant = xx * yy - xy * xy;
  if (!(std::abs(determinant) > 1e-9)) return centre;
  const double x = (xr * yy - yr * xy) / determinant;
  const double y = (yr * xx - xr * xy) / determinant;
  constexpr double kFar = 1 << 20;
  if (!(std::abs(x) < kFar) || !(std::abs(y) < kFar)) return centre;
  return {centre.x + static_cast<std::int32_t>(std::lround(x)),
          centre.y + static_cast<std::int32_t>(std::lround(y))};
}

/// Calls take(centre) for the places around `centre` where that of an arc
/// through `middle` may be.
template <class Take>
void visit_around(Point centre, Point middle, Take&& take) {
  const double radius = std::max(way(centre, middle), 1.0);
  const double nx = (double{1} * middle.x - centre.x) / radius;
  const double ny = (double{1} * middle.y - centre.y) / radius;
  constexpr auto kMost = static_cast<std::int32_t>(kAlong);
  for (std::int32_t dy = -kMost; dy <= kMost; ++dy) {
    for (std::int32_t dx = -kMost; dx <= kMost; ++dx) {
      const bool near = dx >= -2 && dx <= 2 && dy >= -2 && dy <= 2;
      if (!near && (std::abs(dx * ny - dy * nx) > kAside ||
                    std::abs(dx * nx + dy * ny) > kAlong)) {
        continue;
      }
      take(Point{centre.x + dx, centre.y + dy});
    }
  }
}

/// The circle that the points follow from the first on, seen as far as it
/// goes.
struct Bend {
  Point centre;
  Point middle;  ///< of the way seen
  bool clockwise = false;
  Samples samples{};
};
std::optional<Bend> bend_of(std::span<const Point> points) {
  std::optional<Bend> found;
  std::size_t seen = 0;
  for (std::size_t reach = kLeastBend; reach < points.size();
       reach += reach / 2) {
    const Samples samples = samples_of(points, reach);
    const Point a = samples.front();
    const Point middle = samples[kSamples / 2];
    const Point b = samples.back();
    const std::optional<Point> centre = centre_of(a, middle, b);
    if (!centre) continue;
    const Ring ring = ring_of(samples, *centre);
    if (ring.high - ring.low > 2) break;
    const double chord = way(a, b);
    const double turn = side(a, b, middle);
    if (std::abs(turn) < kLeastSagitta * chord) continue;
    found = Bend{*centre, middle, side(a, middle, b) < 0, samples};
    seen = reach;
  }
  if (found) found->centre = refined(points, seen, found->centre);
  return found;
}

}  // namespace

std::optional<ExactArc> longest_arc(std::span<const Step> steps,
                                    std::span<const Point> points,
                                    std::size_t least, bool combined,
                                    double step_mm) {
  least = std::max(least, kLeastArc);
  if (steps.size() <= least) return std::nullopt;
  ArcSearch search(steps, points, combined, step_mm);
  search.set_least(least);
  for (const bool clockwise : {false, true}) {
    CentreRegion region(clockwise);
    const std::size_t taken = region.take(steps, points, combined);
    for (int tries = 0; tries < kRegions; ++tries) {
      if (taken <= std::max(least, search.best().steps)) break;
      for (const Point centre : region.next_centres()) {
        search.try_centre(centre, clockwise);
      }
    }
  }
  if (search.best().steps <= least) return std::nullopt;
  return search.best();
}

std::optional<LaterArc> later_arc(
    std::span<const Step> steps, std::span<const Point> points,
    std::size_t first, std::size_t last, bool combined, double step_mm,
    const std::function<bool(std::size_t)>& may_begin) {
  const std::optional<Bend> bend = bend_of(points.subspan(last));
  if (!bend) return std::nullopt;
  const double radius = way(points[last], bend->centre);
  // A straight way leaves a circle by a step within sqrt(2 R) steps.
  const auto back = static_cast<std::size_t>(16 + 3 * std::sqrt(radius));
  LaterArc found;
  std::size_t end = last + kLeastBend;
  bool closed = false;  // the end found is on the circle
  visit_around(bend->centre, bend->middle, [&](Point centre) {
    const Ring ring = ring_of(bend->samples, centre);
    if (ring.high - ring.low > 1.5) return;
    for (std::size_t at = last; at >= first && at + back > last; --at) {
      const double away = way(points[at], centre);
      if (away < ring.high - 1.25 || away > ring.low + 1.25) continue;
      ArcSearch search(steps.subspan(at), points.subspan(at), combined,
                       step_mm);
      search.set_least(end - at - 1);
      search.try_centre({centre.x - points[at].x, centre.y - points[at].y},
                        bend->clockwise);
      const ExactArc& best = search.best();
      if (at + best.steps < end || best.arc.centre == Point{}) continue;
      const bool on = off_circle(best.arc.centre, best.arc.end) == 0;
      const bool better = at + best.steps > end || (on && !closed);
      if (!better || !may_begin(at)) continue;
      found = {at, best};
      end = at + best.steps;
      closed = on;
    }
  });
  if (found.arc.steps == 0) return std::nullopt;
  return found;
}

}  // namespace unstep::steps
