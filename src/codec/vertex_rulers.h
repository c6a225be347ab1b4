#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unstep::codec {

/// Counts how often lines began or bent sharply in each column and each row.
/// Vertices of maps and of drawings made on a grid share their columns and
/// rows.
class VertexRulers {
 public:
  static std::uint64_t memory(std::int32_t width, std::int32_t height) {
    return (static_cast<std::uint64_t>(width) +
            static_cast<std::uint64_t>(height) + 4) *
           sizeof(std::uint16_t);
  }

  VertexRulers(std::int32_t width, std::int32_t height)
      : columns_(static_cast<std::size_t>(width) + 2),
        rows_(static_cast<std::size_t>(height) + 2) {}

  void add(std::int32_t x, std::int32_t y) {
    count(columns_, x);
    count(rows_, y);
    ++sum_;
  }

  /// How many there are in a column or a row beside what is usual, and whether
  /// more than in its neighbours: 0..53.
  [[nodiscard]] unsigned column(std::int32_t x) const {
    return level(columns_, x, columns_.size() - 2);
  }
  [[nodiscard]] unsigned row(std::int32_t y) const {
    return level(rows_, y, static_cast<std::size_t>(y) + 1);
  }

 private:
  using Ruler = std::vector<std::uint16_t>;

  static void count(Ruler& ruler, std::int32_t at) {
    std::uint16_t& n = ruler[static_cast<std::size_t>(at) + 1];
    n = static_cast<std::uint16_t>(n + (n < 65535 ? 1 : 0));
  }
  [[nodiscard]] unsigned level(const Ruler& ruler, std::int32_t at,
                               std::size_t places) const {
    const auto i = static_cast<std::size_t>(at) + 1;
    const unsigned here = ruler[i];
    const unsigned beside = std::max(ruler[i - 1], ruler[i + 1]);
    const std::uint64_t usual = sum_ * 16 / places + 1;
    const auto ratio = static_cast<unsigned>(here * 16 / usual);
    return (std::min(static_cast<unsigned>(std::bit_width(ratio)), 5U) * 3 +
            (here > beside    ? 2U
             : here == beside ? 1U
                              : 0U)) *
               3 +
           std::min(here, 2U);
  }

  Ruler columns_;
  Ruler rows_;
  std::uint64_t sum_ = 1;
};

}  // namespace unstep::codec
