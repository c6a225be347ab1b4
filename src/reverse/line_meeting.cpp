#include "reverse/line_meeting.h"

#include <algorithm>

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

bool on_line(const LineEnds& line, Point at) {
  const auto [low_x, high_x] = std::minmax(line.a.x, line.b.x);
  const auto [low_y, high_y] = std::minmax(line.a.y, line.b.y);
  return side(line.a, line.b, at) == 0 && low_x <= at.x && at.x <= high_x &&
         low_y <= at.y && at.y <= high_y;
}

}  // namespace

bool LineMeeting::cross_at(LineId p, LineId q, Point at) const {
  const std::optional<Passage> a = passage(p, at);
  const std::optional<Passage> b = passage(q, at);
  return a && b && change_sides(at, a->in, a->out, b->in, b->out);
}

bool LineMeeting::cross(LineId first, LineId second) const {
  const LineEnds p = ends(first);
  const LineEnds q = ends(second);
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

bool change_sides(Point at, Point a_in, Point a_out, Point b_in, Point b_out) {
  if (same_direction(at, a_in, a_out) || same_direction(at, b_in, b_out) ||
      same_direction(at, a_in, b_in) || same_direction(at, a_in, b_out) ||
      same_direction(at, a_out, b_in) || same_direction(at, a_out, b_out)) {
    return false;
  }
  return in_sector(at, a_out, a_in, b_in) != in_sector(at, a_out, a_in, b_out);
}

}  // namespace unstep::reverse
