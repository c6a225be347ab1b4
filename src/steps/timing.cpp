#include "steps/timing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace unstep::steps {
namespace {

using Direction = std::array<double, kMaxStepAxes>;

Direction normal(const Direction& d) {
  double square = 0;
  for (const double part : d) square += part * part;
  const double size = square > 0 ? std::sqrt(square) : 1;
  return {d[0] / size, d[1] / size, d[2] / size};
}

/// The way in which a move begins, or ends.
Direction direction(const GridMove& move, bool at_end) {
  if (!move.is_arc) {
    return normal({static_cast<double>(move.delta[0]),
                   static_cast<double>(move.delta[1]),
                   static_cast<double>(move.delta[2])});
  }
  const double x = (at_end ? move.arc.end.x : 0) - move.arc.centre.x;
  const double y = (at_end ? move.arc.end.y : 0) - move.arc.centre.y;
  return move.arc.clockwise ? normal({y, -x, 0}) : normal({-y, x, 0});
}

/// The speed at which a corner can be passed, mm/s.
double corner_speed(const GridMove& a, const GridMove& b,
                    const StepTiming& timing) {
  const Direction in = direction(a, true);
  const Direction out = direction(b, false);
  const double dot = in[0] * out[0] + in[1] * out[1] + in[2] * out[2];
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

MoveClock::MoveClock(const MoveSpeed& speed, double length, double acceleration)
    : acceleration_(acceleration), first_(speed.first), peak_(speed.most) {
  const double a = acceleration;
  if (a <= 0) return;
  const double v0 = speed.first;
  const double v1 = speed.last;
  // Where speeding up would meet braking.
  peak_ = std::min(speed.most, std::sqrt((v0 * v0 + v1 * v1) / 2 + a * length));
  up_ = std::max(0.0, (peak_ * peak_ - v0 * v0) / (2 * a));
  brake_at_ = length - std::max(0.0, (peak_ * peak_ - v1 * v1) / (2 * a));
  speeding_ = speeding_until(up_);
}

double MoveClock::speeding_until(double way) const {
  return (std::sqrt(first_ * first_ + 2 * acceleration_ * way) - first_) /
         acceleration_;
}

double MoveClock::at(double way) const {
  if (acceleration_ <= 0) return way / peak_;
  if (way <= up_) return speeding_until(way);
  const double steady = std::min(way, brake_at_) - up_;
  const double time = speeding_ + std::max(0.0, steady) / peak_;
  const double braked = way - std::max(up_, brake_at_);
  if (braked <= 0) return time;
  const double left = std::max(0.0, peak_ * peak_ - 2 * acceleration_ * braked);
  return time + (peak_ - std::sqrt(left)) / acceleration_;
}

}  // namespace unstep::steps
