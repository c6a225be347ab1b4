#include "machine/chain_follower.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "machine/pilot.h"
#include "machine/zenit.h"

namespace unstep::machine {
namespace {

/// The carriage is 16 ms behind the command; this is enough to find it.
constexpr double kBehindSeconds = 0.06;

struct Place {
  double x = 0;
  double y = 0;
};

double distance(const Place& p, const Place& from, const Place& to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double length = dx * dx + dy * dy;
  const double along =
      length == 0
          ? 0
          : std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / length,
                       0.0, 1.0);
  return std::hypot(from.x + along * dx - p.x, from.y + along * dy - p.y);
}

/// The places of a chain: its origin, then one after each step.
std::vector<Place> places_of(const Chain& chain, YAxis y_axis) {
  std::vector<Place> places;
  places.reserve(chain.steps.size() + 1);
  Place place{static_cast<double>(chain.origin.x),
              static_cast<double>(chain.origin.y)};
  places.push_back(place);
  for (const Step step : chain.steps) {
    const Point move = step_delta(step, y_axis);
    place.x += move.x;
    place.y += move.y;
    places.push_back(place);
  }
  return places;
}

Status check(std::span<const Chain> chains, YAxis y_axis,
             const FollowOptions& options) {
  const auto refuse = [](const std::string& what) {
    return Error{ErrorCode::out_of_range, "Zenit: " + what};
  };
  if (options.unit_pulses < 13 || options.unit_pulses > 12'500)
    return refuse("a grid unit is not in 1 um .. 1 mm");
  if (!(options.speed_um >= kMinSpeedUm && options.speed_um <= 1e5))
    return refuse("the speed is not in 20 um/s .. 10 cm/s");
  const std::int64_t most =
      std::int64_t{ReversibleCounter::kMaxMagnitude} / options.unit_pulses - 1;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    std::int64_t x = chains[i].origin.x;
    std::int64_t y = chains[i].origin.y;
    std::int64_t farthest = std::max(std::abs(x), std::abs(y));
    for (const Step step : chains[i].steps) {
      const Point move = step_delta(step, y_axis);
      x += move.x;
      y += move.y;
      farthest = std::max({farthest, std::abs(x), std::abs(y)});
    }
    if (farthest > most)
      return refuse("chain " + std::to_string(i) +
                    " leaves the counter's range of " + std::to_string(most) +
                    " grid units");
  }
  return {};
}

class Follower {
 public:
  Follower(const FollowOptions& options, const FollowVisitor& visit)
      : options_(options),
        visit_(visit),
        unit_um_(options.unit_pulses * kPulseUm),
        zenit_(options.plant, options.seed),
        pilot_(zenit_) {
    zenit_.reset();
    zenit_.command(Operation::load_dr1, Axis::x, 1023);
    zenit_.command(Operation::level_mode);
  }

  Status run(std::size_t index, const std::vector<Place>& places) {
    const Place start = places.front();
    pilot_.go(Axis::x, pulses(start.x));
    pilot_.go(Axis::y, pulses(start.y));
    const double way_um =
        std::max(std::abs(pulses(start.x)), std::abs(pulses(start.y))) *
        kPulseUm;
    // From anywhere: the last chain may have ended on the other side.
    Status status =
        pilot_.arrive(60 + 4 * (way_um + farthest_um_) / kMaxSpeedUm);
    if (!status) return status;
    farthest_um_ = std::max(farthest_um_, way_um);
    for (const Axis axis : {Axis::x, Axis::y}) {
      zenit_.command(Operation::reset_cr2, axis);
      zenit_.command(Operation::constant_speed, axis);
      zenit_.command(Operation::start_motor, axis);
    }
    zenit_.command(Operation::laser_on);
    status = draw(index, places);
    zenit_.command(Operation::laser_off);
    return status;
  }

  FollowReport report() {
    report_.seconds = zenit_.seconds();
    report_.top_speed_um = zenit_.top_speed_um();
    if (lit_ticks_ != 0)
      report_.rms_um = std::sqrt(squares_ / static_cast<double>(lit_ticks_));
    report_.lit_seconds = static_cast<double>(lit_ticks_) * kTickSeconds;
    return report_;
  }

 private:
  [[nodiscard]] std::int32_t pulses(double units) const {
    return static_cast<std::int32_t>(
        std::floor(units * options_.unit_pulses + 0.5));
  }

  /// Units from place `i` to the next.
  static double length(const std::vector<Place>& places, std::size_t i) {
    return places[i].x != places[i + 1].x && places[i].y != places[i + 1].y
               ? std::numbers::sqrt2
               : 1.0;
  }

  Status draw(std::size_t index, const std::vector<Place>& places) {
    const double per_tick = options_.speed_um * kTickSeconds / unit_um_;
    const std::size_t steps = places.size() - 1;
    std::int32_t x = pulses(places.front().x);
    std::int32_t y = pulses(places.front().y);
    std::size_t at = 0;
    double along = 0;
    int settled = 0;
    while (settled < 16) {
      along += per_tick;
      while (at < steps && along >= length(places, at)) {
        report_.peak_steps_hz =
            std::max(report_.peak_steps_hz,
                     options_.speed_um / (unit_um_ * length(places, at)));
        along -= length(places, at++);
      }
      Place to = places[at];
      if (at < steps) {
        const double share = along / length(places, at);
        to.x += share * (places[at + 1].x - to.x);
        to.y += share * (places[at + 1].y - to.y);
      }
      command(pulses(to.x) - x, pulses(to.y) - y);
      x = pulses(to.x);
      y = pulses(to.y);
      zenit_.tick();
      if (!measure(index, places, at))
        return Error{ErrorCode::cancelled, "stopped"};
      const bool there = at == steps && std::abs(error(Axis::x)) <= 1 &&
                         std::abs(error(Axis::y)) <= 1;
      settled = there ? settled + 1 : 0;
      waited_ = at == steps ? waited_ + 1 : 0;
      if (static_cast<double>(waited_) * kTickSeconds > 60)
        return Error{ErrorCode::internal,
                     "Zenit: the carriage does not settle"};
    }
    report_.steps += steps;
    return {};
  }

  [[nodiscard]] std::int64_t error(Axis axis) const {
    return zenit_.motor_error(axis);
  }

  void command(std::int32_t dx, std::int32_t dy) {
    zenit_.feed(Axis::x, dx);
    zenit_.feed(Axis::y, dy);
    // Rounding adds up to one pulse to a tick.
    const double most = std::max(std::abs(dx), std::abs(dy)) - 1;
    if (most * kPulseUm > kMaxSpeedUm * kTickSeconds)
      report_.broken.axis_speed = true;
  }

  bool measure(std::size_t index, const std::vector<Place>& places,
               std::size_t at) {
    const Place here{zenit_.position_um(Axis::x) / unit_um_,
                     zenit_.position_um(Axis::y) / unit_um_};
    const auto behind = static_cast<std::size_t>(
        options_.speed_um * kBehindSeconds / unit_um_ + 2);
    const std::size_t last = std::min(at + 1, places.size() - 1);
    double nearest =
        std::hypot(places[last].x - here.x, places[last].y - here.y);
    for (std::size_t i = at > behind ? at - behind : 0; i < last; ++i)
      nearest = std::min(nearest, distance(here, places[i], places[i + 1]));
    nearest *= unit_um_;
    report_.worst_um = std::max(report_.worst_um, nearest);
    squares_ += nearest * nearest;
    ++lit_ticks_;
    for (const Axis axis : {Axis::x, Axis::y}) {
      report_.peak_pulses_hz = std::max(
          report_.peak_pulses_hz,
          static_cast<double>(std::abs(zenit_.pulses(axis))) / kTickSeconds);
    }
    if (zenit_.saturated()) report_.broken.saturated_seconds += kTickSeconds;
    return visit_(index, here.x, here.y);
  }

  const FollowOptions& options_;
  const FollowVisitor& visit_;
  double unit_um_;
  Zenit zenit_;
  Pilot pilot_;
  FollowReport report_;
  double farthest_um_ = 0;
  double squares_ = 0;
  std::uint64_t lit_ticks_ = 0;
  std::int64_t waited_ = 0;
};

}  // namespace

Result<FollowReport> follow_chains(std::span<const Chain> chains, YAxis y_axis,
                                   const FollowOptions& options,
                                   const FollowVisitor& visit) {
  const Status status = check(chains, y_axis, options);
  if (!status) return status.error();
  Follower follower(options, visit);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const Status drawn = follower.run(i, places_of(chains[i], y_axis));
    if (!drawn) return drawn.error();
  }
  return follower.report();
}

}  // namespace unstep::machine
