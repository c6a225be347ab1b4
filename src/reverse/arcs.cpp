#include "reverse/arcs.h"

#include <algorithm>
#include <utility>

namespace unstep::reverse {
namespace {

PathParts lines_only(const LineVertices& vertices) {
  PathParts parts(vertices.size() - 1);
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].end = i + 1;
  return parts;
}

std::vector<Point> points_of(const ChainWalk& chain,
                             const LineVertices& vertices) {
  Point at = chain.origin();
  const std::size_t first = vertices.front().index;
  for (std::size_t i = 0; i < first; ++i) {
    const Point move = chain.delta(chain.step(i));
    at = {at.x + move.x, at.y + move.y};
  }
  return chain.points(first, vertices.back().index, at);
}

/// Greedy from the first vertex on.
class ArcLayer {
 public:
  ArcLayer(const ArcFitter& fitter, std::span<const Point> points,
           const LineVertices& vertices)
      : fitter_(fitter), points_(points), vertices_(vertices) {}

  PathParts run() {
    PathParts parts;
    for (std::size_t a = 0; a + 1 < vertices_.size();) {
      const std::optional<PathPart> arc = longest_from(a);
      parts.push_back(arc ? *arc : PathPart{a + 1, false, {}});
      a = parts.back().end;
    }
    return parts;
  }

 private:
  [[nodiscard]] std::optional<Arc> fit(std::size_t a, std::size_t b) const {
    const std::size_t from = vertices_[a].index - vertices_.front().index;
    const std::size_t to = vertices_[b].index - vertices_.front().index;
    return fitter_.fit({points_.subspan(from, to - from + 1), vertices_[a].at,
                        vertices_[b].at});
  }

  [[nodiscard]] std::optional<PathPart> longest_from(std::size_t a) const {
    const std::size_t last = vertices_.size() - 1;
    std::size_t good = a + kLeastLines;
    if (good > last) return std::nullopt;
    std::optional<Arc> best = fit(a, good);
    if (!best) return std::nullopt;
    std::size_t bad = last + 1;
    for (std::size_t more = kLeastLines; good + more <= last; more *= 2) {
      const std::optional<Arc> longer = fit(a, good + more);
      if (!longer) {
        bad = good + more;
        break;
      }
      best = longer;
      good += more;
    }
    while (bad - good > 1) {
      const std::size_t middle = good + (bad - good) / 2;
      if (const std::optional<Arc> longer = fit(a, middle)) {
        best = longer;
        good = middle;
      } else {
        bad = middle;
      }
    }
    return PathPart{good, true, *best};
  }

  const ArcFitter& fitter_;
  std::span<const Point> points_;  ///< from the first vertex on
  const LineVertices& vertices_;
};

/// The ring begun at another of its vertices.
LineVertices turned(const LineVertices& ring, std::size_t start,
                    std::size_t lap) {
  LineVertices result(ring.begin() + static_cast<std::ptrdiff_t>(start),
                      ring.end());
  for (std::size_t i = 1; i <= start; ++i)
    result.push_back({ring[i].index + lap, ring[i].at});
  if (result.front().index >= lap)
    for (LineVertex& vertex : result) vertex.index -= lap;
  return result;
}

/// The start chosen blindly may lie within an arc: once more from where the
/// first arc ends.
void improve_start(const ChainWalk& chain, const ArcFitter& fitter,
                   ArcPath& path) {
  if (!path.parts.front().is_arc || path.parts.size() < 2) return;
  LineVertices other =
      turned(path.vertices, path.parts.front().end, chain.size());
  const std::vector<Point> points = points_of(chain, other);
  PathParts parts = ArcLayer(fitter, points, other).run();
  if (parts.size() >= path.parts.size()) return;
  path.vertices = std::move(other);
  path.parts = std::move(parts);
}

}  // namespace

ArcPath fit_arcs(const ChainWalk& chain, const ArcFitter& fitter,
                 LineVertices vertices) {
  if (vertices.size() <= kLeastLines) return without_arcs(std::move(vertices));
  ArcPath path = without_arcs(std::move(vertices));
  const std::vector<Point> points = points_of(chain, path.vertices);
  if (chain.closed()) {
    path.ring = fitter.fit_ring(points);
    if (path.ring) return path;
  }
  path.parts = ArcLayer(fitter, points, path.vertices).run();
  if (chain.closed()) improve_start(chain, fitter, path);
  return path;
}

ArcPath without_arcs(LineVertices vertices) {
  PathParts parts = lines_only(vertices);
  return {std::move(vertices), std::move(parts), {}};
}

void drop_dear_arcs(ArcPath& path, const LinePrice& price) {
  if (path.ring) return;
  // About what a centre needs, more or less by the radius, and that it is one.
  constexpr std::int32_t kCentre = 16 * LinePrice::kBit;
  PathParts parts;
  vectors::Vec before;
  std::size_t start = 0;
  const auto line_to = [&](std::size_t a, std::size_t b) {
    return vectors::between(path.vertices[a].at, path.vertices[b].at);
  };
  const auto cost_of = [&](const vectors::Vec& after, const vectors::Vec& v) {
    return price(price.after(after), static_cast<std::int32_t>(v.x),
                 static_cast<std::int32_t>(v.y));
  };
  for (const PathPart& part : path.parts) {
    bool keep = part.is_arc;
    const vectors::Vec chord = line_to(start, part.end);
    if (keep && !chord.zero()) {
      std::int32_t lines = 0;
      vectors::Vec last = before;
      for (std::size_t i = start; i < part.end; ++i) {
        const vectors::Vec v = line_to(i, i + 1);
        lines += cost_of(last, v);
        last = v;
      }
      keep = cost_of(before, chord) + kCentre < lines;
    }
    if (keep) {
      parts.push_back(part);
      before = chord;
    } else {
      for (std::size_t i = start; i < part.end; ++i) {
        parts.push_back({i + 1, false, {}});
        before = line_to(i, i + 1);
      }
    }
    start = part.end;
  }
  path.parts = std::move(parts);
}

Path path_of(const ArcPath& from, bool closed) {
  Path path;
  path.closed = closed;
  if (from.ring) {
    path.origin = from.ring->start;
    for (const Arc& arc : from.ring->arcs)
      path.elements.push_back({Path::Kind::arc, {}, arc});
    return path;
  }
  path.origin = from.vertices.front().at;
  path.elements.resize(from.parts.size());
  std::size_t start = 0;
  for (std::size_t i = 0; i < path.elements.size(); ++i) {
    const PathPart& part = from.parts[i];
    const Point a = from.vertices[start].at;
    const Point b = from.vertices[part.end].at;
    if (part.is_arc) {
      path.elements[i].kind = Path::Kind::arc;
      path.elements[i].arc = part.arc;
    } else {
      path.elements[i].segment = {b.x - a.x, b.y - a.y};
    }
    start = part.end;
  }
  return path;
}

}  // namespace unstep::reverse
