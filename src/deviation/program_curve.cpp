#include "deviation/program_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unstep::deviation {
namespace {

using Axes = std::array<long double, 3>;

Axes in_mm(const ProgramPosition& at) {
  Axes out{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out[axis] = static_cast<long double>(at[axis]) / kProgramUnitsPerMm;
  }
  return out;
}

Place3 place(const Axes& at) { return {at[0], at[1], at[2]}; }

/// Radius and the third axis change evenly with the angle.
void append_arc(const ProgramMove& move, long double sagitta,
                std::vector<Place3>& out) {
  const auto plane = plane_axes(move.plane);
  const Axes start = in_mm(move.start);
  const Axes end = in_mm(move.end);
  std::array<long double, 2> centre{};
  for (std::size_t i = 0; i < 2; ++i) {
    centre[i] = static_cast<long double>(move.centre[i]) / kProgramUnitsPerMm;
  }
  const long double sx = start[plane[0]] - centre[0];
  const long double sy = start[plane[1]] - centre[1];
  const long double ex = end[plane[0]] - centre[0];
  const long double ey = end[plane[1]] - centre[1];
  const long double r0 = std::hypot(sx, sy);
  const long double r1 = std::hypot(ex, ey);
  const long double way = move.kind == ProgramItem::Kind::counter ? 1 : -1;
  constexpr long double kTurn = 2 * std::numbers::pi_v<long double>;
  long double sweep = std::atan2((sx * ey - sy * ex) * way, sx * ex + sy * ey);
  if (sweep <= 1e-12L) sweep += kTurn;
  sweep += kTurn * (move.turns - 1);
  // A chord of angle 2 h is R (1 - cos h) <= R h^2 / 2 from its arc.
  const long double radius = std::max({r0, r1, sagitta});
  const long double half =
      std::min<long double>(std::sqrt(2 * sagitta / radius), 0.5L);
  const auto count = static_cast<std::size_t>(
      std::clamp<long double>(std::ceil(sweep / (2 * half)), 1, 1 << 22));
  const long double first = std::atan2(sy, sx);
  for (std::size_t i = 1; i < count; ++i) {
    const long double part =
        static_cast<long double>(i) / static_cast<long double>(count);
    const long double angle = first + way * sweep * part;
    const long double r = r0 + (r1 - r0) * part;
    Axes at{};
    at[plane[0]] = centre[0] + r * std::cos(angle);
    at[plane[1]] = centre[1] + r * std::sin(angle);
    at[plane[2]] = start[plane[2]] + (end[plane[2]] - start[plane[2]]) * part;
    out.push_back(place(at));
  }
  out.push_back(place(end));
}

bool continues(const ProgramSection& section, const ProgramMove& move) {
  return !section.rapid && section.spindle == move.spindle &&
         std::abs(section.feed - move.feed) <= 1e-3;
}

}  // namespace

Result<std::vector<ProgramSection>> sections_of(const Program& program,
                                                long double sagitta) {
  const auto moves = program_moves(program, true);
  if (!moves) return moves.error();
  std::vector<ProgramSection> sections;
  for (const ProgramMove& move : *moves) {
    const bool rapid = move.kind == ProgramItem::Kind::rapid;
    if (rapid || sections.empty() || !continues(sections.back(), move)) {
      ProgramSection& made = sections.emplace_back();
      made.rapid = rapid;
      made.feed = rapid ? 0 : move.feed;
      made.spindle = move.spindle;
      made.line = move.line;
      if (!rapid) made.path.push_back(place(in_mm(move.start)));
    }
    ProgramSection& section = sections.back();
    if (move.kind == ProgramItem::Kind::clockwise ||
        move.kind == ProgramItem::Kind::counter) {
      append_arc(move, sagitta, section.path);
    } else {
      section.path.push_back(place(in_mm(move.end)));
    }
    section.lines.resize(section.path.size(), move.line);
    section.end = move.end;
  }
  return sections;
}

}  // namespace unstep::deviation
