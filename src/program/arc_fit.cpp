#include "program/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "program/units.h"

namespace unstep {
namespace {

/// Coordinates with the chord on the first axis, its middle at 0.
struct ChordFrame {
  double x, y;    ///< the middle
  double ux, uy;  ///< along the chord
  double half;    ///< of its length

  ChordFrame(const RunPoint& a, const RunPoint& b)
      : x((a.x + b.x) / 2), y((a.y + b.y) / 2) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::hypot(dx, dy);
    half = length / 2;
    ux = length > 0 ? dx / length : 1;
    uy = length > 0 ? dy / length : 0;
  }
  [[nodiscard]] double along(double px, double py) const {
    return (px - x) * ux + (py - y) * uy;
  }
  [[nodiscard]] double across(double px, double py) const {
    return (py - y) * ux - (px - x) * uy;
  }
};

/// The heights of centres above the middle of the chord for which circles
/// through both of its ends pass near enough to all points seen.
class HeightRange {
 public:
  HeightRange(double half, double tolerance, double most)
      : half_(half), tolerance_(tolerance), low_(-most), high_(most) {}

  /// |distance to (0, h) - radius(h)| <= t is quadratic in h. A point nearer
  /// to the chord than the tolerance says nothing here.
  bool add(double x, double y) {
    const double t = tolerance_;
    if (std::abs(y) <= t) return true;
    const double a = 4 * (y - t) * (y + t);
    const double q = x * x + y * y - half_ * half_ - t * t;
    const double b = 2 * q * y;  // half of the linear factor
    const double c = q * q - 4 * t * t * half_ * half_;
    const double inner = b * b - a * c;
    if (inner < 0) return false;
    const double root = std::sqrt(inner);
    low_ = std::max(low_, (b - root) / a);
    high_ = std::min(high_, (b + root) / a);
    return low_ <= high_;
  }
  /// The middle of their curvatures; `wanted`, as near as it comes, where the
  /// chord's middle is among them.
  [[nodiscard]] double choose(double wanted) const {
    if (low_ * high_ > 0) return 2 / (1 / low_ + 1 / high_);
    return std::clamp(wanted, low_, high_);
  }

 private:
  double half_;
  double tolerance_;
  double low_;
  double high_;
};

constexpr std::size_t kSamples = 16;

/// Every so many vertices give the centre; the check sees all of them.
template <class Use>
bool for_samples(const Polyline& run, std::size_t first, std::size_t last,
                 const Use& use) {
  const std::size_t edges = last - first;
  const std::size_t count = std::min(edges, kSamples);
  for (std::size_t k = 1; k <= count; ++k) {
    const std::size_t i = first + k * edges / count;
    const RunPoint& p = run.vertex[i];
    const RunPoint& before = run.vertex[i - 1];
    if (!use((p.x + before.x) / 2, (p.y + before.y) / 2)) return false;
    if (i < last && !use(p.x, p.y)) return false;
  }
  return true;
}

/// The circle nearest to vertices spread over the run, by least squares of
/// |p - c|^2 - r^2 [Kasa 1976]; nothing if they are on a line.
std::optional<FittedArc> nearest_circle(const Polyline& run, std::size_t first,
                                        std::size_t last) {
  constexpr std::size_t kMost = 64;
  const std::size_t count = std::min(last - first, kMost);
  const auto sample = [&](std::size_t k) {
    return run.vertex[first + k * (last - first) / count];
  };
  double mx = 0;
  double my = 0;
  for (std::size_t k = 0; k < count; ++k) {
    mx += sample(k).x / static_cast<double>(count);
    my += sample(k).y / static_cast<double>(count);
  }
  double uu = 0, uv = 0, vv = 0, ul = 0, vl = 0, turn = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double u = sample(k).x - mx;
    const double v = sample(k).y - my;
    uu += u * u;
    uv += u * v;
    vv += v * v;
    ul += u * (u * u + v * v) / 2;
    vl += v * (u * u + v * v) / 2;
    const RunPoint next = sample((k + 1) % count);
    turn += u * (next.y - my) - v * (next.x - mx);
  }
  const double d = uu * vv - uv * uv;
  if (d <= 0) return std::nullopt;
  return FittedArc{mx + (ul * vv - vl * uv) / d, my + (vl * uu - ul * uv) / d,
                   turn < 0, 0};
}

/// Centres on the grid near `arc`, the nearest first.
std::optional<FittedArc> round_centre(const Polyline& run, std::size_t first,
                                      std::size_t last, FittedArc arc,
                                      const ArcFitOptions& options) {
  const RunPoint& start = run.written[first];
  const double g = options.grid;
  const double i = std::floor((arc.x - start.x) / g);
  const double j = std::floor((arc.y - start.y) / g);
  const double fi = (arc.x - start.x) / g - i;
  const double fj = (arc.y - start.y) / g - j;
  const double near_i = fi < 0.5 ? 0 : 1;
  const double near_j = fj < 0.5 ? 0 : 1;
  const bool i_first = std::abs(fi - 0.5) < std::abs(fj - 0.5);
  for (int choice = 0; choice < 4; ++choice) {
    const bool other_i = choice == 3 || (choice == (i_first ? 1 : 2));
    const bool other_j = choice == 3 || (choice == (i_first ? 2 : 1));
    FittedArc rounded = arc;
    rounded.x = start.x + (i + (other_i ? 1 - near_i : near_i)) * g;
    rounded.y = start.y + (j + (other_j ? 1 - near_j : near_j)) * g;
    if (arc_fits(run, first, last, rounded, options)) return rounded;
  }
  return std::nullopt;
}

bool near_start(const RunPoint& start, const RunPoint& point, double t) {
  const double x = point.x - start.x;
  const double y = point.y - start.y;
  return x * x + y * y <= t * t;
}

/// The arc whose radius is on the grid, and its centre what follows from it.
std::optional<FittedArc> round_radius(const Polyline& run, std::size_t first,
                                      std::size_t last, const ChordFrame& frame,
                                      double height, bool clockwise,
                                      const ArcFitOptions& options) {
  // More than a half turn has its centre on the other side of the chord, and
  // a radius below 0.
  const bool large = (height > 0) == clockwise && height != 0;
  const double g = options.grid;
  const double radius = std::round(std::hypot(frame.half, height) / g) * g;
  const double square = (radius - frame.half) * (radius + frame.half);
  if (square <= 0) return std::nullopt;
  const double h = clockwise == large ? std::sqrt(square) : -std::sqrt(square);
  const FittedArc arc{frame.x - h * frame.uy, frame.y + h * frame.ux, clockwise,
                      large ? -radius : radius};
  if (!arc_fits(run, first, last, arc, options)) return std::nullopt;
  return arc;
}

constexpr double kMostSmallSweep = 170;
constexpr double kLeastLargeSweep = 190;

}  // namespace

bool radius_says(double degrees) {
  return degrees <= kMostSmallSweep ||
         (degrees >= kLeastLargeSweep && degrees <= kMostRadiusSweep);
}

bool radii_agree(double first, double last, const ArcRules& rules) {
  const double apart = std::abs(first - last);
  return apart <= rules.radius_mm * kPerMm ||
         (apart <= rules.radius_relative * std::min(first, last) &&
          apart <= 100 * rules.radius_mm * kPerMm);
}

bool arc_fits(const Polyline& run, std::size_t first, std::size_t last,
              const FittedArc& arc, const ArcFitOptions& options) {
  const RunPoint& a = run.written[first];
  const RunPoint& b = run.written[last];
  const double r0 = std::hypot(a.x - arc.x, a.y - arc.y);
  const double r1 = std::hypot(b.x - arc.x, b.y - arc.y);
  const double small = std::min(r0, r1);
  const double large = std::max(r0, r1);
  const double t = options.tolerance;
  if (small < options.rules.min_radius_mm * kPerMm || small <= 2 * t ||
      large > options.rules.max_radius_mm * kPerMm ||
      !radii_agree(r0, r1, options.rules)) {
    return false;
  }
  const double low = large - t;
  const double high = small + t;
  const double low2 = low * low;
  const double high2 = high * high;
  const double turn = arc.clockwise ? -1 : 1;
  // Angles about the centre grow from vertex to vertex, by less than a
  // quarter turn, and the start's direction is passed once at most: then the
  // polyline and the arc can be walked at the same angle, and the distance is
  // that between the radii.
  const double sx = a.x - arc.x;
  const double sy = a.y - arc.y;
  double px = run.vertex[first].x - arc.x;
  double py = run.vertex[first].y - arc.y;
  bool seen_far = false;
  bool second_half = false;
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double x = run.vertex[i].x - arc.x;
    const double y = run.vertex[i].y - arc.y;
    const double r2 = x * x + y * y;
    if (r2 < low2 || r2 > high2) return false;
    const double cross = (px * y - py * x) * turn;
    const double dot = px * x + py * y;
    if (cross < 0 || dot <= 0) return false;
    const double ex = x - px;
    const double ey = y - py;
    // The nearest point of the edge, if it is not one of its ends.
    if (px * ex + py * ey < 0 && x * ex + y * ey > 0 &&
        cross * cross < low2 * (ex * ex + ey * ey)) {
      return false;
    }
    const double side = (sx * y - sy * x) * turn;
    const double ahead = sx * x + sy * y;
    if (ahead < 0) seen_far = true;
    if (side < 0) {
      // Before the written start by its rounding, unless far from it.
      if (!seen_far && !near_start(a, run.vertex[i], t)) return false;
      second_half = seen_far;
    } else if (second_half && side > 0 && ahead > 0) {
      // Once around. Only the end may come back to the start.
      if (i != last) return false;
    }
    px = x;
    py = y;
  }
  // The written end is on the same side as the last vertex.
  const double ex = b.x - arc.x;
  const double ey = b.y - arc.y;
  const double side = (sx * ey - sy * ex) * turn;
  const double ahead = sx * ex + sy * ey;
  if (ahead > 0 && (side <= 0) != second_half) return false;
  const double most = options.rules.max_sweep_degrees;
  if (most < 360 || options.rules.by_radius) {
    double sweep = std::atan2(side, ahead) * 180 / std::numbers::pi;
    if (sweep <= 0) sweep += 360;
    if (sweep > most) return false;
    if (options.rules.by_radius) return radius_says(sweep);
  }
  return true;
}

std::optional<std::size_t> beyond_half_turn(const Polyline& run,
                                            std::size_t first, std::size_t last,
                                            const FittedArc& arc) {
  double turned = 0;
  const double turn = arc.clockwise ? -1 : 1;
  for (std::size_t i = first + 1; i < run.size(); ++i) {
    const double px = run.vertex[i - 1].x - arc.x;
    const double py = run.vertex[i - 1].y - arc.y;
    const double x = run.vertex[i].x - arc.x;
    const double y = run.vertex[i].y - arc.y;
    const double step = std::atan2((px * y - py * x) * turn, px * x + py * y);
    if (step < 0 && i > last) return std::nullopt;
    turned += step * 180 / std::numbers::pi;
    if (i > last && turned > kLeastLargeSweep + 1) return i;
  }
  return std::nullopt;
}

std::optional<FittedArc> fit_arc(const Polyline& run, std::size_t first,
                                 std::size_t last,
                                 const ArcFitOptions& options) {
  const RunPoint& a = run.written[first];
  const RunPoint& b = run.written[last];
  const ChordFrame frame(a, b);
  const double most = options.rules.max_radius_mm * kPerMm;
  // Leaves room for the rounding of the centre.
  const double t = options.tolerance - options.grid;
  if (t <= 0) return std::nullopt;
  HeightRange heights(frame.half, t, most);
  double farthest = 0;
  double through = 0;  // the height of the circle through the farthest
  const bool possible =
      for_samples(run, first, last, [&](double px, double py) {
        const double x = frame.along(px, py);
        const double y = frame.across(px, py);
        if (std::abs(y) > std::abs(farthest)) {
          farthest = y;
          through = (x * x + y * y - frame.half * frame.half) / (2 * y);
        }
        return heights.add(x, y);
      });
  if (possible && frame.half > 0) {
    const double h = heights.choose(through);
    if (options.rules.by_radius) {
      return round_radius(run, first, last, frame, h, farthest > 0, options);
    }
    const FittedArc arc{frame.x - h * frame.uy, frame.y + h * frame.ux,
                        farthest > 0, 0};
    if (const auto rounded = round_centre(run, first, last, arc, options)) {
      return rounded;
    }
  }
  if (options.rules.by_radius) return std::nullopt;
  // Where the ends nearly meet, their chord tells little of the direction in
  // which the centre lies.
  if (std::abs(farthest) < 8 * frame.half) return std::nullopt;
  const auto circle = nearest_circle(run, first, last);
  if (!circle) return std::nullopt;
  return round_centre(run, first, last, *circle, options);
}

}  // namespace unstep
