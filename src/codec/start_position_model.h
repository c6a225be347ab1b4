#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/decision_model.h"
#include "codec/density_grid.h"
#include "codec/number_model.h"
#include "codec/vector_classes.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// The range of all x: below 2^levels, levels 0..31, and from 0 or, if there
/// are negative ones, -2^levels.
struct StartFrame {
  bool negative = false;
  int levels = 0;

  void add(std::int32_t x) {
    negative |= x < 0;
    const auto size = static_cast<std::uint32_t>(x < 0 ? -x : x);
    levels = std::max(levels, static_cast<int>(std::bit_width(size)));
  }
};

/// Predicts where paths and chains start: y from the path before, then x by
/// halving the range, with the vertices and the starts that are already there
/// on either side as contexts.
class StartPositionModel {
 public:
  static constexpr std::size_t kContexts = 10;
  using Decisions = DecisionModel<kContexts>;

  explicit StartPositionModel(int table_bits);

  /// Starts are in the order of their rows, as contours of a drawing are.
  void expect_rows() {
    for (std::size_t i = 0; i < down_.size(); ++i) {
      down_[i].expect(kDownWidths[i], kDownDigits, 1);
    }
  }

  /// What holds for all starts, coded first.
  template <class Coder>
  void code_frame(Coder& coder, const StartFrame& frame) {
    const bool negative = coder.code(frame.negative, 1024);
    int levels = 0;
    for (int bit = 4; bit >= 0; --bit) {
      const bool one = coder.code((frame.levels >> bit & 1) != 0,
                                  kLevelBits[static_cast<std::size_t>(bit)]);
      levels |= one ? 1 << bit : 0;
    }
    levels_ = levels + (negative ? 1 : 0);
    lowest_ = negative ? -(std::int64_t{1} << levels) : 0;
  }

  /// What was coded; y may be out of the range of coordinates.
  template <class Coder>
  Vec code(Coder& coder, Point start, const DensityGrid& density) {
    const std::int64_t dy =
        down_[down_before_].code(coder, std::int64_t{start.y} - before_.y);
    const std::int64_t size = dy < 0 ? -dy : dy;
    down_before_ = size == 0 ? 0 : size < 4 ? 1 : size < 64 ? 2 : 3;
    const std::int64_t y = before_.y + dy;
    const bool same_row = dy == 0;
    std::int64_t low = lowest_;
    for (int level = levels_; level > 0; --level) {
      const std::int64_t middle = low + (std::int64_t{1} << (level - 1));
      const auto selectors = set_contexts(density, low, level, y, same_row);
      const bool right =
          decisions_.code(coder, start.x >= middle,
                          static_cast<std::uint32_t>(level), selectors);
      if (right) low = middle;
    }
    before_ = {low, y};
    starts_.add({static_cast<std::int32_t>(low), static_cast<std::int32_t>(y)});
    return before_;
  }

  /// As if nothing had been coded; what was learned is kept.
  void restart() {
    starts_ = DensityGrid(kStartBits);
    before_ = {};
    down_before_ = 0;
  }

  [[nodiscard]] Decisions& decisions() { return decisions_; }

 private:
  static constexpr int kStartBits = 12;
  /// Of 65536, that a bit of the levels is 1, the lowest first: most drawings
  /// are 2^8 to 2^12 wide.
  static constexpr std::array<int, 5> kLevelBits{32768, 32768, 16384, 49152,
                                                 4096};
  static constexpr std::array<std::array<std::uint8_t, 8>, 4> kDownWidths{{
      {184, 174, 178, 170, 183, 141, 50, 19},
      {195, 177, 149, 140, 97, 79, 81, 57},
      {195, 185, 183, 176, 124, 97, 73, 62},
      {203, 223, 234, 230, 106, 178, 101, 33},
  }};
  static constexpr std::array<std::uint8_t, 11> kDownDigits{
      66, 111, 110, 112, 92, 110, 97, 110, 105, 103, 120};

  std::array<std::uint32_t, 2> set_contexts(const DensityGrid& density,
                                            std::int64_t low, int level,
                                            std::int64_t y, bool same_row);

  Decisions decisions_;
  DensityGrid starts_{kStartBits};
  std::array<SignedNumberModel, 4> down_;
  std::size_t down_before_ = 0;
  Vec before_;
  int levels_ = 0;
  std::int64_t lowest_ = 0;
};

}  // namespace unstep::codec
