#include "steps/centre_region.h"

#include <algorithm>
#include <cmath>

namespace unstep::steps {
namespace {

constexpr double kFarthest = 1 << 20;

/// No step, in place of a Freeman code.
constexpr Step kNone = 8;

/// What stands beside a step: of diagonal ones the nearest straight steps, of
/// steps along one axis at a time the nearest along the other. kNone if there
/// is none near enough.
class Neighbours {
 public:
  Neighbours(std::span<const Step> steps, bool combined)
      : steps_(steps), combined_(combined) {}

  /// For one step after the other from the first on.
  void go_to(std::size_t at) {
    const Step step = steps_[at];
    const unsigned kind = kind_of(step);
    const unsigned other = combined_ ? 0 : 1 - kind;
    before = last_[other];
    after = kNone;
    if (kind == 0 || !combined_) last_[kind] = step;
    if (combined_ && kind == 0) return;
    std::size_t& next = next_[other];
    next = std::max(next, at + 1);
    const std::size_t end = std::min(steps_.size(), at + kReach);
    while (next < end && kind_of(steps_[next]) != other) ++next;
    if (next < end) after = steps_[next];
  }

  Step before = kNone;
  Step after = kNone;

 private:
  static constexpr std::size_t kReach = 4096;

  /// Combined: 0 straight, 1 diagonal. Else the axis.
  [[nodiscard]] unsigned kind_of(Step step) const {
    return combined_ ? step & 1U : step >> 1 & 1U;
  }

  std::span<const Step> steps_;
  bool combined_;
  std::array<Step, 2> last_{kNone, kNone};
  std::array<std::size_t, 2> next_{};
};

}  // namespace

std::size_t CentreRegion::take(std::span<const Step> steps,
                               std::span<const Point> points, bool combined) {
  regions_.assign(1, {{-kFarthest, -kFarthest},
                      {kFarthest, -kFarthest},
                      {kFarthest, kFarthest},
                      {-kFarthest, kFarthest}});
  Neighbours beside(steps, combined);
  // Towards the centre, seen along a step: a quarter turn.
  const unsigned inward = clockwise_ ? 6 : 2;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step step = steps[i];
    beside.go_to(i);
    const Step before = beside.before;
    const Step after = beside.after;
    const double x = 2.0 * (points[i].x - points[0].x);
    const double y = 2.0 * (points[i].y - points[0].y);
    const auto turned = [](Step code, unsigned by) {
      return step_delta(static_cast<Step>((code + by) & 7U));
    };
    const auto ask = [&](Point whole, Point half, bool outside) {
      return cut({x + 2 * whole.x + half.x, y + 2 * whole.y + half.y, outside});
    };
    bool left = true;
    if (!combined) {
      // The sign of F before the step: inside goes on, outside turns.
      if (before != after || before == kNone) continue;
      const bool first = ((before - step) & 7U) == inward;
      left = ask({}, {}, !first);
    } else if ((step & 1) == 0) {
      const Point ahead = step_delta(step);
      const Point in = turned(step, inward);
      left = ask(ahead, in, false) && ask(ahead, {-in.x, -in.y}, true);
    } else {
      // The parts of a diagonal step, in the order of the turn.
      const unsigned eighth = clockwise_ ? 7 : 1;
      const auto last = static_cast<Step>((step + eighth) & 7U);
      const auto first = static_cast<Step>((step + 8 - eighth) & 7U);
      const Point a = step_delta(first);
      const Point b = step_delta(last);
      Turn turn = Turn::unknown;
      if (before == after && before == first) turn = Turn::flat;
      if (before == after && before == last) turn = Turn::steep;
      if (turn == Turn::unknown) turn = turn_at({x / 2, y / 2}, a, b);
      if (turn == Turn::flat) left = ask(a, b, true);
      if (turn == Turn::steep) left = ask(b, a, false);
    }
    if (!left) return i;
  }
  return steps.size();
}

/// By the middle of the region.
CentreRegion::Turn CentreRegion::turn_at(Corner at, Point a, Point b) const {
  Corner middle;
  const Region& region = regions_.back();
  for (const Corner& c : region) {
    middle.x += c.x / static_cast<double>(region.size());
    middle.y += c.y / static_cast<double>(region.size());
  }
  const Corner out{at.x - middle.x, at.y - middle.y};
  const double along = out.x * a.x + out.y * a.y;
  const double across = -(out.x * b.x + out.y * b.y);
  if (along < 0.98 * across - 4) return Turn::flat;
  if (across < 0.98 * along - 4) return Turn::steep;
  return Turn::unknown;
}

bool CentreRegion::cut(const Limit& limit) {
  // F = |m|^2 - 2 m c, here with m of half units; a unit more or less of F is
  // as nothing but on the circle.
  const double square = (limit.x2 * limit.x2 + limit.y2 * limit.y2) / 4;
  const double sign = limit.outside ? 1 : -1;
  const auto margin = [&](const Corner& c) {
    return sign * (square - limit.x2 * c.x - limit.y2 * c.y) + 0.751;
  };
  const Region& region = regions_.back();
  if (std::all_of(region.begin(), region.end(),
                  [&](const Corner& c) { return margin(c) >= 0; })) {
    return true;
  }
  Region out;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Corner& a = region[i];
    const Corner& b = region[(i + 1) % region.size()];
    const double at = margin(a);
    const double bt = margin(b);
    if (at >= 0) out.push_back(a);
    if ((at >= 0) != (bt >= 0)) {
      const double part = at / (at - bt);
      out.push_back({a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part});
    }
  }
  if (out.empty()) return false;
  regions_.push_back(std::move(out));
  return true;
}

std::vector<Point> CentreRegion::whole_points(const Region& region,
                                              std::size_t most) {
  // Columns along the longer side of the box.
  double low = 1e300, high = -1e300, low_y = 1e300, high_y = -1e300;
  for (const Corner& c : region) {
    low = std::min(low, c.x), high = std::max(high, c.x);
    low_y = std::min(low_y, c.y), high_y = std::max(high_y, c.y);
  }
  const bool upright = high_y - low_y > high - low;
  if (upright) std::swap(low, low_y), std::swap(high, high_y);
  constexpr double kSlack = 1e-6;
  const auto first = static_cast<std::int64_t>(std::ceil(low - kSlack));
  const auto last = static_cast<std::int64_t>(std::floor(high + kSlack));
  std::vector<Point> found;
  const std::int64_t middle = (first + last) / 2;
  const auto column = [&](std::int64_t at) {
    double from = 1e300, to = -1e300;
    const auto x = static_cast<double>(at);
    for (std::size_t i = 0; i < region.size(); ++i) {
      Corner a = region[i];
      Corner b = region[(i + 1) % region.size()];
      if (upright) std::swap(a.x, a.y), std::swap(b.x, b.y);
      if (a.x > b.x) std::swap(a, b);
      if (x < a.x - kSlack || x > b.x + kSlack) continue;
      const double part =
          b.x > a.x ? std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0) : 0;
      const double y = a.y + (b.y - a.y) * part;
      from = std::min(from, b.x > a.x ? y : std::min(a.y, b.y));
      to = std::max(to, b.x > a.x ? y : std::max(a.y, b.y));
    }
    for (auto y = static_cast<std::int64_t>(std::ceil(from - kSlack));
         static_cast<double>(y) <= to + kSlack && found.size() < most; ++y) {
      const Point p{static_cast<std::int32_t>(at),
                    static_cast<std::int32_t>(y)};
      found.push_back(upright ? Point{p.y, p.x} : p);
    }
  };
  // A region of so many columns has whole points near its middle, if any.
  constexpr std::int64_t kColumns = 4096;
  for (std::int64_t k = 0; k <= kColumns && found.size() < most; ++k) {
    if (middle - k >= first) column(middle - k);
    if (k > 0 && middle + k <= last) column(middle + k);
    if (middle - k < first && middle + k > last) break;
  }
  return found;
}

std::vector<Point> CentreRegion::next_centres() {
  // Every region is within the one before.
  std::size_t good = 0;
  std::size_t bad = regions_.size();
  while (good + 1 < bad) {
    const std::size_t middle = (good + bad) / 2;
    (whole_points(regions_[middle], 1).empty() ? bad : good) = middle;
  }
  const std::vector<Point> points = whole_points(regions_[good], kMost);
  regions_.resize(std::max<std::size_t>(good, 1));
  return points;
}

}  // namespace unstep::steps
