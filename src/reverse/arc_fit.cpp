#include "reverse/arc_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "grid/arc_ring.h"

namespace unstep::reverse {
namespace {

Vector64 between(Point from, Point to) {
  return {std::int64_t{to.x} - from.x, std::int64_t{to.y} - from.y};
}

/// |d| <= t, exactly. Range: parts of d beyond t are refused first, so that
/// (denominator part)^2 <= numerator^2 < 2^66.
bool within(Vector64 d, std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t reach = numerator / denominator;
  if (d.x > reach || d.x < -reach || d.y > reach || d.y < -reach) return false;
  return dot(d, d) * denominator * denominator <= Int128{numerator} * numerator;
}

/// The centre is not known better than this, relative to the radius, before
/// the numbers of the fit lose their meaning.
constexpr double kMostRadius = 1 << 26;

}  // namespace

/// The circles through (0, 0) and `end`: centre = end / 2 + mu * normal.
struct ArcFitter::Pencil {
  double ex;
  double ey;
  double nx;  ///< unit normal, left of the chord
  double ny;
  double half2;  ///< half the chord, squared

  explicit Pencil(Vector64 end)
      : ex(static_cast<double>(end.x)), ey(static_cast<double>(end.y)) {
    const double length = std::hypot(ex, ey);
    nx = -ey / length;
    ny = ex / length;
    half2 = length * length / 4;
  }

  struct Terms {
    double g;  ///< power of the point for mu = 0
    double v;  ///< how far left of the chord
  };
  [[nodiscard]] Terms terms(Vector64 p) const {
    const auto x = static_cast<double>(p.x);
    const auto y = static_cast<double>(p.y);
    return {x * (x - ex) + y * (y - ey), x * nx + y * ny};
  }
};

namespace {

struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

}  // namespace

ArcFitter::ArcFitter(PathTolerance tolerance, std::int32_t unit) : unit_(unit) {
  const std::int64_t denominator = std::int64_t{1} << PathTolerance::kBits;
  const std::int64_t common = std::gcd(tolerance.fixed, denominator);
  numerator_ = tolerance.fixed / common;
  denominator_ = denominator / common;
  t_ = static_cast<double>(numerator_) / static_cast<double>(denominator_);
}

bool ArcFitter::decides(const Arc& arc) const {
  return numerator_ <= std::int64_t{1} << 30 &&
         ArcRing::decides(arc, numerator_, denominator_, unit_);
}

std::optional<Arc> ArcFitter::fit(const ArcTask& task) const {
  const Vector64 end = between(task.start, task.end);
  if (end == Vector64{} || task.points.size() < 5) return std::nullopt;
  const Pencil pencil(end);
  const auto middle =
      pencil.terms(between(task.start, task.points[task.points.size() / 2]));
  if (std::abs(middle.v) < t_ / 2) return std::nullopt;
  double mu = middle.g / (2 * middle.v);
  Interval allowed;
  for (const bool all : {false, true}) {
    const double radius = std::sqrt(pencil.half2 + mu * mu);
    if (!(radius < kMostRadius)) return std::nullopt;
    const double width = 2 * radius * t_;
    const double square = t_ * t_;
    allowed = {};
    constexpr std::size_t kFew = 24;
    const std::size_t stride =
        all ? 1 : std::max<std::size_t>(1, task.points.size() / kFew);
    for (std::size_t i = 0; i < task.points.size(); i += stride) {
      const auto [g, v] = pencil.terms(between(task.start, task.points[i]));
      // t^2 - width <= g - 2 mu v <= t^2 + width
      const double one = (g - square - width) / (2 * v);
      const double other = (g - square + width) / (2 * v);
      if (std::abs(v) < 1e-6) continue;  // near the ends; proved later
      allowed.low = std::max(allowed.low, std::min(one, other));
      allowed.high = std::min(allowed.high, std::max(one, other));
    }
    if (!(allowed.low <= allowed.high)) return std::nullopt;
    mu = (std::max(allowed.low, -kMostRadius) +
          std::min(allowed.high, kMostRadius)) /
         2;
  }
  const double cx = pencil.ex / 2 + mu * pencil.nx;
  const double cy = pencil.ey / 2 + mu * pencil.ny;
  // The nearest whole point first, then its neighbours on the other side.
  const auto x = static_cast<std::int64_t>(std::llround(cx));
  const auto y = static_cast<std::int64_t>(std::llround(cy));
  const int side_x = cx < static_cast<double>(x) ? -1 : 1;
  const int side_y = cy < static_cast<double>(y) ? -1 : 1;
  const std::array<Vector64, 4> candidates{
      Vector64{x, y}, Vector64{x + side_x, y}, Vector64{x, y + side_y},
      Vector64{x + side_x, y + side_y}};
  for (const Vector64 c : candidates) {
    const double real = static_cast<double>(c.x) * pencil.nx +
                        static_cast<double>(c.y) * pencil.ny;
    if (real < allowed.low || real > allowed.high) continue;
    const Arc arc{
        {static_cast<std::int32_t>(c.x), static_cast<std::int32_t>(c.y)},
        {static_cast<std::int32_t>(end.x), static_cast<std::int32_t>(end.y)},
        middle.v > 0};
    if (proves(arc, task)) return arc;
  }
  return std::nullopt;
}

namespace {

struct Extent {
  std::int64_t low_x = std::numeric_limits<std::int64_t>::max();
  std::int64_t low_y = std::numeric_limits<std::int64_t>::max();
  std::int64_t high_x = std::numeric_limits<std::int64_t>::min();
  std::int64_t high_y = std::numeric_limits<std::int64_t>::min();

  explicit Extent(std::span<const Point> points) {
    for (const Point p : points) {
      low_x = std::min<std::int64_t>(low_x, p.x);
      low_y = std::min<std::int64_t>(low_y, p.y);
      high_x = std::max<std::int64_t>(high_x, p.x);
      high_y = std::max<std::int64_t>(high_y, p.y);
    }
  }
};

/// Twice the area to the left of the ring.
Int128 area(std::span<const Point> ring) {
  Int128 sum = 0;
  for (std::size_t i = 1; i < ring.size(); ++i)
    sum += cross(between(ring[0], ring[i - 1]), between(ring[0], ring[i]));
  return sum;
}

struct Circle {
  double x = 0;
  double y = 0;
  double radius = 0;
  double half_width = 0;  ///< all points are within this of the circle

  [[nodiscard]] double off(Point p) const {
    return std::abs(std::hypot(p.x - x, p.y - y) - radius);
  }
};

/// The ring's points lie between two circles about (x, y): the one midway.
Circle midway(std::span<const Point> ring, double x, double y) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const Point p : ring) {
    const double d = std::hypot(p.x - x, p.y - y);
    low = std::min(low, d);
    high = std::max(high, d);
  }
  return {x, y, (low + high) / 2, (high - low) / 2};
}

/// The circle of least squares of |p - c|^2 - r^2 (Kasa), about the middle of
/// the box so that the sums stay small.
Circle least_squares(std::span<const Point> ring, double x, double y) {
  double xx = 0, xy = 0, yy = 0, xs = 0, ys = 0, sx = 0, sy = 0, ss = 0;
  for (const Point p : ring) {
    const double u = p.x - x;
    const double v = p.y - y;
    const double s = u * u + v * v;
    xx += u * u;
    xy += u * v;
    yy += v * v;
    xs += u * s;
    ys += v * s;
    sx += u;
    sy += v;
    ss += s;
  }
  const auto n = static_cast<double>(ring.size());
  xx -= sx * sx / n;
  xy -= sx * sy / n;
  yy -= sy * sy / n;
  xs -= sx * ss / n;
  ys -= sy * ss / n;
  const double det = 2 * (xx * yy - xy * xy);
  if (!(det > 0)) return midway(ring, x, y);
  return midway(ring, x + (xs * yy - ys * xy) / det,
                y + (ys * xx - xs * xy) / det);
}

std::vector<Point> begun_at(std::span<const Point> ring, std::size_t start) {
  const auto middle = ring.begin() + static_cast<std::ptrdiff_t>(start);
  std::vector<Point> result(middle, ring.end());
  result.insert(result.end(), ring.begin() + 1, middle + 1);
  return result;
}

}  // namespace

std::optional<RingArcs> ArcFitter::fit_ring(std::span<const Point> ring) const {
  const Extent box(ring);
  const std::int64_t wide = box.high_x - box.low_x;
  const std::int64_t tall = box.high_y - box.low_y;
  // Its width and height differ from the diameter by at most 2 t each.
  if (static_cast<double>(std::abs(wide - tall)) > 4 * t_) return std::nullopt;
  const std::int64_t x = (box.low_x + box.high_x) >> 1;
  const std::int64_t y = (box.low_y + box.high_y) >> 1;
  // Most squarish rings are no circles: their middle tells it at once.
  const double most = 2 * t_ + 2 * static_cast<double>(unit_);
  if (midway(ring, static_cast<double>(x), static_cast<double>(y)).half_width >
      most)
    return std::nullopt;
  for (int i = 0; i < 4; ++i) {
    // A box of odd size has its centre between whole points.
    if ((i & 1) != 0 && wide % 2 == 0) continue;
    if ((i & 2) != 0 && tall % 2 == 0) continue;
    const Point centre{static_cast<std::int32_t>(x + (i & 1)),
                       static_cast<std::int32_t>(y + (i >> 1))};
    if (auto whole = full_circle(ring, centre)) return whole;
  }
  auto halves = split_circle(ring, 2);
  return halves ? halves : split_circle(ring, 3);
}

std::optional<RingArcs> ArcFitter::full_circle(std::span<const Point> ring,
                                               Point centre) const {
  const Circle circle = midway(ring, centre.x, centre.y);
  if (circle.half_width > t_) return std::nullopt;
  const auto start = std::min_element(
      ring.begin(), ring.end() - 1,
      [&](Point a, Point b) { return circle.off(a) < circle.off(b); });
  const Arc arc{{centre.x - start->x, centre.y - start->y}, {}, area(ring) < 0};
  const std::vector<Point> turned =
      begun_at(ring, static_cast<std::size_t>(start - ring.begin()));
  if (!proves(arc, {turned, *start, *start})) return std::nullopt;
  return RingArcs{*start, {arc}};
}

/// Ends are sought in a part of the ring near their places, so that no arc is
/// much more than its share.
std::optional<RingArcs> ArcFitter::split_circle(std::span<const Point> ring,
                                                std::size_t count) const {
  const Circle circle = least_squares(ring, ring[0].x, ring[0].y);
  const std::size_t lap = ring.size() - 1;
  if (circle.half_width > t_ || lap < 8 * count) return std::nullopt;
  const auto nearest = [&](std::size_t from, std::size_t to) {
    return static_cast<std::size_t>(
        std::min_element(
            ring.begin() + static_cast<std::ptrdiff_t>(from),
            ring.begin() + static_cast<std::ptrdiff_t>(to),
            [&](Point a, Point b) { return circle.off(a) < circle.off(b); }) -
        ring.begin());
  };
  const std::size_t window = lap / (4 * count);
  const std::size_t first = nearest(0, window);
  RingArcs result{ring[first], {}};
  std::size_t at = first;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::size_t share = i * lap / count;
    const std::size_t next =
        i == count ? first + lap : nearest(share, share + window);
    std::vector<Point> turned;
    std::span<const Point> points = ring;
    if (next > lap) {
      turned = begun_at(ring, first);
      points = turned;
    }
    const std::size_t shift = next > lap ? first : 0;
    const std::optional<Arc> arc =
        fit({points.subspan(at - shift, next - at + 1), points[at - shift],
             points[next - shift]});
    if (!arc) return std::nullopt;
    result.arcs.push_back(*arc);
    at = next;
  }
  return result;
}

bool ArcFitter::proves(const Arc& arc, const ArcTask& task) const {
  if (!decides(arc)) return false;
  const ArcRing ring(arc, numerator_, denominator_);
  const ArcCircle& circle = ring.circle();
  const Vector64 last{arc.end.x, arc.end.y};
  const auto near = [&](Vector64 a, Vector64 b) {
    return within(a - b, numerator_, denominator_);
  };
  // Where the arc has come to: its start, the radius of a point, its end.
  enum class At : std::uint8_t { start, radius, end };
  At kind = At::start;
  Vector64 at;
  Int128 power_at = 0;
  Vector64 q = between(task.start, task.points.front());
  Int128 power = circle.power(q);
  if (!near(q, {})) return false;
  for (std::size_t i = 1; i < task.points.size(); ++i) {
    const Vector64 to = between(task.start, task.points[i]);
    const Vector64 move = to - q;
    const Int128 change = circle.power_change(q, move);
    if (kind == At::end) {
      if (!near(to, last)) return false;
    } else if (circle.ahead(at, to) <= 0) {
      if (kind == At::start
              ? !near(to, {})
              : !ring.near_radius(at, power_at, to, power + change))
        return false;
    } else {
      if (!ring.holds(power + change) ||
          !ring.stays_outside(move, power, change))
        return false;
      if (circle.ahead(at, last) > 0 && circle.ahead(last, to) >= 0) {
        if (!near(to, last)) return false;
        kind = At::end;
        at = last;
      } else {
        kind = At::radius;
        at = to;
        power_at = power + change;
      }
    }
    q = to;
    power += change;
  }
  if (!near(q, last)) return false;
  if (kind == At::start && circle.full()) return false;
  return kind == At::end || circle.ahead(at, last) >= 0;
}

}  // namespace unstep::reverse
