#include "steps/grid_moves.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "interpolate/arc_walk.h"
#include "program/arc_geometry.h"
#include "program/moves.h"
#include "steps/arc_rule.h"

namespace unstep::steps {
namespace {

using Kind = ProgramItem::Kind;

class Gridder {
 public:
  explicit Gridder(const StepMakeOptions& options)
      : options_(options),
        per_unit_(1.0 / static_cast<double>(options.step)),
        at_(options.origin) {
    if (options.axes == 2) at_[2] = 0;
  }

  Status add(const ProgramMove& move) {
    feed_ = move.feed;
    rapid_ = move.kind == Kind::rapid;
    if (move.kind == Kind::clockwise || move.kind == Kind::counter) {
      for (std::uint32_t turn = 1; turn < move.turns; ++turn) {
        if (Status done = add_turn(move); !done) return done;
      }
      return add_arc(move);
    }
    return line_to(move.end);
  }

  std::vector<GridMove> take() { return std::move(moves_); }

 private:
  [[nodiscard]] double in_mm(double steps) const {
    return steps * static_cast<double>(options_.step) /
           static_cast<double>(kProgramUnitsPerMm);
  }

  Status round(std::int64_t value, std::int32_t& out) const {
    const std::int64_t step = options_.step;
    const std::int64_t half = std::abs(value) + step / 2;
    // Below 2^51, so the product is off by less than one: a quotient without a
    // division.
    auto whole =
        static_cast<std::int64_t>(static_cast<double>(half) * per_unit_);
    const std::int64_t rest = half - whole * step;
    whole += rest < 0 ? -1 : rest >= step ? 1 : 0;
    const std::int64_t steps = value < 0 ? -whole : whole;
    if (steps > kMaxCoord || steps < -kMaxCoord) {
      return Error{ErrorCode::out_of_range,
                   "a motion leaves the range of 2^30 steps"};
    }
    out = static_cast<std::int32_t>(steps);
    return {};
  }
  Status round(const ProgramPosition& at, GridPoint& out) const {
    for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
      out[axis] = 0;
      if (static_cast<int>(axis) >= options_.axes) continue;
      if (Status done = round(at[axis], out[axis]); !done) return done;
    }
    return {};
  }

  Status line_to(const ProgramPosition& to) {
    GridPoint end{};
    if (Status done = round(to, end); !done) return done;
    return line_to(end);
  }
  Status line_to(const GridPoint& end) {
    GridMove move;
    move.rapid = rapid_;
    move.feed = feed_;
    double square = 0;
    for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
      move.delta[axis] = end[axis] - at_[axis];
      square += std::pow(static_cast<double>(move.delta[axis]), 2);
    }
    if (square == 0) return {};
    move.length = in_mm(std::sqrt(square));
    at_ = end;
    return push(move);
  }

  /// Every move has a step at least, so the limit of steps holds for moves.
  Status push(const GridMove& move) {
    if (moves_.size() >= options_.max_steps) {
      return Error{ErrorCode::limit_exceeded, "more steps than allowed"};
    }
    moves_.push_back(move);
    return {};
  }

  /// Once around from the start, in the plane.
  Status add_turn(ProgramMove move) {
    const auto plane = plane_axes(move.plane);
    move.end[plane[0]] = move.start[plane[0]];
    move.end[plane[1]] = move.start[plane[1]];
    move.end[plane[2]] = move.start[plane[2]];
    return add_arc(move);
  }

  Status add_arc(const ProgramMove& move) {
    GridPoint end{};
    if (Status done = round(move.end, end); !done) return done;
    if (move.plane == ProgramPlane::xy && end[2] == at_[2]) {
      Arc arc{
          {}, {end[0] - at_[0], end[1] - at_[1]}, move.kind == Kind::clockwise};
      // Ends that are one on the grid: all of the circle, or nothing of it.
      const bool closed =
          move.start[0] == move.end[0] && move.start[1] == move.end[1];
      const bool full = arc.end == Point{} &&
                        (closed || ProgramArc(move).sweep() > std::numbers::pi);
      if (Status done = find_centre(move, full, arc); !done) return done;
      if ((full || arc.end != Point{}) && arc.centre != Point{} &&
          interpolation::check_arc(arc)) {
        GridMove out;
        out.rapid = rapid_;
        out.feed = feed_;
        out.is_arc = true;
        out.arc = arc;
        out.delta = {arc.end.x, arc.end.y, 0};
        const PlanePoint from{0, 0};
        const PlanePoint to{arc.end.x, arc.end.y};
        const PlanePoint middle{arc.centre.x, arc.centre.y};
        out.radius = in_mm(std::hypot(arc.centre.x, arc.centre.y));
        out.length = out.radius * arc_sweep(from, to, middle, !arc.clockwise);
        at_ = end;
        return push(out);
      }
    }
    return add_chords(move);
  }

  /// The whole-numbered centre nearest to that of the move, or another near it
  /// if only that makes the radii at both ends agree to less than a step and as
  /// controls want it: both ends have been rounded.
  Status find_centre(const ProgramMove& move, bool full, Arc& arc) const {
    std::array<std::int32_t, 2> nearest{};
    for (std::size_t i = 0; i < 2; ++i) {
      if (Status done = round(move.centre[i], nearest[i]); !done) return done;
    }
    arc.centre = {nearest[0] - at_[0], nearest[1] - at_[1]};
    if (full) return {};
    const auto is_taken = [&](Point centre) {
      return centre != Point{} && control_takes(centre, arc.end, in_mm(1)) &&
             interpolation::check_arc({centre, arc.end, arc.clockwise});
    };
    if (is_taken(arc.centre)) return {};
    constexpr double kMaxAway = 1.25;
    const Point first = arc.centre;
    const double x = static_cast<double>(move.centre[0]) * per_unit_ - at_[0];
    const double y = static_cast<double>(move.centre[1]) * per_unit_ - at_[1];
    // Those that a control takes come first, and of these the nearest.
    std::pair<double, double> best{1e300, 1e300};
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        const Point centre{first.x + dx, first.y + dy};
        const double away = std::hypot(centre.x - x, centre.y - y);
        if (centre == Point{} || (away > kMaxAway && centre != first)) {
          continue;
        }
        const double off = std::abs(radius_change(centre, arc.end));
        const std::pair<double, double> rank{is_taken(centre) ? -1 : off, away};
        if (rank >= best) continue;
        best = rank;
        arc.centre = centre;
      }
    }
    return {};
  }

  /// Chords of at most half a step, for what has no arc on the grid.
  Status add_chords(const ProgramMove& move) {
    const ProgramArc arc(move);
    const double wanted = std::ceil(arc.radius() * arc.sweep() * 2 /
                                    static_cast<double>(options_.step));
    if (!(wanted <= 4 * static_cast<double>(options_.max_steps) + 16)) {
      return Error{ErrorCode::limit_exceeded, "more steps than allowed"};
    }
    const auto count = static_cast<std::uint64_t>(std::max(wanted, 1.0));
    for (std::uint64_t i = 1; i < count; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(count);
      if (Status done = line_to(arc.at(part)); !done) return done;
    }
    return line_to(move.end);
  }

  const StepMakeOptions& options_;
  double per_unit_;  ///< steps in 1e-7 mm
  std::vector<GridMove> moves_;
  GridPoint at_;
  double feed_ = 0;
  bool rapid_ = false;
};

}  // namespace

Result<std::vector<GridMove>> grid_moves(const Program& program,
                                         const StepMakeOptions& options) {
  Gridder gridder(options);
  const auto add = [&gridder](const ProgramMove& move) {
    Status done = gridder.add(move);
    if (done) return done;
    return Status(Error{done.error().code, "line " + std::to_string(move.line) +
                                               ": " + done.error().message});
  };
  const Status done = visit_moves(program, options.skip_unknown, add);
  if (!done) return done.error();
  return gridder.take();
}

}  // namespace unstep::steps
