#include "steps/timing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace unstep::steps {
namespace {

using Direction = std::array<double, kMaxStepAxes>;

double product(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The way in which a move begins, or ends, of any length but 0.
Direction direction(const GridMove& move, bool at_end) {
  if (!move.is_arc) {
    return {static_cast<double>(move.delta[0]),
            static_cast<double>(move.delta[1]),
            static_cast<double>(move.delta[2])};
  }
  const double x = (at_end ? move.arc.end.x : 0) - move.arc.centre.x;
  const double y = (at_end ? move.arc.end.y : 0) - move.arc.centre.y;
  return move.arc.clockwise ? Direction{y, -x, 0} : Direction{-y, x, 0};
}

/// The speed at which a corner can be passed, mm/s.
double corner_speed(const GridMove& a, const GridMove& b,
                    const StepTiming& timing) {
  const Direction in = direction(a, true);
  const Direction out = direction(b, false);
  const double sizes = product(in, in) * product(out, out);
  const double dot = sizes > 0 ? product(in, out) / std::sqrt(sizes) : 0;
  // The sine of half the angle between the two legs.
  const double sine = std::sqrt(std::clamp((1 + dot) / 2, 0.0, 1.0));
  if (sine > 0.9999995) return 1e9;
  return std::sqrt(timing.acceleration * timing.corner * sine / (1 - sine));
}

}  // namespace

std::vector<MoveSpeed> plan_speeds(std::span<const GridMove> moves,
                                   const StepTiming& timing) {
  std::vector<MoveSpeed> speeds(moves.size());
  const double a = timing.acceleration;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const GridMove& move = moves[i];
    const double feed = move.feed > 0 ? move.feed : timing.feed;
    speeds[i].most = (move.rapid ? timing.rapid : feed) / 60;
    if (move.is_arc && a > 0) {
      speeds[i].most = std::min(speeds[i].most, std::sqrt(a * move.radius));
    }
    speeds[i].first = speeds[i].last = speeds[i].most;
  }
  if (a <= 0) return speeds;
  double next = 0;
  for (std::size_t i = moves.size(); i-- > 0;) {
    MoveSpeed& speed = speeds[i];
    speed.last = std::min(speed.most, next);
    speed.first = std::min(speed.most, std::sqrt(speed.last * speed.last +
                                                 2 * a * moves[i].length));
    if (i == 0 || moves[i - 1].rapid != moves[i].rapid) speed.first = 0;
    if (i > 0) {
      speed.first =
          std::min(speed.first, corner_speed(moves[i - 1], moves[i], timing));
    }
    next = speed.first;
  }
  double before = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    MoveSpeed& speed = speeds[i];
    speed.first = std::min(speed.first, before);
    speed.last = std::min(speed.last, std::sqrt(speed.first * speed.first +
                                                2 * a * moves[i].length));
    before = speed.last;
  }
  return speeds;
}

}  // namespace unstep::steps
