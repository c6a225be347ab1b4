#pragma once

#include <cstdint>
#include <functional>

#include "render/sub_grid.h"
#include "unstep/grid.h"

namespace unstep::render {

/// The lines of a path, each with its ends in sub-units.
using LineVisitor = std::function<void(Place from, Place to)>;

/// What can be seen: nothing outside of it is drawn.
struct View {
  Place least;
  Place greatest;
};

/// Visits chords of an arc that starts at `start`: at most 1/64 of a grid unit
/// from the arc, ends exact. A part that lies beyond one side of `view` may be
/// one chord that lies there too; so the number of chords is bounded by what is
/// seen, not by the radius.
void flatten_arc(const Arc& arc, Place start, const SubGrid& grid,
                 const View& view, const LineVisitor& visit);

}  // namespace unstep::render
