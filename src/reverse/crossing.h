#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reverse/line_meeting.h"
#include "reverse/places.h"

namespace unstep::reverse {

struct CrossingPair {
  LineId first;
  LineId second;
};

/// The pairs of lines that meet otherwise than by touching in a point: they
/// cross, at a vertex or between, or lie on each other for a length. Lines
/// that follow one another in a path are not looked at. A pair may come more
/// than once. `closed[i]`: path i is a ring. Lines that do not reach into any
/// of `places` are looked at only if they are near one.
///
/// Each line goes into the square cells that it reaches, a power of two wide,
/// `cell_size` or less at first and twice that until there are at most five
/// cells to a line, and is compared with the lines that are there. Time O(L)
/// for L lines that are short or sparse. Memory: 24 bytes per line, 68 per cell
/// that lines reach and eight of them there, 8 per cell, 64 per place.
///
/// REQUIRES: `places` is not empty. Range: coordinates are within kMaxCoord, so
/// an orientation, the difference of two products of differences, is below
/// 2^63.
std::vector<CrossingPair> find_crossings(std::span<const LineVertices> paths,
                                         const std::vector<bool>& closed,
                                         std::span<const Box> places,
                                         std::int64_t cell_size);

}  // namespace unstep::reverse
