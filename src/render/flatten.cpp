#include "render/flatten.h"

#include <algorithm>
#include <cmath>

namespace unstep::render {
namespace {

Wide dot(Place a, Place b) { return Wide{a.x} * b.x + Wide{a.y} * b.y; }
Wide cross(Place a, Place b) { return Wide{a.x} * b.y - Wide{a.y} * b.x; }

/// floor(sqrt(v)). REQUIRES: 0 <= v < 2^92: the root of a double is then less
/// than 1 off, and corrected.
std::int64_t root(Wide v) {
  auto r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(v)));
  while (Wide{r} * r > v) --r;
  while (Wide{r + 1} * (r + 1) <= v) ++r;
  return r;
}

std::int64_t rounded_div(Wide a, Wide b) { return floor_div(2 * a + b, 2 * b); }

/// The centre from the start of the arc, to half a sub-unit. n is below 2^31,
/// |centre . n| below 2^63.
Place true_centre(const Arc& arc, const SubGrid& grid) {
  const Wide unit = grid.per_path_unit;
  const Place centre{arc.centre.x, arc.centre.y};
  const Place end{arc.end.x, arc.end.y};
  const Wide square = dot(end, end);
  if (square == 0)
    return {centre.x * grid.per_path_unit, centre.y * grid.per_path_unit};
  const Place normal{-end.y, end.x};
  const Wide along = dot(centre, normal);
  const auto part = [&](std::int64_t of_end, std::int64_t of_normal) {
    return rounded_div(unit * (of_end * square + 2 * of_normal * along),
                       2 * square);
  };
  return {part(end.x, normal.x), part(end.y, normal.y)};
}

/// Halves pieces of at most a right angle until their chords are near enough.
/// Points are relative to the centre, below 2^44.
class Flattener {
 public:
  Flattener(Place centre, const SubGrid& grid, const View& view,
            const LineVisitor& visit)
      : centre_(centre),
        tolerance_(grid.per_grid_unit / 128),
        view_(view),
        visit_(visit) {}

  void piece(Place from, Place to) const {
    const Place sum{from.x + to.x, from.y + to.y};
    const std::int64_t length = root(dot(sum, sum));
    const std::int64_t radius =
        std::max(root(dot(from, from)), root(dot(to, to)));
    const std::int64_t height = radius + 1 - length / 2;
    if (height <= tolerance_ || length == 0 || out_of_view(from, to, height)) {
      visit_(seen(from), seen(to));
      return;
    }
    const Place middle{rounded_div(Wide{sum.x} * radius, length),
                       rounded_div(Wide{sum.y} * radius, length)};
    piece(from, middle);
    piece(middle, to);
  }

 private:
  [[nodiscard]] Place seen(Place at) const {
    return {at.x + centre_.x, at.y + centre_.y};
  }

  /// The piece is within `height` of its chord.
  [[nodiscard]] bool out_of_view(Place a, Place b, std::int64_t height) const {
    const Place p = seen(a);
    const Place q = seen(b);
    return std::max(p.x, q.x) + height < view_.least.x ||
           std::max(p.y, q.y) + height < view_.least.y ||
           std::min(p.x, q.x) - height > view_.greatest.x ||
           std::min(p.y, q.y) - height > view_.greatest.y;
  }

  Place centre_;
  std::int64_t tolerance_;
  View view_;
  const LineVisitor& visit_;
};

}  // namespace

void flatten_arc(const Arc& arc, Place start, const SubGrid& grid,
                 const View& view, const LineVisitor& visit) {
  const Place to_centre = true_centre(arc, grid);
  const Place centre{start.x + to_centre.x, start.y + to_centre.y};
  Place from{-to_centre.x, -to_centre.y};
  const Place to{from.x + arc.end.x * grid.per_path_unit,
                 from.y + arc.end.y * grid.per_path_unit};
  const Flattener flattener(centre, grid, view, visit);
  const bool full = arc.end == Point{};
  // Whole right angles first: turned exactly.
  for (int quarter = 0; quarter < (full ? 4 : 3); ++quarter) {
    const Wide turn = arc.clockwise ? -cross(from, to) : cross(from, to);
    if (!full && turn >= 0 && dot(from, to) >= 0) break;
    const Place next =
        arc.clockwise ? Place{from.y, -from.x} : Place{-from.y, from.x};
    flattener.piece(from, next);
    from = next;
  }
  if (!full) flattener.piece(from, to);
}

}  // namespace unstep::render
