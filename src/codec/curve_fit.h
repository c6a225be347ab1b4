#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/crack_map.h"

namespace unstep::codec {

/// Foretells where a walk along a smooth curve will cross the next column or
/// row: the least squares line and parabola through its last places, and the
/// line through its last distances from the curves beside it.
///
/// Places are sampled per axis: at every step along x the y of the walk, at
/// every step along y its x. What is kept are differences of neighbours,
/// latest first, so that a forecast is one sum of products.
class CurveFit {
 public:
  /// Distances from a crack to the nearest known one parallel to it, towards
  /// greater and towards lesser coordinates; 0: none seen.
  using Gaps = std::array<int, 2>;

  void begin() { axes_ = {}; }

  /// The walk has made a step and stands at (x, y) from its start, each within
  /// 2^30; `gaps` are those of the crack it walked.
  void step(Quarter direction, std::int32_t x, std::int32_t y,
            const Gaps& gaps);

  /// Where the next step along an axis (0: x, 1: y) would lead.
  [[nodiscard]] Quarter heading(std::size_t axis) const {
    return static_cast<Quarter>(axes_[axis].sign < 0 ? axis + 2 : axis);
  }

  /// What is expected, as contexts below 2^16.
  struct Forecast {
    std::uint64_t curve = 0;  ///< from the walk's own past
    std::uint64_t right = 0;  ///< from the curve to the right
    std::uint64_t left = 0;
  };
  /// For a walk at (x, y) that has just gone in `direction` and moves mostly
  /// along `axis`; `gaps` are those of the crack in direction heading(axis).
  [[nodiscard]] Forecast forecast(std::size_t axis, Quarter direction,
                                  std::int32_t x, std::int32_t y,
                                  const Gaps& gaps) const;

 private:
  static constexpr std::size_t kSamples = 32;
  static constexpr std::int32_t kJump = 24;  ///< a longer step is a corner
  static constexpr int kGapJump = 3;

  /// Values in a row, as differences.
  struct Series {
    std::array<std::int16_t, kSamples> steps{};  ///< latest first
    unsigned count = 0;                          ///< of values
    std::int32_t last = 0;

    void push(std::int32_t value, std::int32_t jump);
  };
  struct Axis {
    Series places;
    std::array<Series, 2> gaps;
    int sign = 0;
    int error = 0;  ///< running mean of 1/256 unit of the line's forecast
  };

  std::array<Axis, 2> axes_{};
};

}  // namespace unstep::codec
