#pragma once

#include <cstdint>

#include "unstep/grid.h"

/// The units in which paths are drawn.
namespace unstep::render {

__extension__ using Wide = __int128;

/// A point in sub-units.
struct Place {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// Sub-units divide the path unit evenly, and a grid unit, always an even
/// number of them, at least 1024 times, so that a rounded sub-unit is far below
/// the 1/64 that arcs may be off.
///
/// Range: coordinates of paths are below 2^30. One path unit is 1024 sub-units
/// at scale 1 and 2 from scale 512 up, so vertices are below 2^40 and
/// differences below 2^41; centres of arcs, below 2^32 path units from the
/// start, are below 2^43.
struct SubGrid {
  explicit SubGrid(std::int32_t scale)
      : per_path_unit((1023 / scale + 2) / 2 * 2),
        per_grid_unit(per_path_unit * scale) {}

  std::int64_t per_path_unit;
  std::int64_t per_grid_unit;
};

inline std::int64_t floor_div(Wide a, Wide b) {
  const Wide q = a / b;
  return static_cast<std::int64_t>(a % b < 0 ? q - 1 : q);  // b > 0
}

inline std::int64_t ceil_div(Wide a, Wide b) { return -floor_div(-a, b); }

}  // namespace unstep::render
