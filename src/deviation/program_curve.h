#pragma once

#include <cstdint>
#include <vector>

#include "deviation/polyline_frechet.h"
#include "unstep/program.h"
#include "unstep/result.h"

/// Programs as polylines in space. Shares nothing with src/program.
namespace unstep::deviation {

/// Motions that may be merged with each other, or one rapid.
struct ProgramSection {
  bool rapid = false;
  double feed = 0;
  double spindle = -1;
  ProgramPosition end{};
  std::uint32_t line = 0;    ///< of the source, its first motion
  std::vector<Place3> path;  ///< mm, from where it begins; rapids: their end
  std::vector<std::uint32_t> lines;  ///< of the motion that leads to each place
};

/// Arcs become chords within `sagitta` mm, 2^22 at most each.
Result<std::vector<ProgramSection>> sections_of(const Program& program,
                                                long double sagitta);

}  // namespace unstep::deviation
