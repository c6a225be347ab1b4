#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "unstep/bitmap.h"

namespace unstep {

/// Squared Euclidean distances between pixel centres, row by row in memory of
/// a few rows. A. Meijster, J. Roerdink, W. Hesselink, "A general algorithm for
/// computing distance transforms in linear time", 2000; the first phase, along
/// columns, is done as the rows pass. Sides are below 2^30, so squares of
/// distances are below 2^61.
class RowDistances {
 public:
  /// Where there is none of what is looked for.
  static constexpr std::int64_t kNone = std::int64_t{1} << 62;

  enum class To : std::uint8_t {
    ink,   ///< the nearest ink pixel
    paper  ///< the nearest paper pixel; all around the raster is paper
  };

  /// `pixels` must outlive this.
  RowDistances(const Bitmap& pixels, To to);

  /// The squared distances of the pixels of row y, valid until the next call.
  /// REQUIRES: y is larger than in the call before.
  std::span<const std::int64_t> row(std::int32_t y);

 private:
  [[nodiscard]] bool wanted(std::size_t x, std::int32_t y) const {
    return pixels_.get(static_cast<std::int32_t>(x), y) == (to_ == To::ink);
  }
  void pass(std::int32_t y);
  void look_down(std::int32_t y);
  void envelope();

  /// A column's parabola, and the first x where it is the lowest.
  struct Bow {
    std::int64_t column;
    std::int64_t square;  ///< of the distance along the column
    std::int64_t from;
  };

  const Bitmap& pixels_;
  To to_;
  std::int32_t passed_ = 0;           ///< rows that `above_` knows
  std::vector<std::int32_t> above_;   ///< the last wanted row; -1: none
  std::vector<std::int32_t> below_;   ///< the next one; height: none
  std::vector<std::int64_t> column_;  ///< squares of distances along columns
  std::vector<Bow> bows_;
  std::vector<std::int64_t> squares_;
};

}  // namespace unstep
