#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// The warm start: what the models of coder 1 know before the first bit,
/// learned from other drawings. tests/bench/train_warm_start.cpp makes
/// warm_start_table.cpp; docs/format.md says how it is applied. Part of the
/// format: a changed table is a new table id.
namespace unstep::codec::warm {

inline constexpr std::uint8_t kTableId = 1;
inline constexpr std::size_t kTurnContexts = 12;
inline constexpr std::size_t kStartContexts = 3;
inline constexpr std::size_t kContexts = kTurnContexts + kStartContexts;
inline constexpr std::size_t kFlags = 1664;

/// How a slot starts. Eight characters of the table, six bits each, hold
/// index 16, check 12, two stretches 6 + 6, two ages 4 + 4.
struct Record {
  std::uint16_t index = 0;  ///< upper 16 bits of the context's hash
  std::uint16_t check = 0;  ///< its 12 check bits
  std::array<std::uint16_t, 2> p{};
  std::array<std::uint8_t, 2> n{};
};

/// Six bits to and from a printable character that needs no escape.
constexpr char to_char(unsigned value) {
  const char c = static_cast<char>('0' + value);
  return c == '\\' ? 'p' : c;
}
constexpr unsigned from_char(char c) {
  return static_cast<unsigned>((c == 'p' ? '\\' : c) - '0');
}

inline constexpr std::array<std::uint8_t, 16> kAges{
    0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 22, 26, 30, 40};

Record parse(std::string_view eight);

/// Calls `apply(record)` for the records of one context.
template <class Apply>
void for_each(std::size_t context, Apply apply);

// The generated table.
extern const std::array<std::uint16_t, kContexts> kCounts;
extern const std::string_view kRecords;
extern const std::array<std::array<std::int16_t, 32>, 2> kTurnWeights;
extern const std::array<std::array<std::int16_t, 8>, 1> kStartWeights;
extern const std::array<std::array<std::uint16_t, 2>, kFlags> kFlagStart;

template <class Apply>
void for_each(std::size_t context, Apply apply) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < context; ++i) first += kCounts[i];
  for (std::size_t i = 0; i < kCounts[context]; ++i) {
    apply(parse(kRecords.substr((first + i) * 8, 8)));
  }
}

}  // namespace unstep::codec::warm
