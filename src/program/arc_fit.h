#pragma once

#include <cstddef>
#include <optional>

#include "program/polyline.h"
#include "unstep/program.h"

namespace unstep {

/// An arc of the x-y plane of a run, its centre relative to the same vertex
/// as the run's points.
struct FittedArc {
  double x = 0;
  double y = 0;
  bool clockwise = false;
  /// If the rules want it, else 0; below 0: of more than a half turn.
  double radius = 0;
};

struct ArcFitOptions {
  double tolerance = 0;  ///< program units
  double grid = 1;       ///< the centre is a multiple of it from the start
  ArcRules rules;
};

/// An arc between the written vertices that is within the Frechet distance of
/// the polyline, whatever radius between its first and its last a control
/// takes; nothing if none was found. REQUIRES: first + 1 < last < size(), all
/// z alike.
[[nodiscard]] std::optional<FittedArc> fit_arc(const Polyline& run,
                                               std::size_t first,
                                               std::size_t last,
                                               const ArcFitOptions& options);

/// The check alone.
[[nodiscard]] bool arc_fits(const Polyline& run, std::size_t first,
                            std::size_t last, const FittedArc& arc,
                            const ArcFitOptions& options);

/// Arcs of more degrees would have ends too near to each other for R.
inline constexpr double kMostRadiusSweep = 340;

/// True if R says where the centre of an arc of so many degrees is: near a half
/// turn and a full one it depends on the last digits of the ends.
[[nodiscard]] bool radius_says(double degrees);

/// The first vertex after `last` that the run reaches by more than the half
/// turn that R does not say, if it goes on around the centre of `arc`.
[[nodiscard]] std::optional<std::size_t> beyond_half_turn(const Polyline& run,
                                                          std::size_t first,
                                                          std::size_t last,
                                                          const FittedArc& arc);

/// True if controls accept these radii at the start and the end of an arc.
[[nodiscard]] bool radii_agree(double first, double last,
                               const ArcRules& rules);

}  // namespace unstep
