#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid/vector_classes.h"
#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// About what the coder of paths (docs/format.md, coder 24) needs for a line
/// after the line before it: its turn, its length, its smaller component. Made
/// from what lines of other drawings look like and from lines of this one.
class LinePrice {
 public:
  static constexpr std::int32_t kBit = 32;    ///< prices are in parts of a bit
  static constexpr std::uint32_t kUnit = 64;  ///< one line, counted

  /// Prices of a turn and a class of length.
  struct Entry {
    std::int16_t price = 0;  ///< without the smaller component
    std::int16_t least = 0;  ///< of all lines nearly the same
  };

  /// What a price depends on: the line before.
  struct Context {
    const Entry* entries = nullptr;
    int direction = 0;
    std::int32_t least = 0;  ///< no line costs less
  };

  /// Prices of lines of any drawing.
  LinePrice();

  /// Counts the lines of one path; a ring has its first vertex again at its
  /// end, and its last line is not coded.
  void count(const LineVertices& path, bool closed);
  /// From now on prices are those of the lines counted.
  void settle();

  /// For training: what was counted, the start included.
  [[nodiscard]] const std::vector<std::uint32_t>& turn_counts() const {
    return turn_counts_;
  }
  [[nodiscard]] const std::vector<std::uint32_t>& length_counts() const {
    return length_counts_;
  }

  /// `before` is zero for the first line of a path.
  [[nodiscard]] Context after(const vectors::Vec& before) const;

  /// REQUIRES: (x, y) is not (0, 0), both are below 2^31.
  [[nodiscard]] std::int32_t operator()(const Context& context, std::int32_t x,
                                        std::int32_t y) const {
    const Shape s = shape(x, y);
    return entry(context, s).price + s.minor;
  }

  /// No line costs less whose components differ from these by at most a
  /// quarter of the larger. REQUIRES: as above.
  [[nodiscard]] std::int32_t least(const Context& context, std::int32_t x,
                                   std::int32_t y) const {
    return entry(context, shape(x, y)).least;
  }

 private:
  static constexpr std::size_t kTurns = vectors::kDirections;
  static constexpr std::size_t kFoldedTurns = kTurns / 2 + 1;
  static constexpr std::size_t kSlopes = 8;    ///< of the line before; 7: none
  static constexpr std::size_t kSizes = 4;     ///< of its length, for turns
  static constexpr std::size_t kBefore = 8;    ///< of its length, for lengths
  static constexpr std::size_t kLengths = 26;  ///< classes; longer are the last
  static constexpr std::size_t kRow = kBefore * kLengths;
  static constexpr std::size_t kPlaces = kSlopes * kSizes * kBefore;
  /// Vectors whose components are at most this are looked up.
  static constexpr std::int32_t kSmall = 40;
  static constexpr std::int32_t kSide = 2 * kSmall + 1;

  /// Turns to both sides are of the same lengths.
  static constexpr std::size_t folded(std::size_t turn) {
    return std::min(turn, kTurns - turn);
  }

  /// What the price of a line needs of it.
  struct Shape {
    std::int16_t minor = 0;  ///< the price of its smaller component
    std::uint8_t direction = 0;
    std::uint8_t length = 0;
  };
  static Shape measured(const vectors::Vec& v);
  static const std::vector<Shape>& small_shapes();

  [[nodiscard]] Shape shape(std::int32_t x, std::int32_t y) const {
    const auto column = static_cast<std::uint32_t>(x + kSmall);
    const auto row = static_cast<std::uint32_t>(y + kSmall);
    return column < kSide && row < kSide ? small_[row * kSide + column]
                                         : measured({x, y});
  }

  [[nodiscard]] static const Entry& entry(const Context& context,
                                          const Shape& s) {
    int turn = s.direction - context.direction;
    if (turn < 0) turn += vectors::kDirections;
    return context
        .entries[static_cast<std::size_t>(turn) * kLengths + s.length];
  }

  /// Where a line after `before` is counted and priced.
  struct Place {
    std::size_t slope;
    std::size_t size;
    std::size_t length;
    int direction;

    [[nodiscard]] std::size_t turns() const {
      return (slope * kSizes + size) * kTurns;
    }
    [[nodiscard]] std::size_t lengths() const { return length * kLengths; }
    [[nodiscard]] std::size_t number() const {
      return (slope * kSizes + size) * kBefore + length;
    }
  };
  struct Table {
    std::vector<Entry> entries;
    std::int32_t least = 0;
  };
  [[nodiscard]] Table table_of(const Place& place) const;
  static Place place_after(const vectors::Vec& before);

  const Shape* small_;
  std::vector<std::uint32_t> turn_counts_;  ///< kUnit each
  std::vector<std::uint32_t> length_counts_;
  std::vector<std::int32_t> turn_prices_;
  std::vector<std::int32_t> length_prices_;
  mutable std::vector<Table> tables_;  ///< of each place once it is asked for
};

}  // namespace unstep::reverse
