#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/block_coder.h"
#include "codec/colour_run.h"
#include "codec/pixel_masks.h"
#include "codec/pixel_models.h"
#include "codec/pixel_rows.h"
#include "codec/pixel_runs.h"
#include "codec/pixel_slots.h"

namespace unstep::codec {

/// The order of coder 4, for both sides. Rows from the top, pixels from the
/// left. Where the colours around stay what they are along the row, a whole run
/// is one decision. Other pixels pass a gate, one counter under the nearest 16,
/// which codes alone if it is nearly certain. The rest is left to the model.
///
/// `Side` has coder(), truth(y), the words of a row or null for a decoder,
/// row(y, words) for a complete row, and damaged().
template <class Side, class Model>
class PixelScan {
 public:
  PixelScan(Side& side, std::int32_t width, std::int32_t rows)
      : side_(side),
        width_(width),
        height_(rows),
        rows_(width),
        masks_(width),
        gates_(kGates) {}

  static std::uint64_t memory(std::int32_t width) {
    return PixelRows::memory(width) + PixelMasks::memory(width) +
           PixelRuns::memory() + Model::memory() + kGates * sizeof(PixelSlot);
  }

  Status run(const BlockProgress& progress) {
    for (std::int32_t y = 0; y < height_; ++y) {
      if ((y & 63) == 0 && progress &&
          !progress(static_cast<std::uint64_t>(y))) {
        return Error{ErrorCode::cancelled, "cancelled"};
      }
      code_row(y);
      side_.row(y, at_[0]);
      if (side_.damaged()) {
        return Error{ErrorCode::corrupt, "pixels go on beyond their payload"};
      }
    }
    return {};
  }

 private:
  static constexpr std::size_t kGates = std::size_t{1} << 16;
  static constexpr int kGateRate = 7;  ///< of a gate that is nearly certain
  static constexpr int kLeft = 4;  ///< pixels before a run that have its colour

  using Row = std::uint64_t*;

  void code_row(std::int32_t y) {
    rows_.clear(y);
    for (std::int32_t k = 0; k < PixelWindow::kRows; ++k) {
      at_[static_cast<std::size_t>(k)] = rows_.row(y - k);
    }
    masks_.find(at_[1], at_[2]);
    runs_.begin_row();
    truth_ = side_.truth(y);
    for (std::int32_t x = 0; x < width_;) x = code_some(x);
  }

  /// Codes pixels from x on; returns where to go on.
  std::int32_t code_some(std::int32_t x) {
    PixelWindow window;
    window.look(at_, x);
    std::uint64_t edges = masks_.edges(x);
    std::uint64_t truth =
        truth_ != nullptr ? from(truth_, x) : std::uint64_t{0};
    const std::int32_t end = std::min(x + PixelWindow::kMoves, width_);
    const std::int32_t start = x;
    auto& coder = side_.coder();
    bool run = false;
    model_.skip();
    for (; x < end; ++x) {
      if ((edges >> 63) == 0 && quiet(window)) {
        run = true;
        break;
      }
      window.move(code_pixel(coder, (truth >> 63) != 0, window));
      edges <<= 1;
      truth <<= 1;
    }
    store(start, window.before(x - start), x - start);
    return run ? code_run(window, x) : x;
  }

  static bool quiet(const PixelWindow& window) {
    const std::uint64_t left = window.before(kLeft);
    return left == (window.cut(1, 0, 0) != 0 ? (1U << kLeft) - 1 : 0U);
  }

  template <class Coder>
  bool code_pixel(Coder& coder, bool truth, const PixelWindow& window) {
    const std::uint64_t near = window.near();
    PixelSlot& gate = gates_[near];
    const unsigned flip = gate.p >= 32768 ? 0xffffU : 0U;
    const unsigned rare = gate.p ^ flip;
    if (rare < Model::kRare) {
      const bool likely = flip != 0;
      const bool surprise =
          coder.code(truth != likely, static_cast<int>(rare) + 4);
      const unsigned now =
          surprise ? rare + ((65535 - rare) >> kGateRate)
                   : rare - ((rare + (1U << kGateRate) - 1) >> kGateRate);
      gate.p = static_cast<std::uint16_t>(now ^ flip);
      model_.skip();
      return likely != surprise;
    }
    const bool bit = model_.code(coder, truth, window, near, gate.p);
    gate.learn(bit);
    return bit;
  }

  /// A run from x on: where to go on after it, the pixel that ended it
  /// included.
  std::int32_t code_run(const PixelWindow& window, std::int32_t x) {
    const std::int32_t end = masks_.next_edge(x);
    PixelWindow ahead;
    ahead.look(at_, end);
    const auto above = static_cast<unsigned>(window.cut(1, 0, 0));
    const auto top = static_cast<unsigned>(window.cut(2, 0, 0));
    const bool ink = above != 0;
    const std::int32_t change =
        truth_ != nullptr ? first_other(truth_, x, end, ink) : end;
    const std::int32_t found = runs_.code_run(
        side_.coder(), change, x, end,
        {above | top << 1,
         PixelRuns::slope(window.alike_before(0) - window.alike_before(1)),
         PixelRuns::slope(ahead.alike_from(2) - ahead.alike_from(1))});
    if (ink) fill(x, found);
    if (found == end) return end;
    if (!ink) set(found);
    return found + 1;
  }

  void set(std::int32_t x) {
    at_[0][x >> 6] |= std::uint64_t{1} << (63 - (x & 63));
  }
  void fill(std::int32_t x, std::int32_t end) {
    while (x < end) {
      const std::int32_t count = std::min(end - x, 64 - (x & 63));
      at_[0][x >> 6] |= ~std::uint64_t{0} >> (64 - count)
                                                 << (64 - (x & 63) - count);
      x += count;
    }
  }
  /// `count` pixels, the last in the lowest bit, from x on.
  void store(std::int32_t x, std::uint64_t pixels, std::int32_t count) {
    if (count == 0) return;
    const std::uint64_t high = pixels << (64 - count);
    const auto shift = static_cast<unsigned>(x) & 63U;
    Row word = at_[0] + (x >> 6);
    word[0] |= high >> shift;
    word[1] |= high << 1 << (63 - shift);
  }
  /// 64 pixels from x on.
  [[nodiscard]] std::uint64_t from(const std::uint64_t* words,
                                   std::int32_t x) const {
    const auto shift = static_cast<unsigned>(x) & 63U;
    const std::int32_t word = x >> 6;
    std::uint64_t pixels = words[word] << shift;
    if (shift != 0 && (word + 1) * 64 < width_) {
      pixels |= words[word + 1] >> (64 - shift);
    }
    return pixels;
  }

  Side& side_;
  std::int32_t width_;
  std::int32_t height_;
  PixelRows rows_;
  PixelMasks masks_;
  PixelRuns runs_;
  Model model_;
  std::vector<PixelSlot> gates_;
  std::array<Row, PixelWindow::kRows> at_{};  ///< this row and those above
  const std::uint64_t* truth_ = nullptr;
};

}  // namespace unstep::codec
