#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "codec/block_coder.h"
#include "codec/crack_map.h"
#include "codec/deep_turn_model.h"
#include "codec/fast_turn_model.h"
#include "codec/start_model.h"
#include "codec/turn_model.h"

namespace unstep::codec {

/// The warm start of a block.
template <class Turns>
const warm::Table& first_table(std::int32_t width, std::int32_t rows) {
  if constexpr (std::is_same_v<Turns, SmallTurnModel>) return warm::kSmall;
  return warm::table_for(width, rows, Turns::kClean);
}

/// Coder 1, both sides: the contours of a raster, found in raster order and
/// walked one by one. Encoder and decoder run this same code; `Side` is what
/// differs:
///
///     coder()                    an arithmetic encoder or decoder
///     starts(y, word)            the true contour starts, as far as known
///     any_start(y, word, count)  whether one of so many words has one
///     turn(x, y, direction, ink) the true turn of the walk
///     row(y, pixels)             a row of pixels is complete
///     damaged()                  the payload cannot be right; give up
///
/// The decoder's answers to the questions are never looked at.
template <class Side, class Turns>
class ContourScan {
 public:
  using Starts = typename Turns::Starts;

  ContourScan(Side& side, std::int32_t width, std::int32_t height,
              int table_bits, const warm::Table& start)
      : side_(side),
        cracks_(width, height),
        turns_(cracks_, table_bits, start),
        starts_(cracks_, start),
        above_((static_cast<std::size_t>(width) + 63) / 64) {}

  Status run(const BlockProgress& progress) {
    for (std::int32_t y = 0; y < cracks_.height(); ++y) {
      starts_.begin_row(y);
      const auto words = static_cast<std::int32_t>(above_.size());
      for (std::int32_t word = 0; word < words;) {
        const std::int32_t skipped = starts_.code_quiet_span(
            side_.coder(), word, above_, [&](std::int32_t count) {
              return side_.any_start(y, word, count, cracks_);
            });
        if (skipped > 0) {
          word += skipped;
        } else if (!scan_word(y, word++)) {
          return Error{
              ErrorCode::corrupt,
              "contour payload is damaged at row " + std::to_string(y)};
        }
      }
      complete_row(y);
      if (progress && y % 64 == 63 &&
          !progress(static_cast<std::uint64_t>(y) + 1)) {
        return Error{ErrorCode::cancelled, "cancelled"};
      }
    }
    return {};
  }

  [[nodiscard]] const Turns& turns() const { return turns_; }
  [[nodiscard]] const Starts& starts() const { return starts_; }

 private:
  bool scan_word(std::int32_t y, std::int32_t word) {
    const std::uint64_t above = above_[static_cast<std::size_t>(word)];
    const std::int32_t left = cracks_.width() - word * 64;
    const std::uint64_t used =
        left >= 64 ? ~std::uint64_t{0} : ~std::uint64_t{0} << (64 - left);
    std::uint64_t excluded = 0;  // candidates that are known to be none
    auto found = starts_.candidates(y, word, above, used);
    for (int ink = 0; ink < 2; ++ink) {
      for (;;) {
        const std::uint64_t mask =
            found.open[static_cast<std::size_t>(ink)] & ~excluded;
        if (mask == 0) break;
        const std::uint64_t bit =
            starts_.code_open(side_.coder(), mask, word, ink != 0,
                              side_.starts(y, word, cracks_));
        excluded |= bit == 0 ? mask : 0;
        if (bit == 0) break;
        if (!walk(word * 64 + std::countl_zero(bit), y, ink == 0)) return false;
        found = starts_.candidates(y, word, above, used);
      }
    }
    for (;;) {
      const std::uint64_t mask = found.likely & ~excluded;
      if (mask == 0) break;
      const std::uint64_t bit = std::bit_floor(mask);
      excluded |= bit;
      const std::uint64_t truth = side_.starts(y, word, cracks_);
      if (!starts_.code_one(side_.coder(), bit, word * 64, y, above, truth)) {
        continue;
      }
      if (!walk(word * 64 + std::countl_zero(bit), y, (above & bit) == 0)) {
        return false;
      }
      found = starts_.candidates(y, word, above, used);
    }
    for (;;) {
      // A walk can make a near candidate a likely one.
      const std::uint64_t mask = (found.near | found.likely) & ~excluded;
      if (mask == 0) break;
      const std::uint64_t truth = side_.starts(y, word, cracks_);
      const std::uint64_t bit =
          starts_.code_near(side_.coder(), mask, word * 64, y, above, truth);
      if (bit == 0) break;
      excluded |= ~(bit - 1);  // it and those before it
      if (!walk(word * 64 + std::countl_zero(bit), y, (above & bit) == 0)) {
        return false;
      }
      found = starts_.candidates(y, word, above, used);
    }
    return true;
  }

  /// Walks the contour that starts at (x, y) towards the east until it comes
  /// back, marking its cracks.
  bool walk(std::int32_t x, std::int32_t y, bool ink) {
    const CrackMap::Address start = cracks_.at(x, y);
    const std::int32_t top = y;
    CrackMap::Address point = start;
    CrackMap::Address flipped = cracks_.flipped_at(x, y);
    Quarter direction = 0;
    turns_.begin(start, flipped, ink);
    starts_.walked();
    for (;;) {
      cracks_.mark(point, flipped, direction);
      point += cracks_.step(direction);
      flipped += cracks_.flipped_step(direction);
      x += kQuarterDx[static_cast<std::size_t>(direction)];
      y += kQuarterDy[static_cast<std::size_t>(direction)];
      if (point == start) return true;
      const unsigned allowed = turns_.arrive() & inside(x, y, top, direction);
      Turn turn = kStraight;
      if (allowed != 0 && (allowed & (allowed - 1)) == 0) {
        turn = static_cast<Turn>(std::countr_zero(allowed));
      } else if (allowed == 0 || side_.damaged()) {
        return false;
      } else {
        turn = turns_.code(side_.coder(), side_.turn(x, y, direction, ink),
                           allowed);
      }
      turns_.advance(turn);
      direction = turned(direction, turn);
    }
  }

  /// The turns that stay inside the raster. A contour never goes north or west
  /// in the row of its start.
  [[nodiscard]] unsigned inside(std::int32_t x, std::int32_t y,
                                std::int32_t top, Quarter direction) const {
    if (x > 0 && x < cracks_.width() && y > top && y < cracks_.height()) {
      return 7;
    }
    unsigned allowed = 0;
    for (const Turn turn : {kStraight, kLeft, kRight}) {
      const Quarter q = turned(direction, turn);
      const bool in = q == 0   ? x < cracks_.width()
                      : q == 1 ? y < cracks_.height()
                      : q == 2 ? x > 0 && y > top
                               : y > top;
      if (in) allowed |= 1U << turn;
    }
    return allowed;
  }

  /// All cracks of the pixel row are known: its pixels follow by parity.
  void complete_row(std::int32_t y) {
    std::uint64_t carry = 0;
    for (std::size_t word = 0; word < above_.size(); ++word) {
      std::uint64_t bits =
          cracks_.vertical_word(y, static_cast<std::int32_t>(word));
      for (const unsigned shift : {1U, 2U, 4U, 8U, 16U, 32U}) {
        bits ^= bits >> shift;
      }
      bits ^= carry;
      carry = (bits & 1) != 0 ? ~std::uint64_t{0} : 0;
      above_[word] = bits;
    }
    side_.row(y, above_);
  }

  Side& side_;
  CrackMap cracks_;
  Turns turns_;
  Starts starts_;
  std::vector<std::uint64_t> above_;  ///< pixels of the row before
};

}  // namespace unstep::codec
