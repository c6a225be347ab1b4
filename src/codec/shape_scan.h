#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "codec/block_coder.h"
#include "codec/placed_shape.h"
#include "codec/shape_glyph.h"
#include "codec/shape_layout.h"
#include "codec/shape_library.h"
#include "codec/shape_pixels.h"
#include "codec/shape_sequence.h"

namespace unstep::codec {

/// Coder 2's first part, both sides: shapes one after another, each told by
/// its place after the one before and, if it is like an earlier one, by what
/// differs. `Side` is what differs between encoder and decoder:
///
///     coder()          an arithmetic encoder or decoder
///     next()           the next true shape, or null at the end or if unknown
///     place(shape)     a shape is complete; false if it cannot be placed
///     damaged()        the payload cannot be right; give up
template <class Side>
class ShapeScan {
 public:
  /// Models of 2^table_bits slots a context; `shape_memory` bytes may go to
  /// what is remembered of shapes.
  ShapeScan(Side& side, std::int32_t width, std::int32_t height, int table_bits,
            std::uint64_t shape_memory)
      : side_(side),
        room_(shape_room(width, height)),
        memory_(shape_memory),
        pixels_(table_bits),
        sequence_(kSequenceBits),
        layout_(width, height) {}

  /// Bytes that the models allocate.
  static std::uint64_t memory(int table_bits) {
    return ShapePixels::memory(table_bits) +
           (std::uint64_t{ShapeSequence::kContexts * 4} << kSequenceBits) +
           (1 << 20);
  }

  /// corrupt if the payload is damaged, limit_exceeded if the memory does not
  /// suffice, cancelled. Shapes come from the top: `progress` hears their rows.
  Status run(const BlockProgress& progress) {
    const PlacedShape none;
    std::uint64_t quiet = 0;  // work since progress heard something
    for (;;) {
      const PlacedShape* next = side_.next();
      if (!sequence_.flag(side_.coder(), ShapeSequence::kMore, next != nullptr,
                          {0, 0, 0, 0, 0, 0})) {
        return {};
      }
      if (memory_ < ShapeLibrary::kLargest) {
        return Error{ErrorCode::limit_exceeded,
                     "shapes need more than the memory limit"};
      }
      const std::uint64_t room = room_;
      if (side_.damaged() || !one(next != nullptr ? *next : none)) {
        return Error{ErrorCode::corrupt, "shape payload is damaged"};
      }
      quiet += room - room_;
      if (quiet < kOften) continue;
      quiet = 0;
      if (progress && !progress(static_cast<std::uint64_t>(row_))) {
        return Error{ErrorCode::cancelled, "cancelled"};
      }
    }
  }

 private:
  using Past = ShapePast;
  static constexpr int kSequenceBits = 16;
  static constexpr std::uint64_t kOften = 1 << 16;  ///< pixels: some ms

  bool one(const PlacedShape& truth) {
    auto& coder = side_.coder();
    PlacedShape shape;
    const Past& a = past_[0];
    const Past& b = past_[1];
    const Past& c = past_[2];
    shape.new_line =
        layout_.code_new_line(coder, sequence_, truth.new_line, past_);
    const std::uint64_t fresh = shape.new_line ? 1 : 0;
    shape.refers = sequence_.flag(
        coder, ShapeSequence::kRefers, truth.refers,
        {fresh, join_values(1, a.klass, b.klass), join_values(2, a.klass),
         join_values(3, a.refers, b.refers, c.refers),
         join_values(4, clip_value(a.gap, 20), a.refers),
         join_values(5, a.width, a.height)});
    Past now;
    now.refers = shape.refers;
    if (shape.refers) {
      if (!reference(shape, truth, now, fresh)) return false;
    } else {
      open(shape, truth);
    }
    const std::uint64_t cost =
        shape_cost(shape.glyph.width, shape.glyph.height);
    if (cost > room_) return false;
    room_ -= cost;
    if (!now.same) memory_ -= ShapeLibrary::memory(shape.glyph);
    if (!layout_.code_place(coder, sequence_, shape, truth, now, past_)) {
      return false;
    }
    if (!now.same) draw(shape, truth);
    return remember(shape, now);
  }

  bool reference(PlacedShape& shape, const PlacedShape& truth, Past& now,
                 std::uint64_t fresh) {
    if (library_.size() == 0) return false;
    auto& coder = side_.coder();
    const Past& a = past_[0];
    const Past& b = past_[1];
    const Past& c = past_[2];
    const bool known = truth.refers;
    const std::uint32_t true_class =
        known ? library_.entry(truth.reference).klass : 0;
    const std::uint32_t klass = sequence_.number(
        coder, ShapeSequence::kClass, true_class,
        {fresh, join_values(1, a.klass, fresh),
         join_values(2, a.klass, b.klass),
         join_values(3, a.klass, b.klass, c.klass), join_values(4, a.id, a.gap),
         join_values(5, a.width, a.height, fresh)});
    if (klass >= library_.classes()) return false;
    const auto rank = static_cast<std::size_t>(sequence_.small(
        coder, ShapeSequence::kRank,
        known ? static_cast<unsigned>(library_.rank(truth.reference)) : 0U,
        ShapeLibrary::kRankBits,
        {0, join_values(1, klass), join_values(2, library_.offered(klass)),
         join_values(3, klass, a.id), join_values(4, a.same),
         join_values(5, klass, a.klass)}));
    if (rank >= library_.offered(klass)) return false;
    shape.reference = library_.at(klass, rank);
    const Glyph& model = library_.entry(shape.reference).glyph;
    now.same = sequence_.flag(
        coder, ShapeSequence::kSame, known && truth.glyph == model,
        {join_values(0, a.same, b.same, c.same), join_values(1, klass),
         join_values(2, shape.reference), join_values(3, a.same),
         join_values(4, model.height), join_values(5, rank)});
    now.klass = klass + 1;
    now.id = shape.reference + 1;
    library_.touch(klass, rank);
    if (now.same) {
      shape.glyph = model;
      return true;
    }
    const auto small = [&](ShapeSequence::Field field, std::int32_t value) {
      const auto read = sequence_.small(
          coder, field, known ? static_cast<unsigned>(value + 4) & 7U : 0U, 3,
          {0, join_values(1, klass), join_values(2, a.klass),
           join_values(3, model.height), join_values(4, model.width),
           join_values(5, shape.reference)});
      return static_cast<std::int32_t>(read) - 4;
    };
    const std::int32_t width =
        model.width +
        small(ShapeSequence::kWidth, truth.glyph.width - model.width);
    const std::int32_t height =
        model.height +
        small(ShapeSequence::kHeight, truth.glyph.height - model.height);
    if (width < 1 || height < 1 || width > kMaxShapeSide ||
        height > kMaxShapeSide) {
      return false;
    }
    shape.dx = small(ShapeSequence::kAlignX, truth.dx);
    shape.dy = small(ShapeSequence::kAlignY, truth.dy);
    shape.glyph = Glyph(width, height);
    return true;
  }

  void open(PlacedShape& shape, const PlacedShape& truth) {
    const Past& a = past_[0];
    const auto side = [&](ShapeSequence::Field field, std::int32_t value,
                          std::uint64_t other) {
      const auto read =
          sequence_.small(side_.coder(), field,
                          static_cast<unsigned>(std::max(1, value) - 1), 8,
                          {0, join_values(1, other), join_values(2, a.width),
                           join_values(3, a.height), join_values(4, a.klass),
                           join_values(5, a.refers)});
      return std::min<std::int32_t>(static_cast<std::int32_t>(read) + 1,
                                    kMaxShapeSide);
    };
    const std::int32_t width =
        side(ShapeSequence::kSide, truth.glyph.width, 1000);
    const std::int32_t height = side(ShapeSequence::kSide, truth.glyph.height,
                                     static_cast<std::uint64_t>(width));
    shape.glyph = Glyph(width, height);
  }

  void draw(PlacedShape& shape, const PlacedShape& truth) {
    canvas_.clear(shape.glyph.height);
    if (shape.refers) {
      const Glyph& model = library_.entry(shape.reference).glyph;
      reference_.clear(shape.glyph.height);
      reference_.draw(model, (model.width - shape.glyph.width) / 2 + shape.dx,
                      (model.height - shape.glyph.height) / 2 + shape.dy);
    }
    pixels_.code(side_.coder(), Side::kKnows ? &truth.glyph : nullptr,
                 shape.glyph.width, shape.glyph.height, canvas_,
                 shape.refers ? &reference_ : nullptr);
    canvas_.take(shape.glyph);
  }

  bool remember(PlacedShape& shape, Past& now) {
    if (!side_.place(shape)) return false;
    row_ = shape.y;
    now.width = shape.glyph.width;
    now.height = shape.glyph.height;
    layout_.advance(shape, now.klass);
    if (!now.refers) {
      now.id = library_.open(std::move(shape.glyph)) + 1;
      now.klass = library_.entry(now.id - 1).klass + 1;
    } else if (!now.same) {
      now.id = library_.add(now.klass - 1, std::move(shape.glyph)) + 1;
    }
    past_[2] = past_[1];
    past_[1] = past_[0];
    past_[0] = now;
    return true;
  }

  Side& side_;
  std::uint64_t room_;
  std::uint64_t memory_;
  ShapePixels pixels_;
  ShapeSequence sequence_;
  ShapeLibrary library_;
  ShapeCanvas canvas_;
  ShapeCanvas reference_;
  ShapeLayout layout_;
  ShapePasts past_{};
  std::int32_t row_ = 0;  ///< the top of the last shape
};

}  // namespace unstep::codec
