#include "reverse/crossing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "reverse/crossing_grid.h"

namespace unstep::reverse {
namespace {

/// Twice the signed area of the triangle: > 0 if c is left of a -> b.
std::int64_t orientation(Point a, Point b, Point c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

/// Sign of the same; the product of signs never overflows.
int side(Point a, Point b, Point c) {
  const std::int64_t o = orientation(a, b, c);
  return (o > 0) - (o < 0);
}

bool same_direction(Point at, Point a, Point b) {
  return side(at, a, b) == 0 &&
         (std::int64_t{a.x} - at.x) * (std::int64_t{b.x} - at.x) +
                 (std::int64_t{a.y} - at.y) * (std::int64_t{b.y} - at.y) >
             0;
}

/// True if `c` is inside the turn counter-clockwise from `from` to `to`, all
/// seen from `at`. REQUIRES: no two in the same direction.
bool in_sector(Point at, Point from, Point to, Point c) {
  const bool left_of_from = side(at, from, c) > 0;
  const bool right_of_to = side(at, to, c) < 0;
  switch (side(at, from, to)) {
    case 1: return left_of_from && right_of_to;  // less than half a turn
    case 0: return left_of_from;
    default: return left_of_from || right_of_to;
  }
}

bool on_line(const Ends& line, Point at) {
  const auto [low_x, high_x] = std::minmax(line.a.x, line.b.x);
  const auto [low_y, high_y] = std::minmax(line.a.y, line.b.y);
  return side(line.a, line.b, at) == 0 && low_x <= at.x && at.x <= high_x &&
         low_y <= at.y && at.y <= high_y;
}

class CrossingFinder {
 public:
  CrossingFinder(std::span<const LineVertices> paths,
                 const std::vector<bool>& closed)
      : paths_(paths), closed_(closed) {}

  std::vector<CrossingPair> run(std::span<const Box> places,
                                std::int64_t cell_size);

 private:
  [[nodiscard]] Point start(LineId id) const {
    return paths_[id.path][id.line].at;
  }
  [[nodiscard]] Point end(LineId id) const {
    return paths_[id.path][id.line + 1].at;
  }
  [[nodiscard]] std::uint32_t lines(std::uint32_t path) const {
    return static_cast<std::uint32_t>(paths_[path].size() - 1);
  }

  [[nodiscard]] bool consecutive(LineId a, LineId b) const {
    if (a.path != b.path) return false;
    const std::uint32_t apart =
        a.line > b.line ? a.line - b.line : b.line - a.line;
    return apart <= 1 || (closed_[a.path] && apart + 1 == lines(a.path));
  }

  /// The vertex before a line's start or after its end; none at an open end.
  [[nodiscard]] std::optional<Point> beyond(LineId id, bool after) const {
    const LineVertices& path = paths_[id.path];
    if (after) {
      if (id.line + 2 < path.size()) return path[id.line + 2].at;
      if (closed_[id.path]) return path[1].at;
    } else {
      if (id.line > 0) return path[id.line - 1].at;
      if (closed_[id.path]) return path[path.size() - 2].at;
    }
    return std::nullopt;
  }

  struct Passage {
    Point in;
    Point out;
  };
  /// How a path passes through a point of one of its lines.
  [[nodiscard]] std::optional<Passage> passage(LineId id, Point at) const {
    const Point a = start(id);
    const Point b = end(id);
    if (at == a) {
      const std::optional<Point> before = beyond(id, false);
      if (!before) return std::nullopt;
      return Passage{*before, b};
    }
    if (at == b) {
      const std::optional<Point> after = beyond(id, true);
      if (!after) return std::nullopt;
      return Passage{a, *after};
    }
    return Passage{a, b};
  }

  [[nodiscard]] bool meet(LineId first, LineId second) const;
  [[nodiscard]] bool cross_at(LineId p, LineId q, Point at) const;
  void find_lines(std::span<const Box> places);
  void enter(std::int32_t line, std::size_t cell, std::uint32_t sixteenths);
  void search_crowded(std::size_t cell);
  void compare(const Line& p, const Line& q);

  /// A cell's lines are in groups, the first at `group`, all but the latest
  /// full. Groups of few lines side by side are compared without branches.
  struct Cell {
    std::int32_t latest = -1;
    std::int32_t count = 0;
  };
  static constexpr std::size_t kGroup = 8;
  struct Group {
    std::array<std::uint32_t, kGroup> sixteenths{};  ///< 0: no line
    std::array<std::int32_t, kGroup> lines{};
  };

  /// Calls visit for the lines of a cell.
  template <class Visit>
  void for_lines(const Cell& cell, const Visit& visit) const {
    std::int32_t left = cell.count;
    for (std::int32_t g = cell.latest; g >= 0;
         g = before_[static_cast<std::size_t>(g)]) {
      const std::int32_t here = (left - 1) % static_cast<int>(kGroup) + 1;
      for (std::int32_t i = 0; i < here; ++i) {
        visit(groups_[static_cast<std::size_t>(g)]
                  .lines[static_cast<std::size_t>(i)]);
      }
      left -= here;
    }
  }

  /// Of more lines in a cell not all pairs are looked at.
  static constexpr std::int32_t kFew = 16;

  std::span<const LineVertices> paths_;
  const std::vector<bool>& closed_;
  std::vector<Line> lines_;
  std::vector<Cell> cells_;
  std::vector<Group> groups_;
  std::vector<std::int32_t> before_;  ///< the group before, by group
  std::vector<std::size_t> crowded_;
  std::vector<CrossingPair> found_;
};

bool CrossingFinder::cross_at(LineId p, LineId q, Point at) const {
  const std::optional<Passage> a = passage(p, at);
  const std::optional<Passage> b = passage(q, at);
  return a && b && change_sides(at, a->in, a->out, b->in, b->out);
}

bool CrossingFinder::meet(LineId first, LineId second) const {
  const Ends p{start(first), end(first)};
  const Ends q{start(second), end(second)};
  const int pa = side(q.a, q.b, p.a);
  const int pb = side(q.a, q.b, p.b);
  if (pa * pb > 0) return false;
  const int qa = side(p.a, p.b, q.a);
  const int qb = side(p.a, p.b, q.b);
  if (qa * qb > 0) return false;
  if (pa * pb < 0 && qa * qb < 0) return true;
  if (pa == 0 && pb == 0) {
    // On one line: along the axis in which it is longer they overlap by more
    // than a point or not.
    const bool by_x = p.a.x != p.b.x;
    const auto key = [by_x](Point point) { return by_x ? point.x : point.y; };
    const auto [p_low, p_high] = std::minmax({key(p.a), key(p.b)});
    const auto [q_low, q_high] = std::minmax({key(q.a), key(q.b)});
    if (std::max(p_low, q_low) < std::min(p_high, q_high)) return true;
  }
  // They touch in an end of one of them, if at all.
  for (const Point at : {q.a, q.b}) {
    if (on_line(p, at)) return cross_at(first, second, at);
  }
  for (const Point at : {p.a, p.b}) {
    if (on_line(q, at)) return cross_at(first, second, at);
  }
  return false;
}

void CrossingFinder::compare(const Line& p, const Line& q) {
  if (!p.box.meets(q.box) || consecutive(p.id, q.id)) return;
  if (meet(p.id, q.id)) found_.push_back({p.id, q.id});
}

/// Puts a line into a cell, beside those that are there.
void CrossingFinder::enter(std::int32_t line, std::size_t cell,
                           std::uint32_t sixteenths) {
  Cell& c = cells_[cell];
  if (c.count < kFew) {
    for (std::int32_t g = c.latest; g >= 0;
         g = before_[static_cast<std::size_t>(g)]) {
      const Group& group = groups_[static_cast<std::size_t>(g)];
      std::uint32_t hits = 0;
      for (std::size_t i = 0; i < kGroup; ++i) {
        const std::uint32_t common = group.sixteenths[i] & sixteenths;
        const bool hit = static_cast<int>((common & 0xffffU) != 0) &
                         static_cast<int>(common > 0xffffU);
        hits |= std::uint32_t{hit} << i;
      }
      for (; hits != 0; hits &= hits - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(hits));
        compare(lines_[static_cast<std::size_t>(line)],
                lines_[static_cast<std::size_t>(group.lines[i])]);
      }
    }
  } else if (c.count == kFew) {
    crowded_.push_back(cell);
  }
  const std::size_t place = static_cast<std::size_t>(c.count) % kGroup;
  if (place == 0) {
    before_.push_back(c.latest);
    c.latest = static_cast<std::int32_t>(groups_.size());
    groups_.emplace_back();
  }
  Group& latest = groups_[static_cast<std::size_t>(c.latest)];
  latest.sixteenths[place] = sixteenths;
  latest.lines[place] = line;
  ++c.count;
}

/// All lines of a cell from left to right, each with those that reach as far.
void CrossingFinder::search_crowded(std::size_t cell) {
  std::vector<const Line*> lines;
  for_lines(cells_[cell], [&](std::int32_t line) {
    lines.push_back(&lines_[static_cast<std::size_t>(line)]);
  });
  std::sort(lines.begin(), lines.end(), [](const Line* p, const Line* q) {
    return p->box.low_x < q->box.low_x;
  });
  std::vector<const Line*> active;
  for (const Line* line : lines) {
    std::size_t kept = 0;
    for (const Line* other : active) {
      if (other->box.high_x < line->box.low_x) continue;
      active[kept++] = other;
      compare(*line, *other);
    }
    active.resize(kept);
    active.push_back(line);
  }
}

/// Some places, as the cells of a grid that they reach.
class Places {
 public:
  explicit Places(std::span<const Box> places) : box_(places.front()) {
    for (const Box& place : places) box_.add(place);
    all_ = places.size() == 1;
    if (all_) return;
    const auto most = static_cast<std::int64_t>(64 * places.size());
    while (column(box_.high_x) >= most / (row(box_.high_y) + 1)) ++shift_;
    columns_ = column(box_.high_x) + 1;
    marks_.resize(static_cast<std::size_t>(columns_ * (row(box_.high_y) + 1)));
    for (const Box& place : places) {
      for_cells(place, [this](std::size_t cell) {
        marks_[cell] = 1;
        return false;
      });
    }
  }

  /// True if the box reaches one, perhaps if it is near one.
  [[nodiscard]] bool meets(const Box& box) const {
    if (!box_.meets(box)) return false;
    return all_ || for_cells(box, [this](std::size_t cell) {
             return marks_[cell] != 0;
           });
  }

 private:
  [[nodiscard]] std::int64_t column(std::int64_t x) const {
    return (x - box_.low_x) >> shift_;
  }
  [[nodiscard]] std::int64_t row(std::int64_t y) const {
    return (y - box_.low_y) >> shift_;
  }

  /// Until `visit` says true; then true.
  template <class Visit>
  bool for_cells(const Box& box, const Visit& visit) const {
    const std::int64_t left = column(std::max(box.low_x, box_.low_x));
    const std::int64_t right = column(std::min(box.high_x, box_.high_x));
    const std::int64_t last = row(std::min(box.high_y, box_.high_y));
    for (std::int64_t r = row(std::max(box.low_y, box_.low_y)); r <= last; ++r)
      for (std::int64_t c = left; c <= right; ++c)
        if (visit(static_cast<std::size_t>(r * columns_ + c))) return true;
    return false;
  }

  Box box_;
  bool all_ = false;
  int shift_ = 2;
  std::int64_t columns_ = 1;
  std::vector<std::uint8_t> marks_;
};

void CrossingFinder::find_lines(std::span<const Box> boxes) {
  const Places places(boxes);
  std::size_t most = 0;
  for (const LineVertices& path : paths_) most += path.size();
  if (boxes.size() == 1) lines_.reserve(most);
  for (std::uint32_t path = 0; path < paths_.size(); ++path) {
    for (std::uint32_t line = 0; line < lines(path); ++line) {
      const LineId id{path, line};
      const Point a = start(id);
      const Point b = end(id);
      const Box box = Box::around(a, b);
      if (places.meets(box)) lines_.push_back({box, id});
    }
  }
}

std::vector<CrossingPair> CrossingFinder::run(std::span<const Box> places,
                                              std::int64_t cell_size) {
  find_lines(places);
  const Grid grid = Grid::around(lines_, cell_size);
  cells_.resize(static_cast<std::size_t>(grid.columns * grid.rows));
  groups_.reserve(lines_.size());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line& line = lines_[i];
    const auto visit = [&](std::int64_t row, std::int64_t column) {
      enter(static_cast<std::int32_t>(i),
            static_cast<std::size_t>(row * grid.columns + column),
            grid.sixteenths(line.box, row, column));
    };
    if (!enter_small(grid, line.box, visit))
      for_cells(grid, line.box, {start(line.id), end(line.id)}, visit);
  }
  for (const std::size_t cell : crowded_) search_crowded(cell);
  return std::move(found_);
}

}  // namespace

bool change_sides(Point at, Point a_in, Point a_out, Point b_in, Point b_out) {
  if (same_direction(at, a_in, a_out) || same_direction(at, b_in, b_out) ||
      same_direction(at, a_in, b_in) || same_direction(at, a_in, b_out) ||
      same_direction(at, a_out, b_in) || same_direction(at, a_out, b_out)) {
    return false;
  }
  return in_sector(at, a_out, a_in, b_in) != in_sector(at, a_out, a_in, b_out);
}

std::vector<CrossingPair> find_crossings(std::span<const LineVertices> paths,
                                         const std::vector<bool>& closed,
                                         std::span<const Box> places,
                                         std::int64_t cell_size) {
  return CrossingFinder(paths, closed).run(places, cell_size);
}

}  // namespace unstep::reverse
