#include "reverse/crossing.h"

#include <algorithm>
#include <array>
#include <bit>

#include "reverse/crossing_grid.h"

namespace unstep::reverse {
namespace {

class CrossingFinder {
 public:
  CrossingFinder(std::span<const LineVertices> paths,
                 const std::vector<bool>& closed)
      : paths_(paths), meeting_(paths, closed) {}

  std::vector<CrossingPair> run(std::span<const Box> places,
                                std::int64_t cell_size);

 private:
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
  LineMeeting meeting_;
  std::vector<Line> lines_;
  std::vector<Cell> cells_;
  std::vector<Group> groups_;
  std::vector<std::int32_t> before_;  ///< the group before, by group
  std::vector<std::size_t> crowded_;
  std::vector<CrossingPair> found_;
};

void CrossingFinder::compare(const Line& p, const Line& q) {
  if (!p.box.meets(q.box) || meeting_.consecutive(p.id, q.id)) return;
  if (meeting_.cross(p.id, q.id)) found_.push_back({p.id, q.id});
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

void CrossingFinder::find_lines(std::span<const Box> boxes) {
  const Places places(boxes);
  std::size_t most = 0;
  for (const LineVertices& path : paths_) most += path.size();
  if (boxes.size() == 1) lines_.reserve(most);
  for (std::uint32_t path = 0; path < paths_.size(); ++path) {
    for (std::uint32_t line = 0; line < meeting_.lines(path); ++line) {
      const LineId id{path, line};
      const auto [a, b] = meeting_.ends(id);
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
      for_cells(grid, line.box, meeting_.ends(line.id), visit);
  }
  for (const std::size_t cell : crowded_) search_crowded(cell);
  return std::move(found_);
}

}  // namespace

std::vector<CrossingPair> find_crossings(std::span<const LineVertices> paths,
                                         const std::vector<bool>& closed,
                                         std::span<const Box> places,
                                         std::int64_t cell_size) {
  return CrossingFinder(paths, closed).run(places, cell_size);
}

}  // namespace unstep::reverse
