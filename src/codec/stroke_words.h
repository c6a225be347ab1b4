#pragma once

#include <cstdint>
#include <vector>

#include "codec/shape_layout.h"
#include "codec/stroke_models.h"
#include "codec/stroke_word.h"

namespace unstep::codec {

/// What the encoder has found of the paths to come.
struct StrokeItem {
  std::uint64_t count = 1;  ///< paths, at least one
  bool word = false;        ///< they may come again, or have come before
  bool refers = false;      ///< they have: as word `reference`
  std::uint32_t reference = 0;
  bool new_line = false;  ///< of words
};

/// The words of a payload, and where they stand: in lines, as the shapes of
/// coder 2 do. A word is placed by the box of its vertices, in units.
class StrokeWords {
 public:
  explicit StrokeWords(StrokeModels& models) : models_(models) {}

  [[nodiscard]] std::size_t size() const { return words_.size(); }
  [[nodiscard]] const StrokeWord& operator[](std::uint32_t klass) const {
    return words_[klass];
  }
  /// The class of the last word and 1, 0 for none.
  [[nodiscard]] std::uint32_t last() const { return past_[0].klass; }
  /// About the origin of the word's first path.
  [[nodiscard]] const VertexBox& box(std::uint32_t klass) const {
    return boxes_[klass];
  }

  /// `starts` is the history of StrokeStart.
  template <class Coder>
  bool code_refers(Coder& coder, bool truth, std::uint64_t starts) {
    if (words_.empty()) return false;
    const bool refers = models_.items.flag(
        coder, kRefers, truth,
        {join_values(0, was_), join_values(1, past_[0].klass, was_),
         join_values(2, past_[0].klass, past_[1].klass),
         join_values(3, starts, was_), join_values(4, history_ & 7U),
         join_values(5, history_)});
    history_ = (history_ << 1 | (refers ? 1U : 0U)) & 255U;
    return refers;
  }

  template <class Coder>
  bool code_word(Coder& coder, bool truth, std::uint64_t starts) {
    const bool word = models_.items.flag(
        coder, kWord, truth,
        {join_values(0, was_), join_values(1, history_ & 7U),
         join_values(2, starts), join_values(3, past_[0].klass),
         join_values(4, words_.size() / 8),
         join_values(5, was_, history_ & 3U)});
    if (!word) was_ = 0;
    return word;
  }

  template <class Coder>
  bool code_new_line(Coder& coder, bool truth, std::uint64_t starts) {
    return models_.items.flag(
        coder, kNewLine, truth,
        {join_values(0, was_), join_values(1, past_[0].klass),
         join_values(2, past_[0].klass, past_[1].klass), join_values(3, starts),
         join_values(4, clip_value(past_[0].gap, 20)),
         join_values(5, history_ & 31U)});
  }

  /// Whether a new word has a path after `count`, the last of `elements`.
  template <class Coder>
  bool code_goes_on(Coder& coder, bool truth, std::uint64_t count,
                    std::uint64_t elements, std::uint64_t starts, Point rest) {
    const std::uint64_t n = std::min<std::uint64_t>(count, 8);
    return models_.items.flag(
        coder, kGoesOn, truth,
        {n, join_values(1, elements), join_values(2, starts),
         join_values(3, elements, n), join_values(4, rest.x, rest.y), 5});
  }

  /// The class of a word that came before; not checked.
  template <class Coder>
  std::uint32_t code_class(Coder& coder, std::uint32_t truth, bool new_line) {
    const ShapePast& a = past_[0];
    const ShapePast& b = past_[1];
    const std::uint64_t line = new_line ? 1 : 0;
    return models_.items.number(
        coder, kClass, truth,
        {line, join_values(1, a.klass, line),
         join_values(2, a.klass, b.klass, line),
         join_values(3, a.klass, b.klass, past_[2].klass),
         join_values(4, a.gap), join_values(5, a.width, a.height)});
  }

  /// The origin of a word after the word before it. False if it cannot be
  /// there.
  template <class Coder>
  bool code_place(Coder& coder, std::uint32_t klass, bool new_line,
                  std::int32_t unit, const UnitPoint& truth,
                  UnitPoint& origin) {
    const Placed zero = placed({{}, origin.rest}, klass, unit, new_line);
    const Placed wanted =
        placed({truth.at, origin.rest}, klass, unit, new_line);
    Placed shape = zero;
    ShapePast now = past_of(klass, shape);
    if (!layout_.code_place(coder, models_.layout, shape, wanted, now, past_)) {
      return false;
    }
    origin.at = {shape.x - zero.x, shape.y - zero.y};
    return remember(shape, now, 2);
  }

  /// A word stands where it is known to. False if it cannot be there.
  bool stand(std::uint32_t klass, bool new_line, std::int32_t unit,
             const UnitPoint& origin) {
    const Placed shape = placed(origin, klass, unit, new_line);
    return remember(shape, past_of(klass, shape), 2);
  }

  /// A new word, its box about its first origin. False if it cannot be there.
  bool open(const StrokeWord& word, const VertexBox& box, bool new_line,
            std::int32_t unit, const UnitPoint& origin) {
    words_.push_back(word);
    boxes_.push_back(box);
    const auto klass = static_cast<std::uint32_t>(words_.size() - 1);
    const Placed shape = placed(origin, klass, unit, new_line);
    ShapePast now;
    now.width = shape.w;
    now.height = shape.h;
    if (!remember(shape, now, 1)) return false;
    past_[0].klass = past_[0].id = klass + 1;
    return true;
  }

 private:
  enum Field : std::uint8_t { kRefers, kWord, kNewLine, kClass, kGoesOn };

  struct Placed {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t w = 0;
    std::int32_t h = 0;
    bool new_line = false;
    [[nodiscard]] std::int32_t width() const { return w; }
    [[nodiscard]] std::int32_t height() const { return h; }
  };

  /// Coordinates of words are checked to be below 2^30, so all fits.
  [[nodiscard]] Placed placed(const UnitPoint& origin, std::uint32_t klass,
                              std::int32_t unit, bool new_line) const {
    const VertexBox& box = boxes_[klass];
    const auto units = [&](std::int64_t v) { return floor_div(v, unit); };
    const auto part = [](std::int64_t v) {
      return static_cast<std::int32_t>(v);
    };
    const std::int64_t left = units(origin.rest.x + box.left);
    const std::int64_t top = units(origin.rest.y + box.top);
    return {part(origin.at.x + left), part(origin.at.y + top),
            part(units(origin.rest.x + box.right) - left),
            part(units(origin.rest.y + box.bottom) - top), new_line};
  }

  static ShapePast past_of(std::uint32_t klass, const Placed& shape) {
    ShapePast now;
    now.refers = now.same = true;
    now.klass = now.id = klass + 1;
    now.width = shape.w;
    now.height = shape.h;
    return now;
  }

  /// The layout is of places on a page: none is negative.
  bool remember(const Placed& shape, const ShapePast& now, unsigned was) {
    if (shape.x < 0 || shape.y < 0 || shape.w > kMaxCoord - shape.x ||
        shape.h > kMaxCoord - shape.y) {
      return false;
    }
    layout_.advance(shape, now.klass);
    past_[2] = past_[1];
    past_[1] = past_[0];
    past_[0] = now;
    was_ = was;
    return true;
  }

  StrokeModels& models_;
  std::vector<StrokeWord> words_;
  std::vector<VertexBox> boxes_;
  ShapeLayout layout_{kMaxCoord, kMaxCoord};
  ShapePasts past_{};
  unsigned was_ = 0;      ///< the last item: 0 a path, 1 a new word, 2 an old
  unsigned history_ = 0;  ///< whether the last items were old words, a bit each
};

}  // namespace unstep::codec
