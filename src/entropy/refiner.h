#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "entropy/counter.h"
#include "entropy/logistic.h"

namespace unstep::entropy {

/// Corrects a prediction by what followed like ones in the same context
/// (secondary estimation; M. Mahoney, "Data Compression Explained", 4.3.4):
/// counters over 17 stretches, between which it is interpolated.
class Refiner {
 public:
  explicit Refiner(std::size_t contexts) : counters_(contexts * kNodes) {
    for (std::size_t i = 0; i < counters_.size(); ++i) {
      const int x = static_cast<int>(i % kNodes) * kApart - kReach;
      counters_[i] = i < kNodes
                         ? Counter{static_cast<std::uint16_t>(squash(x)), kAge}
                         : counters_[i - kNodes];
    }
  }

  static std::uint64_t memory(std::size_t contexts) {
    return contexts * kNodes * sizeof(Counter);
  }

  /// The probability of 65536 in place of squash(x). REQUIRES: context is
  /// below the number given to the constructor.
  int refine(int x, std::size_t context) {
    const int at = std::clamp(x, -kReach, kReach - 1) + kReach;
    const int part = at % kApart;
    low_ = &counters_[context * kNodes + static_cast<std::size_t>(at / kApart)];
    return (low_[0].p * (kApart - part) + low_[1].p * part) / kApart;
  }

  /// What was predicted last has become `bit`.
  void learn(bool bit) {
    low_[0].update(bit);
    low_[1].update(bit);
  }

 private:
  static constexpr std::size_t kNodes = 17;
  static constexpr int kApart = 256;
  static constexpr int kReach = 2048;
  static constexpr std::uint8_t kAge = 20;

  std::vector<Counter> counters_;
  Counter* low_ = nullptr;
};

}  // namespace unstep::entropy
