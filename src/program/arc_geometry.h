#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "unstep/program.h"

/// Arcs in a plane, in program units.
namespace unstep {

using PlanePoint = std::array<std::int64_t, 2>;

/// The centre of the arc from `start` to `end` with this radius; below 0: of
/// more than a half turn. Where the radius is too small for the distance of
/// the ends, the middle between them. Nothing if start == end or the centre is
/// farther from the start than kMaxProgramLength on an axis.
[[nodiscard]] std::optional<PlanePoint> centre_by_radius(
    const PlanePoint& start, const PlanePoint& end, std::int64_t radius,
    bool counter);

[[nodiscard]] double distance(const PlanePoint& a, const PlanePoint& b);

/// The angle that an arc turns through, in radians, above 0; a full turn where
/// start and end are in one direction.
[[nodiscard]] double arc_sweep(const PlanePoint& start, const PlanePoint& end,
                               const PlanePoint& centre, bool counter);

/// The circle of a motion of kind clockwise or counter in its plane, walked
/// with what the axis across it does.
class ProgramArc {
 public:
  explicit ProgramArc(const ProgramMove& move);

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double sweep() const { return sweep_; }  ///< radians, above 0
  /// After `part` of the arc, 0..1, to the nearest unit.
  [[nodiscard]] ProgramPosition at(double part) const;

 private:
  ProgramMove move_;
  double radius_;
  double sweep_;
  double first_;  ///< angle of the start
};

}  // namespace unstep
