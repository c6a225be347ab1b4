#include "trace/skeleton_pruning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <queue>
#include <utility>

namespace unstep::trace {
namespace {

double distance(Point a, Point b) {
  const double dx = double{1} * a.x - b.x;
  const double dy = double{1} * a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

bool touch(Point a, Point b) {
  return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1;
}

/// The shortest way over the spots from one that touches `from` to one that
/// touches `to`; without `to` to the middle.
std::vector<Spot> way_through(const Junction& junction, Point from,
                              const Point* to) {
  const std::vector<Spot>& spots = junction.spots;
  constexpr std::size_t kUnseen = ~std::size_t{0};
  std::vector<std::size_t> before(spots.size(), kUnseen);
  std::vector<std::size_t> queue;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (!touch(spots[i].at, from)) continue;
    before[i] = i;
    queue.push_back(i);
  }
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const std::size_t i = queue[k];
    const bool there = to != nullptr ? touch(spots[i].at, *to)
                                     : spots[i].at == junction.middle.at;
    if (there) {
      std::vector<Spot> way;
      for (std::size_t j = i;; j = before[j]) {
        way.push_back(spots[j]);
        if (before[j] == j) break;
      }
      std::ranges::reverse(way);
      return way;
    }
    for (std::size_t j = 0; j < spots.size(); ++j) {
      if (before[j] != kUnseen || !touch(spots[i].at, spots[j].at)) continue;
      before[j] = i;
      queue.push_back(j);
    }
  }
  return {};
}

/// Branches that a junction joins stay apart until the end: what has become
/// one is known by a forest, so that long lines with many spurs are not copied
/// for each.
class Pruner {
 public:
  explicit Pruner(SkeletonGraph& graph)
      : graph_(graph), lines_(graph.branches.size()) {
    for (std::size_t b = 0; b < lines_.size(); ++b) {
      const Branch& branch = graph.branches[b];
      lines_[b] = {b,
                   {End{branch.from, branch.spots.front()},
                    End{branch.to, branch.spots.back()}},
                   false};
    }
  }

  void run() {
    for (std::size_t j = 0; j < graph_.junctions.size(); ++j) settle(j);
    for (std::size_t b = 0; b < lines_.size(); ++b) consider(b);
    while (!spurs_.empty()) {
      const std::size_t line = spurs_.top().line;
      spurs_.pop();
      // It may have become part of a longer one since.
      if (lines_[line].parent != line || !is_spur(lines_[line])) continue;
      lines_[line].removed = true;
      const std::size_t j = base(lines_[line]).junction;
      std::erase_if(graph_.junctions[j].branches,
                    [&](std::size_t b) { return line_of(b) == line; });
      settle(j);
    }
    join_all();
  }

 private:
  struct End {
    std::size_t junction = Branch::kNone;
    Spot tip;
  };
  /// Branches that are one; those of the root count.
  struct Line {
    std::size_t parent = 0;
    std::array<End, 2> ends;
    bool removed = false;
  };
  struct Spur {
    double share = 0;  ///< of its length in what makes it one
    std::size_t line = 0;
    friend bool operator<(const Spur& a, const Spur& b) {
      return a.share != b.share ? a.share > b.share : a.line > b.line;
    }
  };

  std::size_t line_of(std::size_t b) {
    while (lines_[b].parent != b) {
      lines_[b].parent = lines_[lines_[b].parent].parent;
      b = lines_[b].parent;
    }
    return b;
  }

  static const End& base(const Line& line) {
    return line.ends[line.ends[0].junction != Branch::kNone ? 0 : 1];
  }
  static const End& free_end(const Line& line) {
    return line.ends[line.ends[0].junction != Branch::kNone ? 1 : 0];
  }

  /// Above 1 it is no spur.
  [[nodiscard]] double share(const Line& line) const {
    const Spot& middle = graph_.junctions[base(line).junction].middle;
    const double radius = radius_of(middle);
    return distance(free_end(line).tip.at, middle.at) /
           (kSpurReach * radius + std::min(kSpurSlack, radius + 0.5));
  }

  [[nodiscard]] bool is_spur(const Line& line) const {
    const bool leaf = (line.ends[0].junction == Branch::kNone) !=
                      (line.ends[1].junction == Branch::kNone);
    return leaf && !line.removed && share(line) <= 1;
  }

  void consider(std::size_t line) {
    if (lines_[line].parent == line && is_spur(lines_[line])) {
      spurs_.push({share(lines_[line]), line});
    }
  }

  /// Makes a junction of fewer than three branches part of them.
  void settle(std::size_t j) {
    const std::vector<std::size_t>& branches = graph_.junctions[j].branches;
    if (branches.size() > 2) return;
    if (branches.size() == 1) {
      Line& line = lines_[line_of(branches[0])];
      line.ends[line.ends[0].junction == j ? 0 : 1] = {
          Branch::kNone, graph_.junctions[j].middle};
      consider(line_of(branches[0]));
    } else if (branches.size() == 2) {
      unite(j, line_of(branches[0]), line_of(branches[1]));
    }
  }

  void unite(std::size_t j, std::size_t a, std::size_t b) {
    if (a == b) return;  // a ring
    const auto other_end = [&](const Line& line) {
      return line.ends[line.ends[0].junction == j ? 1 : 0];
    };
    lines_[a].ends = {other_end(lines_[a]), other_end(lines_[b])};
    lines_[b].parent = a;
    consider(a);
  }

  [[nodiscard]] bool settled(std::size_t j) const {
    return graph_.junctions[j].branches.size() < 3;
  }

  /// Whether a branch ends here: no other one goes on.
  [[nodiscard]] bool ends_at(std::size_t j) const {
    return j == Branch::kNone || graph_.junctions[j].branches.size() != 2;
  }

  void join_all() {
    std::vector<Branch> joined;
    std::vector<bool> done(graph_.branches.size());
    const auto wanted = [&](std::size_t b) {
      return !done[b] && !lines_[line_of(b)].removed;
    };
    for (std::size_t b = 0; b < graph_.branches.size(); ++b) {
      const Branch& branch = graph_.branches[b];
      if (!wanted(b)) continue;
      if (ends_at(branch.from)) {
        joined.push_back(follow(b, branch.to, done));
      } else if (ends_at(branch.to)) {
        joined.push_back(follow(b, branch.from, done));
      }
    }
    for (std::size_t b = 0; b < graph_.branches.size(); ++b) {
      if (wanted(b)) joined.push_back(follow(b, graph_.branches[b].to, done));
    }
    keep_junctions(joined);
    graph_.branches = std::move(joined);
  }

  /// The line from branch b on, through its end at junction `to`, to where it
  /// ends or closes.
  Branch follow(std::size_t b, std::size_t to, std::vector<bool>& done) {
    const Branch& first = graph_.branches[b];
    const bool first_ahead = first.to == to;
    Branch line;
    line.from = first_ahead ? first.from : first.to;
    line.closed = first.closed;
    begin_at_middle(
        line, first_ahead ? first.spots.front().at : first.spots.back().at);
    for (bool ahead = first_ahead;;) {
      const Branch& branch = graph_.branches[b];
      done[b] = true;
      append(line.spots, branch.spots, ahead);
      line.to = ahead ? branch.to : branch.from;
      if (ends_at(line.to)) break;
      const Junction& junction = graph_.junctions[line.to];
      const std::size_t next = junction.branches[0] == b ? junction.branches[1]
                                                         : junction.branches[0];
      const Branch& after = graph_.branches[next];
      const bool closes = done[next];
      // Of a ring the first spot is where it began.
      const bool next_ahead = after.from == line.to;
      const Point to_spot = closes       ? line.spots.front().at
                            : next_ahead ? after.spots.front().at
                                         : after.spots.back().at;
      append(line.spots, way_through(junction, line.spots.back().at, &to_spot),
             true);
      if (closes) {
        line.from = line.to = Branch::kNone;
        line.closed = true;
        return line;
      }
      b = next;
      ahead = next_ahead;
    }
    if (line.to != Branch::kNone && settled(line.to)) {
      append(
          line.spots,
          way_through(graph_.junctions[line.to], line.spots.back().at, nullptr),
          true);
      line.to = Branch::kNone;
    }
    return line;
  }

  /// A junction of one branch is the line's end.
  void begin_at_middle(Branch& line, Point first) const {
    if (line.from == Branch::kNone || !settled(line.from)) return;
    append(line.spots, way_through(graph_.junctions[line.from], first, nullptr),
           false);
    line.from = Branch::kNone;
  }

  static void append(std::vector<Spot>& spots, const std::vector<Spot>& more,
                     bool ahead) {
    if (ahead) {
      spots.insert(spots.end(), more.begin(), more.end());
    } else {
      spots.insert(spots.end(), more.rbegin(), more.rend());
    }
  }

  /// Those of three branches or more stay, those of none become a spot.
  void keep_junctions(std::vector<Branch>& joined) {
    std::vector<std::size_t> number(graph_.junctions.size(), Branch::kNone);
    std::vector<Junction> kept;
    for (std::size_t j = 0; j < graph_.junctions.size(); ++j) {
      Junction& junction = graph_.junctions[j];
      if (junction.branches.empty()) {
        joined.push_back({{junction.middle}, Branch::kNone, Branch::kNone});
      } else if (!settled(j)) {
        number[j] = kept.size();
        junction.branches.clear();
        kept.push_back(std::move(junction));
      }
    }
    for (std::size_t b = 0; b < joined.size(); ++b) {
      for (std::size_t* end : {&joined[b].from, &joined[b].to}) {
        if (*end == Branch::kNone) continue;
        *end = number[*end];
        kept[*end].branches.push_back(b);
      }
    }
    graph_.junctions = std::move(kept);
  }

  SkeletonGraph& graph_;
  std::vector<Line> lines_;
  std::priority_queue<Spur> spurs_;
};

}  // namespace

void prune_spurs(SkeletonGraph& graph) { Pruner(graph).run(); }

}  // namespace unstep::trace
