#include "reverse/refine.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "reverse/crossing.h"

namespace unstep::reverse {
namespace {

/// Side of a cell of the search, grid units: lines at a tolerance of 1 are a
/// few times as long.
constexpr std::int64_t kCellRows = 16;

std::uint64_t key(Point p) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.x)) << 32 |
         static_cast<std::uint32_t>(p.y);
}

/// A part of a chain: the points with their neighbours on both sides, as far
/// as there are any.
struct Part {
  std::size_t first = 0;  ///< index of points[0]
  std::vector<Point> points;
};

/// True if two parts of chains run through a common edge, cross in one, or
/// change sides at a common point.
bool parts_cross(const Part& a, const Part& b, bool same_chain,
                 std::size_t lap) {
  std::unordered_multimap<std::uint64_t, std::size_t> places;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    places.emplace(key(a.points[i]), i);
  }
  const auto at_once = [&](std::size_t i, std::size_t j) {
    return same_chain && (a.first + i) % lap == (b.first + j) % lap;
  };
  const auto edge_of_a = [&](Point from, Point to, std::size_t j) {
    const auto [low, high] = places.equal_range(key(from));
    for (auto place = low; place != high; ++place) {
      const std::size_t i = place->second;
      if (i + 1 < a.points.size() && a.points[i + 1] == to && !at_once(i, j)) {
        return true;
      }
      if (i > 0 && a.points[i - 1] == to && !at_once(i - 1, j)) return true;
    }
    return false;
  };
  for (std::size_t j = 0; j < b.points.size(); ++j) {
    const Point at = b.points[j];
    if (j + 1 < b.points.size()) {
      const Point next = b.points[j + 1];
      const bool diagonal = at.x != next.x && at.y != next.y;
      if (edge_of_a(at, next, j) ||
          (diagonal && edge_of_a({at.x, next.y}, {next.x, at.y}, j))) {
        return true;
      }
    }
    if (j == 0 || j + 1 == b.points.size()) continue;
    const auto [low, high] = places.equal_range(key(at));
    for (auto place = low; place != high; ++place) {
      const std::size_t i = place->second;
      if (i == 0 || i + 1 == a.points.size() || at_once(i, j)) continue;
      if (change_sides(at, a.points[i - 1], a.points[i + 1], b.points[j - 1],
                       b.points[j + 1])) {
        return true;
      }
    }
  }
  return false;
}

class Refiner {
 public:
  Refiner(std::span<const ChainWalk> chains, PathTolerance tolerance,
          std::span<LineVertices> paths)
      : chains_(chains), tolerance_(tolerance), paths_(paths) {
    for (const ChainWalk& chain : chains) closed_.push_back(chain.closed());
  }

  std::uint64_t run();

 private:
  /// What is known of a path in this round.
  struct Bad {
    std::vector<Point> anchors;  ///< the chain at each vertex
    std::vector<bool> lines;     ///< to be cut
    bool any = false;
  };

  Bad& bad(std::uint32_t path);
  Part part(LineId id);
  bool is_chain(LineId id);
  void judge(const CrossingPair& pair);
  void cut(std::uint32_t path, Bad& bad, std::vector<Box>& places);
  void cut_line(std::uint32_t path, const Bad& bad, std::size_t line,
                LineVertices& result);

  [[nodiscard]] std::size_t steps(LineId id) const {
    const LineVertices& path = paths_[id.path];
    return path[id.line + 1].index - path[id.line].index;
  }

  std::span<const ChainWalk> chains_;
  PathTolerance tolerance_;
  std::span<LineVertices> paths_;
  std::vector<bool> closed_;
  std::map<std::uint32_t, Bad> bad_;
};

Refiner::Bad& Refiner::bad(std::uint32_t path) {
  const auto [place, fresh] = bad_.try_emplace(path);
  Bad& result = place->second;
  if (!fresh) return result;
  const ChainWalk& chain = chains_[path];
  const LineVertices& vertices = paths_[path];
  result.lines.resize(vertices.size() - 1);
  Point at = chain.origin();
  std::size_t index = 0;
  for (const LineVertex& vertex : vertices) {
    for (; index < vertex.index; ++index) {
      const Point move = chain.delta(chain.step(index));
      at = {at.x + move.x, at.y + move.y};
    }
    result.anchors.push_back(at);
  }
  return result;
}

Part Refiner::part(LineId id) {
  const ChainWalk& chain = chains_[id.path];
  const LineVertices& path = paths_[id.path];
  std::size_t first = path[id.line].index;
  std::size_t last = path[id.line + 1].index;
  Point at = bad(id.path).anchors[id.line];
  if (chain.closed() || last < chain.size()) ++last;
  if (chain.closed() && first == 0) {
    first += chain.size();
    last += chain.size();
  }
  if (first > 0) {
    --first;
    const Point move = chain.delta(chain.step(first));
    at = {at.x - move.x, at.y - move.y};
  }
  return {first, chain.points(first, last, at)};
}

/// True if nothing finer than this line can stand for its steps.
bool Refiner::is_chain(LineId id) {
  const LineVertices& path = paths_[id.path];
  const ChainWalk& chain = chains_[id.path];
  const Bad& known = bad(id.path);
  for (std::size_t k = id.line; k <= id.line + 1; ++k) {
    if (path[k].at != known.anchors[k]) return false;
  }
  for (std::size_t i = path[id.line].index + 1; i < path[id.line + 1].index;
       ++i) {
    if (!chain.straight_at(i)) return false;
  }
  return true;
}

void Refiner::judge(const CrossingPair& pair) {
  // Whichever way round they were found, the later of two equals is cut.
  const bool in_order = pair.first.path != pair.second.path
                            ? pair.first.path > pair.second.path
                            : pair.first.line > pair.second.line;
  const LineId a = in_order ? pair.first : pair.second;
  const LineId b = in_order ? pair.second : pair.first;
  const bool same = a.path == b.path;
  const std::size_t lap = std::max<std::size_t>(1, chains_[a.path].size());
  if (parts_cross(part(a), part(b), same, lap)) return;
  const bool a_fixed = is_chain(a);
  const bool b_fixed = is_chain(b);
  if (a_fixed && b_fixed) return;
  const bool cut_a = !a_fixed && (b_fixed || steps(a) >= steps(b));
  const LineId id = cut_a ? a : b;
  Bad& known = bad(id.path);
  known.any = true;
  known.lines[id.line] = true;
  if (steps(id) > 0) return;
  // It leads from the chain to a free vertex or back: the vertex goes.
  if (id.line > 0) known.lines[id.line - 1] = true;
  if (id.line + 1 < known.lines.size()) known.lines[id.line + 1] = true;
}

void Refiner::cut_line(std::uint32_t path, const Bad& known, std::size_t line,
                       LineVertices& result) {
  const LineVertices& old = paths_[path];
  const LineVertex from{old[line].index, known.anchors[line]};
  const LineVertex to{old[line + 1].index, known.anchors[line + 1]};
  if (result.back().at != from.at) result.push_back(from);
  const std::size_t longest =
      std::max<std::size_t>(1, (to.index - from.index) / 2);
  fit_lines_between(chains_[path], tolerance_, to.index, longest, result);
}

void Refiner::cut(std::uint32_t path, Bad& known, std::vector<Box>& places) {
  const LineVertices old = paths_[path];
  LineVertices result;
  result.push_back(known.lines.front()
                       ? LineVertex{old.front().index, known.anchors.front()}
                       : old.front());
  for (std::size_t line = 0; line < known.lines.size(); ++line) {
    const std::size_t before = result.size() - 1;
    if (known.lines[line]) {
      cut_line(path, known, line, result);
    } else {
      if (result.back().at != old[line].at) result.push_back(old[line]);
      result.push_back(old[line + 1]);
      if (result.size() - before == 2) continue;
    }
    for (std::size_t k = before; k + 1 < result.size(); ++k)
      places.push_back(Box::around(result[k].at, result[k + 1].at));
  }
  if (closed_[path] && result.back().at != result.front().at) {
    places.push_back(Box::around(result.back().at, result.front().at));
    result.push_back({old.back().index, result.front().at});
  }
  paths_[path] = std::move(result);
}

std::uint64_t Refiner::run() {
  if (chains_.empty()) return 0;
  const std::int64_t cell_size =
      kCellRows * std::int64_t{chains_.front().delta(0).x};
  std::vector<bool> changed(paths_.size());
  std::vector<Box> places{kEverywhere};
  while (!places.empty()) {
    bad_.clear();
    for (const CrossingPair& pair :
         find_crossings(paths_, closed_, places, cell_size)) {
      judge(pair);
    }
    places.clear();
    for (auto& [path, known] : bad_) {
      if (!known.any) continue;
      cut(path, known, places);
      changed[path] = true;
    }
  }
  return static_cast<std::uint64_t>(
      std::count(changed.begin(), changed.end(), true));
}

}  // namespace

std::uint64_t refine_crossings(std::span<const ChainWalk> chains,
                               PathTolerance tolerance,
                               std::span<LineVertices> paths) {
  return Refiner(chains, tolerance, paths).run();
}

}  // namespace unstep::reverse
