#include "reverse/arcs.h"

#include <algorithm>
#include <utility>

namespace unstep::reverse {
namespace {

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

  std::vector<PathArc> run() {
    std::vector<PathArc> arcs;
    for (std::size_t a = 0; a + 1 < vertices_.size();) {
      const std::optional<PathArc> arc = longest_from(a);
      if (arc) arcs.push_back(*arc);
      a = arc ? arc->end : a + 1;
    }
    return arcs;
  }

 private:
  [[nodiscard]] std::optional<Arc> fit(std::size_t a, std::size_t b) const {
    const std::size_t from = vertices_[a].index - vertices_.front().index;
    const std::size_t to = vertices_[b].index - vertices_.front().index;
    return fitter_.fit({points_.subspan(from, to - from + 1), vertices_[a].at,
                        vertices_[b].at});
  }

  [[nodiscard]] std::optional<PathArc> longest_from(std::size_t a) const {
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
    return PathArc{a, good, *best};
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
  if (path.arcs.empty() || path.arcs.front().first > 0 || path.parts() < 2) {
    return;
  }
  ArcPath other =
      without_arcs(turned(path.vertices, path.arcs.front().end, chain.size()));
  const std::vector<Point> points = points_of(chain, other.vertices);
  other.arcs = ArcLayer(fitter, points, other.vertices).run();
  if (other.parts() < path.parts()) path = std::move(other);
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
  path.arcs = ArcLayer(fitter, points, path.vertices).run();
  if (chain.closed()) improve_start(chain, fitter, path);
  return path;
}

ArcPath without_arcs(LineVertices vertices) {
  return {std::move(vertices), {}, {}};
}

void drop_dear_arcs(ArcPath& path, const LinePrice& price) {
  if (path.ring) return;
  // About what a centre needs, more or less by the radius, and that it is one.
  constexpr std::int32_t kCentre = 16 * LinePrice::kBit;
  std::vector<PathArc> kept;
  vectors::Vec before;
  const auto line_to = [&](std::size_t a, std::size_t b) {
    return vectors::between(path.vertices[a].at, path.vertices[b].at);
  };
  const auto cost_of = [&](const vectors::Vec& after, const vectors::Vec& v) {
    return price(price.after(after), static_cast<std::int32_t>(v.x),
                 static_cast<std::int32_t>(v.y));
  };
  for_parts(path, [&](std::size_t a, std::size_t b, const Arc* arc) {
    const vectors::Vec chord = line_to(a, b);
    if (arc == nullptr || chord.zero()) {
      if (arc != nullptr) kept.push_back({a, b, *arc});
      before = chord;
      return;
    }
    std::int32_t lines = 0;
    vectors::Vec last = before;
    for (std::size_t i = a; i < b; ++i) {
      const vectors::Vec v = line_to(i, i + 1);
      lines += cost_of(last, v);
      last = v;
    }
    if (cost_of(before, chord) + kCentre < lines) {
      kept.push_back({a, b, *arc});
      before = chord;
    } else {
      before = line_to(b - 1, b);
    }
  });
  path.arcs = std::move(kept);
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
  path.elements.reserve(from.parts());
  for_parts(from, [&](std::size_t a, std::size_t b, const Arc* arc) {
    const Point start = from.vertices[a].at;
    const Point end = from.vertices[b].at;
    if (arc != nullptr) {
      path.elements.push_back({Path::Kind::arc, {}, *arc});
    } else {
      path.elements.push_back(
          {Path::Kind::segment, {end.x - start.x, end.y - start.y}, {}});
    }
  });
  return path;
}

}  // namespace unstep::reverse
