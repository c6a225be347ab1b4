#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "unstep/interpolate.h"

/// The brute-force oracle of forward interpolation: follows every tick and
/// measures the distance to the true line or circle in long double.
namespace unstep::oracle {

struct Trace {
  long double worst = 0;  ///< largest distance from the true curve, units
  std::int64_t x = 0;     ///< where it ended
  std::int64_t y = 0;
  std::uint64_t ticks = 0;
  std::uint64_t steps = 0;     ///< ticks that moved
  std::uint64_t diagonal = 0;  ///< of them
  bool legal = true;      ///< every tick agrees with itself, done stays done
  long double swept = 0;  ///< arcs: signed angle seen from the centre
};

/// True if the tick's fields agree with each other.
inline bool legal_tick(const Tick& t) {
  switch (t.kind) {
    case Tick::Kind::done:
    case Tick::Kind::idle: return t.dx == 0 && t.dy == 0;
    case Tick::Kind::step:
      return t.step <= 7 && Point{t.dx, t.dy} == step_delta(t.step);
    case Tick::Kind::increment: return t.dx != 0 || t.dy != 0;
  }
  return false;
}

template <class Distance>
Trace follow(Interpolator interpolator, std::uint64_t max_ticks,
             Distance distance) {
  Trace trace;
  Tick tick;
  while (trace.ticks <= max_ticks &&
         (tick = interpolator.next()).kind != Tick::Kind::done) {
    ++trace.ticks;
    trace.legal = trace.legal && legal_tick(tick);
    trace.steps += tick.kind != Tick::Kind::idle;
    trace.diagonal += tick.dx != 0 && tick.dy != 0;
    const std::int64_t from_x = trace.x;
    const std::int64_t from_y = trace.y;
    trace.x += tick.dx;
    trace.y += tick.dy;
    trace.worst = std::max(trace.worst, distance(trace, from_x, from_y));
  }
  trace.legal = trace.legal && trace.ticks <= max_ticks &&
                interpolator.next().kind == Tick::Kind::done;
  return trace;
}

inline Trace follow_line(const Interpolator& interpolator, Segment s,
                         std::uint64_t max_ticks = std::uint64_t{1} << 40) {
  const long double length = std::hypot(static_cast<long double>(s.dx),
                                        static_cast<long double>(s.dy));
  return follow(
      interpolator, max_ticks, [=](const Trace& t, std::int64_t, std::int64_t) {
        const auto x = static_cast<long double>(t.x);
        const auto y = static_cast<long double>(t.y);
        return length == 0 ? std::hypot(x, y)
                           : std::abs(x * static_cast<long double>(s.dy) -
                                      y * static_cast<long double>(s.dx)) /
                                 length;
      });
}

inline Trace follow_arc(const Interpolator& interpolator, const Arc& arc,
                        std::uint64_t max_ticks = std::uint64_t{1} << 40) {
  const auto cx = static_cast<long double>(arc.centre.x);
  const auto cy = static_cast<long double>(arc.centre.y);
  const long double radius = std::hypot(cx, cy);
  long double swept = 0;
  Trace trace =
      follow(interpolator, max_ticks,
             [&](const Trace& t, std::int64_t from_x, std::int64_t from_y) {
               const long double ux = static_cast<long double>(from_x) - cx;
               const long double uy = static_cast<long double>(from_y) - cy;
               const long double vx = static_cast<long double>(t.x) - cx;
               const long double vy = static_cast<long double>(t.y) - cy;
               swept += std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
               return std::abs(std::hypot(vx, vy) - radius);
             });
  trace.swept = swept;
  return trace;
}

/// The angle an arc should sweep, positive counter-clockwise.
inline long double arc_sweep(const Arc& arc) {
  constexpr long double kTurn = 2 * std::numbers::pi_v<long double>;
  if (arc.end == Point{}) return arc.clockwise ? -kTurn : kTurn;
  const auto sx = -static_cast<long double>(arc.centre.x);
  const auto sy = -static_cast<long double>(arc.centre.y);
  const long double ex = static_cast<long double>(arc.end.x) + sx;
  const long double ey = static_cast<long double>(arc.end.y) + sy;
  long double angle = std::atan2(sx * ey - sy * ex, sx * ex + sy * ey);
  if (arc.clockwise && angle > 0) angle -= kTurn;
  if (!arc.clockwise && angle < 0) angle += kTurn;
  return angle;
}

}  // namespace unstep::oracle
