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
/// same direction; negative if it is half a turn or more. There are 930 points
/// in a quadrant and so at most 8370 directions.
class NearDirections {
 public:
  struct Entry {
    std::uint16_t direction = 0;
    std::uint16_t left = 0;  ///< sides of the disc; if it has not the apex
    std::uint16_t right = 0;
    std::uint16_t r2 = kOutside;  ///< the square of the distance
  };
  static constexpr std::uint16_t kOutside = 0xFFFF;

  /// Two sides.
  struct Range {
    std::uint16_t left = 0;
    std::uint16_t right = 0;
  };

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
  /// The same as Cone::BackRule::holds_all. REQUIRES: r2 <= near2().
  [[nodiscard]] bool holds_all(std::int32_t farthest2, std::int32_t r2) const {
    return farthest2 <= held_[static_cast<std::size_t>(r2)];
  }
  /// As Cone::BackRule has it: more than 4 if none is left.
  [[nodiscard]] int quarters(std::int32_t farthest2, std::int32_t r2) const {
    return back_.quarters<std::int64_t>(farthest2, r2);
  }
  /// What a ray may do that waits for a point that comes nearer. REQUIRES:
  /// 1 to 4 quarters of the tolerance, such as quarters() gives for the place
  /// and one that is farther, not the apex.
  [[nodiscard]] Range waiting(std::int32_t place, int quarters) const {
    return waiting_[static_cast<std::size_t>(place)]
                   [static_cast<std::size_t>(quarters - 1)];
  }
  /// Some vector of a direction.
  [[nodiscard]] Cone::Vector vector_of(std::uint16_t direction) const;
  /// The greatest r2 of points that the apex alone serves, as Cone has it.
  [[nodiscard]] std::int32_t near2() const { return near2_; }

 private:
  struct Near;
  void enter(const Near& near);

  Cone::BackRule back_;
  std::int32_t near2_;
  std::array<std::int32_t, 65> held_{};
  std::vector<Cone::Vector> vectors_;  ///< those of the first quadrant
  static constexpr std::size_t kPlaces = std::size_t{kRow} * kRow;
  std::array<Entry, kPlaces> entries_;
  std::array<std::array<Range, 4>, kPlaces> waiting_;
};

}  // namespace unstep::reverse
