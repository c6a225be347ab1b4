#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/program_line.h"

/// The motions of a program so far, and where it was before.
namespace unstep::codec {

/// A motion as the models see it, in units of the frame's decimals.
struct ProgramMotion {
  int motion = 1;                                   ///< 0..3, in force
  std::uint32_t words = 0;                          ///< of its line
  std::array<std::int64_t, kProgramWords> value{};  ///< of the words there
  std::array<std::int64_t, kProgramAxisWords> from{};
  std::array<std::int64_t, kProgramAxisWords> to{};

  [[nodiscard]] std::int64_t delta(std::size_t axis) const {
    return to[axis] - from[axis];
  }
  [[nodiscard]] bool has(std::size_t word) const {
    return (words >> word & 1) != 0;
  }
};

/// What an earlier place of the program expects to come next.
struct ProgramGuess {
  const ProgramMotion* next = nullptr;
  unsigned length = 0;  ///< motions that it has foretold
};

/// Of the length of a guess: its bits, 0..7.
[[nodiscard]] inline unsigned length_class(unsigned length) {
  return std::min(static_cast<unsigned>(std::bit_width(length)), 7U);
}

/// Remembers the last 2^16 motions and finds earlier ones: the same two
/// vectors, the same two places, the same place.
class ProgramHistory {
 public:
  static constexpr std::uint64_t kSize = std::uint64_t{1} << 16;

  ProgramHistory();

  /// Motion `back` before the next, from 1; one without words if there is none.
  [[nodiscard]] const ProgramMotion& before(std::size_t back) const {
    return back <= end_ && back < kSize ? motion(end_ - back) : none_;
  }
  [[nodiscard]] const std::array<std::int64_t, kProgramAxisWords>& at() const {
    return at_;
  }
  /// Where the last rapid ended.
  [[nodiscard]] const std::array<std::int64_t, kProgramAxisWords>& home()
      const {
    return home_;
  }

  [[nodiscard]] ProgramGuess by_vectors() const { return guess(vectors_); }
  [[nodiscard]] ProgramGuess by_places() const { return guess(places_); }
  /// The motion that left this place before, and the one that led there.
  [[nodiscard]] const ProgramMotion* left_here() const;
  [[nodiscard]] const ProgramMotion* led_here() const;

  void push(const ProgramMotion& motion);

 private:
  static constexpr int kHeadBits = 16;
  struct Match {
    std::vector<std::uint64_t> heads;  ///< one behind a motion; 0: none
    std::uint64_t at = 0;              ///< the motion that is expected
    unsigned length = 0;
  };

  [[nodiscard]] const ProgramMotion& motion(std::uint64_t index) const {
    return motions_[static_cast<std::size_t>(index % kSize)];
  }
  /// Whether the motion with this number has not been forgotten.
  [[nodiscard]] bool remembers(std::uint64_t index) const {
    return index < end_ && end_ - index < kSize;
  }
  [[nodiscard]] ProgramGuess guess(const Match& match) const;
  void follow(Match& match, bool foretold, std::uint64_t hash);

  std::vector<ProgramMotion> motions_;  ///< by number modulo kSize
  std::uint64_t end_ = 0;               ///< number of the next
  ProgramMotion none_;
  std::array<std::int64_t, kProgramAxisWords> at_{};
  std::array<std::int64_t, kProgramAxisWords> home_{};
  Match vectors_;
  Match places_;
  std::vector<std::uint64_t> visits_;  ///< by place: one behind a motion
  std::uint64_t visit_ = 0;            ///< of this place before
};

}  // namespace unstep::codec
