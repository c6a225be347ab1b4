#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/context.h"
#include "codec/vector_classes.h"

namespace unstep::codec {

/// Finds the last place where the same two vectors followed each other and
/// says which came next there. Remembers the last 2^16 vectors.
class VectorMatch {
 public:
  VectorMatch() : vectors_(kSize), heads_(std::size_t{1} << kHeadBits) {}

  /// A path starts.
  void begin() {
    length_ = 0;
    before_ = {};
  }

  /// How many vectors the match has foretold so far, 0 for no match.
  [[nodiscard]] unsigned length() const { return length_; }
  /// The expected vector; zero if there is none.
  [[nodiscard]] Vec expected() const {
    return length_ > 0 ? vectors_[at_ % kSize] : Vec{};
  }

  void push(const Vec& v) {
    if (length_ > 0) {
      length_ = expected() == v ? std::min(length_ + 1, 1000U) : 0;
      ++at_;
    }
    vectors_[end_++ % kSize] = v;
    if (!before_.zero()) {
      const std::uint64_t hash =
          mix(mix(word(v), word(before_)), 0) * kGolden >> (64 - kHeadBits);
      std::uint64_t& head = heads_[hash];
      if (length_ == 0) find(head);
      head = end_;
    }
    before_ = v;
  }

 private:
  static constexpr std::uint64_t kSize = std::uint64_t{1} << 16;
  static constexpr int kHeadBits = 14;

  static std::uint64_t word(const Vec& v) {
    return static_cast<std::uint64_t>(v.x) << 32 ^
           static_cast<std::uint64_t>(v.y);
  }

  /// `candidate` is one behind the later of two vectors, 0 for none.
  void find(std::uint64_t candidate) {
    if (candidate < 2 || end_ - candidate >= kSize - 2) return;
    if (vectors_[(candidate - 1) % kSize] != vectors_[(end_ - 1) % kSize] ||
        vectors_[(candidate - 2) % kSize] != before_) {
      return;
    }
    length_ = 1;
    at_ = candidate;
  }

  std::vector<Vec> vectors_;
  std::vector<std::uint64_t> heads_;
  Vec before_;
  std::uint64_t end_ = 0;
  std::uint64_t at_ = 0;
  unsigned length_ = 0;
};

}  // namespace unstep::codec
