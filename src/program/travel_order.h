#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "unstep/grid.h"

namespace unstep::program {

/// Something to draw, by its ends.
struct Trip {
  Point from;
  Point to;
};

/// One trip of an order, drawn backwards or not.
struct Leg {
  std::uint32_t trip = 0;
  bool turned = false;
};

/// A short way through all trips that begins at `start`.
[[nodiscard]] std::vector<Leg> short_order(const std::vector<Trip>& trips,
                                           Point start);

/// The length of the ways between them, in order.
[[nodiscard]] double travel_of(const std::vector<Trip>& trips,
                               const std::vector<Leg>& order, Point start);

}  // namespace unstep::program
