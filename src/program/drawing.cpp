#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <new>
#include <numbers>
#include <string>

#include "program/arc_geometry.h"
#include "unstep/program.h"

/// Programs to drawings. docs/cnc.md, "To a drawing".
namespace unstep {
namespace {

using Kind = ProgramItem::Kind;

/// Path units per mm, and of it program units, that hold every position.
struct Grid {
  std::int32_t scale = 1'000'000;
  std::int64_t unit = 10;
};

/// The finest decimals, at most 6, at which all stays in range.
Result<Grid> grid_of(const std::vector<ProgramMove>& moves) {
  std::int64_t farthest = 0;
  for (const ProgramMove& move : moves) {
    for (const std::size_t axis : {0U, 1U}) {
      farthest = std::max(farthest, std::abs(move.end[axis]));
      if (move.kind == Kind::clockwise || move.kind == Kind::counter) {
        farthest = std::max(farthest, std::abs(move.centre[axis]));
      }
    }
  }
  Grid grid;
  while (farthest / grid.unit >= kMaxCoord / 2) {
    if (grid.scale == 1) {
      return Error{ErrorCode::out_of_range,
                   "a position beyond 500 km of a drawing"};
    }
    grid.scale /= 10;
    grid.unit *= 10;
  }
  return grid;
}

class Tracer {
 public:
  Tracer(Grid grid, Drawing& drawing) : grid_(grid), drawing_(drawing) {}

  /// True if it drew something.
  bool add(const ProgramMove& move) {
    const bool arc = move.kind == Kind::clockwise || move.kind == Kind::counter;
    const Point start = point(move.start);
    const Point end = point(move.end);
    if (!arc && start == end) return false;
    if (!open_) {
      drawing_.paths.emplace_back().origin = start;
      at_ = start;
      open_ = true;
    }
    if (!arc) {
      line_to(end);
    } else if (move.plane == ProgramPlane::xy) {
      add_arc(move, end);
    } else {
      add_tilted(move);
    }
    return true;
  }

  void lift() {
    if (!open_) return;
    open_ = false;
    Path& path = drawing_.paths.back();
    if (path.elements.empty()) {
      drawing_.paths.pop_back();
    } else {
      path.closed = at_ == path.origin;
    }
  }

 private:
  [[nodiscard]] std::int32_t on_grid(std::int64_t value) const {
    const std::int64_t half = grid_.unit / 2;
    return static_cast<std::int32_t>(value < 0 ? -((-value + half) / grid_.unit)
                                               : (value + half) / grid_.unit);
  }
  [[nodiscard]] Point point(const ProgramPosition& at) const {
    return {on_grid(at[0]), on_grid(at[1])};
  }

  void line_to(Point end) {
    if (end == at_) return;
    drawing_.paths.back().elements.push_back(
        {Path::Kind::segment, {end.x - at_.x, end.y - at_.y}, {}});
    at_ = end;
  }

  void add_arc(const ProgramMove& move, Point end) {
    Arc arc;
    arc.clockwise = move.kind == Kind::clockwise;
    arc.centre = {on_grid(move.centre[0]) - at_.x,
                  on_grid(move.centre[1]) - at_.y};
    arc.end = {end.x - at_.x, end.y - at_.y};
    const bool full =
        move.start[0] == move.end[0] && move.start[1] == move.end[1];
    // What is smaller than the grid, or a circle only by rounding.
    if (arc.centre == Point{} || (arc.end == Point{} && !full)) {
      return line_to(end);
    }
    drawing_.paths.back().elements.push_back({Path::Kind::arc, {}, arc});
    at_ = end;
  }

  /// An arc of another plane, seen from above: chords within 0.001 mm.
  void add_tilted(const ProgramMove& move) {
    const ProgramArc arc(move);
    const double share =
        std::min(1.0, 0.001 * static_cast<double>(kProgramUnitsPerMm) /
                          std::max(arc.radius(), 1.0));
    const auto count = static_cast<int>(
        std::min(1e5, std::ceil(arc.sweep() / (2 * std::acos(1 - share)))) + 1);
    for (int i = 1; i < count; ++i) {
      line_to(point(arc.at(static_cast<double>(i) / count)));
    }
    line_to(point(move.end));
  }

  Grid grid_;
  Drawing& drawing_;
  bool open_ = false;
  Point at_;
};

/// What of the moves a drawing has no place for.
struct Lost {
  bool z = false;
  bool others = false;
  bool feed = false;
  bool tilted = false;
  bool turns = false;
  std::uint64_t rapids = 0;
  std::uint64_t dark = 0;

  void look_at(const ProgramMove& move) {
    z = z || move.start[2] != move.end[2];
    others = others || !std::equal(move.start.begin() + 3, move.start.end(),
                                   move.end.begin() + 3);
    feed = feed || move.feed > 0;
    const bool arc = move.kind == Kind::clockwise || move.kind == Kind::counter;
    tilted = tilted || (arc && move.plane != ProgramPlane::xy);
    turns = turns || move.turns > 1;
  }

  void say(std::vector<std::string>& notes) const {
    if (z) notes.emplace_back("Z is not in a drawing");
    if (others) {
      notes.emplace_back("axes beside X, Y and Z are not in a drawing");
    }
    if (feed) notes.emplace_back("feed and spindle are not in a drawing");
    if (rapids > 0) {
      notes.push_back(std::to_string(rapids) + " rapids are not drawn");
    }
    if (dark > 0) {
      notes.push_back(std::to_string(dark) + " moves at S0 are not drawn");
    }
    if (tilted) notes.emplace_back("arcs of other planes than XY become lines");
    if (turns) notes.emplace_back("arcs of several turns are drawn once");
  }
};

}  // namespace

Result<Drawing> program_drawing(const Program& program,
                                std::vector<std::string>* notes) {
  try {
    const Result<std::vector<ProgramMove>> moves = program_moves(program, true);
    if (!moves) return moves.error();
    const Result<Grid> grid = grid_of(*moves);
    if (!grid) return grid.error();
    Drawing drawing;
    drawing.canvas.y_axis = YAxis::up;
    drawing.scale = grid->scale;
    drawing.paint = Paint::stroke;
    Tracer tracer(*grid, drawing);
    Lost lost;
    for (const ProgramMove& move : *moves) {
      if (move.kind == Kind::rapid || move.spindle == 0) {
        ++(move.kind == Kind::rapid ? lost.rapids : lost.dark);
        lost.z = lost.z || move.start[2] != move.end[2];
        tracer.lift();
        continue;
      }
      tracer.add(move);
      lost.look_at(move);
    }
    tracer.lift();
    if (notes != nullptr) {
      lost.say(*notes);
      notes->insert(notes->end(), program.notes.begin(), program.notes.end());
    }
    return drawing;
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the drawing"};
  }
}

}  // namespace unstep
