#include "reverse/line_price.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string_view>

#include "reverse/line_price_prior.h"

namespace unstep::reverse {
namespace {

using vectors::Vec;

/// Of every turn and class of length before any is seen.
constexpr std::uint32_t kTrace = 3;

/// log2 of value >= 1 in parts of a bit, rounded down: 5 fractional bits by
/// squaring.
std::int32_t log2_parts(std::uint64_t value) {
  static_assert(LinePrice::kBit == 32);
  const auto whole = static_cast<int>(std::bit_width(value)) - 1;
  std::uint64_t x = whole >= 31 ? value >> (whole - 31) : value << (31 - whole);
  std::int32_t result = whole;
  for (int i = 0; i < 5; ++i) {
    x = x * x >> 31;  // below 2^33
    const bool one = x >> 32 != 0;
    result = 2 * result + (one ? 1 : 0);
    if (one) x >>= 1;
  }
  return result;
}

/// '0' is none, from then on four to the octave: 1, 1.25, 1.5, 1.75, 2, 2.5.
std::uint32_t count_of(char c) {
  if (c <= '0') return 0;
  const auto level = static_cast<std::uint32_t>(c - '1');
  return (4 + level % 4) << (level / 4) >> 2;
}

void read_counts(std::string_view text, std::vector<std::uint32_t>& counts) {
  for (std::size_t i = 0; i < counts.size() && i < text.size(); ++i) {
    counts[i] = count_of(text[i]);
  }
}

/// The prices of `n` things counted together, plus what is `more` for each.
template <class More>
void price_all(const std::uint32_t* counts, std::size_t n, std::int32_t* prices,
               More more) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += counts[i] + kTrace;
  const std::int32_t all = log2_parts(sum);
  for (std::size_t i = 0; i < n; ++i) {
    prices[i] = all - log2_parts(counts[i] + kTrace) + more(i);
  }
}

int size_class(std::int64_t size) {
  return size <= 2 ? 0 : size <= 6 ? 1 : size <= 20 ? 2 : 3;
}

/// How many lengths are in a class of vectors::length_class, as bits.
std::int32_t bits_within(std::size_t length_class) {
  return length_class < 4 ? 0 : static_cast<std::int32_t>(length_class / 2) - 1;
}

/// What the smaller component of a class of length costs at least, off the
/// axes.
constexpr std::array<std::int32_t, 26> kMinors = [] {
  std::array<std::int32_t, 26> bits{};
  for (std::size_t k = 4; k < bits.size(); ++k) {
    // A third of the sizes from 2^(k / 2) or 1.5 times that.
    const auto whole = static_cast<std::int32_t>(k / 2);
    bits[k] =
        LinePrice::kBit *
        std::max<std::int32_t>(0, k % 2 == 0 ? 2 * whole - 5 : 2 * whole - 4) /
        2;
  }
  return bits;
}();

}  // namespace

LinePrice::LinePrice()
    : small_(small_shapes().data()),
      turn_counts_(kSlopes * kSizes * kTurns),
      length_counts_(kFoldedTurns * kRow),
      turn_prices_(turn_counts_.size()),
      length_prices_(length_counts_.size()),
      tables_(kPlaces) {
  read_counts(prior::kTurns, turn_counts_);
  read_counts(prior::kLengths, length_counts_);
  settle();
}

LinePrice::Shape LinePrice::measured(const Vec& v) {
  const int direction = vectors::direction_of(v);
  const std::int64_t size = vectors::size_of(v);
  const vectors::MinorRange range = vectors::minor_range(direction % 7, size);
  const std::int64_t choices =
      std::max<std::int64_t>(1, range.high - range.low + 1);
  return {static_cast<std::int16_t>(
              log2_parts(static_cast<std::uint64_t>(choices))),
          static_cast<std::uint8_t>(direction),
          static_cast<std::uint8_t>(
              std::min<int>(vectors::length_class(size), kLengths - 1))};
}

const std::vector<LinePrice::Shape>& LinePrice::small_shapes() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> made;
    for (std::int32_t y = -kSmall; y <= kSmall; ++y) {
      for (std::int32_t x = -kSmall; x <= kSmall; ++x) {
        made.push_back(x == 0 && y == 0 ? Shape{} : measured({x, y}));
      }
    }
    return made;
  }();
  return shapes;
}

LinePrice::Place LinePrice::place_after(const Vec& before) {
  if (before.zero()) return {kSlopes - 1, 0, 0, 0};
  const int direction = vectors::direction_of(before);
  const std::int64_t size = vectors::size_of(before);
  return {static_cast<std::size_t>(direction % 7),
          static_cast<std::size_t>(size_class(size)),
          static_cast<std::size_t>(std::min(vectors::length_class(size) / 2,
                                            static_cast<int>(kBefore) - 1)),
          direction};
}

void LinePrice::count(const LineVertices& path, bool closed) {
  Vec before;
  const std::size_t lines = path.size() - (closed && path.size() > 1 ? 1 : 0);
  for (std::size_t i = 1; i < lines; ++i) {
    const Vec v = vectors::between(path[i - 1].at, path[i].at);
    const Shape s = measured(v);
    const Place place = place_after(before);
    const int turn = (s.direction - place.direction + vectors::kDirections) %
                     vectors::kDirections;
    const auto t = static_cast<std::size_t>(turn);
    turn_counts_[place.turns() + t] += kUnit;
    length_counts_[folded(t) * kRow + place.lengths() + s.length] += kUnit;
    before = v;
  }
}

void LinePrice::settle() {
  for (std::size_t i = 0; i < turn_counts_.size(); i += kTurns) {
    price_all(&turn_counts_[i], kTurns, &turn_prices_[i],
              [](std::size_t) { return 0; });
  }
  for (std::size_t i = 0; i < length_counts_.size(); i += kLengths) {
    price_all(&length_counts_[i], kLengths, &length_prices_[i],
              [](std::size_t k) { return kBit * bits_within(k); });
  }
  for (Table& table : tables_) table.entries.clear();
}

LinePrice::Table LinePrice::table_of(const Place& place) const {
  constexpr std::int16_t kNone = std::numeric_limits<std::int16_t>::max();
  Table table{std::vector<Entry>(kTurns * kLengths), kNone};
  // Of each turn and length what is least for the lengths beside it.
  std::array<std::int16_t, kTurns * kLengths> least{};
  for (std::size_t turn = 0; turn < kTurns; ++turn) {
    const bool axis = (place.slope + turn) % 7 == 0;
    const std::int32_t turned = turn_prices_[place.turns() + turn];
    const std::int32_t* const lengths =
        &length_prices_[folded(turn) * kRow + place.lengths()];
    std::array<std::int16_t, kLengths + 2> row{};
    row.fill(kNone);
    for (std::size_t k = 0; k < kLengths; ++k) {
      const std::int32_t price = turned + lengths[k];
      table.entries[turn * kLengths + k].price =
          static_cast<std::int16_t>(price);
      row[k + 1] = static_cast<std::int16_t>(price + (axis ? 0 : kMinors[k]));
    }
    for (std::size_t k = 0; k < kLengths; ++k) {
      least[turn * kLengths + k] = std::min({row[k], row[k + 1], row[k + 2]});
      table.least = std::min<std::int32_t>(table.least, row[k + 1]);
    }
  }
  // A vector changed by a quarter is at most two classes of direction away.
  for (std::size_t turn = 0; turn < kTurns; ++turn) {
    for (std::size_t k = 0; k < kLengths; ++k) {
      std::int16_t& result = table.entries[turn * kLengths + k].least;
      result = kNone;
      for (std::size_t near = turn + kTurns - 2; near <= turn + kTurns + 2;
           ++near) {
        result = std::min(result, least[near % kTurns * kLengths + k]);
      }
    }
  }
  return table;
}

LinePrice::Context LinePrice::after(const Vec& before) const {
  const Place place = place_after(before);
  Table& table = tables_[place.number()];
  if (table.entries.empty()) table = table_of(place);
  return {table.entries.data(), place.direction, table.least};
}

}  // namespace unstep::reverse
