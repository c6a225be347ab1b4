#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "machine/carriage.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// Chains drawn by "Zenit" with its laser.
namespace unstep::machine {

struct FollowOptions {
  std::int32_t unit_pulses = 50;  ///< lambda / 8 a grid unit: 4 um
  double speed_um = 1000;         ///< along the chain, per second
  Plant plant;
  std::uint64_t seed = 1;
};

/// What is above a limit of the machine; it is run all the same.
struct BrokenLimits {
  bool axis_speed = false;       ///< an axis was commanded above 1 cm/s
  double saturated_seconds = 0;  ///< a motor at full duty with the light on
  friend bool operator==(const BrokenLimits&, const BrokenLimits&) = default;
};

struct FollowReport {
  double seconds = 0;      ///< of machine time, ways between chains included
  double lit_seconds = 0;  ///< with the light on
  std::uint64_t steps = 0;
  double worst_um = 0;  ///< from the carriage to the commanded path, lit
  double rms_um = 0;
  double peak_steps_hz = 0;   ///< unit steps commanded, a second
  double peak_pulses_hz = 0;  ///< of a pulse former, within a tick
  double top_speed_um = 0;    ///< of an axis, per second
  BrokenLimits broken;
};

/// Called every tick with the light on: which chain, and where the carriage is
/// in grid units. Return false to stop.
using FollowVisitor =
    std::function<bool(std::size_t chain, double x, double y)>;

/// Runs every chain in turn at constant speed with stops between them: the
/// steps, spread evenly over time, take the place of the rate multiplier's
/// pulses in y = k integral(fx dt) - integral(fu dt). y of the drawing is y of
/// the machine.
///
/// out_of_range: a point beyond the counter's 23 bits, a unit not in 13..12500
/// pulses (1 um .. 1 mm), a speed not in 20 um/s .. 10 cm/s. internal if the
/// carriage never arrives (too noisy a plant); cancelled.
Result<FollowReport> follow_chains(std::span<const Chain> chains, YAxis y_axis,
                                   const FollowOptions& options,
                                   const FollowVisitor& visit);

}  // namespace unstep::machine
