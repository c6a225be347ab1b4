#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/context.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// What a walk of unit steps in eight directions has done so far, as contexts.
/// A turn is the difference of a step to the one before, modulo 8.
class ChainTrack {
 public:
  explicit ChainTrack(YAxis axis) : axis_(axis) {}

  /// A walk starts at a point, as if it had come there along `direction`.
  void begin(Point origin, Step direction) {
    origin_ = origin;
    direction_ = direction;
    history_ = kNoHistory;
    runs_ = {};
    bends_ = {};
    steps_ = 0;
    here_ = {origin, 0};
    trail_[0] = here_;
  }

  void advance(unsigned turn) {
    history_ = history_ << 3 | turn;
    if (turn == 0) {
      ++runs_[0];
    } else {
      runs_ = {0, runs_[0], runs_[1], runs_[2]};
      bends_ = {static_cast<std::uint8_t>(turn), bends_[0], bends_[1]};
    }
    direction_ = static_cast<Step>((direction_ + turn) & 7U);
    const Point move = step_delta(direction_, axis_);
    here_.area += static_cast<std::uint64_t>(
        (std::int64_t{here_.at.y} - origin_.y) * move.x -
        (std::int64_t{here_.at.x} - origin_.x) * move.y);
    here_.at.x += move.x;
    here_.at.y += move.y;
    trail_[++steps_ % trail_.size()] = here_;
  }

  [[nodiscard]] Point origin() const { return origin_; }
  [[nodiscard]] Point position() const { return here_.at; }
  [[nodiscard]] Step direction() const { return direction_; }
  /// Since the start, modulo 2^32.
  [[nodiscard]] std::uint32_t steps() const { return steps_; }

  /// The last turns, three bits each, the latest lowest.
  [[nodiscard]] std::uint64_t history(unsigned turns) const {
    return history_ & ((std::uint64_t{1} << (3 * turns)) - 1);
  }
  /// Straight steps since the last turn (k = 0), between the two before ...
  [[nodiscard]] std::uint64_t run(std::size_t k, std::uint32_t limit) const {
    return std::min(runs_[k], limit);
  }
  /// The last three turns that were some, three bits each.
  [[nodiscard]] std::uint64_t bends() const {
    return bends_[0] | std::uint64_t{bends_[1]} << 3 |
           std::uint64_t{bends_[2]} << 6;
  }

  /// A vector in the frame of the current quarter.
  [[nodiscard]] Point in_frame(Point v) const {
    for (unsigned q = 0; q < direction_ / 2U; ++q) {
      v = axis_ == YAxis::up ? Point{v.y, -v.x} : Point{-v.y, v.x};
    }
    return v;
  }

  /// The last steps as a vector in that frame, 0 if there are fewer.
  /// REQUIRES: steps <= 64.
  [[nodiscard]] std::uint64_t chord(std::uint32_t steps) const {
    if (steps_ < steps) return 0;
    const Point from = trail_[(steps_ - steps) % trail_.size()].at;
    const Point v = in_frame({here_.at.x - from.x, here_.at.y - from.y});
    return static_cast<std::uint64_t>((v.x + 128) << 9 | (v.y + 128) << 1 |
                                      (direction_ & 1));
  }

  /// Doubled area between the last steps and their chord (F of SU 1089551).
  [[nodiscard]] unsigned bulge(std::uint32_t steps) const {
    if (steps_ < steps) return 0;
    const Trail& from = trail_[(steps_ - steps) % trail_.size()];
    const std::int64_t dx = std::int64_t{here_.at.x} - from.at.x;
    const std::int64_t dy = std::int64_t{here_.at.y} - from.at.y;
    const std::int64_t x = std::int64_t{from.at.x} - origin_.x;
    const std::int64_t y = std::int64_t{from.at.y} - origin_.y;
    return quantise_area(static_cast<std::int64_t>(here_.area - from.area) -
                         (y * dx - x * dy));
  }

 private:
  struct Trail {
    Point at;
    std::uint64_t area = 0;  ///< modulo 2^64: a long walk may wind many times
  };
  /// Stands for the turns before the first step.
  static constexpr std::uint64_t kNoHistory = 0x4924924924924924ULL;

  YAxis axis_;
  Point origin_;
  Step direction_ = 0;
  std::uint64_t history_ = kNoHistory;
  std::array<std::uint32_t, 4> runs_{};
  std::array<std::uint8_t, 3> bends_{};
  std::uint32_t steps_ = 0;
  Trail here_;
  std::array<Trail, 64> trail_{};  ///< the last positions, by steps_ % 64
};

}  // namespace unstep::codec
