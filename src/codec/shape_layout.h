#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "codec/shape_sequence.h"

namespace unstep::codec {

/// What is remembered of a shape that was coded.
struct ShapePast {
  std::uint32_t klass = 0;  ///< and 1; 0 is none
  std::uint32_t id = 0;     ///< and 1
  std::int32_t gap = 0;
  std::int32_t rise = 0;
  std::int32_t width = 0;
  std::int32_t height = 0;
  bool refers = false;
  bool same = false;
};
using ShapePasts = std::array<ShapePast, 3>;  ///< the latest first

/// Where shapes stand: in lines, one after another, each class at its own
/// height. A shape has a place x, y, a size width(), height() and new_line.
class ShapeLayout {
 public:
  /// Of a band of width x height pixels.
  ShapeLayout(std::int32_t width, std::int32_t height)
      : width_(width), height_(height) {}

  /// Whether a shape begins a line.
  template <class Coder, class Sequence>
  bool code_new_line(Coder& coder, Sequence& sequence, bool truth,
                     const ShapePasts& past) const {
    const ShapePast& a = past[0];
    sequence.begin({x_, base_, line_x_, line_base_, in_line_});
    return sequence.flag(
        coder, ShapeSequence::kNewLine, truth,
        {0, join_values(1, a.klass), join_values(2, a.klass, past[1].klass),
         join_values(3, in_line_),
         join_values(4, clip_value(a.gap, 20), a.refers),
         join_values(5, std::int64_t{x_} * 16 / width_)});
  }

  /// The left side follows the right side of the shape before, the lower side
  /// the line on which shapes of the same class stood. False if it would lie
  /// outside the band.
  template <class Coder, class Sequence, class Shape>
  bool code_place(Coder& coder, Sequence& sequence, Shape& shape,
                  const Shape& truth, ShapePast& now,
                  const ShapePasts& past) const {
    const ShapePast& a = past[0];
    const ShapePast& b = past[1];
    const std::uint64_t fresh = shape.new_line ? 1 : 0;
    const std::int32_t from = shape.new_line ? line_x_ : x_;
    const std::int32_t base = shape.new_line ? line_base_ : base_;
    const std::int32_t drop = now.klass != 0 ? drops_[now.klass - 1] : 0;
    const std::int64_t gap =
        sequence.signed_number(coder, ShapeSequence::kGap, truth.x - from,
                               {fresh, join_values(1, now.klass, fresh),
                                join_values(2, now.klass, a.klass, fresh),
                                join_values(3, now.id, a.id, fresh),
                                join_values(4, clip_value(a.gap, 40), fresh),
                                join_values(5, now.klass, a.klass, b.klass)});
    const std::int64_t bottom =
        std::int64_t{truth.y} + shape.height() - base - drop;
    const std::int64_t rise = sequence.signed_number(
        coder, ShapeSequence::kRise, bottom,
        {fresh, join_values(1, now.klass, fresh),
         join_values(2, now.klass, a.klass, fresh),
         join_values(3,
                     clip_value(static_cast<std::int32_t>(
                                    std::clamp<std::int64_t>(gap, -64, 64)),
                                64),
                     fresh, now.refers),
         join_values(4, clip_value(a.rise, 20), fresh, clip_value(b.rise, 4)),
         join_values(5, now.id, a.id)});
    const std::int64_t x = from + gap;
    const std::int64_t y = base + drop + rise - shape.height();
    if (x < 0 || y < 0 || x + shape.width() > width_ ||
        y + shape.height() > height_) {
      return false;
    }
    shape.x = static_cast<std::int32_t>(x);
    shape.y = static_cast<std::int32_t>(y);
    now.gap = static_cast<std::int32_t>(gap);
    now.rise = static_cast<std::int32_t>(rise);
    return true;
  }

  /// A shape stands at its place. `klass` is its class and 1, 0 if it opens
  /// the next one.
  template <class Shape>
  void advance(const Shape& shape, std::uint32_t klass) {
    const std::int32_t bottom = shape.y + shape.height();
    if (shape.new_line) line_x_ = shape.x;
    if (klass == 0) {
      if (shape.new_line) base_ = bottom;
      drops_.push_back(bottom - base_);
    } else {
      base_ = std::clamp(bottom - drops_[klass - 1], 0, height_);
    }
    if (shape.new_line) line_base_ = base_;
    x_ = shape.x + shape.width();
    in_line_ = shape.new_line ? 0 : std::min(in_line_ + 1, 15U);
  }

 private:
  std::int32_t width_;
  std::int32_t height_;
  std::vector<std::int32_t> drops_;  ///< of each class below the line
  std::int32_t x_ = 0;               ///< right side of the last shape
  std::int32_t base_ = 0;
  std::int32_t line_x_ = 0;
  std::int32_t line_base_ = 0;
  unsigned in_line_ = 0;
};

}  // namespace unstep::codec
