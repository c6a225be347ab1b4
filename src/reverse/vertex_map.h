#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "unstep/grid.h"

namespace unstep::reverse {

/// The vertices of paths by where they are. A place is a point as a number, row
/// after row, so that few far points share one. Whether there may be a vertex
/// at a place takes a bit, of 64 or more for each vertex, again from the first
/// one on after the last.
class VertexMap {
 public:
  struct Vertex {
    std::uint32_t path = 0;
    std::uint32_t line = 0;   ///< it starts this one of the path
    std::uint32_t index = 0;  ///< the chain's, modulo 2^32
    std::uint32_t place = 0;  ///< modulo 2^32
    std::uint32_t next = 0;   ///< in its cell, counted from 1
  };

  /// For about so many.
  explicit VertexMap(std::size_t vertices)
      : cells_(std::max<std::size_t>(std::bit_ceil(vertices), 64)),
        bits_(cells_.size()),
        four_shift_(64 + 2 - std::countr_zero(cells_.size())),
        row_((std::size_t{1} << (std::countr_zero(cells_.size()) + 6) / 2) +
             5) {
    vertices_.reserve(vertices);
  }

  /// Modulo 2^64, so that the place of a sum of points is the sum of theirs.
  [[nodiscard]] std::size_t place_of(Point p) const {
    return static_cast<std::size_t>(p.y) * row_ + static_cast<std::size_t>(p.x);
  }

  class Bits {
   public:
    explicit Bits(const std::vector<std::uint64_t>& words)
        : words_(words.data()), last_(words.size() - 1) {}
    /// The lowest bit is 0 if no vertex is at the place.
    [[nodiscard]] std::uint64_t at(std::size_t place) const {
      return words_[place / 64 & last_] >> place % 64;
    }

   private:
    const std::uint64_t* words_;
    std::size_t last_;
  };
  [[nodiscard]] Bits bits() const { return Bits(bits_); }

  /// visit(vertex) for those at a point, and perhaps others.
  template <class Visit>
  void for_each_at(Point at, const Visit& visit) const {
    const auto place = static_cast<std::uint32_t>(place_of(at));
    for (std::uint32_t v = cells_[cell_of(at)]; v != 0;) {
      const Vertex& vertex = vertices_[v - 1];
      if (vertex.place == place) visit(vertex);
      v = vertex.next;
    }
  }

  void add(Point at, Vertex vertex) {
    const std::size_t place = place_of(at);
    bits_[place / 64 & (bits_.size() - 1)] |= std::uint64_t{1} << place % 64;
    std::uint32_t& cell = cells_[cell_of(at)];
    vertex.place = static_cast<std::uint32_t>(place);
    vertex.next = cell;
    vertices_.push_back(vertex);
    cell = static_cast<std::uint32_t>(vertices_.size());
  }

 private:
  /// One for a square of 4 x 4 points, four squares side by side, and for
  /// others anywhere: drawings repeat at even distances.
  [[nodiscard]] std::size_t cell_of(Point p) const {
    const std::uint64_t row = static_cast<std::uint32_t>(p.y >> 2);
    const std::uint64_t four = row << 32 | static_cast<std::uint32_t>(p.x >> 4);
    return four * 0x9E3779B97F4A7C15U >> four_shift_ << 2 |
           (static_cast<std::uint32_t>(p.x) >> 2 & 3);
  }

  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> cells_;  ///< the last that came
  std::vector<std::uint64_t> bits_;
  int four_shift_;
  std::size_t row_;
};

}  // namespace unstep::reverse
