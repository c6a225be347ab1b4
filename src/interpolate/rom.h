#pragma once

#include <cstdint>

#include "interpolate/digit_by_digit.h"
#include "unstep/interpolate.h"

/// D4: tables of sin and cos over a quarter circle, nodes at multiples of
/// 2^-s rad so that the high bits of the angle address the table, with a
/// polynomial correction between the nodes.
///
/// Error of the correction, h = 2^-s (all derivatives are at most 1):
///   linear    h^2 / 8
///   parabolic h^3 / (9 sqrt 3), three nodes ahead (Newton)
///   cubic     3 h^4 / 128, four nodes around (Lagrange)
/// and 2^-n for rounding and arithmetic.
namespace unstep::interpolation {

class Rom {
 public:
  /// REQUIRES: kMinRomBits <= bits <= kMaxRomBits.
  Rom(int bits, RomForm form, RomCorrection correction)
      : bits_(bits), form_(form), correction_(correction) {}

  /// Words of n digits, 0 <= phi <= pi / 2. The difference form sums the
  /// differences from the node of the last call (or from an end of the table
  /// if that is nearer), so its cost grows with the distance.
  SinCos at(std::int64_t phi, int n);

 private:
  struct Node {
    std::int64_t cos;
    std::int64_t sin;
  };
  Node node(std::int64_t index);

  int bits_;
  RomForm form_;
  RomCorrection correction_;
  std::int64_t last_ = 0;  ///< the node whose values are summed up
  Node sum_{std::int64_t{1} << kAngleBits, 0};
};

}  // namespace unstep::interpolation
