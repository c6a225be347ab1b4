#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "reverse/arcs.h"

namespace unstep::reverse {
namespace {

/// In path units: what is nearer counts as a meeting, and a meeting this near
/// to a common joint as the joint.
constexpr double kNear = 1.0 / 1024;
constexpr double kFullTurn = 2 * std::numbers::pi;

struct Vector {
  double x = 0;
  double y = 0;
};

double distance(Vector a, Vector b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// A part of a path as a curve.
struct Curve {
  std::uint32_t path = 0;
  std::uint32_t part = 0;
  bool is_arc = false;
  Vector from;
  Vector to;
  Vector centre = {};
  double radius = 0;
  double first = 0;  ///< angle at `from`
  double turn = 0;   ///< > 0 counter-clockwise by the numbers
};

Vector vector_of(Point p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

void set_arc(Curve& curve, const Arc& arc) {
  curve.is_arc = true;
  Vector centre = vector_of(arc.centre);
  const Vector end = vector_of(arc.end);
  if (arc.end != Point{}) {
    const double k =
        (centre.y * end.x - centre.x * end.y) / (end.x * end.x + end.y * end.y);
    centre = {end.x / 2 - end.y * k, end.y / 2 + end.x * k};
  }
  curve.centre = {curve.from.x + centre.x, curve.from.y + centre.y};
  curve.radius = std::hypot(centre.x, centre.y);
  curve.first = std::atan2(-centre.y, -centre.x);
  curve.turn = kFullTurn;
  if (arc.end != Point{}) {
    const double last = std::atan2(end.y - centre.y, end.x - centre.x);
    curve.turn = arc.clockwise ? curve.first - last : last - curve.first;
    while (curve.turn <= 0) curve.turn += kFullTurn;
  }
  if (arc.clockwise) curve.turn = -curve.turn;
}

Vector place_on(const Curve& curve, double t) {
  if (!curve.is_arc)
    return {curve.from.x + t * (curve.to.x - curve.from.x),
            curve.from.y + t * (curve.to.y - curve.from.y)};
  const double angle = curve.first + t * curve.turn;
  return {curve.centre.x + curve.radius * std::cos(angle),
          curve.centre.y + curve.radius * std::sin(angle)};
}

/// A place of the curve's line or circle belongs to the curve itself.
bool holds(const Curve& curve, Vector p) {
  if (distance(p, curve.from) <= kNear || distance(p, curve.to) <= kNear)
    return true;
  if (!curve.is_arc) {
    const double dx = curve.to.x - curve.from.x;
    const double dy = curve.to.y - curve.from.y;
    const double t = (p.x - curve.from.x) * dx + (p.y - curve.from.y) * dy;
    return t >= 0 && t <= dx * dx + dy * dy;
  }
  double angle =
      std::atan2(p.y - curve.centre.y, p.x - curve.centre.x) - curve.first;
  if (curve.turn < 0) angle = -angle;
  while (angle < 0) angle += kFullTurn;
  while (angle >= kFullTurn) angle -= kFullTurn;
  return angle <= std::abs(curve.turn);
}

struct Meetings {
  std::array<Vector, 2> at;
  bool any = false;
  bool everywhere = false;  ///< the same circle
};

/// Where the circle meets a line through `p` along the unit vector `d`. A line
/// that passes by closely touches.
Meetings meet_line(const Curve& arc, Vector p, Vector d) {
  const double along = (arc.centre.x - p.x) * d.x + (arc.centre.y - p.y) * d.y;
  const Vector foot{p.x + along * d.x, p.y + along * d.y};
  const double off = distance(foot, arc.centre);
  if (off > arc.radius + kNear) return {};
  const double half =
      std::sqrt(std::max(0.0, arc.radius * arc.radius - off * off));
  return {{Vector{foot.x - half * d.x, foot.y - half * d.y},
           Vector{foot.x + half * d.x, foot.y + half * d.y}},
          true,
          false};
}

Meetings meetings(const Curve& arc, const Curve& other) {
  if (!other.is_arc) {
    const double length = distance(other.from, other.to);
    if (length == 0) return {};
    return meet_line(arc, other.from,
                     {(other.to.x - other.from.x) / length,
                      (other.to.y - other.from.y) / length});
  }
  const double apart = distance(arc.centre, other.centre);
  if (apart > arc.radius + other.radius + kNear ||
      apart < std::abs(arc.radius - other.radius) - kNear)
    return {};
  if (apart < kNear) return {{}, true, true};
  // The line through both places where the circles meet.
  const Vector d{(other.centre.x - arc.centre.x) / apart,
                 (other.centre.y - arc.centre.y) / apart};
  const double along = (apart + (arc.radius - other.radius) *
                                    (arc.radius + other.radius) / apart) /
                       2;
  const double reach = std::clamp(along, -arc.radius, arc.radius);
  return meet_line(arc,
                   {arc.centre.x + reach * d.x, arc.centre.y + reach * d.y},
                   {-d.y, d.x});
}

/// Pieces of curves in square cells.
struct Entry {
  std::uint64_t cell = 0;
  std::uint32_t curve = 0;
};

class ArcCrossings {
 public:
  ArcCrossings(std::span<ArcPath> paths, const std::vector<bool>& closed,
               std::int32_t scale)
      : paths_(paths), closed_(closed), cell_(16.0 * scale) {}

  std::uint64_t run() {
    std::vector<bool> changed(paths_.size());
    while (collect()) {
      std::vector<bool> wrong(curves_.size());
      search(wrong);
      if (std::find(wrong.begin(), wrong.end(), true) == wrong.end()) break;
      remove(wrong, changed);
    }
    return static_cast<std::uint64_t>(
        std::count(changed.begin(), changed.end(), true));
  }

 private:
  /// False if there are no arcs.
  bool collect() {
    curves_.clear();
    counts_.assign(paths_.size(), 1);
    bool arcs = false;
    for (std::uint32_t i = 0; i < paths_.size(); ++i) {
      const ArcPath& path = paths_[i];
      if (path.ring) {
        collect_ring(i, *path.ring);
        arcs = true;
        continue;
      }
      counts_[i] = static_cast<std::uint32_t>(path.parts.size());
      std::size_t start = 0;
      for (std::uint32_t k = 0; k < path.parts.size(); ++k) {
        const PathPart& part = path.parts[k];
        Curve curve{i, k, false, vector_of(path.vertices[start].at),
                    vector_of(path.vertices[part.end].at)};
        if (part.is_arc) set_arc(curve, part.arc);
        arcs = arcs || part.is_arc;
        curves_.push_back(curve);
        start = part.end;
      }
    }
    return arcs;
  }

  void collect_ring(std::uint32_t path, const RingArcs& ring) {
    counts_[path] = static_cast<std::uint32_t>(ring.arcs.size());
    Vector at = vector_of(ring.start);
    for (std::uint32_t k = 0; k < ring.arcs.size(); ++k) {
      const Vector end = vector_of(ring.arcs[k].end);
      Curve curve{path, k, true, at, {at.x + end.x, at.y + end.y}};
      set_arc(curve, ring.arcs[k]);
      curves_.push_back(curve);
      at = curve.to;
    }
  }

  [[nodiscard]] std::uint64_t key(std::int64_t column, std::int64_t row) const {
    return static_cast<std::uint64_t>(column) << 32 |
           static_cast<std::uint32_t>(row);
  }

  void add(std::uint32_t index) {
    const Curve& curve = curves_[index];
    const double length = curve.is_arc
                              ? curve.radius * std::abs(curve.turn)
                              : std::max(std::abs(curve.to.x - curve.from.x),
                                         std::abs(curve.to.y - curve.from.y));
    const auto pieces = static_cast<std::size_t>(std::ceil(length / cell_)) + 1;
    Vector a = curve.from;
    for (std::size_t i = 1; i <= pieces; ++i) {
      const Vector b =
          place_on(curve, static_cast<double>(i) / static_cast<double>(pieces));
      // A piece bulges from its chord by at most an eighth of its length
      // squared over the radius, and that is at most the length.
      const double bulge =
          curve.is_arc ? std::min(cell_, cell_ * cell_ / (8 * curve.radius))
                       : 0;
      const double margin = bulge + 2 * kNear;
      const auto cell = [this](double v) {
        return static_cast<std::int64_t>(std::floor(v / cell_));
      };
      for (std::int64_t c = cell(std::min(a.x, b.x) - margin);
           c <= cell(std::max(a.x, b.x) + margin); ++c)
        for (std::int64_t r = cell(std::min(a.y, b.y) - margin);
             r <= cell(std::max(a.y, b.y) + margin); ++r)
          enter(key(c, r), curve.is_arc, index);
      a = b;
    }
  }

  /// Lines are of interest only in the cells of arcs; a few others get in, for
  /// the marks are by a hash.
  void enter(std::uint64_t cell, bool is_arc, std::uint32_t index) {
    const std::size_t mark =
        (cell * 0x9E3779B97F4A7C15U >> 32) & (marks_.size() - 1);
    if (is_arc) marks_[mark] = true;
    if (marks_[mark]) entries_.push_back({cell, index});
  }

  void search(std::vector<bool>& wrong) {
    entries_.clear();
    marks_.assign(std::bit_ceil(8 * curves_.size() + 1024), false);
    for (const bool arcs : {true, false})
      for (std::uint32_t i = 0; i < curves_.size(); ++i)
        if (curves_[i].is_arc == arcs) add(i);
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) {
                return a.cell != b.cell ? a.cell < b.cell : a.curve < b.curve;
              });
    for (std::size_t first = 0; first < entries_.size();) {
      std::size_t end = first + 1;
      while (end < entries_.size() &&
             entries_[end].cell == entries_[first].cell)
        ++end;
      for (std::size_t i = first; i < end; ++i) {
        if (i > first && entries_[i].curve == entries_[i - 1].curve) continue;
        for (std::size_t k = i + 1; k < end; ++k) {
          if (entries_[k].curve == entries_[k - 1].curve) continue;
          compare(entries_[i].curve, entries_[k].curve, wrong);
        }
      }
      first = end;
    }
  }

  void compare(std::uint32_t i, std::uint32_t k, std::vector<bool>& wrong) {
    const Curve& a = curves_[i];
    const Curve& b = curves_[k];
    if (!a.is_arc && !b.is_arc) return;
    // Arcs of one ring follow one another round nearly the same centre.
    if (a.path == b.path && paths_[a.path].ring) return;
    if (wrong[i] || wrong[k]) return;
    if (!cross(a.is_arc ? a : b, a.is_arc ? b : a)) return;
    // The longer arc goes.
    const auto size = [](const Curve& curve) {
      return curve.is_arc ? curve.radius * std::abs(curve.turn) : -1;
    };
    wrong[size(a) >= size(b) ? i : k] = true;
  }

  [[nodiscard]] bool cross(const Curve& arc, const Curve& other) const {
    if (!other.is_arc && beside(arc, other)) return false;
    const Meetings found = meetings(arc, other);
    if (!found.any) return false;
    if (found.everywhere)
      return !is_joint(arc, other, arc.from) && !is_joint(arc, other, arc.to);
    for (const Vector& at : found.at) {
      if (!holds(arc, at) || !holds(other, at)) continue;
      if (!is_joint(arc, other, at)) return true;
    }
    return false;
  }

  /// A line outside of the square about the arc's circle.
  static bool beside(const Curve& arc, const Curve& line) {
    const double reach = arc.radius + kNear;
    return std::max(line.from.x, line.to.x) < arc.centre.x - reach ||
           std::min(line.from.x, line.to.x) > arc.centre.x + reach ||
           std::max(line.from.y, line.to.y) < arc.centre.y - reach ||
           std::min(line.from.y, line.to.y) > arc.centre.y + reach;
  }

  /// The place is where one of the two goes over into the other.
  [[nodiscard]] bool is_joint(const Curve& a, const Curve& b, Vector at) const {
    if (a.path != b.path) return false;
    const std::uint32_t count = counts_[a.path];
    const auto follows = [&](const Curve& p, const Curve& q) {
      const bool next = q.part == p.part + 1 ||
                        (closed_[a.path] && q.part == 0 && p.part + 1 == count);
      return next && distance(p.to, at) <= 2 * kNear;
    };
    return follows(a, b) || follows(b, a);
  }

  void remove(const std::vector<bool>& wrong, std::vector<bool>& changed) {
    std::size_t index = 0;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      const std::size_t first = index;
      index += counts_[i];
      const auto at = [&](std::size_t k) {
        return wrong.begin() + static_cast<std::ptrdiff_t>(k);
      };
      if (std::find(at(first), at(index), true) == at(index)) continue;
      changed[i] = true;
      if (paths_[i].ring)
        paths_[i].ring.reset();
      else
        remove_from(paths_[i], at(first));
    }
  }

  static void remove_from(ArcPath& path,
                          std::vector<bool>::const_iterator wrong) {
    PathParts parts;
    std::size_t start = 0;
    for (const PathPart& part : path.parts) {
      if (*wrong++) {
        for (std::size_t v = start + 1; v <= part.end; ++v)
          parts.push_back({v, false, {}});
      } else {
        parts.push_back(part);
      }
      start = part.end;
    }
    path.parts = std::move(parts);
  }

  std::span<ArcPath> paths_;
  const std::vector<bool>& closed_;
  double cell_;
  std::vector<Curve> curves_;
  std::vector<std::uint32_t> counts_;
  std::vector<Entry> entries_;
  std::vector<bool> marks_;  ///< cells that arcs reach
};

}  // namespace

std::uint64_t remove_crossing_arcs(std::span<ArcPath> paths,
                                   const std::vector<bool>& closed,
                                   std::int32_t scale) {
  return ArcCrossings(paths, closed, scale).run();
}

}  // namespace unstep::reverse
