#include "machine/controller_word.h"

namespace unstep::machine {
namespace {

constexpr std::uint64_t kStrobe = std::uint64_t{1} << 36;
constexpr unsigned kLastDigit = 5;
constexpr std::uint32_t kAxisLine = 1U << 25;

}  // namespace

WordBytes pack_word(const ControllerWord& word) {
  const std::uint64_t lines = kStrobe | std::uint64_t{word.address} << 28 |
                              std::uint64_t{word.function} << 26 |
                              std::uint64_t{word.data};
  WordBytes bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(lines >> (8 * (4 - i)));
  return bytes;
}

Result<ControllerWord> unpack_word(const WordBytes& bytes) {
  std::uint64_t lines = 0;
  for (const std::uint8_t byte : bytes) lines = lines << 8 | byte;
  if (lines >> 36 != 1)
    return Error{ErrorCode::corrupt,
                 "controller word, byte 0: the strobe must be 1 and the three "
                 "bits above it 0"};
  ControllerWord word;
  word.address = static_cast<std::uint8_t>(lines >> 28);
  word.function = static_cast<std::uint8_t>(lines >> 26 & 3);
  word.data = static_cast<std::uint32_t>(lines & 0x3ffffff);
  return word;
}

ReadBytes pack_read(std::uint32_t word) {
  return {static_cast<std::uint8_t>(word >> 16),
          static_cast<std::uint8_t>(word >> 8),
          static_cast<std::uint8_t>(word)};
}

std::uint32_t unpack_read(const ReadBytes& bytes) {
  return std::uint32_t{bytes[0]} << 16 | std::uint32_t{bytes[1]} << 8 |
         bytes[2];
}

ControllerWord encode_command(const Command& command, std::uint32_t data) {
  const unsigned module = static_cast<unsigned>(command.module);
  const unsigned digits = command.code >> 3U & 077U;
  ControllerWord word;
  word.address = static_cast<std::uint8_t>(module << 6 | digits);
  word.function = static_cast<std::uint8_t>(command.code >> 10);
  word.data = data | (command.axis == Axis::y ? kAxisLine : 0);
  return word;
}

const Command* decode_command(const ControllerWord& word) {
  const unsigned code =
      unsigned{word.function} << 10 | (word.address & 077U) << 3 | kLastDigit;
  return find_command(static_cast<Module>(word.address >> 6),
                      (word.data & kAxisLine) != 0 ? Axis::y : Axis::x,
                      static_cast<std::uint16_t>(code));
}

}  // namespace unstep::machine
