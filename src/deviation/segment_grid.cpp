#include "deviation/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace unstep::deviation {
namespace {

constexpr long double kMostCells = 1 << 12;  // on a side
constexpr long double kSmallestSide = 4;

}  // namespace

long double distance_to(const Line& line, Place place) {
  const long double dx = line.to.x - line.from.x;
  const long double dy = line.to.y - line.from.y;
  const long double length2 = dx * dx + dy * dy;
  const long double px = place.x - line.from.x;
  const long double py = place.y - line.from.y;
  const long double t = length2 == 0 ? 0
                                     : std::clamp<long double>(
                                           (px * dx + py * dy) / length2, 0, 1);
  const long double x = px - t * dx;
  const long double y = py - t * dy;
  return std::sqrt(x * x + y * y);
}

SegmentGrid::SegmentGrid(std::vector<Line> lines) : lines_(std::move(lines)) {
  constexpr long double kMax = std::numeric_limits<long double>::max();
  Place low{kMax, kMax};
  Place high{-kMax, -kMax};
  for (const Line& line : lines_) {
    for (const Place& p : {line.from, line.to}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  corner_ = low;
  side_ = std::max({kSmallestSide, (high.x - low.x) / (kMostCells - 2),
                    (high.y - low.y) / (kMostCells - 2)});
  columns_ = static_cast<std::int64_t>((high.x - low.x) / side_) + 1;
  rows_ = static_cast<std::int64_t>((high.y - low.y) / side_) + 1;
  const auto cells = static_cast<std::size_t>(columns_ * rows_);
  starts_.assign(cells + 1, 0);
  for (const Line& line : lines_)
    visit_cells(line, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t i = 0; i < cells; ++i) starts_[i + 1] += starts_[i];
  members_.resize(starts_[cells]);
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    visit_cells(lines_[i], [&](std::size_t cell) {
      members_[next[cell]++] = static_cast<std::uint32_t>(i);
    });
  }
}

SegmentGrid::Cell SegmentGrid::cell_of(Place place) const {
  const auto index = [this](long double offset, std::int64_t count) {
    return std::clamp(static_cast<std::int64_t>(std::floor(offset / side_)),
                      std::int64_t{0}, count - 1);
  };
  return {index(place.x - corner_.x, columns_),
          index(place.y - corner_.y, rows_)};
}

/// The cells the line goes through, one row after the other; some more at the
/// corners.
template <class Visit>
void SegmentGrid::visit_cells(const Line& line, Visit visit) const {
  const bool up = line.from.y <= line.to.y;
  const Place a = up ? line.from : line.to;
  const Place b = up ? line.to : line.from;
  const std::int64_t first = cell_of(a).row;
  const std::int64_t last = cell_of(b).row;
  const long double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
  for (std::int64_t row = first; row <= last; ++row) {
    const long double top = corner_.y + static_cast<long double>(row) * side_;
    const long double x0 = row == first ? a.x : a.x + (top - a.y) * slope;
    const long double x1 =
        row == last ? b.x : a.x + (top + side_ - a.y) * slope;
    const std::int64_t from =
        cell_of({std::min(x0, x1) - side_ / 64, top}).column;
    const std::int64_t to =
        cell_of({std::max(x0, x1) + side_ / 64, top}).column;
    for (std::int64_t column = from; column <= to; ++column)
      visit(static_cast<std::size_t>(row * columns_ + column));
  }
}

void SegmentGrid::look(Cell cell, Place place, long double& best) const {
  if (cell.column < 0 || cell.column >= columns_ || cell.row < 0 ||
      cell.row >= rows_)
    return;
  const auto index =
      static_cast<std::size_t>(cell.row * columns_ + cell.column);
  for (std::uint32_t i = starts_[index]; i < starts_[index + 1]; ++i)
    best = std::min(best, distance_to(lines_[members_[i]], place));
}

long double SegmentGrid::nearest(Place place) const {
  const Cell home = cell_of(place);
  long double best = std::numeric_limits<long double>::max();
  const std::int64_t most = std::max(columns_, rows_);
  for (std::int64_t ring = 0; ring <= most; ++ring) {
    // What is not looked at yet is beyond ring - 1 whole cells.
    if (best <= static_cast<long double>(ring - 1) * side_) break;
    for (std::int64_t column = home.column - ring; column <= home.column + ring;
         ++column) {
      const bool side =
          column == home.column - ring || column == home.column + ring;
      const std::int64_t step = side || ring == 0 ? 1 : 2 * ring;
      for (std::int64_t row = home.row - ring; row <= home.row + ring;
           row += step)
        look({column, row}, place, best);
    }
  }
  return best;
}

}  // namespace unstep::deviation
