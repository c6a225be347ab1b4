#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unstep::codec {

/// Finds the last place where the same kMinimum turns (0..7) of a chain
/// occurred and predicts what followed there. Remembers the last 2^18 turns.
class ChainMatch {
 public:
  static constexpr std::uint32_t kMinimum = 12;
  static constexpr std::uint32_t kLookBack = 32;

  ChainMatch() : turns_(kSize), heads_(std::size_t{1} << kHeadBits) {}

  /// 0..7: how long the match is, 0 for none.
  [[nodiscard]] unsigned confidence() const {
    static constexpr std::array<std::uint16_t, 6> kSteps{15, 20, 28,
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
      length_ =
          prediction() == turn ? length_ + (length_ < kLongest ? 1 : 0) : 0;
      ++match_;
    }
    turns_[end_++ % kSize] = static_cast<std::uint8_t>(turn);
    recent_ = (recent_ << 3 | turn) & ((std::uint64_t{1} << 3 * kMinimum) - 1);
    std::uint64_t& head =
        heads_[recent_ * 0x9e3779b97f4a7c15ULL >> (64 - kHeadBits)];
    if (length_ == 0) find(head);
    head = end_;
  }

 private:
  static constexpr std::uint64_t kSize = std::uint64_t{1} << 18;
  static constexpr int kHeadBits = 16;
  static constexpr std::uint32_t kLongest = 65535;

  /// 0 is no candidate: nothing has ended before the first turn.
  void find(std::uint64_t candidate) {
    if (candidate == 0 || end_ - candidate >= kSize - 2 * kLookBack) return;
    std::uint32_t same = 0;
    while (same < kLookBack && same < candidate &&
           turns_[(candidate - 1 - same) % kSize] ==
               turns_[(end_ - 1 - same) % kSize]) {
      ++same;
    }
    if (same < kMinimum) return;
    length_ = same;
    match_ = candidate;
  }

  std::vector<std::uint8_t> turns_;
  std::vector<std::uint64_t> heads_;
  std::uint64_t recent_ = 0;
  std::uint64_t end_ = 0;
  std::uint64_t match_ = 0;
  std::uint32_t length_ = 0;
};

}  // namespace unstep::codec
