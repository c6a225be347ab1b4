#include "reverse/swept_points.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace unstep::reverse {
namespace {

std::size_t count_vertices(std::span<const LineVertices> paths) {
  std::size_t count = 0;
  for (const LineVertices& path : paths) count += path.size();
  return count;
}

Box box_around(const LineVertices& path) {
  Box box = Box::around(path.front().at, path.front().at);
  for (const LineVertex& vertex : path)
    box.add(Box::around(vertex.at, vertex.at));
  return box;
}

}  // namespace

SweptPoints::SweptPoints(std::span<const ChainWalk> chains,
                         std::span<const LineVertices> paths,
                         const std::vector<bool>& closed)
    : chains_(chains),
      paths_(paths),
      closed_(closed),
      meeting_(paths, closed),
      map_(count_vertices(paths)) {
  for (std::size_t code = 0; code < moves_.size() && !chains.empty(); ++code) {
    const Point by = chains.front().delta(static_cast<Step>(code));
    moves_[code] = {by, map_.place_of(by)};
  }
  boxes_.reserve(paths.size());
  for (std::uint32_t i = 0; i < paths.size(); ++i) {
    boxes_.push_back(box_around(paths[i]));
    const std::size_t own = paths[i].size() - (closed[i] ? 1 : 0);
    for (std::size_t k = 0; k < own; ++k) add(paths[i][k], i, k);
  }
}

void SweptPoints::add(const LineVertex& vertex, std::uint32_t path,
                      std::size_t line) {
  const Vertex added{path, static_cast<std::uint32_t>(line),
                     static_cast<std::uint32_t>(vertex.index)};
  if ((map_.bits().at(map_.place_of(vertex.at)) & 1) != 0)
    perhaps_shared_.push_back(added);
  map_.add(vertex.at, added);
}

/// Where the vertex is in its path now. REQUIRES: that has less than 2^32
/// steps.
std::uint32_t SweptPoints::line_of(const Vertex& vertex) const {
  const LineVertices& path = paths_[vertex.path];
  const auto low = [](const LineVertex& v) {
    return static_cast<std::uint32_t>(v.index);
  };
  if (low(path[vertex.line]) == vertex.index) return vertex.line;
  return static_cast<std::uint32_t>(
      std::ranges::lower_bound(path, vertex.index, {}, low) - path.begin());
}

/// visit(place, p) for the points that a line sweeps but its ends, and perhaps
/// some beside. Along the axis in which the line is shorter, chain and line are
/// less than 2 apart, so that at most one point is between. Products:
/// differences are below 2^31, so a cross product fits int64.
template <class Visit>
void SweptPoints::for_swept(LineId id, const Visit& visit) const {
  const LineVertex& from = paths_[id.path][id.line];
  const LineVertex& to = paths_[id.path][id.line + 1];
  const std::int64_t dx = std::int64_t{to.at.x} - from.at.x;
  const std::int64_t dy = std::int64_t{to.at.y} - from.at.y;
  const bool is_wide = std::abs(dx) >= std::abs(dy);
  const std::int64_t apart = is_wide ? std::abs(dx) : std::abs(dy);
  // From a point with a positive cross product towards the line.
  const Point back =
      is_wide ? Point{0, dx > 0 ? -1 : 1} : Point{dy > 0 ? 1 : -1, 0};
  const std::size_t place_back = map_.place_of(back);
  const std::span<const Step> steps = chains_[id.path].steps();
  const Step* const end = steps.data() + steps.size();
  std::size_t first = from.index;
  while (first >= steps.size()) first -= steps.size();
  const Step* next = steps.data() + first;
  Point at = from.at;
  std::size_t place = map_.place_of(at);
  const std::size_t place_from = place;
  const std::size_t place_to = map_.place_of(to.at);
  std::int64_t cross = 0;
  for (std::size_t left = to.index - from.index; left > 1; --left) {
    const Move& move = moves_[*next];
    if (++next == end) next = steps.data();
    at = moved(at, move.by);
    place += move.place;
    cross += dx * move.by.y - dy * move.by.x;
    visit(place, at);
    if (std::abs(cross) < apart) continue;
    const int side = cross > 0 ? 1 : -1;
    const std::size_t beside =
        cross > 0 ? place + place_back : place - place_back;
    if (beside == place_from || beside == place_to) continue;
    visit(beside, {at.x + side * back.x, at.y + side * back.y});
  }
}

/// visit(id) for the lines that begin or end at a vertex.
template <class Visit>
void SweptPoints::for_lines_at(std::uint32_t path, std::uint32_t vertex,
                               const Visit& visit) const {
  const std::uint32_t lines = meeting_.lines(path);
  if (vertex < lines) visit(LineId{path, vertex});
  if (vertex > 0) visit(LineId{path, vertex - 1});
  if (vertex == 0 && closed_[path]) visit(LineId{path, lines - 1});
}

/// Compares a line with those at the vertices of a point.
void SweptPoints::compare_at(Point at, LineId id) {
  map_.for_each_at(at, [&](const Vertex& vertex) {
    const std::uint32_t line = line_of(vertex);
    if (paths_[vertex.path][line].at != at) return;
    for_lines_at(vertex.path, line, [&](LineId other) {
      if (!meeting_.consecutive(id, other) && meeting_.cross(id, other))
        found_.push_back({id, other});
    });
  });
}

/// Compares the lines at a vertex with those at others there.
void SweptPoints::compare_ends(const Vertex& vertex) {
  const std::uint32_t line = line_of(vertex);
  const Point at = paths_[vertex.path][line].at;
  for_lines_at(vertex.path, line, [&](LineId id) { compare_at(at, id); });
}

void SweptPoints::sweep(LineId id) {
  const VertexMap::Bits vertices = map_.bits();
  std::uint64_t found = 0;
  for_swept(id, [&](std::size_t place, Point) { found |= vertices.at(place); });
  if ((found & 1) == 0) return;
  for_swept(id, [&](std::size_t place, Point at) {
    if ((vertices.at(place) & 1) != 0) compare_at(at, id);
  });
}

std::vector<CrossingPair> SweptPoints::find_all() {
  for (std::uint32_t path = 0; path < paths_.size(); ++path) {
    for (std::uint32_t line = 0; line < meeting_.lines(path); ++line)
      sweep({path, line});
  }
  for (const Vertex& vertex : perhaps_shared_) compare_ends(vertex);
  return std::exchange(found_, {});
}

std::vector<CrossingPair> SweptPoints::find(std::span<const Box> boxes) {
  const Places places(boxes);
  // Chains are a unit beside their lines at most, and further vertices of a
  // path are on its chain.
  for (std::uint32_t path = 0; path < paths_.size(); ++path) {
    if (!places.meets(boxes_[path].grown(2))) continue;
    for (std::uint32_t line = 0; line < meeting_.lines(path); ++line) {
      const auto [a, b] = meeting_.ends({path, line});
      if (places.meets(Box::around(a, b).grown(1))) sweep({path, line});
    }
  }
  for (const Vertex& vertex : perhaps_shared_) {
    const Point at = paths_[vertex.path][line_of(vertex)].at;
    if (places.meets(Box::around(at, at))) compare_ends(vertex);
  }
  return std::exchange(found_, {});
}

}  // namespace unstep::reverse
