#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "codec/stroke_models.h"
#include "codec/stroke_word.h"

namespace unstep::codec {

/// Predicts where paths begin: on an earlier path, or somewhere after the paths
/// since the last one that began on none.
class StrokeStart {
 public:
  explicit StrokeStart(StrokeModels& models) : models_(models) {}

  /// Vectors are multiples of 2^bits; so are starts, but for a rest.
  void set_unit_bits(int bits) { unit_bits_ = bits; }
  [[nodiscard]] std::int32_t unit() const { return 1 << unit_bits_; }

  /// A few bits of history, as a context.
  [[nodiscard]] std::uint64_t history() const { return anchored_; }

  template <class Coder>
  Point code_rest(Coder& coder, Point truth, std::uint64_t kind) {
    if (unit_bits_ == 0) return {};
    NumberSequence& sequence = models_.starts;
    const auto x = sequence.small(
        coder, kRestX, static_cast<unsigned>(truth.x), unit_bits_,
        {kind, join_values(1, rest_.x, rest_.y), 2, 3, 4, 5});
    const auto y = sequence.small(
        coder, kRestY, static_cast<unsigned>(truth.y), unit_bits_,
        {join_values(kind, x), join_values(1, rest_.x, rest_.y, x),
         join_values(2, x), 3, 4, 5});
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }

  /// Whether a path begins on an earlier one. `kind` is what is known of it,
  /// `role` whether it is one of a word, `klass` of which word.
  template <class Coder>
  bool code_anchored(Coder& coder, Point truth, std::uint64_t kind,
                     unsigned role, std::uint32_t klass) {
    const VertexMemory& vertices = models_.paths.vertices();
    if (vertices.size() == 0) return false;
    const bool anchored = models_.starts.flag(
        coder, kAnchored, StrokeAnchor::finds(vertices, truth),
        {join_values(0, role), join_values(1, kind),
         join_values(2, anchored_ & 1U, role), join_values(3, anchored_, role),
         join_values(4, kind, anchored_ & 1U), join_values(5, klass, role)});
    anchored_ = (anchored_ << 1 | (anchored ? 1U : 0U)) & 15U;
    return anchored;
  }

  template <class Coder>
  std::optional<Point> on_path(Coder& coder, Point truth, std::uint64_t kind) {
    return models_.anchors.code(coder, models_.paths.vertices(), truth, kind);
  }

  /// From the upper right corner of what was drawn since the last free start.
  template <class Coder>
  Vec free(Coder& coder, Point truth, std::uint64_t kind) {
    NumberSequence& sequence = models_.starts;
    const Vec from = corner();
    const std::uint64_t before = anchored_ & 7U;
    const std::int64_t dy = sequence.signed_number(
        coder, kDown, truth.y - from.y,
        {0, join_values(1, kind), join_values(2, before),
         join_values(3, move_.y), join_values(4, move_.x),
         join_values(5, kind, before)});
    const auto size = static_cast<std::uint64_t>(
        std::bit_width(static_cast<std::uint64_t>(std::abs(dy))));
    const std::uint64_t down = dy < 0 ? 64 + size : size;
    const std::int64_t dx = sequence.signed_number(
        coder, kRight, truth.x - from.x,
        {down, join_values(1, kind, down), join_values(2, before, down),
         join_values(3, move_.x, down), join_values(4, dy),
         join_values(5, kind, before)});
    return {from.x + dx, from.y + dy};
  }

  /// A path that was told alone begins there.
  void advance(const UnitPoint& point) {
    const auto clipped = [](std::int64_t v) {
      return std::clamp<std::int64_t>(v, -30, 30);
    };
    move_ = {clipped(std::int64_t{point.at.x} - start_.x),
             clipped(std::int64_t{point.at.y} - start_.y)};
    start_ = point.at;
    rest_ = point.rest;
  }
  [[nodiscard]] Point rest() const { return rest_; }

 private:
  enum Field : std::uint8_t { kDown, kRight, kAnchored, kRestX, kRestY };

  Vec corner() {
    const VertexMemory& vertices = models_.paths.vertices();
    VertexBox box;
    for (std::int32_t id = vertices.size(); id-- > seen_;) {
      box.add(vertices[id].at.x, vertices[id].at.y);
    }
    const bool any = vertices.size() > seen_;
    seen_ = vertices.size();
    return any ? Vec{box.right, box.top} : Vec{};
  }

  StrokeModels& models_;
  int unit_bits_ = 0;
  unsigned anchored_ = 0;  ///< of the last four paths, a bit each
  Point rest_;
  Point start_;
  Vec move_;               ///< to the last start from that before, clipped
  std::int32_t seen_ = 0;  ///< vertices before the last free start
};

}  // namespace unstep::codec
