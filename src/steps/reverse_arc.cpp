#include "steps/reverse_arc.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "unstep/interpolate.h"

namespace unstep::steps {
namespace {

/// Arcs of fewer steps are no better than lines.
constexpr std::size_t kLeast = 12;

/// The centre of the circle through (0, 0), a and b, rounded.
std::optional<Point> centre_of(Point a, Point b) {
  const double ax = a.x;
  const double ay = a.y;
  const double bx = b.x;
  const double by = b.y;
  const double cross = 2 * (ax * by - ay * bx);
  if (cross == 0) return std::nullopt;
  const double aa = ax * ax + ay * ay;
  const double bb = bx * bx + by * by;
  const double x = (by * aa - ay * bb) / cross;
  const double y = (ax * bb - bx * aa) / cross;
  constexpr double kMost = 1 << 26;
  if (!(std::abs(x) < kMost) || !(std::abs(y) < kMost)) return std::nullopt;
  return Point{static_cast<std::int32_t>(std::lround(x)),
               static_cast<std::int32_t>(std::lround(y))};
}

class Search {
 public:
  Search(std::span<const Step> steps, std::span<const Point> points,
         bool combined, double step_mm)
      : steps_(steps), points_(points), step_mm_(step_mm) {
    options_.combined = combined;
  }

  /// Steps that a full circle about the centre draws as given.
  [[nodiscard]] std::size_t matched(Point centre, bool clockwise) const {
    Result<Interpolator> drawn =
        Interpolator::arc(Method::circular, {centre, {}, clockwise}, options_);
    if (!drawn) return 0;
    std::size_t count = 0;
    while (count < steps_.size()) {
      const Tick tick = drawn->next();
      if (tick.kind == Tick::Kind::idle) continue;
      if (tick.kind == Tick::Kind::done || tick.step != steps_[count]) break;
      ++count;
    }
    return count;
  }

  /// Whether the arc to the point after `count` steps draws just these.
  [[nodiscard]] bool draws(Point centre, bool clockwise,
                           std::size_t count) const {
    Result<Interpolator> drawn = Interpolator::arc(
        Method::circular, {centre, point(count), clockwise}, options_);
    if (!drawn) return false;
    std::size_t at = 0;
    for (Tick t = drawn->next(); t.kind != Tick::Kind::done;
         t = drawn->next()) {
      if (t.kind != Tick::Kind::step) continue;
      if (at == count || t.step != steps_[at]) return false;
      ++at;
    }
    return at == count;
  }

  /// Looks around the centre that three points say.
  void try_reach(std::size_t reach) {
    // Of a closed figure the end is the start again.
    const std::size_t third = point(reach) == Point{} ? 3 : 2;
    const std::size_t a = reach / third;
    const std::size_t b = third == 3 ? 2 * reach / 3 : reach;
    const Point p = point(a);
    const Point q = point(b);
    const std::optional<Point> centre = centre_of(p, q);
    if (!centre) return;
    const double turn = double{1} * p.x * q.y - double{1} * p.y * q.x;
    const bool clockwise = turn < 0;
    constexpr std::int32_t kAround = 2;
    for (std::int32_t dy = -kAround; dy <= kAround; ++dy) {
      for (std::int32_t dx = -kAround; dx <= kAround; ++dx) {
        try_centre({centre->x + dx, centre->y + dy}, clockwise);
      }
    }
  }

  [[nodiscard]] const ExactArc& best() const { return best_; }
  void set_least(std::size_t least) { best_.steps = least; }

 private:
  /// Relative to the start.
  [[nodiscard]] Point point(std::size_t i) const {
    return {points_[i].x - points_[0].x, points_[i].y - points_[0].y};
  }

  /// How much farther the end is from the centre than the start, squared.
  static std::int64_t off_circle(Point centre, Point end) {
    const std::int64_t x = std::int64_t{end.x} - centre.x;
    const std::int64_t y = std::int64_t{end.y} - centre.y;
    const std::int64_t cx = centre.x;
    const std::int64_t cy = centre.y;
    return x * x + y * y - cx * cx - cy * cy;
  }

  /// As the strictest of the controls wants it (ArcRules).
  [[nodiscard]] bool radii_agree(Point centre, Point end) const {
    const double radius = std::hypot(centre.x, centre.y);
    const double off =
        std::abs(static_cast<double>(off_circle(centre, end))) / (2 * radius);
    return off * step_mm_ <=
           std::max(0.0009, std::min(0.1, 7e-4 * radius * step_mm_));
  }

  [[nodiscard]] bool is_end(Point centre, bool clockwise,
                            std::size_t count) const {
    return radii_agree(centre, point(count)) && draws(centre, clockwise, count);
  }

  void try_centre(Point centre, bool clockwise) {
    if (centre == Point{}) return;
    std::size_t count = matched(centre, clockwise);
    // The last steps may lead to an end that is not on the circle.
    constexpr int kBack = 64;
    int tries = 0;
    while (count > best_.steps && !is_end(centre, clockwise, count)) {
      if (++tries == kBack) return;
      --count;
    }
    if (count <= best_.steps) return;
    count = before_tangent(centre, clockwise, count);
    if (count <= best_.steps) return;
    best_ = {{centre, point(count), clockwise}, count};
  }

  /// Steps straight on may belong to a line that follows the arc: where they
  /// begin on the circle itself, the arc ends there.
  [[nodiscard]] std::size_t before_tangent(Point centre, bool clockwise,
                                           std::size_t count) const {
    std::size_t at = count;
    while (at > kLeast && steps_[at - 1] == steps_[count - 1] &&
           off_circle(centre, point(at)) != 0) {
      --at;
    }
    const bool on_circle = off_circle(centre, point(at)) == 0;
    return on_circle && draws(centre, clockwise, at) ? at : count;
  }

  std::span<const Step> steps_;
  std::span<const Point> points_;
  double step_mm_;
  InterpolatorOptions options_;
  ExactArc best_;
};

}  // namespace

std::optional<ExactArc> longest_arc(std::span<const Step> steps,
                                    std::span<const Point> points,
                                    std::size_t least, bool combined,
                                    double step_mm) {
  least = std::max(least, kLeast);
  if (steps.size() <= least) return std::nullopt;
  Search search(steps, points, combined, step_mm);
  search.set_least(least);
  // From the longest reach: what a shorter one finds is mostly as long.
  for (std::size_t reach = steps.size(); reach > least; reach = reach * 2 / 3) {
    search.try_reach(reach);
    if (search.best().steps >= reach) break;
  }
  if (search.best().steps <= least) return std::nullopt;
  return search.best();
}

}  // namespace unstep::steps
