#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/program_history.h"
#include "codec/program_line.h"

/// Where the numbers of a motion are expected, by several rules each.
namespace unstep::codec {

inline constexpr std::size_t kProgramPredictors = 14;
using ProgramPredictions = std::array<std::int64_t, kProgramPredictors>;

/// What is known of the motion that is being coded.
struct ProgramContext {
  const ProgramHistory& history;
  const ProgramMotion& motion;  ///< words, values and places so far
};

/// The latest moves of an axis, the last first.
struct AxisTrail {
  static constexpr std::size_t kLength = 8;
  std::array<std::int64_t, kLength> moves{};
  void push(std::int64_t move) {
    for (std::size_t i = kLength - 1; i > 0; --i) moves[i] = moves[i - 1];
    moves[0] = move;
  }
};

/// The moves of an axis, X to E, that the rules expect.
[[nodiscard]] ProgramPredictions predict_axis(const ProgramContext& context,
                                              std::size_t axis,
                                              const AxisTrail& trail);

/// I or J as they are expected, relative to the start; `other` is the one that
/// is known already, if any.
[[nodiscard]] ProgramPredictions predict_centre(const ProgramContext& context,
                                                std::size_t word,
                                                bool other_known,
                                                const AxisTrail& trail);

/// K, R, F or S, by those before.
[[nodiscard]] ProgramPredictions predict_word(const ProgramContext& context,
                                              std::size_t word,
                                              const AxisTrail& trail);

}  // namespace unstep::codec
