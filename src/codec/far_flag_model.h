#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/counter.h"
#include "entropy/mixer.h"

namespace unstep::codec {

/// 0..7: how many rows ago the last far start was, an octave apart.
[[nodiscard]] inline std::size_t far_start_age(std::int32_t rows) {
  return static_cast<std::size_t>(
      std::min<unsigned>(std::bit_width(static_cast<unsigned>(rows) / 2), 7));
}

/// Predicts whether one of a word's far points is a start of a contour: mixes
/// the counter that the start model knows it by with three that see how often
/// such starts came around here (docs/format.md, Far starts).
class FarFlagModel {
 public:
  /// `words`: of 64 columns.
  explicit FarFlagModel(std::size_t words);

  /// What a flag is asked under.
  struct Sight {
    bool ink = false;
    std::size_t size = 0;  ///< 0..3: how many points there are
    std::size_t row = 0;   ///< 0..3: starts in this row before
    std::array<std::size_t, 3>
        ages{};  ///< 0..7: of the words left, here, right
  };

  /// Rows come one after another from 0.
  void begin_row(std::int32_t y);

  /// The probability of 65536 that a point of the word is a start. `known`
  /// must live until update().
  int predict(entropy::Counter& known, std::size_t word, const Sight& sight);
  void update(bool any);
  /// A start that no flag of this model has told.
  void count(std::size_t word, bool ink);

 private:
  static constexpr std::size_t kContexts = 3;
  static constexpr int kContextBits = 12;
  static constexpr std::int32_t kRows = 4;  ///< between looks at the density

  /// Starts of one colour in each word, decaying over the rows; 4096 is one.
  /// A word more on either side.
  struct Density {
    std::vector<std::uint32_t> quick, slow;
    std::vector<std::array<std::uint8_t, 3>> levels;  ///< quick, slow, wide
  };
  static void look(Density& density);

  std::array<Density, 2> density_;
  std::vector<entropy::Counter> counters_;
  std::array<entropy::Counter*, kContexts + 1> active_{};
  std::uint32_t* quick_ = nullptr;  ///< where a start is counted
  std::uint32_t* slow_ = nullptr;
  entropy::Mixer<8, 1> mixer_;
};

}  // namespace unstep::codec
