#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deviation/free_space.h"
#include "deviation/pairing.h"
#include "deviation/thorough.h"
#include "unstep/deviation.h"

namespace unstep {
namespace deviation {
namespace {

enum class Verdict : std::uint8_t { within, beyond, unknown };

/// What the exact form says of one path, and how far it came.
struct Decision {
  Verdict verdict = Verdict::unknown;
  std::size_t step = 0;
};

/// numerator and denominator of the tolerance in path units, lowest terms;
/// none if they are too large for the exact form.
std::optional<Bound> exact_bound(const Rational& tolerance,
                                 std::int32_t scale) {
  const std::uint64_t n =
      std::uint64_t{tolerance.numerator} * static_cast<std::uint64_t>(scale);
  const std::uint64_t d = tolerance.denominator;
  const std::uint64_t common = std::gcd(n, d);
  constexpr std::uint64_t kMost = std::uint64_t{1} << 30;
  if (n / common > kMost || d / common > kMost) return std::nullopt;
  Bound bound;
  bound.numerator = static_cast<std::int64_t>(n / common);
  bound.denominator = static_cast<std::int64_t>(d / common);
  bound.reach = (bound.numerator + bound.denominator - 1) / bound.denominator;
  bound.unit = scale;
  return bound;
}

/// Walks the whole path; false once nothing is reached.
bool walk(Front& front, const Path& path) {
  Vector64 at{path.origin.x, path.origin.y};
  for (const Path::Element& element : path.elements) {
    if (element.kind == Path::Kind::segment)
      walk_line(front, at, element.segment);
    else
      walk_arc(front, at, element.arc);
    if (!front.alive() && &element != &path.elements.back()) return false;
    at = at + move_of(element);
  }
  return true;
}

Vector64 end_of(const Path& path) {
  Vector64 at{path.origin.x, path.origin.y};
  for (const Path::Element& element : path.elements) at = at + move_of(element);
  return at;
}

/// One closed chain begun at one of its points.
class Rotation {
 public:
  Rotation(const Bound& bound, const Chain& chain, YAxis axis)
      : bound_(bound), chain_(chain), axis_(axis) {}

  /// The chain starts at `origin`, its point after `start` steps.
  bool from_point(const Path& path, std::size_t start, Vector64 origin) {
    turn(start, 0);
    Front front(bound_, {origin, steps_, axis_, bound_.unit});
    const Vector64 vertex{path.origin.x, path.origin.y};
    const bool done = front.start(vertex) && walk(front, path) && front.last;
    farthest_ = std::max(farthest_, front.farthest);
    return done;
  }

  /// It starts at `place` on the edge after that point.
  bool from_edge(const Path& path, std::size_t start, Vector64 origin,
                 Vector64 place) {
    turn(start, 1);
    Front front(bound_, {origin, steps_, axis_, bound_.unit});
    const Vector64 vertex{path.origin.x, path.origin.y};
    const bool done = front.start_on_edge(vertex, place) && walk(front, path) &&
                      front.ends_on_edge(place);
    farthest_ = std::max(farthest_, front.farthest);
    return done;
  }

  [[nodiscard]] std::size_t farthest() const { return farthest_; }

 private:
  void turn(std::size_t start, std::size_t more) {
    const auto middle =
        chain_.steps.begin() + static_cast<std::ptrdiff_t>(start);
    steps_.assign(middle, chain_.steps.end());
    steps_.insert(steps_.end(), chain_.steps.begin(), middle);
    for (std::size_t i = 0; i < more; ++i) steps_.push_back(steps_[i]);
  }

  const Bound& bound_;
  const Chain& chain_;
  YAxis axis_;
  std::vector<Step> steps_;
  std::size_t farthest_ = 0;
};

/// Where a closed chain may start: near the path's start.
struct StartPoint {
  std::size_t index = 0;
  Vector64 at;
  std::int64_t distance2 = 0;
};

/// The points of the chain within the bound of `vertex`: the nearest of every
/// stretch of them first, then the others, each by distance. On a chain that
/// turns back, the nearest point need not be the one that the path stands for.
std::vector<StartPoint> start_points(const Bound& bound, const ChainWalk& chain,
                                     Vector64 vertex) {
  std::vector<StartPoint> nearest;
  std::vector<StartPoint> others;
  ChainWalk walk = chain;
  bool inside = false;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Vector64 d = walk.at() - vertex;
    const bool in = bound.within(walk.at(), vertex);
    if (in) {
      StartPoint point{i, walk.at(), d.x * d.x + d.y * d.y};
      if (!inside) {
        nearest.push_back(point);
      } else {
        if (point.distance2 < nearest.back().distance2) {
          std::swap(point, nearest.back());
        }
        others.push_back(point);
      }
    }
    inside = in;
    walk.seek(i + 1);
  }
  const auto nearer = [](const StartPoint& a, const StartPoint& b) {
    return a.distance2 < b.distance2;
  };
  std::stable_sort(nearest.begin(), nearest.end(), nearer);
  std::stable_sort(others.begin(), others.end(), nearer);
  nearest.insert(nearest.end(), others.begin(), others.end());
  return nearest;
}

/// The place of the path's grid on an edge nearest to `vertex`, if near enough.
std::optional<Vector64> place_on_edge(const Bound& bound, Vector64 from,
                                      Vector64 move, Vector64 vertex) {
  const Vector64 unit{move.x / bound.unit, move.y / bound.unit};
  if (!cut_edge(bound, from, unit, vertex).any) return std::nullopt;
  const Vector64 q = vertex - from;
  const std::int64_t length2 = unit.x * unit.x + unit.y * unit.y;
  const std::int64_t along =
      std::clamp((unit.x * q.x + unit.y * q.y + length2 / 2) / length2,
                 std::int64_t{0}, bound.unit);
  const Vector64 place{from.x + unit.x * along, from.y + unit.y * along};
  if (!bound.within(place, vertex)) return std::nullopt;
  return place;
}

/// More starts than these are left to the thorough form.
constexpr std::size_t kMaxQuickStarts = 64;

Decision decide_closed(const Bound& bound, const Chain& chain, const Path& path,
                       YAxis axis) {
  const ChainWalk walk({std::int64_t{chain.origin.x} * bound.unit,
                        std::int64_t{chain.origin.y} * bound.unit},
                       chain.steps, axis, bound.unit);
  const Vector64 vertex{path.origin.x, path.origin.y};
  Rotation rotation(bound, chain, axis);
  std::size_t tries = 0;
  for (const StartPoint& start : start_points(bound, walk, vertex)) {
    if (++tries > kMaxQuickStarts) break;
    if (rotation.from_point(path, start.index, start.at))
      return {Verdict::within, 0};
  }
  if (tries == 0 && bound.unit > 1) {
    ChainWalk edge = walk;
    for (std::size_t i = 0; i < walk.size() && tries < kMaxQuickStarts; ++i) {
      edge.seek(i);
      const auto place = place_on_edge(bound, edge.at(), edge.move(i), vertex);
      if (!place) continue;
      ++tries;
      if (rotation.from_edge(path, i, edge.at(), *place))
        return {Verdict::within, 0};
    }
  }
  return {Verdict::unknown, rotation.farthest()};
}

Decision decide(const Bound& bound, const Chain& chain, const Path& path,
                YAxis axis) {
  bool arcs = false;
  for (const Path::Element& element : path.elements) {
    if (element.kind != Path::Kind::arc) continue;
    if (!arc_is_decidable(bound, element.arc)) return {};
    arcs = true;
  }
  if (chain.closed) return decide_closed(bound, chain, path, axis);
  const Vector64 origin{std::int64_t{chain.origin.x} * bound.unit,
                        std::int64_t{chain.origin.y} * bound.unit};
  Front front(bound, {origin, chain.steps, axis, bound.unit});
  const ChainSpan span = span_of(chain, axis, bound.unit);
  const bool within = front.start({path.origin.x, path.origin.y}) &&
                      walk(front, path) && front.last &&
                      bound.within(span.end, end_of(path));
  if (within) return {Verdict::within, 0};
  return {arcs ? Verdict::unknown : Verdict::beyond, front.farthest};
}

Error beyond(std::size_t index, std::size_t step, const std::string& how_far) {
  return {ErrorCode::corrupt,
          path_name(index) +
              "farther from its chain than the tolerance, near step " +
              std::to_string(step) + how_far};
}

}  // namespace
}  // namespace deviation

Status check_deviation(const Drawing& chains, const Drawing& paths,
                       const Rational& tolerance) {
  using namespace deviation;
  if (Status valid = check_pairs(chains, paths); !valid) return valid;
  if (tolerance.denominator == 0)
    return Error{ErrorCode::invalid_argument,
                 "the tolerance has the denominator 0"};
  const std::optional<Bound> bound = exact_bound(tolerance, paths.scale);
  const YAxis axis = chains.canvas.y_axis;
  const double most = static_cast<double>(tolerance.numerator) /
                      static_cast<double>(tolerance.denominator);
  for (std::size_t i = 0; i < paths.paths.size(); ++i) {
    const Chain& chain = chains.chains[i];
    const Path& path = paths.paths[i];
    Decision decision;
    if (bound) decision = decide(*bound, chain, path, axis);
    if (decision.verdict == Verdict::within) continue;
    if (decision.verdict == Verdict::beyond)
      return beyond(i, decision.step, "");
    if (!thorough_within(chain, path, axis, paths.scale,
                         std::nextafter(most, 0.0)))
      return beyond(i, decision.step, " (by the thorough form)");
  }
  return {};
}

}  // namespace unstep
