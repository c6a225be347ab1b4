#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// A line of a program that is a motion and nothing else, in the one form that
/// write_gcode gives it.
namespace unstep::codec {

/// The words of a motion in the order in which they stand.
inline constexpr std::string_view kProgramLetters = "XYZABCUVWEIJKRFS";
inline constexpr std::size_t kProgramWords = 16;
inline constexpr std::size_t kProgramAxisWords = 10;  ///< X to E
inline constexpr std::size_t kWordE = 9;
inline constexpr std::size_t kWordI = 10;
inline constexpr std::size_t kWordJ = 11;
inline constexpr std::size_t kWordR = 13;

/// Numbers have up to 7 decimals and are below this in units of the last.
inline constexpr std::int64_t kMaxProgramNumber = 2'000'000'000'000'000;
inline constexpr int kMaxProgramDecimals = 7;

struct ProgramLine {
  int motion = -1;          ///< 0..3 for G0..G3, -1: no G word
  std::uint32_t words = 0;  ///< which of kProgramLetters
  std::array<std::int64_t, kProgramWords> value{};  ///< times 10^7

  [[nodiscard]] bool has(std::size_t word) const {
    return (words >> word & 1) != 0;
  }
};

/// The line as a motion; nothing unless append_line gives the same text.
[[nodiscard]] std::optional<ProgramLine> parse_line(std::string_view text);

/// "G1 X1.5 Y-2", without an end of line. REQUIRES: |value| within
/// kMaxProgramNumber; a word or a G.
void append_line(std::string& out, const ProgramLine& line);

/// The fewest decimals that a value needs, 0..7.
[[nodiscard]] int decimals_of(std::int64_t value);

}  // namespace unstep::codec
