#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reverse/tolerance_cone.h"

namespace unstep::reverse {

/// What Cone computes of the points within 30 units of its apex, once for all:
/// their directions and the sides of their discs, each replaced by its place in
/// the circular order of all of them. Comparing two places is comparing two
/// vectors exactly, so a cone of places decides as Cone does, at a third of the
/// time.
///
/// A place has 16 bits, a quadrant 2^14 of them from its axis on: the
/// difference of two, taken as a signed number, is positive if the first is
/// less than half a turn counter-clockwise of the second; 0 if they are the
/// same direction; negative if it is half a turn or more. There are 900 points
/// in a quadrant and so at most 2700 directions.
class NearDirections {
 public:
  struct Entry {
    std::uint16_t direction = 0;
    std::uint16_t left = 0;  ///< sides of the disc; if it has not the apex
    std::uint16_t right = 0;
    std::uint16_t r2 = kOutside;  ///< the square of the distance
  };
  static constexpr std::uint16_t kOutside = 0xFFFF;

  /// Tolerances above have no use for it: most of its points are too near.
  static constexpr std::int64_t kMaxTolerance = std::int64_t{8}
                                                << PathTolerance::kBits;

  /// Points form rows of kRow entries; the first and last row and the ends of
  /// each are outside.
  static constexpr std::int32_t kRow = 64;
  static constexpr std::int32_t kApex = 32 * kRow + 32;

  /// REQUIRES: tolerance.fixed <= kMaxTolerance.
  explicit NearDirections(PathTolerance tolerance);

  [[nodiscard]] static std::int32_t place_of(Point offset) {
    return kApex + offset.y * kRow + offset.x;
  }
  [[nodiscard]] static Point offset_of(std::int32_t place) {
    return {place % kRow - 32, place / kRow - 32};
  }
  [[nodiscard]] const Entry& at(std::int32_t place) const {
    return entries_[static_cast<std::size_t>(place)];
  }
  /// Some vector of a direction.
  [[nodiscard]] Cone::Vector vector_of(std::uint16_t direction) const;
  /// The greatest r2 of points that the apex alone serves, as Cone has it.
  [[nodiscard]] std::int32_t near2() const { return near2_; }

 private:
  [[nodiscard]] std::uint16_t find(Cone::Vector vector) const;

  std::int32_t near2_;
  std::vector<Cone::Vector> vectors_;  ///< those of the first quadrant
  std::array<Entry, std::size_t{kRow} * kRow> entries_;
};

}  // namespace unstep::reverse
