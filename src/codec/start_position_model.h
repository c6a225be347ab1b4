#pragma once

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

/// Predicts where paths start: y from the path before, then x by halving the
/// range, with the vertices already there on either side as contexts.
class StartPositionModel {
 public:
  static constexpr std::size_t kContexts = 7;
  using Decisions = DecisionModel<kContexts>;
  static constexpr int kMaxLevels = 31;

  explicit StartPositionModel(int table_bits);

  /// x is within 0..2^levels - 1, or -2^levels..2^levels - 1 if negative.
  void set_range(int levels, bool negative) {
    levels_ = levels + (negative ? 1 : 0);
    lowest_ = negative ? -(std::int64_t{1} << levels) : 0;
  }

  /// What was coded; y may be out of the range of coordinates.
  template <class Coder>
  Vec code(Coder& coder, Point start, const DensityGrid& density) {
    const std::int64_t dy =
        down_[down_before_].code(coder, std::int64_t{start.y} - before_.y);
    down_before_ = dy == 0 ? 0 : dy > 0 && dy < 4 ? 1 : dy > 0 ? 2 : 3;
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
    return before_;
  }

  [[nodiscard]] Decisions& decisions() { return decisions_; }

 private:
  std::array<std::uint32_t, 2> set_contexts(const DensityGrid& density,
                                            std::int64_t low, int level,
                                            std::int64_t y, bool same_row);

  Decisions decisions_;
  std::array<SignedNumberModel, 4> down_;
  std::size_t down_before_ = 0;
  Vec before_;
  int levels_ = 0;
  std::int64_t lowest_ = 0;
};

}  // namespace unstep::codec
