#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "codec/warm_start.h"

/// The warm start of deep turns in small drawings: what DeepTurnModel knows
/// before the first bit under revision 1 of coder 1. tests/bench/
/// train_deep_turns.cpp makes deep_warm_start.cpp. A part of table 1.
namespace unstep::codec::warm {

struct DeepTable {
  static constexpr std::size_t kContexts = 30;
  static constexpr std::size_t kInputs = 96;
  static constexpr std::size_t kNumber =
      3;  ///< characters of a vector's number

  std::array<std::uint16_t, kContexts> counts;  ///< of records, by context
  std::string_view records;                     ///< all of them, parse()
  std::string_view vectors;                     ///< for_each_vector()
  /// What all vectors of a decision begin with, 12 fractional bits.
  std::array<std::array<std::int16_t, kInputs>, 2> weights;
};

extern const DeepTable kDeepTurns;

}  // namespace unstep::codec::warm
