#include "reverse/tolerance_lines.h"

#include <algorithm>

namespace unstep::reverse {
namespace {

/// Steps that are looked at in vain before the farthest point is taken: in
/// proportion to the line found, so that the time stays linear.
constexpr std::size_t kPatience = 64;

Point moved(Point at, Point by) { return {at.x + by.x, at.y + by.y}; }

/// The farthest point after `from` to which one line may go, at most `limit`.
/// REQUIRES: from.index < limit, and `from` on the chain.
LineVertex farthest_end(const ChainWalk& chain, const LineVertex& from,
                        std::size_t limit, Cone& cone) {
  cone.restart();
  Point offset;
  std::size_t end = from.index;
  Point end_offset;
  std::size_t stop = std::min(limit, from.index + kPatience);
  Step step = chain.step(from.index);
  for (std::size_t i = from.index; i < stop;) {
    offset = moved(offset, chain.delta(step));
    ++i;
    if (cone.may_end_at(offset.x, offset.y)) {
      end = i;
      end_offset = offset;
      stop = std::min(limit, from.index + 4 * (i - from.index) + kPatience);
    }
    if (i == limit) break;
    const Step next = chain.step(i);
    if (next != step && !cone.add(offset.x, offset.y)) break;
    step = next;
  }
  return {end, moved(from.at, end_offset)};
}

/// Lines from the last vertex to exactly `last`.
void append_lines(const ChainWalk& chain, std::size_t last, Cone& cone,
                  LineVertices& vertices) {
  while (vertices.back().index < last) {
    vertices.push_back(farthest_end(chain, vertices.back(), last, cone));
  }
}

/// Closed chain: lines go on round the ring until they come to a vertex that
/// they made a lap before. From there on they close by themselves, without the
/// short line that ends at a start chosen blindly. If that has not happened
/// after two laps, the ring starts at the end of the first line.
LineVertices fit_ring(const ChainWalk& chain, Cone& cone) {
  const std::size_t lap = chain.size();
  LineVertices vertices{{0, chain.origin()}};
  std::size_t before = 0;  // the first vertex not passed again
  while (vertices.back().index < 2 * lap) {
    const LineVertex from = vertices.back();
    vertices.push_back(farthest_end(chain, from, from.index + lap, cone));
    const std::size_t now = vertices.back().index;
    while (vertices[before].index + lap < now) ++before;
    if (vertices[before].index + lap == now) {
      vertices.erase(vertices.begin(),
                     vertices.begin() + static_cast<std::ptrdiff_t>(before));
      return vertices;
    }
  }
  LineVertices forced{vertices[1]};
  append_lines(chain, forced.front().index + lap, cone, forced);
  return forced;
}

/// The point between two vertices that is farthest from their line; the first
/// vertex if all are on it. Products: differences are below 2^31, so a cross
/// product fits int64.
LineVertex farthest_from_line(const ChainWalk& chain, const LineVertex& from,
                              const LineVertex& to) {
  const std::int64_t dx = std::int64_t{to.at.x} - from.at.x;
  const std::int64_t dy = std::int64_t{to.at.y} - from.at.y;
  LineVertex best = from;
  std::int64_t distance = 0;
  Point at = from.at;
  for (std::size_t i = from.index; i + 1 < to.index; ++i) {
    at = moved(at, chain.delta(chain.step(i)));
    const std::int64_t cross =
        dx * (at.y - from.at.y) - dy * (at.x - from.at.x);
    if (std::abs(cross) > distance) {
      distance = std::abs(cross);
      best = {i + 1, at};
    }
  }
  return best;
}

/// A ring of two lines encloses nothing. If its chain does, each of the two
/// gets a vertex where the chain is farthest from it.
LineVertices unfolded(const ChainWalk& chain, const LineVertices& ring,
                      Cone& cone) {
  LineVertices result{ring.front()};
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const LineVertex middle = farthest_from_line(chain, ring[i - 1], ring[i]);
    if (middle.index > ring[i - 1].index) {
      append_lines(chain, middle.index, cone, result);
    }
    append_lines(chain, ring[i].index, cone, result);
  }
  return result;
}

/// Indices of the first vertex within the first lap.
void normalise(const ChainWalk& chain, LineVertices& ring) {
  const std::size_t laps = ring.front().index / chain.size() * chain.size();
  for (LineVertex& vertex : ring) vertex.index -= laps;
}

}  // namespace

LineVertices fit_lines(const ChainWalk& chain, PathTolerance tolerance) {
  LineVertices vertices{{0, chain.origin()}};
  if (chain.size() == 0) return vertices;
  Cone cone(tolerance);
  if (!chain.closed()) {
    append_lines(chain, chain.size(), cone, vertices);
    return vertices;
  }
  vertices = fit_ring(chain, cone);
  if (vertices.size() == 3) vertices = unfolded(chain, vertices, cone);
  normalise(chain, vertices);
  return vertices;
}

void fit_lines_between(const ChainWalk& chain, PathTolerance tolerance,
                       std::size_t last, std::size_t longest,
                       LineVertices& vertices) {
  Cone cone(tolerance);
  while (vertices.back().index < last) {
    const std::size_t limit = std::min(last, vertices.back().index + longest);
    vertices.push_back(farthest_end(chain, vertices.back(), limit, cone));
  }
}

}  // namespace unstep::reverse
