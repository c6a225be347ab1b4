#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/program_line.h"

/// Coder 28: programs under mixed models, docs/format.md.
namespace unstep::codec {

inline constexpr std::uint8_t kProgramRevision = 0;

/// What holds for all lines of a program.
struct ProgramFrame {
  std::uint32_t words = 0;  ///< that any motion has
  /// Decimals of the numbers, by group: lengths, angles, E, F, S.
  std::array<int, 5> decimals{};
};

/// The group of a word.
[[nodiscard]] constexpr std::size_t program_group(std::size_t word) {
  if (word >= 3 && word <= 5) return 1;
  if (word == kWordE) return 2;
  if (word == 14) return 3;
  return word == 15 ? 4 : 0;
}

/// log2 of the model's counters per context, a rule of the program's lines
/// only, so that it need not be stored.
[[nodiscard]] constexpr int program_table_bits(std::uint64_t lines) {
  return lines < 1'000 ? 14 : lines < 10'000 ? 16 : 18;
}

}  // namespace unstep::codec
