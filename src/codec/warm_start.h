#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// The warm start: what the models of coder 1 know before the first bit,
/// learned from other drawings. tests/bench/train_warm_start.cpp makes
/// warm_start_small.cpp, warm_start_large.cpp and warm_start_clean.cpp;
/// docs/format.md says how they are applied. Part of the format: a changed
/// table is a new table id.
namespace unstep::codec::warm {

inline constexpr std::uint8_t kTableId = 1;
inline constexpr std::size_t kTurnContexts = 15;
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

/// 64 levels of a stored probability: stretches in steps of 72 / 256 around 0.
std::uint16_t probability(unsigned level);

/// What a character of a vector adds to a weight with 12 fractional bits, in
/// steps around 32.
inline constexpr int kWeightStep = 32;

/// Calls `apply(number, weights)` for the vectors of a mixer that do not begin
/// with `shared(number)`: kNumber characters hold the number, counted through
/// the sets, and one for each weight how much more it is. 12 fractional bits.
template <std::size_t kInputs, std::size_t kNumber = 2, class Shared,
          class Apply>
void for_each_vector(std::string_view text, Shared shared, Apply apply) {
  constexpr std::size_t kCharacters = kNumber + kInputs;
  for (; !text.empty(); text.remove_prefix(kCharacters)) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < kNumber; ++i) {
      number = number << 6 | from_char(text[i]);
    }
    std::array<std::int16_t, kInputs> weights = shared(number);
    for (std::size_t i = 0; i < kInputs; ++i) {
      const int steps = static_cast<int>(from_char(text[kNumber + i])) - 32;
      weights[i] = static_cast<std::int16_t>(weights[i] + kWeightStep * steps);
    }
    apply(number, weights);
  }
}

/// Calls `apply(record)` for the records of one context; `counts` says how many
/// each has.
template <std::size_t kContexts, class Apply>
void for_each_record(std::string_view records,
                     const std::array<std::uint16_t, kContexts>& counts,
                     std::size_t context, Apply apply) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < context; ++i) first += counts[i];
  for (std::size_t i = 0; i < counts[context]; ++i) {
    apply(parse(records.substr((first + i) * 8, 8)));
  }
}

struct Table {
  std::array<std::uint16_t, kContexts> counts;  ///< of records, by context
  std::string_view records;                     ///< all of them, parse()
  std::string_view vectors;                     ///< for_each_vector()
  std::array<std::array<std::int16_t, 32>, 2> turn_weights;
  std::array<std::array<std::int16_t, 8>, 1> start_weights;
  std::array<std::array<std::uint16_t, 2>, kFlags> flags;

  /// Calls `apply(record)` for the records of one context.
  template <class Apply>
  void for_each(std::size_t context, Apply apply) const {
    for_each_record(records, counts, context, apply);
  }
};

/// Icons, letters, symbols: much must be known from the start.
extern const Table kSmall;
/// Pages: what all kinds have in common. What is common on small drawings
/// costs 1 % here.
extern const Table kLarge;
/// Pages without noise, as maps: whole pages by the models for those.
extern const Table kClean;

/// A rule of the size and the models only, so that it need not be stored.
[[nodiscard]] inline const Table& table_for(std::int32_t width,
                                            std::int32_t rows, bool clean) {
  if (std::int64_t{width} * rows < 2'000'000) return kSmall;
  return clean ? kClean : kLarge;
}

}  // namespace unstep::codec::warm
