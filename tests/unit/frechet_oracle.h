#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "unstep/grid.h"

/// Brute-force Frechet decisions for tests, by the free-space diagram of Alt
/// and Godau (1995), in long double with a margin.
namespace unstep::testing {

struct Place {
  long double x = 0;
  long double y = 0;
};

using Polyline = std::vector<Place>;

/// The part of [0, 1] along a line that is within a distance of a point.
struct Reach {
  long double low = 2;
  long double high = -1;
  [[nodiscard]] bool empty() const { return low > high; }
};

inline Reach within(const Place& from, const Place& to, const Place& of,
                    long double e) {
  const long double dx = to.x - from.x;
  const long double dy = to.y - from.y;
  const long double px = of.x - from.x;
  const long double py = of.y - from.y;
  const long double length2 = dx * dx + dy * dy;
  if (length2 == 0) {
    return px * px + py * py <= e * e ? Reach{0, 1} : Reach{};
  }
  const long double along = (px * dx + py * dy) / length2;
  const long double off = px * dy - py * dx;
  const long double rest = e * e - off * off / length2;
  if (rest < 0) return {};
  const long double half = std::sqrt(rest / length2);
  const Reach reach{std::max(0.0L, along - half), std::min(1.0L, along + half)};
  return reach;
}

/// From a reachable part of one side of a cell to the opposite side: all of
/// the free part that is not before it.
inline Reach not_before(const Reach& free, const Reach& reached) {
  if (reached.empty() || free.empty()) return {};
  return {std::max(free.low, reached.low), free.high};
}

/// True if the Frechet distance of two polylines is at most `e` (up to 1e-9).
/// Both have a point at least.
inline bool frechet_within(Polyline chain, Polyline path, long double e) {
  e += 1e-9L;
  if (chain.size() == 1) chain.push_back(chain.front());
  if (path.size() == 1) path.push_back(path.front());
  const std::size_t edges = chain.size() - 1;
  // `left[i]`: the places of chain edge i that are reachable together with
  // the path's vertex j.
  struct Entry {
    std::size_t edge;
    Reach reach;
  };
  std::vector<Entry> left;
  for (std::size_t i = 0; i < edges; ++i) {
    const Reach free = within(chain[i], chain[i + 1], path.front(), e);
    if (free.empty() || free.low > 0) break;
    left.push_back({i, free});
    if (free.high < 1) break;
  }
  for (std::size_t j = 0; j + 1 < path.size(); ++j) {
    std::vector<Entry> right;
    std::size_t next = 0;
    Reach bottom;
    if (j == 0 && !left.empty()) {
      bottom = within(path[0], path[1], chain.front(), e);
      if (bottom.low > 0) bottom = {};
    } else if (!left.empty() && left.front().edge == 0 &&
               left.front().reach.low == 0) {
      bottom = within(path[j], path[j + 1], chain.front(), e);
      if (bottom.low > 0) bottom = {};
    }
    std::size_t i = left.empty() ? edges : left.front().edge;
    while (i < edges) {
      Reach side;
      if (next < left.size() && left[next].edge == i) {
        side = left[next++].reach;
      }
      const Reach free_right = within(chain[i], chain[i + 1], path[j + 1], e);
      const Reach free_top = within(path[j], path[j + 1], chain[i + 1], e);
      const Reach to_right =
          bottom.empty() ? not_before(free_right, side) : free_right;
      const Reach to_top =
          side.empty() ? not_before(free_top, bottom) : free_top;
      if (!to_right.empty()) right.push_back({i, to_right});
      bottom = to_top;
      if (!bottom.empty()) {
        ++i;
      } else {
        i = next < left.size() ? left[next].edge : edges;
      }
    }
    left = std::move(right);
    if (left.empty()) return false;
  }
  return left.back().edge == edges - 1 && left.back().reach.high >= 1;
}

/// A chain's points in grid units, y as the axis says.
inline Polyline polyline_of(const Chain& chain, YAxis axis) {
  Polyline result{{static_cast<long double>(chain.origin.x),
                   static_cast<long double>(chain.origin.y)}};
  for (const Step step : chain.steps) {
    const Point move = step_delta(step, axis);
    result.push_back({result.back().x + move.x, result.back().y + move.y});
  }
  return result;
}

/// A path's vertices in grid units. Lines only.
inline Polyline polyline_of(const Path& path, std::int32_t scale) {
  std::int64_t x = path.origin.x;
  std::int64_t y = path.origin.y;
  Polyline result;
  const auto add = [&] {
    result.push_back({static_cast<long double>(x) / scale,
                      static_cast<long double>(y) / scale});
  };
  add();
  for (const Path::Element& element : path.elements) {
    x += element.segment.dx;
    y += element.segment.dy;
    add();
  }
  return result;
}

/// True if `path` keeps within `e` of `chain`; a closed path may start beside
/// any point of its chain.
inline bool path_within(const Chain& chain, YAxis axis, const Path& path,
                        std::int32_t scale, long double e) {
  Polyline points = polyline_of(chain, axis);
  const Polyline lines = polyline_of(path, scale);
  if (!chain.closed || points.size() < 2) {
    return frechet_within(points, lines, e);
  }
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (k > 0) {
      points.erase(points.begin());
      points.push_back(points.front());
    }
    const long double dx = points.front().x - lines.front().x;
    const long double dy = points.front().y - lines.front().y;
    if (dx * dx + dy * dy > e * e + 1e-9L) continue;
    if (frechet_within(points, lines, e)) return true;
  }
  return false;
}

}  // namespace unstep::testing
