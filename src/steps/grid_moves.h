#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "unstep/grid.h"
#include "unstep/result.h"
#include "unstep/step_stream.h"

/// Motions of a program on the grid of steps.
namespace unstep::steps {

using GridPoint = std::array<std::int32_t, kMaxStepAxes>;

struct GridMove {
  bool rapid = false;
  bool is_arc = false;
  GridPoint delta{};  ///< |d| <= 2^31 - 2
  Arc arc;            ///< y up, relative to the start
  double feed = 0;    ///< mm/min; 0: not known
  double length = 0;  ///< mm
  double radius = 0;  ///< of arcs, mm
};

/// Motions without a step are left out.
Result<std::vector<GridMove>> grid_moves(const Program& program,
                                         const StepMakeOptions& options);

}  // namespace unstep::steps
