#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "codec/block_coder.h"
#include "codec/placed_shape.h"
#include "codec/shape_glyph.h"
#include "codec/shape_layout.h"
#include "codec/shape_library.h"
#include "codec/shape_models.h"

namespace unstep::codec {

/// Coder 2's first part, both sides: shapes one after another, each told by
/// its place after the one before and, if it is like an earlier one, by what
/// differs. `Side` is what differs between encoder and decoder:
///
///     coder()          an arithmetic encoder or decoder
///     next()           the next true shape, or null at the end or if unknown
///     place(shape)     a shape is complete; false if it cannot be placed
///     damaged()        the payload cannot be right; give up
///
/// `Models` are its Pixels and its Sequence.
template <class Side, class Models>
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
        sequence_(width, height),
        layout_(width, height) {}

  /// Bytes that the models allocate.
  static std::uint64_t memory(std::int32_t width, std::int32_t height,
                              int table_bits) {
    return Models::Pixels::memory(table_bits) +
           Models::Sequence::memory(width, height) + (1 << 20);
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

  [[nodiscard]] const typename Models::Pixels& pixels() const {
    return pixels_;
  }
  [[nodiscard]] const typename Models::Sequence& sequence() const {
    return sequence_;
  }

 private:
  using Past = ShapePast;
  /// Of a shape's sides and place against what it refers to.
  static constexpr std::int64_t kMostChange = 4;
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
    const auto rank = static_cast<std::size_t>(sequence_.number(
        coder, ShapeSequence::kRank,
        known ? static_cast<std::uint32_t>(library_.rank(truth.reference)) : 0U,
        {0, join_values(1, klass), join_values(2, library_.offered(klass)),
         join_values(3, klass, a.id), join_values(4, a.same),
         join_values(5, klass, a.klass)}));
    if (rank >= library_.offered(klass)) return false;
    shape.reference = library_.at(klass, rank);
    sequence_.refer(shape.reference + 1);
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
    bool near = true;
    const auto small = [&](std::uint8_t field, std::int32_t value) {
      const std::int64_t read = sequence_.signed_number(
          coder, field, known ? value : 0,
          {0, join_values(1, klass), join_values(2, a.klass),
           join_values(3, model.height), join_values(4, model.width),
           join_values(5, shape.reference)});
      near = near && std::abs(read) <= kMostChange;
      return near ? static_cast<std::int32_t>(read) : 0;
    };
    const std::int32_t width =
        model.width +
        small(ShapeSequence::kWidth, truth.glyph.width - model.width);
    const std::int32_t height =
        model.height +
        small(ShapeSequence::kHeight, truth.glyph.height - model.height);
    shape.dx = small(ShapeSequence::kAlignX, truth.dx);
    shape.dy = small(ShapeSequence::kAlignY, truth.dy);
    if (!near || width < 1 || height < 1 || width > kMaxShapeSide ||
        height > kMaxShapeSide) {
      return false;
    }
    shape.glyph = Glyph(width, height);
    return true;
  }

  void open(PlacedShape& shape, const PlacedShape& truth) {
    const Past& a = past_[0];
    const auto side = [&](std::uint8_t field, std::int32_t value,
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
    if (shape.refers) align(shape);
    pixels_.code(side_.coder(), Side::kKnows ? &truth.glyph : nullptr,
                 shape.glyph.width, shape.glyph.height, canvas_,
                 shape.refers ? &told_ : nullptr);
    canvas_.take(shape.glyph);
  }

  /// Lays what the shape refers to over it.
  void align(const PlacedShape& shape) {
    const auto lay = [&](std::size_t k, const Glyph& glyph, std::int32_t dx,
                         std::int32_t dy) {
      laid_[k].clear(shape.glyph.height);
      laid_[k].draw(glyph, dx, dy);
      return &laid_[k];
    };
    const ShapeLibrary::Entry& model = library_.entry(shape.reference);
    const std::int32_t dx =
        (model.glyph.width - shape.glyph.width) / 2 + shape.dx;
    const std::int32_t dy =
        (model.glyph.height - shape.glyph.height) / 2 + shape.dy;
    constexpr std::int32_t kFar = 1 << 20;  // however long a class goes on
    told_ = {lay(0, model.glyph, dx, dy),
             model.klass + 1,
             std::clamp(model.x + dx, -kFar, kFar),
             std::clamp(model.y + dy, -kFar, kFar),
             {}};
    if constexpr (!Models::Pixels::kSeesOthers) return;
    std::size_t found = 0;
    for (std::size_t r = 0; r < library_.offered(model.klass); ++r) {
      const std::uint32_t id = library_.at(model.klass, r);
      const ShapeLibrary::Entry& other = library_.entry(id);
      const std::int32_t x = told_.x - other.x;
      const std::int32_t y = told_.y - other.y;
      if (id == shape.reference || std::abs(x) > 30 || std::abs(y) > 30) {
        continue;
      }
      told_.others[found] = lay(found + 1, other.glyph, x, y);
      if (++found == told_.others.size()) return;
    }
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
      now.id = library_.add(now.klass - 1, std::move(shape.glyph), told_.x,
                            told_.y) +
               1;
    }
    sequence_.remember({now.klass, now.gap, now.rise, shape.x,
                        shape.y + now.height, now.width, now.height,
                        shape.new_line});
    past_[2] = past_[1];
    past_[1] = past_[0];
    past_[0] = now;
    return true;
  }

  Side& side_;
  std::uint64_t room_;
  std::uint64_t memory_;
  typename Models::Pixels pixels_;
  typename Models::Sequence sequence_;
  ShapeLibrary library_;
  ShapeCanvas canvas_;
  ShapeReference told_;  ///< what the last shape with pixels referred to
  std::array<ShapeCanvas, 3> laid_;
  ShapeLayout layout_;
  ShapePasts past_{};
  std::int32_t row_ = 0;  ///< the top of the last shape
};

}  // namespace unstep::codec
