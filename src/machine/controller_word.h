#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "machine/zenit_commands.h"
#include "unstep/result.h"

/// The words between the computer and the modules of "Zenit".
namespace unstep::machine {

/// The 36 lines of a word beside the strobe.
struct ControllerWord {
  std::uint8_t address = 0;   ///< A, 8 lines
  std::uint8_t function = 0;  ///< F, 2 lines: 0 act, 1 write, 3 read
  std::uint32_t data = 0;     ///< W, 26 lines
  friend bool operator==(const ControllerWord&,
                         const ControllerWord&) = default;
};

using WordBytes = std::array<std::uint8_t, 5>;
using ReadBytes = std::array<std::uint8_t, 3>;

/// Five bytes, most significant first: 0 0 0 strobe A7..A4 | A3..A0 F1 F0 W25
/// W24 | W23..W0. The layout is ours, the article names the counts only. The
/// strobe is the 37th bit of the register; it is 1 in every word sent.
/// REQUIRES: function < 4, data < 2^26.
[[nodiscard]] WordBytes pack_word(const ControllerWord& word);

/// corrupt if the strobe is 0 or one of the three bits above it is not.
[[nodiscard]] Result<ControllerWord> unpack_word(const WordBytes& bytes);

/// Three bytes of the read bus R, most significant first.
[[nodiscard]] ReadBytes pack_read(std::uint32_t word);
[[nodiscard]] std::uint32_t unpack_read(const ReadBytes& bytes);

/// The way of a command onto the lines, ours again. Every printed code is
/// 2 bits of function, a 0, two octal digits and a last digit 5, so
///     F1 F0 = bits 11 and 10, A5..A0 = the two digits in the middle,
///     A7 A6 = the module, W25 = the axis, W24 = 0, W23..W0 = the data
/// keeps all of (module, axis, code). REQUIRES: data < 2^24.
[[nodiscard]] ControllerWord encode_command(const Command& command,
                                            std::uint32_t data = 0);

/// The command of a word; nullptr if the table has none.
[[nodiscard]] const Command* decode_command(const ControllerWord& word);

/// The 24 bits of data in a word.
[[nodiscard]] constexpr std::uint32_t command_data(const ControllerWord& word) {
  return word.data & 0xffffff;
}

/// Direct code: bit 23 is the sign, the rest the magnitude; 0 is positive.
/// REQUIRES: |value| < 2^23.
[[nodiscard]] constexpr std::uint32_t to_direct_code(std::int32_t value) {
  return value < 0 ? 0x800000U | static_cast<std::uint32_t>(-value)
                   : static_cast<std::uint32_t>(value);
}
[[nodiscard]] constexpr std::int32_t from_direct_code(std::uint32_t word) {
  const auto magnitude = static_cast<std::int32_t>(word & 0x7fffff);
  return (word & 0x800000) != 0 ? -magnitude : magnitude;
}

}  // namespace unstep::machine
