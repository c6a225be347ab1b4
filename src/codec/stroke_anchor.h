#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "codec/number_sequence.h"
#include "codec/vertex_memory.h"

namespace unstep::codec {

/// Predicts the points of earlier paths on which new ones begin: a vertex, or
/// a point between two. The latest vertices are asked one after the other.
class StrokeAnchor {
 public:
  enum Field : std::uint8_t { kHere, kInside, kFromEnd, kAlong };
  /// Vertices that are asked.
  static constexpr int kReach = 64;

  explicit StrokeAnchor(int table_bits) : sequence_(table_bits) {}

  void restart() {
    back_ = 0;
    along_ = 0;
  }

  /// Whether a point can be told so.
  [[nodiscard]] static bool finds(const VertexMemory& vertices, Point truth) {
    bool found = false;
    for_each(vertices, [&](std::int32_t id, int /*back*/, bool /*known*/) {
      found =
          vertices[id].at == truth || along(vertices, id, truth).has_value();
      return !found;
    });
    return found;
  }

  /// Codes the point; nothing if none is left that it could be. `kind` is what
  /// is known of the path.
  template <class Coder>
  std::optional<Point> code(Coder& coder, const VertexMemory& vertices,
                            Point truth, std::uint64_t kind) {
    std::optional<Point> found;
    for_each(vertices, [&](std::int32_t id, int back, bool known) {
      const VertexMemory::Vertex& v = vertices[id];
      const bool last = v.next == VertexMemory::kNone;
      const bool first = v.previous == VertexMemory::kNone;
      const std::uint64_t ends = (last ? 1U : 0U) + (first ? 2U : 0U);
      const Vec side = first ? Vec{} : vertices[v.previous].at - v.at;
      const auto direction =
          static_cast<std::uint64_t>(first ? kNoDirection : direction_of(side));
      const auto size = static_cast<std::uint64_t>(
          std::bit_width(static_cast<std::uint64_t>(size_of(side))));
      if (!known &&
          sequence_.flag(
              coder, kHere, v.at == truth,
              {ends, join_values(1, back), join_values(2, ends, back_ - back),
               join_values(3, ends, direction, size),
               join_values(4, kind, ends), join_values(5, kind, back)})) {
        found = v.at;
      } else if (size > 1 && size <= kLongest) {
        found = inside(coder, vertices, id, truth, kind, back, direction, size);
      }
      if (found) back_ = back;
      return !found;
    });
    return found;
  }

 private:
  /// Lines of more digits are not asked: products of lengths fit 63 bits.
  static constexpr std::uint64_t kLongest = 20;

  /// visit(id, how many were asked before, whether one at the same place was)
  /// until it says false.
  template <class Visit>
  static void for_each(const VertexMemory& vertices, Visit visit) {
    std::array<Point, kReach> seen;
    int back = 0;
    for (std::int32_t id = vertices.size(); id-- > 0 && back < kReach;) {
      const Point at = vertices[id].at;
      const auto end = seen.begin() + back;
      const bool known = std::find(seen.begin(), end, at) != end;
      if (known && vertices[id].previous == VertexMemory::kNone) continue;
      seen[static_cast<std::size_t>(back)] = at;
      if (!visit(id, back++, known)) return;
    }
  }

  /// The point on the line to a vertex, `k` steps of its longer side from the
  /// vertex before.
  static Point on_line(Point from, const Vec& line, std::int64_t k) {
    const std::int64_t n = size_of(line);
    const auto part = [&](std::int64_t d) {
      const std::int64_t twice = 2 * d * k;
      return static_cast<std::int32_t>(twice >= 0 ? (twice + n) / (2 * n)
                                                  : -((-twice + n) / (2 * n)));
    };
    return {from.x + part(line.x), from.y + part(line.y)};
  }

  /// Where the truth is on the line to a vertex, if it is.
  static std::optional<std::int64_t> along(const VertexMemory& vertices,
                                           std::int32_t id, Point truth) {
    const std::int32_t before = vertices[id].previous;
    if (before == VertexMemory::kNone) return std::nullopt;
    const Point from = vertices[before].at;
    const Vec line = vertices[id].at - from;
    const Vec d = truth - from;
    const bool wide = std::abs(line.x) >= std::abs(line.y);
    const std::int64_t k =
        wide ? (line.x < 0 ? -d.x : d.x) : (line.y < 0 ? -d.y : d.y);
    const std::int64_t n = size_of(line);
    if (k < 1 || k >= n || n >> kLongest != 0) return std::nullopt;
    if (on_line(from, line, k) != truth) return std::nullopt;
    return k;
  }

  template <class Coder>
  std::optional<Point> inside(Coder& coder, const VertexMemory& vertices,
                              std::int32_t id, Point truth, std::uint64_t kind,
                              int back, std::uint64_t direction,
                              std::uint64_t size) {
    const std::optional<std::int64_t> k = along(vertices, id, truth);
    if (!sequence_.flag(
            coder, kInside, k.has_value(),
            {size, join_values(1, back), join_values(2, back_ - back, size),
             join_values(3, direction, size), join_values(4, kind, size),
             join_values(5, kind)})) {
      return std::nullopt;
    }
    const Point from = vertices[vertices[id].previous].at;
    const Vec line = vertices[id].at - from;
    const std::int64_t n = size_of(line);
    const std::int64_t truth_k = k.value_or(1);
    const bool from_end = sequence_.flag(
        coder, kFromEnd, 2 * truth_k > n,
        {0, join_values(1, direction), join_values(2, size),
         join_values(3, kind), join_values(4, n), join_values(5, back)});
    const std::int64_t limit = n - 1;
    const auto read = std::int64_t{sequence_.number(
        coder, kAlong,
        static_cast<std::uint32_t>((from_end ? n - truth_k : truth_k) - 1),
        {size, join_values(1, n), join_values(2, along_, from_end),
         join_values(3, kind, size), join_values(4, direction, size),
         join_values(5, size, from_end)})};
    if (read >= limit) return std::nullopt;
    along_ = read;
    return on_line(from, line, from_end ? n - 1 - read : read + 1);
  }

  NumberSequence sequence_;
  int back_ = 0;  ///< of the anchor before
  std::int64_t along_ = 0;
};

}  // namespace unstep::codec
