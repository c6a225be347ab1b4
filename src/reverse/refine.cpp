#include "reverse/refine.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "reverse/crossing.h"
#include "reverse/swept_points.h"

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

struct Place {
  std::uint64_t key = 0;
  std::size_t index = 0;
};

/// True if two parts of chains run through a common edge, cross in one, or
/// change sides at a common point.
bool parts_cross(const Part& a, const Part& b, bool same_chain,
                 std::size_t lap) {
  std::vector<Place> places;
  places.reserve(a.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
    places.push_back({key(a.points[i]), i});
  std::ranges::sort(places, {}, &Place::key);
  const auto at = [&places](Point point) {
    return std::ranges::equal_range(places, key(point), {}, &Place::key);
  };
  const auto at_once = [&](std::size_t i, std::size_t j) {
    return same_chain && (a.first + i) % lap == (b.first + j) % lap;
  };
  const auto edge_of_a = [&](Point from, Point to, std::size_t j) {
    for (const Place& place : at(from)) {
      const std::size_t i = place.index;
      if (i + 1 < a.points.size() && a.points[i + 1] == to && !at_once(i, j)) {
        return true;
      }
      if (i > 0 && a.points[i - 1] == to && !at_once(i - 1, j)) return true;
    }
    return false;
  };
  for (std::size_t j = 0; j < b.points.size(); ++j) {
    const Point here = b.points[j];
    if (j + 1 < b.points.size()) {
      const Point next = b.points[j + 1];
      const bool diagonal = here.x != next.x && here.y != next.y;
      if (edge_of_a(here, next, j) ||
          (diagonal && edge_of_a({here.x, next.y}, {next.x, here.y}, j))) {
        return true;
      }
    }
    if (j == 0 || j + 1 == b.points.size()) continue;
    for (const Place& place : at(here)) {
      const std::size_t i = place.index;
      if (i == 0 || i + 1 == a.points.size() || at_once(i, j)) continue;
      if (change_sides(here, a.points[i - 1], a.points[i + 1], b.points[j - 1],
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
          VerticesAt at, std::span<LineVertices> paths)
      : chains_(chains),
        tolerance_(tolerance),
        on_chain_(at == VerticesAt::chain),
        paths_(paths) {
    closed_.reserve(chains.size());
    for (const ChainWalk& chain : chains) closed_.push_back(chain.closed());
    if (on_chain_ && has_short_lines()) swept_.emplace(chains, paths, closed_);
  }

  std::uint64_t run();

 private:
  /// What is known of a path in this round.
  struct Bad {
    std::vector<Point> anchors;  ///< the chain at each vertex that is free
    std::vector<bool> lines;     ///< to be cut
    bool any = false;
  };

  [[nodiscard]] bool has_short_lines() const;
  std::vector<CrossingPair> crossings(std::span<const Box> places);
  Bad& bad(std::uint32_t path);
  Point anchor(std::uint32_t path, std::size_t vertex) {
    return on_chain_ ? paths_[path][vertex].at : bad(path).anchors[vertex];
  }
  Part part(LineId id);
  bool is_chain(LineId id);
  void judge(const CrossingPair& pair);
  void cut(std::uint32_t path, Bad& bad, std::vector<Box>& places);
  void cut_line(std::uint32_t path, const LineVertex& from,
                const LineVertex& to, LineVertices& result);

  [[nodiscard]] std::size_t steps(LineId id) const {
    const LineVertices& path = paths_[id.path];
    return path[id.line + 1].index - path[id.line].index;
  }

  std::span<const ChainWalk> chains_;
  PathTolerance tolerance_;
  bool on_chain_;
  std::span<LineVertices> paths_;
  std::vector<bool> closed_;
  std::optional<SweptPoints> swept_;
  std::map<std::uint32_t, Bad> bad_;
};

Refiner::Bad& Refiner::bad(std::uint32_t path) {
  const auto [place, fresh] = bad_.try_emplace(path);
  Bad& result = place->second;
  if (!fresh) return result;
  const ChainWalk& chain = chains_[path];
  const LineVertices& vertices = paths_[path];
  result.lines.resize(vertices.size() - 1);
  if (on_chain_) return result;
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
  Point at = anchor(id.path, id.line);
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
  for (std::size_t k = id.line; k <= id.line + 1; ++k) {
    if (path[k].at != anchor(id.path, k)) return false;
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

/// Appends lines for one, from its vertices' anchors.
void Refiner::cut_line(std::uint32_t path, const LineVertex& from,
                       const LineVertex& to, LineVertices& result) {
  if (result.back().at != from.at) result.push_back(from);
  const std::size_t first = result.size();
  const std::size_t longest =
      std::max<std::size_t>(1, (to.index - from.index) / 2);
  fit_lines_between(chains_[path], tolerance_, to.index, longest, result);
  if (!swept_) return;
  for (std::size_t k = first; k + 1 < result.size(); ++k)
    swept_->add(result[k], path, k);
}

void Refiner::cut(std::uint32_t path, Bad& known, std::vector<Box>& places) {
  const LineVertices& old = paths_[path];
  const auto anchored = [&](std::size_t k) {
    return LineVertex{old[k].index, anchor(path, k)};
  };
  LineVertices result;
  result.reserve(old.size() + 8);
  result.push_back(known.lines.front() ? anchored(0) : old.front());
  for (std::size_t line = 0; line < known.lines.size(); ++line) {
    const std::size_t before = result.size() - 1;
    if (known.lines[line]) {
      cut_line(path, anchored(line), anchored(line + 1), result);
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

/// Of longer ones the grid knows sooner than all the points that they sweep.
bool Refiner::has_short_lines() const {
  constexpr std::uint64_t kFewSteps = 12;
  std::uint64_t steps = 0;
  std::uint64_t lines = 0;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    steps += chains_[i].size();
    lines += paths_[i].size() - 1;
  }
  return steps <= kFewSteps * lines && steps < std::uint64_t{1} << 31;
}

std::vector<CrossingPair> Refiner::crossings(std::span<const Box> places) {
  if (swept_) return places.empty() ? swept_->find_all() : swept_->find(places);
  const std::int64_t cell_size =
      kCellRows * std::int64_t{chains_.front().delta(0).x};
  return find_crossings(paths_, closed_,
                        places.empty() ? std::span(&kEverywhere, 1) : places,
                        cell_size);
}

std::uint64_t Refiner::run() {
  if (chains_.empty()) return 0;
  std::vector<bool> changed(paths_.size());
  std::vector<Box> places;
  do {
    bad_.clear();
    for (const CrossingPair& pair : crossings(places)) judge(pair);
    places.clear();
    for (auto& [path, known] : bad_) {
      if (!known.any) continue;
      cut(path, known, places);
      changed[path] = true;
    }
  } while (!places.empty());
  return static_cast<std::uint64_t>(
      std::count(changed.begin(), changed.end(), true));
}

}  // namespace

std::uint64_t refine_crossings(std::span<const ChainWalk> chains,
                               PathTolerance tolerance, VerticesAt at,
                               std::span<LineVertices> paths) {
  return Refiner(chains, tolerance, at, paths).run();
}

}  // namespace unstep::reverse
