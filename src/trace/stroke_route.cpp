#include "trace/stroke_route.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "trace/neighbourhood.h"

namespace unstep::trace {
namespace {

constexpr std::size_t kNone = Branch::kNone;

/// Junctions closer than their half widths and this much are one.
constexpr double kZoneSlack = 1;

/// Farther ones, up to this many half widths and pixels (which alone set thin
/// lines apart that cross at a slant), are one if straight lines cross there:
/// both ways on are as straight as this, of 3.
constexpr double kSlantReach = 1.8;
constexpr double kSlantSlack = 5;
constexpr double kCrossing = 2.7;

/// No stroke turns back at a junction: the cosine of the sharpest turn.
constexpr double kSharpest = -0.2;

/// An end of a branch at a junction: branch * 2, + 1 for the last spot.
using BranchEnd = std::size_t;

/// What a branch is like just outside the ink of its junction.
struct Arm {
  BranchEnd end = 0;
  Point cut;         ///< its first spot there
  Vector2 outwards;  ///< unit vector
  double radius = 0;
};

/// Junctions that count as one.
struct Zone {
  std::vector<std::size_t> junctions;
  std::vector<Arm> arms;
};

/// How a stroke goes on from one branch to the next.
struct Link {
  BranchEnd next = kNone;
  std::vector<Spot> bridge;  ///< from the cut to the next one, or to its end
};

class Forest {
 public:
  explicit Forest(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool unite(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
};

class Router {
 public:
  Router(const Bitmap& ink, const SkeletonGraph& graph)
      : ink_(ink),
        graph_(graph),
        inner_(graph.branches.size()),
        cuts_(graph.branches.size()),
        links_(graph.branches.size() * 2) {}

  std::vector<Route> run() {
    make_zones();
    for (Zone& zone : zones_) make_arms(zone);
    for (Zone& zone : zones_) pair_arms(zone);
    std::vector<Route> routes;
    std::vector<bool> done(graph_.branches.size());
    for (std::size_t b = 0; b < graph_.branches.size(); ++b) {
      if (inner_[b] || done[b]) continue;
      if (links_[b * 2].next == kNone) {
        routes.push_back(follow(b * 2, done));
      } else if (links_[b * 2 + 1].next == kNone) {
        routes.push_back(follow(b * 2 + 1, done));
      }
    }
    for (std::size_t b = 0; b < graph_.branches.size(); ++b) {
      if (!inner_[b] && !done[b]) routes.push_back(follow(b * 2, done));
    }
    return routes;
  }

 private:
  struct Cut {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  void make_zones() {
    struct Bridge {
      double length;
      std::size_t branch;
    };
    std::vector<Bridge> bridges;
    for (std::size_t b = 0; b < graph_.branches.size(); ++b) {
      const Branch& branch = graph_.branches[b];
      if (branch.from == kNone || branch.to == kNone ||
          branch.from == branch.to) {
        continue;
      }
      const Spot& a = graph_.junctions[branch.from].middle;
      const Spot& z = graph_.junctions[branch.to].middle;
      const double apart = length(to_vector(a.at) - to_vector(z.at));
      const double reach = radius_of(a) + radius_of(z);
      const auto steps = static_cast<double>(branch.spots.size());
      const bool near =
          apart <= reach + kZoneSlack && steps <= 2 * (reach + kZoneSlack);
      const bool slant = apart <= kSlantReach * reach + kSlantSlack;
      if (near || (slant && is_crossing(b))) bridges.push_back({apart, b});
    }
    std::ranges::stable_sort(bridges, {}, &Bridge::length);
    Forest forest(graph_.junctions.size());
    for (const Bridge& bridge : bridges) {
      const Branch& branch = graph_.branches[bridge.branch];
      inner_[bridge.branch] = forest.unite(branch.from, branch.to);
    }
    std::vector<std::size_t> number(graph_.junctions.size(), kNone);
    for (std::size_t j = 0; j < graph_.junctions.size(); ++j) {
      const std::size_t root = forest.root(j);
      if (number[root] == kNone) {
        number[root] = zones_.size();
        zones_.emplace_back();
      }
      zones_[number[root]].junctions.push_back(j);
    }
  }

  /// Whether two straight lines cross over a branch, on top of each other.
  [[nodiscard]] bool is_crossing(std::size_t bridge) {
    const Branch& branch = graph_.branches[bridge];
    Zone zone;
    zone.junctions = {branch.from, branch.to};
    inner_[bridge] = true;
    make_arms(zone);
    inner_[bridge] = false;
    const std::vector<Arm>& arms = zone.arms;
    if (arms.size() != 4 || graph_.junctions[branch.from].branches.size() != 3)
      return false;
    // The first two are those of one junction.
    const double same = std::min(straightness(arms[0], arms[2]),
                                 straightness(arms[1], arms[3]));
    const double other = std::min(straightness(arms[0], arms[3]),
                                  straightness(arms[1], arms[2]));
    return std::max(same, other) >= kCrossing;
  }

  void make_arms(Zone& zone) {
    for (const std::size_t j : zone.junctions) {
      std::size_t before = kNone;
      std::vector<std::size_t> branches = graph_.junctions[j].branches;
      std::ranges::sort(branches);
      for (const std::size_t b : branches) {
        if (inner_[b]) continue;
        const Branch& branch = graph_.branches[b];
        // A loop has both of its ends here.
        const bool last = branch.from != j || before == b;
        zone.arms.push_back(arm(zone, b * 2 + (last ? 1 : 0)));
        before = b;
      }
    }
  }

  [[nodiscard]] bool in_zone(const Zone& zone, Point at) const {
    return std::ranges::any_of(zone.junctions, [&](std::size_t j) {
      const Spot& middle = graph_.junctions[j].middle;
      return length(to_vector(at) - to_vector(middle.at)) <=
             radius_of(middle) + 0.5;
    });
  }

  [[nodiscard]] Vector2 middle_of(const Zone& zone) const {
    Vector2 sum;
    for (const std::size_t j : zone.junctions) {
      sum = sum + to_vector(graph_.junctions[j].middle.at);
    }
    return (1 / static_cast<double>(zone.junctions.size())) * sum;
  }

  Arm arm(const Zone& zone, BranchEnd end) {
    const Branch& branch = graph_.branches[end / 2];
    const bool last = end % 2 == 1;
    const std::size_t n = branch.spots.size();
    const auto spot = [&](std::size_t i) -> const Spot& {
      return branch.spots[last ? n - 1 - i : i];
    };
    // The other end may need its half.
    const bool other = (last ? branch.from : branch.to) != kNone;
    const std::size_t most = other ? (n - 1) / 2 : n - 1;
    std::size_t cut = 0;
    while (cut < most && in_zone(zone, spot(cut).at)) ++cut;
    (last ? cuts_[end / 2].last : cuts_[end / 2].first) = cut;
    Arm arm{end, spot(cut).at, {}, radius_of(spot(cut))};
    const auto reach = static_cast<std::size_t>(std::max(8.0, 4 * arm.radius));
    std::vector<Spot> ahead;
    for (std::size_t i = cut; i < n && i < cut + reach; ++i) {
      ahead.push_back(spot(i));
    }
    arm.outwards = ahead.size() > 3
                       ? direction_of(ahead)
                       : unit(to_vector(arm.cut) - middle_of(zone));
    return arm;
  }

  /// 3 for a straight line.
  static double straightness(const Arm& a, const Arm& b) {
    const Vector2 across = to_vector(b.cut) - to_vector(a.cut);
    const double turn = -dot(a.outwards, b.outwards);
    double score = 3 * turn;
    if (length(across) >= 3) {
      const Vector2 m = unit(across);
      score = turn - dot(a.outwards, m) + dot(b.outwards, m);
    }
    const double wider = std::max(a.radius, b.radius) + 0.5;
    return score - 0.6 * std::abs(a.radius - b.radius) / wider;
  }

  void pair_arms(const Zone& zone) {
    struct Pair {
      double score;
      std::size_t a;
      std::size_t b;
    };
    const std::vector<Arm>& arms = zone.arms;
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < arms.size(); ++a) {
      for (std::size_t b = a + 1; b < arms.size(); ++b) {
        if (arms.size() > 2 &&
            -dot(arms[a].outwards, arms[b].outwards) < kSharpest) {
          continue;
        }
        pairs.push_back({-straightness(arms[a], arms[b]), a, b});
      }
    }
    std::ranges::stable_sort(pairs, {}, &Pair::score);
    std::vector<bool> taken(arms.size());
    std::vector<std::array<Point, 2>> bars;
    for (const Pair& pair : pairs) {
      if (taken[pair.a] || taken[pair.b]) continue;
      taken[pair.a] = taken[pair.b] = true;
      join(zone, arms[pair.a], arms[pair.b]);
      bars.push_back({arms[pair.a].cut, arms[pair.b].cut});
    }
    for (std::size_t a = 0; a < arms.size(); ++a) {
      if (!taken[a]) end_on(zone, arms[a], bars);
    }
  }

  [[nodiscard]] bool all_ink(const std::vector<Spot>& spots) const {
    return std::ranges::all_of(
        spots, [&](const Spot& s) { return pixel_at(ink_, s.at); });
  }

  [[nodiscard]] double reach_of(const Zone& zone) const {
    double reach = 0;
    const Vector2 middle = middle_of(zone);
    for (const std::size_t j : zone.junctions) {
      const Spot& spot = graph_.junctions[j].middle;
      reach = std::max(reach,
                       length(to_vector(spot.at) - middle) + radius_of(spot));
    }
    return reach;
  }

  /// Where two lines meet, both given by a point and a direction.
  static std::optional<Vector2> meeting(Vector2 p, Vector2 u, Vector2 q,
                                        Vector2 v) {
    const double sine = cross(u, v);
    if (std::abs(sine) < 0.1) return std::nullopt;
    return p + (cross(q - p, v) / sine) * u;
  }

  /// The pixel in the zone where the arm meets a line, ahead of its cut.
  [[nodiscard]] std::optional<Point> corner(const Zone& zone, const Arm& arm,
                                            Vector2 q, Vector2 v) const {
    const Vector2 p = to_vector(arm.cut);
    const auto at = meeting(p, arm.outwards, q, v);
    if (!at || dot(*at - p, arm.outwards) > 1 ||
        length(*at - middle_of(zone)) > reach_of(zone) + 1) {
      return std::nullopt;
    }
    const Point pixel = nearest(*at);
    if (!pixel_at(ink_, pixel)) return std::nullopt;
    return pixel;
  }

  [[nodiscard]] Point nearest_middle(const Zone& zone, Point at) const {
    Point best = graph_.junctions[zone.junctions[0]].middle.at;
    for (const std::size_t j : zone.junctions) {
      const Point p = graph_.junctions[j].middle.at;
      if (length(to_vector(p) - to_vector(at)) <
          length(to_vector(best) - to_vector(at))) {
        best = p;
      }
    }
    return best;
  }

  [[nodiscard]] std::vector<Spot> bridge(const Zone& zone, const Arm& a,
                                         const Arm& b) const {
    std::vector<Spot> spots;
    append_line(spots, a.cut, b.cut);
    const bool straight = -dot(a.outwards, b.outwards) > 0.9;
    if (straight && all_ink(spots)) return spots;
    std::optional<Point> via = corner(zone, a, to_vector(b.cut), b.outwards);
    if (via && dot(to_vector(*via) - to_vector(b.cut), b.outwards) > 1) {
      via.reset();
    }
    std::vector<Spot> bent;
    if (via) {
      append_line(bent, a.cut, *via);
      append_line(bent, *via, b.cut);
      if (all_ink(bent)) return bent;
    }
    bent.clear();
    const Point middle = nearest_middle(zone, a.cut);
    const Point second = nearest_middle(zone, b.cut);
    append_line(bent, a.cut, middle);
    append_line(bent, middle, second);
    append_line(bent, second, b.cut);
    return all_ink(bent) || !all_ink(spots) ? bent : spots;
  }

  void join(const Zone& zone, const Arm& a, const Arm& b) {
    std::vector<Spot> there = bridge(zone, a, b);
    std::vector<Spot> back(there.rbegin(), there.rend());
    // Each leaves its own cut out and holds the other one.
    if (!back.empty()) {
      back.erase(back.begin());
      back.push_back({a.cut, 0});
    }
    links_[a.end] = {b.end, std::move(there)};
    links_[b.end] = {a.end, std::move(back)};
  }

  void end_on(const Zone& zone, const Arm& arm,
              const std::vector<std::array<Point, 2>>& bars) {
    std::optional<Point> best;
    for (const auto& bar : bars) {
      const Vector2 along = to_vector(bar[1]) - to_vector(bar[0]);
      const auto at = corner(zone, arm, to_vector(bar[0]), unit(along));
      if (!at) continue;
      const auto apart = [&](Point p) {
        return length(to_vector(p) - to_vector(arm.cut));
      };
      if (!best || apart(*at) < apart(*best)) best = at;
    }
    const Point end = best.value_or(nearest_middle(zone, arm.cut));
    append_line(links_[arm.end].bridge, arm.cut, end);
  }

  /// From one end of a branch, through it and on.
  Route follow(BranchEnd start, std::vector<bool>& done) {
    Route route;
    const Branch& first = graph_.branches[start / 2];
    route.closed = first.closed;
    route.free_from = (start % 2 == 0 ? first.from : first.to) == kNone;
    const std::vector<Spot>& lead = links_[start].bridge;
    if (links_[start].next == kNone) {
      route.spots.assign(lead.rbegin(), lead.rend());
    }
    for (BranchEnd at = start;;) {
      const std::size_t b = at / 2;
      done[b] = true;
      append_branch(route.spots, b, at % 2 == 1);
      const BranchEnd leaving = at ^ 1;
      const Link& link = links_[leaving];
      route.spots.insert(route.spots.end(), link.bridge.begin(),
                         link.bridge.end());
      if (link.next == kNone) {
        const Branch& branch = graph_.branches[b];
        route.free_to = (leaving % 2 == 0 ? branch.from : branch.to) == kNone;
        break;
      }
      at = link.next;
      if (done[at / 2]) {
        route.closed = true;
        break;
      }
    }
    drop_repeats(route);
    return route;
  }

  void append_branch(std::vector<Spot>& spots, std::size_t b, bool backwards) {
    const std::vector<Spot>& all = graph_.branches[b].spots;
    const std::size_t first = cuts_[b].first;
    const std::size_t last = all.size() - 1 - cuts_[b].last;
    for (std::size_t i = first; i <= last; ++i) {
      spots.push_back(all[backwards ? last - (i - first) : i]);
    }
  }

  static void drop_repeats(Route& route) {
    std::vector<Spot>& spots = route.spots;
    const auto same = [](const Spot& a, const Spot& b) { return a.at == b.at; };
    spots.erase(std::unique(spots.begin(), spots.end(), same), spots.end());
    while (route.closed && spots.size() > 1 &&
           same(spots.front(), spots.back())) {
      spots.pop_back();
    }
  }

  const Bitmap& ink_;
  const SkeletonGraph& graph_;
  std::vector<Zone> zones_;
  std::vector<bool> inner_;  ///< branches within a zone
  std::vector<Cut> cuts_;    ///< spots left out at both ends
  std::vector<Link> links_;  ///< by branch end
};

}  // namespace

void append_line(std::vector<Spot>& spots, Point from, Point to) {
  const std::int32_t dx = std::abs(to.x - from.x);
  const std::int32_t dy = std::abs(to.y - from.y);
  const std::int32_t sx = to.x < from.x ? -1 : 1;
  const std::int32_t sy = to.y < from.y ? -1 : 1;
  const std::int32_t n = std::max(dx, dy);
  for (std::int32_t i = 1; i <= n; ++i) {
    const auto part = [&](std::int64_t d) {
      return static_cast<std::int32_t>((2 * d * i + n) / (2 * std::int64_t{n}));
    };
    spots.push_back({{from.x + sx * part(dx), from.y + sy * part(dy)}, 0});
  }
}

Vector2 direction_of(std::span<const Spot> spots) {
  const std::size_t part = std::max<std::size_t>(1, spots.size() / 2);
  Vector2 head;
  Vector2 tail;
  for (std::size_t i = 0; i < part; ++i) {
    head = head + to_vector(spots[i].at);
    tail = tail + to_vector(spots[spots.size() - 1 - i].at);
  }
  return unit(tail - head);
}

std::vector<Route> routes_of(const Bitmap& ink, const SkeletonGraph& graph) {
  return Router(ink, graph).run();
}

}  // namespace unstep::trace
