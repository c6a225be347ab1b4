#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "unstep/program.h"

/// An independent check of compaction: the continuous Frechet distance between
/// two polylines by the free-space diagram (Alt and Godau 1995), arcs as dense
/// polylines. Shares no code with the library.
namespace unstep::oracle {

using Point3 = std::array<double, 3>;  ///< mm
using Path3 = std::vector<Point3>;

struct Interval {
  double low = 1;
  double high = 0;
  [[nodiscard]] bool empty() const { return low > high; }
};

/// Which part of the segment a-b is within e of p, as parameters 0..1.
inline Interval near_part(const Point3& p, const Point3& a, const Point3& b,
                          double e) {
  double dd = 0;
  double dp = 0;
  double pp = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    dd += (b[k] - a[k]) * (b[k] - a[k]);
    dp += (b[k] - a[k]) * (p[k] - a[k]);
    pp += (p[k] - a[k]) * (p[k] - a[k]);
  }
  if (dd == 0) return pp <= e * e ? Interval{0, 1} : Interval{};
  const double middle = dp / dd;
  double away = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = p[k] - a[k] - middle * (b[k] - a[k]);
    away += d * d;
  }
  if (away > e * e) return {};
  const double half = std::sqrt((e * e - away) / dd);
  const Interval found{std::max(0.0, middle - half),
                       std::min(1.0, middle + half)};
  return found;
}

inline double apart(const Point3& a, const Point3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// True if the Frechet distance of the two polylines is at most e. Only cells
/// that can be reached are looked at.
inline bool frechet_within(const Path3& p, const Path3& q, double e) {
  if (p.empty() || q.empty()) return p.empty() == q.empty();
  if (apart(p.front(), q.front()) > e || apart(p.back(), q.back()) > e) {
    return false;
  }
  if (p.size() == 1 || q.size() == 1) {
    const Path3& line = p.size() == 1 ? q : p;
    const Point3& point = p.size() == 1 ? p[0] : q[0];
    return std::all_of(line.begin(), line.end(),
                       [&](const Point3& v) { return apart(v, point) <= e; });
  }
  const std::size_t n = p.size() - 1;
  const std::size_t m = q.size() - 1;
  // left[j]: reachable part of edge j of q at vertex i of p.
  std::vector<Interval> left(m);
  for (std::size_t j = 0; j < m; ++j) {
    const Interval part = near_part(p[0], q[j], q[j + 1], e);
    if (part.empty() || part.low > 0) break;
    left[j] = part;
    if (part.high < 1) break;
  }
  Interval floor_start{0, 0};  // of edge i of p at vertex 0 of q
  bool floor_open = true;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Interval> right(m);
    Interval bottom;
    if (floor_open) {
      floor_start = near_part(q[0], p[i], p[i + 1], e);
      if (floor_start.empty() || floor_start.low > 0) {
        floor_open = false;
      } else {
        bottom = floor_start;
        floor_open = floor_start.high >= 1;
      }
    }
    for (std::size_t j = 0; j < m; ++j) {
      if (left[j].empty() && bottom.empty()) continue;
      // Free space of a cell is convex: from the bottom everything free on
      // the right is reachable, from the left what is not lower.
      Interval on_right = near_part(p[i + 1], q[j], q[j + 1], e);
      Interval on_top = near_part(q[j + 1], p[i], p[i + 1], e);
      if (bottom.empty()) on_right.low = std::max(on_right.low, left[j].low);
      if (left[j].empty()) on_top.low = std::max(on_top.low, bottom.low);
      right[j] = on_right;
      bottom = on_top;
    }
    left = std::move(right);
  }
  return !left[m - 1].empty() && left[m - 1].high >= 1;
}

/// The path of motions between two items that no merging may cross.
struct Section {
  std::string anchor;  ///< the item before it
  Path3 path;
};

inline Point3 to_mm(const ProgramPosition& position) {
  Point3 point{};
  for (std::size_t k = 0; k < 3; ++k) {
    point[k] = static_cast<double>(position[k]) / 1e7;
  }
  return point;
}

/// Radius and height change evenly with the angle. `fine` is the greatest
/// sagitta.
inline void sample_arc(Path3& path, const ProgramMove& move, double fine) {
  const auto axes = plane_axes(move.plane);
  const Point3 start = to_mm(move.start);
  const Point3 end = to_mm(move.end);
  const double cx = static_cast<double>(move.centre[0]) / 1e7;
  const double cy = static_cast<double>(move.centre[1]) / 1e7;
  const double sx = start[axes[0]] - cx;
  const double sy = start[axes[1]] - cy;
  const double ex = end[axes[0]] - cx;
  const double ey = end[axes[1]] - cy;
  const double r0 = std::hypot(sx, sy);
  const double r1 = std::hypot(ex, ey);
  const double sign = move.kind == ProgramItem::Kind::counter ? 1 : -1;
  double sweep = std::atan2((sx * ey - sy * ex) * sign, sx * ex + sy * ey);
  if (sweep <= 1e-12) sweep += 2 * std::numbers::pi;
  sweep += 2 * std::numbers::pi * (move.turns - 1);
  const double step =
      2 * std::acos(std::max(0.0, 1 - fine / std::max(r0, fine)));
  const auto count = static_cast<std::size_t>(std::ceil(sweep / step)) + 1;
  const double from = std::atan2(sy, sx);
  for (std::size_t i = 1; i <= count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    const double angle = from + sign * sweep * t;
    const double r = r0 + (r1 - r0) * t;
    Point3 point{};
    point[axes[0]] = cx + r * std::cos(angle);
    point[axes[1]] = cy + r * std::sin(angle);
    point[axes[2]] = start[axes[2]] + (end[axes[2]] - start[axes[2]]) * t;
    path.push_back(i == count ? end : point);
  }
}

/// Text, rapids and kept motions are anchors; empty text is not.
inline std::vector<Section> sections(const Program& program, double fine) {
  using Kind = ProgramItem::Kind;
  std::vector<Section> found(1);
  ProgramPosition at = program.position(program.start);
  found[0].path.push_back(to_mm(at));
  for (const ProgramItem& item : program.items) {
    const ProgramPosition end = program.position(item);
    const bool anchor =
        !item.is_motion() || item.keep_text || item.kind == Kind::rapid;
    if (anchor) {
      Section next;
      next.anchor = item.kind == Kind::rapid && !item.keep_text
                        ? std::string("rapid")
                        : std::string(program.text_of(item));
      next.path.push_back(to_mm(end));
      found.push_back(next);
    } else if (item.is_arc()) {
      ProgramMove move;
      move.kind = item.kind;
      move.plane = program.modes[item.modes].plane.value_or(ProgramPlane::xy);
      move.turns = item.turns;
      move.start = at;
      move.end = end;
      move.centre = item.centre;
      sample_arc(found.back().path, move, fine);
    } else {
      found.back().path.push_back(to_mm(end));
    }
    at = end;
  }
  return found;
}

/// What is wrong with `after` as a shorter form of `before`, or nothing.
inline std::string compare(const Program& before, const Program& after,
                           double tolerance) {
  const double fine = tolerance / 2000;
  const std::vector<Section> a = sections(before, fine);
  const std::vector<Section> b = sections(after, fine);
  if (a.size() != b.size()) return "another number of rapids and texts";
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].anchor != b[i].anchor) return "text changed: " + a[i].anchor;
    if (!frechet_within(a[i].path, b[i].path, tolerance + fine)) {
      return "section " + std::to_string(i) + " after \"" + a[i].anchor +
             "\" is farther away than the tolerance";
    }
  }
  return {};
}

}  // namespace unstep::oracle
