#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "reverse/arcs.h"

namespace unstep::reverse {
namespace {

/// In path units: what is nearer counts as a meeting, and a meeting this near
/// to a common joint as the joint.
constexpr double kNear = 1.0 / 1024;
constexpr double kFullTurn = 2 * std::numbers::pi;

struct RealVector {
  double x = 0;
  double y = 0;
};

/// Coordinates are below 2^31: no square overflows.
double distance(RealVector a, RealVector b) {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// A part of a path as a curve.
struct Curve {
  std::uint32_t path = 0;
  std::uint32_t part = 0;
  bool is_arc = false;
  RealVector from;
  RealVector to;
  RealVector centre = {};
  double radius = 0;
  double first = 0;  ///< angle at `from`
  double turn = 0;   ///< > 0 counter-clockwise by the numbers
};

RealVector vector_of(Point p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

void set_arc(Curve& curve, const Arc& arc) {
  curve.is_arc = true;
  RealVector centre = vector_of(arc.centre);
  const RealVector end = vector_of(arc.end);
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

RealVector place_on(const Curve& curve, double t) {
  if (!curve.is_arc)
    return {curve.from.x + t * (curve.to.x - curve.from.x),
            curve.from.y + t * (curve.to.y - curve.from.y)};
  const double angle = curve.first + t * curve.turn;
  return {curve.centre.x + curve.radius * std::cos(angle),
          curve.centre.y + curve.radius * std::sin(angle)};
}

/// A place of the curve's line or circle belongs to the curve itself.
bool holds(const Curve& curve, RealVector p) {
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
  std::array<RealVector, 2> at;
  bool any = false;
  bool everywhere = false;  ///< the same circle
};

/// Where the circle meets a line through `p` along the unit vector `d`. A line
/// that passes by closely touches.
Meetings meet_line(const Curve& arc, RealVector p, RealVector d) {
  const double along = (arc.centre.x - p.x) * d.x + (arc.centre.y - p.y) * d.y;
  const RealVector foot{p.x + along * d.x, p.y + along * d.y};
  const double off = distance(foot, arc.centre);
  if (off > arc.radius + kNear) return {};
  const double half =
      std::sqrt(std::max(0.0, arc.radius * arc.radius - off * off));
  return {{RealVector{foot.x - half * d.x, foot.y - half * d.y},
           RealVector{foot.x + half * d.x, foot.y + half * d.y}},
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
  const RealVector d{(other.centre.x - arc.centre.x) / apart,
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

/// Rows of cells: both ends belong to it.
struct Band {
  std::int64_t first = 0;
  std::int64_t last = 0;
  [[nodiscard]] bool meets(const Band& other) const {
    return first <= other.last && other.first <= last;
  }
};

/// A large drawing is searched band by band, so that only the curves of one
/// are in memory.
class ArcCrossings {
 public:
  ArcCrossings(std::span<ArcPath> paths, const std::vector<bool>& closed,
               std::int32_t scale, std::int64_t band_parts)
      : paths_(paths),
        closed_(closed),
        cell_(16.0 * scale),
        band_parts_(band_parts) {
    rows_.reserve(paths.size());
    for (const ArcPath& path : paths) {
      rows_.push_back(rows_of(path, 0, path.vertices.size() - 1));
      all_.first = std::min(all_.first, rows_.back().first);
      all_.last = std::max(all_.last, rows_.back().last);
    }
  }

  std::uint64_t run() {
    std::vector<bool> changed(paths_.size());
    while (number_parts()) {
      const auto parts = static_cast<std::int64_t>(offsets_.back());
      const std::int64_t bands = parts / band_parts_ + 1;
      const std::int64_t height = (all_.last - all_.first) / bands + 1;
      wrong_.assign(offsets_.back(), false);
      for (std::int64_t row = all_.first; row <= all_.last; row += height) {
        const Band band{row, row + height - 1};
        collect(band);
        search(band);
      }
      if (std::find(wrong_.begin(), wrong_.end(), true) == wrong_.end()) break;
      remove(changed);
    }
    return static_cast<std::uint64_t>(
        std::count(changed.begin(), changed.end(), true));
  }

 private:
  [[nodiscard]] std::int64_t cell_of(double v) const {
    return static_cast<std::int64_t>(std::floor(v / cell_));
  }

  /// An arc is near the lines that it stands for: within a cell.
  [[nodiscard]] Band rows_of(const ArcPath& path, std::size_t a,
                             std::size_t b) const {
    std::int32_t low = path.vertices[a].at.y;
    std::int32_t high = low;
    for (std::size_t i = a + 1; i <= b; ++i) {
      low = std::min(low, path.vertices[i].at.y);
      high = std::max(high, path.vertices[i].at.y);
    }
    return {cell_of(low) - 1, cell_of(high) + 1};
  }

  /// False if there are no arcs.
  bool number_parts() {
    offsets_.assign(1, 0);
    bool arcs = false;
    for (const ArcPath& path : paths_) {
      arcs = arcs || path.ring || !path.arcs.empty();
      offsets_.push_back(offsets_.back() +
                         (path.ring ? path.ring->arcs.size() : path.parts()));
    }
    return arcs;
  }
  [[nodiscard]] std::size_t number_of(const Curve& curve) const {
    return offsets_[curve.path] + curve.part;
  }

  void collect(const Band& band) {
    curves_.clear();
    for (std::uint32_t i = 0; i < paths_.size(); ++i) {
      const ArcPath& path = paths_[i];
      if (!band.meets(rows_[i])) continue;
      if (path.ring) {
        collect_ring(i, *path.ring);
        continue;
      }
      std::uint32_t part = 0;
      for_parts(path, [&](std::size_t a, std::size_t b, const Arc* arc) {
        const std::uint32_t k = part++;
        if (!band.meets(rows_of(path, a, b))) return;
        Curve curve{i, k, false, vector_of(path.vertices[a].at),
                    vector_of(path.vertices[b].at)};
        if (arc != nullptr) set_arc(curve, *arc);
        curves_.push_back(curve);
      });
    }
  }

  void collect_ring(std::uint32_t path, const RingArcs& ring) {
    RealVector at = vector_of(ring.start);
    for (std::uint32_t k = 0; k < ring.arcs.size(); ++k) {
      const RealVector end = vector_of(ring.arcs[k].end);
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

  void add(std::uint32_t index, const Band& band) {
    const Curve& curve = curves_[index];
    const double length = curve.is_arc
                              ? curve.radius * std::abs(curve.turn)
                              : std::max(std::abs(curve.to.x - curve.from.x),
                                         std::abs(curve.to.y - curve.from.y));
    const auto pieces = static_cast<std::size_t>(std::ceil(length / cell_)) + 1;
    RealVector a = curve.from;
    for (std::size_t i = 1; i <= pieces; ++i) {
      const RealVector b =
          place_on(curve, static_cast<double>(i) / static_cast<double>(pieces));
      // A piece bulges from its chord by at most an eighth of its length
      // squared over the radius, and that is at most the length.
      const double bulge =
          curve.is_arc ? std::min(cell_, cell_ * cell_ / (8 * curve.radius))
                       : 0;
      const double margin = bulge + 2 * kNear;
      const std::int64_t left = cell_of(std::min(a.x, b.x) - margin);
      const std::int64_t right = cell_of(std::max(a.x, b.x) + margin);
      const std::int64_t top =
          std::max(cell_of(std::min(a.y, b.y) - margin), band.first);
      const std::int64_t bottom =
          std::min(cell_of(std::max(a.y, b.y) + margin), band.last);
      for (std::int64_t c = left; c <= right; ++c)
        for (std::int64_t r = top; r <= bottom; ++r)
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

  void search(const Band& band) {
    entries_.clear();
    marks_.assign(std::bit_ceil(8 * curves_.size() + 1024), false);
    for (const bool arcs : {true, false})
      for (std::uint32_t i = 0; i < curves_.size(); ++i)
        if (curves_[i].is_arc == arcs) add(i, band);
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
          compare(curves_[entries_[i].curve], curves_[entries_[k].curve]);
        }
      }
      first = end;
    }
  }

  void compare(const Curve& a, const Curve& b) {
    if (!a.is_arc && !b.is_arc) return;
    // Arcs of one ring follow one another round nearly the same centre.
    if (a.path == b.path && paths_[a.path].ring) return;
    if (wrong_[number_of(a)] || wrong_[number_of(b)]) return;
    if (!cross(a.is_arc ? a : b, a.is_arc ? b : a)) return;
    // The longer arc goes.
    const auto size = [](const Curve& curve) {
      return curve.is_arc ? curve.radius * std::abs(curve.turn) : -1;
    };
    wrong_[number_of(size(a) >= size(b) ? a : b)] = true;
  }

  [[nodiscard]] bool cross(const Curve& arc, const Curve& other) const {
    if (!other.is_arc && beside(arc, other)) return false;
    const Meetings found = meetings(arc, other);
    if (!found.any) return false;
    if (found.everywhere)
      return !is_joint(arc, other, arc.from) && !is_joint(arc, other, arc.to);
    for (const RealVector& at : found.at) {
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
  [[nodiscard]] bool is_joint(const Curve& a, const Curve& b,
                              RealVector at) const {
    if (a.path != b.path) return false;
    const std::size_t count = offsets_[a.path + 1] - offsets_[a.path];
    const auto follows = [&](const Curve& p, const Curve& q) {
      const bool next = q.part == p.part + 1 ||
                        (closed_[a.path] && q.part == 0 && p.part + 1 == count);
      return next && distance(p.to, at) <= 2 * kNear;
    };
    return follows(a, b) || follows(b, a);
  }

  void remove(std::vector<bool>& changed) {
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      ArcPath& path = paths_[i];
      const std::size_t first = offsets_[i];
      const auto at = [this](std::size_t number) {
        return wrong_.begin() + static_cast<std::ptrdiff_t>(number);
      };
      const auto end = at(offsets_[i + 1]);
      if (std::find(at(first), end, true) == end) continue;
      changed[i] = true;
      if (path.ring) {
        path.ring.reset();
        continue;
      }
      std::size_t number = first;
      std::vector<PathArc> kept;
      for_parts(path, [&](std::size_t a, std::size_t b, const Arc* arc) {
        if (!wrong_[number++] && arc != nullptr) kept.push_back({a, b, *arc});
      });
      path.arcs = std::move(kept);
    }
  }

  std::span<ArcPath> paths_;
  const std::vector<bool>& closed_;
  double cell_;
  std::int64_t band_parts_;
  std::vector<Band> rows_;  ///< of each path
  Band all_{std::numeric_limits<std::int64_t>::max(),
            std::numeric_limits<std::int64_t>::min()};
  std::vector<std::size_t> offsets_;  ///< the number of each path's first part
  std::vector<bool> wrong_;           ///< by number
  std::vector<Curve> curves_;
  std::vector<Entry> entries_;
  std::vector<bool> marks_;  ///< cells that arcs reach
};

}  // namespace

std::uint64_t remove_crossing_arcs(std::span<ArcPath> paths,
                                   const std::vector<bool>& closed,
                                   std::int32_t scale,
                                   std::int64_t band_parts) {
  return ArcCrossings(paths, closed, scale, band_parts).run();
}

}  // namespace unstep::reverse
