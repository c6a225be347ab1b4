#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "interpolate/arc_walk.h"
#include "interpolate/letters.h"

namespace unstep::interpolation {

/// The steps of Circular in bulk, in letters of one's own. In an octant one
/// axis moves at every step and F alone says whether the other does too, so a
/// step is an addition and a comparison.
class ArcSteps {
 public:
  ArcSteps(const ArcGeometry& arc, bool combined, const Letters& letters)
      : walk_(arc), combined_(combined), letters_(letters) {}

  /// Steps until `out` is full or the end is reached; how many were written.
  std::size_t fill(std::span<std::uint8_t> out);

 private:
  /// Steps of this piece that need no choice of three; 0 where there are none.
  std::size_t draw_run(std::span<std::uint8_t> out);
  std::size_t draw_straight(std::span<std::uint8_t> out);
  std::size_t draw_separate(std::span<std::uint8_t> out);
  std::size_t draw_flat(std::span<std::uint8_t> out);
  std::size_t draw_steep(std::span<std::uint8_t> out);
  [[nodiscard]] std::uint8_t letter(Point move) const;
  void name_moves();

  ArcWalk walk_;
  bool combined_;
  Letters letters_;
  int named_ = -1;  ///< turns of the piece whose letters these are:
  std::uint8_t along_a_ = 0;
  std::uint8_t along_b_ = 0;
  std::uint8_t both_ = 0;
};

}  // namespace unstep::interpolation
