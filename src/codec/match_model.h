#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unstep::codec {

/// Finds the last place where the same kMinimum turns occurred and predicts
/// what followed there. Remembers the last 2^18 turns. REQUIRES: at most 32.
template <unsigned kMinimum>
class TurnMatch {
 public:
  TurnMatch() : turns_(kSize, 3), heads_(std::size_t{1} << 16) {}

  /// 0..7: how long the match is, 0 for none.
  [[nodiscard]] unsigned confidence() const {
    static constexpr std::array<std::uint16_t, 6> kSteps{16, 20, 28,
                                                         40, 80, 200};
    if (length_ == 0) return 0;
    unsigned level = 1;
    for (const std::uint16_t step : kSteps) level += length_ > step ? 1U : 0U;
    return level;
  }
  /// The predicted turn; meaningful if confidence() > 0.
  [[nodiscard]] unsigned prediction() const { return turns_[match_ % kSize]; }

  void push(unsigned turn) {
    if (length_ > 0) {
      length_ = prediction() == turn ? length_ + 1 : 0;
      ++match_;
    }
    turns_[end_++ % kSize] = static_cast<std::uint8_t>(turn);
    hash_ = hash_ << 2 | turn;
    const std::uint64_t key = (hash_ & kLooked) * 0x9e3779b97f4a7c15ULL >> 48;
    if (length_ == 0) find(heads_[key]);
    heads_[key] = end_;
  }

 private:
  static constexpr std::size_t kSize = std::size_t{1} << 18;
  /// The turns by which a place is found.
  static constexpr std::uint64_t kLooked = ~std::uint64_t{0} >>
                                           (64 - 2 * kMinimum);

  void find(std::uint32_t candidate) {
    if (candidate == 0 || end_ - candidate >= kSize - 64) return;
    std::uint32_t same = 0;
    while (same < 32 && same < candidate &&
           turns_[(candidate - 1 - same) % kSize] ==
               turns_[(end_ - 1 - same) % kSize]) {
      ++same;
    }
    if (same < kMinimum) return;
    length_ = same;
    match_ = candidate;
  }

  std::vector<std::uint8_t> turns_;
  std::vector<std::uint32_t> heads_;
  std::uint64_t hash_ = 0;
  std::uint32_t end_ = 1;
  std::uint32_t match_ = 0;
  std::uint32_t length_ = 0;
};

using MatchModel = TurnMatch<16>;

}  // namespace unstep::codec
