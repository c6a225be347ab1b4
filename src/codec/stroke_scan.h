#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "codec/block_coder.h"
#include "codec/path_model.h"
#include "codec/path_warm_start.h"
#include "codec/shape_layout.h"
#include "codec/shape_sequence.h"
#include "codec/stroke_anchor.h"
#include "codec/stroke_coder.h"
#include "codec/stroke_head.h"
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

/// What holds for all paths of a payload.
struct StrokeFrame {
  PathFrame paths;
  int unit_bits = 0;  ///< vectors are multiples of 2 to this power
};

/// What learns in coder 25; nothing of a payload itself.
struct StrokeModels {
  static constexpr int kTableBits = 14;

  StrokeModels() { path_warm::apply(path_warm::kTable, paths.vectors()); }

  NumberSequence items{kTableBits};
  NumberSequence starts{kTableBits};
  ShapeSequence layout{kTableBits};
  StrokeAnchor anchors{kTableBits};
  StrokeHeadModel heads{kTableBits};
  PathModel paths;
};

/// Coder 25, both sides: paths one by one or, if they came before as a word,
/// together. Encoder and decoder run this same code; `Side` is what differs:
///
///     coder()      an arithmetic encoder or decoder
///     frame()      what holds for all paths
///     item()       the true next item
///     path(i)      path i; a true one if i was not coded
///     add(path)    a path is complete
///     damaged()    the payload cannot be right; give up
///
/// The decoder's answers to the questions of what is true are never looked at.
template <class Side>
class StrokeScan {
 public:
  static constexpr int kMaxUnitBits = 3;
  static constexpr std::int32_t kMaxVector = 2 * kMaxCoord;

  StrokeScan(Side& side, StrokeModels& models, std::uint64_t count,
             std::uint64_t elements)
      : side_(side),
        count_(count),
        left_(elements),
        sequence_(models.items),
        starts_(models.starts),
        layouts_(models.layout),
        anchors_(models.anchors),
        heads_(models.heads),
        model_(models.paths) {}

  Status run(const BlockProgress& progress) {
    if (count_ == 0) return left_ == 0 ? Status() : damaged();
    restart();
    for (std::uint64_t told = 0; done_ < count_; ++told) {
      if (progress && told % 64 == 63 && !progress(done_)) {
        return Error{ErrorCode::cancelled, "cancelled"};
      }
      if (!item() || side_.damaged()) return damaged();
    }
    return left_ == 0 ? Status() : damaged();
  }

 private:
  enum Field : std::uint8_t {
    kUnit,
    kRefers,
    kWord,
    kNewLine,
    kClass,
    kGoesOn,
    kAnchored,
    kRestX,
    kRestY,
    kDown = 0,
    kRight
  };
  /// A word as the layout sees it: the box of its vertices, in units.
  struct Placed {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t w = 0;
    std::int32_t h = 0;
    bool new_line = false;
    [[nodiscard]] std::int32_t width() const { return w; }
    [[nodiscard]] std::int32_t height() const { return h; }
  };

  [[nodiscard]] Error damaged() const {
    return {ErrorCode::corrupt,
            "path payload is damaged at path " + std::to_string(done_ + 1)};
  }
  auto& coder() { return side_.coder(); }

  void restart() {
    const StrokeFrame truth = side_.frame();
    model_.restart();
    anchors_.restart();
    heads_.restart();
    frame_.unit_bits = static_cast<int>(sequence_.small(
        coder(), kUnit, static_cast<unsigned>(truth.unit_bits), 2, {}));
    unit_ = 1 << frame_.unit_bits;
    model_.code_frame(coder(), truth.paths);
  }

  bool item() {
    const StrokeItem truth = side_.item();
    const ShapePast& a = past_[0];
    const ShapePast& b = past_[1];
    bool refers = false;
    if (!words_.empty()) {
      refers = sequence_.flag(
          coder(), kRefers, truth.refers,
          {join_values(0, was_word_), join_values(1, a.klass, was_word_),
           join_values(2, a.klass, b.klass), join_values(3, anchored_),
           join_values(4, history_ & 7U),
           join_values(5, history_ & 255U)});
    }
    history_ = history_ << 1 | (refers ? 1U : 0U);
    return refers ? again(truth) : fresh(truth);
  }

  // --- words that came before ---

  bool again(const StrokeItem& truth) {
    const ShapePast& a = past_[0];
    const ShapePast& b = past_[1];
    const ShapePast& c = past_[2];
    const std::uint64_t line = truth_line(truth);
    const std::uint32_t klass = sequence_.number(
        coder(), kClass, truth.reference,
        {line, join_values(1, a.klass, line),
         join_values(2, a.klass, b.klass, line),
         join_values(3, a.klass, b.klass, c.klass), join_values(4, a.gap),
         join_values(5, a.width, a.height)});
    if (klass >= words_.size()) return false;
    const StrokeWord& word = words_[klass];
    if (word.count > count_ - done_) return false;
    ShapePast now;
    now.refers = now.same = true;
    now.klass = now.id = klass + 1;
    Point origin;
    if (!place(klass, now, line != 0, origin)) return false;
    const Point first = side_.path(word.first).origin;
    for (std::uint64_t i = 0; i < word.count; ++i) {
      Path path = side_.path(word.first + i);
      path.origin = {path.origin.x - first.x + origin.x,
                     path.origin.y - first.y + origin.y};
      if (path.elements.size() > left_) return false;
      follow(path);
      heads_.pass({path.closed, path.width, path.elements.size()});
      take(std::move(path));
    }
    remember(now);
    was_word_ = 2;
    return true;
  }

  std::uint64_t truth_line(const StrokeItem& truth) {
    const ShapePast& a = past_[0];
    return sequence_.flag(
               coder(), kNewLine, truth.new_line,
               {join_values(0, was_word_), join_values(1, a.klass),
                join_values(2, a.klass, past_[1].klass),
                join_values(3, anchored_), join_values(4, clip_value(a.gap, 20)),
                join_values(5, history_ & 31U)})
               ? 1
               : 0;
  }

  /// Where a word begins that came before.
  bool place(std::uint32_t klass, ShapePast& now, bool new_line,
             Point& origin) {
    const Point truth = side_.path(done_).origin;
    const std::uint64_t kind = join_values(100, klass);
    const UnitPoint true_point = in_units(truth, unit_);
    UnitPoint point;
    point.rest = code_rest(true_point.rest, kind);
    const bool anchored = code_anchored(true_point.at, kind, 2);
    const VertexBox& box = boxes_[klass];
    if (anchored) {
      const auto at =
          anchors_.code(coder(), model_.vertices(), true_point.at, kind);
      if (!at) return false;
      point.at = *at;
      shape_ = shape_at(point, box, new_line);
      now.width = shape_.w;
      now.height = shape_.h;
    } else {
      Placed shape = shape_at({{}, point.rest}, box, new_line);
      const Placed true_shape =
          shape_at({true_point.at, point.rest}, box, new_line);
      const Point corner{shape.x, shape.y};
      now.width = shape.w;
      now.height = shape.h;
      if (!layout_.code_place(coder(), layouts_, shape, true_shape, now,
                              past_)) {
        return false;
      }
      point.at = {shape.x - corner.x, shape.y - corner.y};
      shape_ = shape;
    }
    const std::int64_t x = std::int64_t{point.at.x} * unit_ + point.rest.x;
    const std::int64_t y = std::int64_t{point.at.y} * unit_ + point.rest.y;
    if (!in_range({x + box.left, y + box.top, x + box.right, y + box.bottom})) {
      return false;
    }
    origin = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    return true;
  }

  Placed shape_at(const UnitPoint& origin, const VertexBox& box,
                  bool new_line) const {
    const auto units = [&](std::int64_t v) { return floor_div(v, unit_); };
    const std::int64_t left = units(origin.rest.x + box.left);
    const std::int64_t top = units(origin.rest.y + box.top);
    const auto part = [](std::int64_t v) {
      return static_cast<std::int32_t>(v);
    };
    return {part(origin.at.x + left), part(origin.at.y + top),
            part(units(origin.rest.x + box.right) - left),
            part(units(origin.rest.y + box.bottom) - top), new_line};
  }

  // --- paths told one by one ---

  bool fresh(const StrokeItem& truth) {
    const bool word = sequence_.flag(
        coder(), kWord, truth.word,
        {join_values(0, was_word_), join_values(1, history_ & 7U),
         join_values(2, anchored_), join_values(3, past_[0].klass),
         join_values(4, words_.size() / 8), join_values(5, was_word_, history_ & 3U)});
    const bool new_line = word && truth_line(truth) != 0;
    const std::uint64_t first = done_;
    for (std::uint64_t i = 0;; ++i) {
      if (!one(word, i)) return false;
      if (!word || done_ == count_) break;
      const std::uint64_t n = std::min<std::uint64_t>(i, 7);
      const std::uint64_t last = side_.path(done_ - 1).elements.size();
      if (!sequence_.flag(coder(), kGoesOn, i + 1 < truth.count,
                          {n, join_values(1, last), join_values(2, anchored_),
                           join_values(3, last, n), join_values(4, rest_.x, rest_.y), 5})) {
        break;
      }
    }
    was_word_ = word ? 1 : 0;
    if (word) open(first, new_line);
    return true;
  }

  void open(std::uint64_t first, bool new_line) {
    VertexBox box;
    for (std::uint64_t i = first; i < done_; ++i) box.add(side_.path(i));
    const Point origin = side_.path(first).origin;
    box = {box.left - origin.x, box.top - origin.y, box.right - origin.x,
           box.bottom - origin.y};
    words_.push_back({first, done_ - first});
    boxes_.push_back(box);
    shape_ = shape_at(in_units(origin, unit_), box, new_line);
    ShapePast now;
    now.width = shape_.w;
    now.height = shape_.h;
    remember(now);
    past_[0].klass = past_[0].id = static_cast<std::uint32_t>(words_.size());
  }

  bool one(bool word, std::uint64_t index) {
    const Path& truth = side_.path(done_);
    const std::uint64_t kind =
        word ? 1 + std::min<std::uint64_t>(index, 3) : 0;
    StrokeHead head{truth.closed, truth.width, truth.elements.size()};
    if (!heads_.code(coder(), head, kind, left_)) return false;
    const std::uint64_t about =
        join_values(kind, head.closed);
    const UnitPoint true_point = in_units(truth.origin, unit_);
    UnitPoint point;
    point.rest = code_rest(true_point.rest,
                           join_values(head.width, rest_.x, rest_.y));
    if (code_anchored(true_point.at, about, word ? 1 : 0)) {
      const auto at =
          anchors_.code(coder(), model_.vertices(), true_point.at, about);
      if (!at) return false;
      point.at = *at;
    } else {
      const Vec start = code_start(true_point.at, about);
      if (!in_range(start.x) || !in_range(start.y)) return false;
      point.at = {static_cast<std::int32_t>(start.x),
                  static_cast<std::int32_t>(start.y)};
    }
    rest_ = point.rest;
    move_ = {point.at.x - start_.x, point.at.y - start_.y};
    start_ = point.at;
    const std::int64_t x = std::int64_t{point.at.x} * unit_ + point.rest.x;
    const std::int64_t y = std::int64_t{point.at.y} * unit_ + point.rest.y;
    if (!in_range(x) || !in_range(y)) return false;
    Path path;
    path.closed = head.closed;
    path.width = head.width;
    path.origin = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    return elements(truth, head, point.at, std::move(path), kind);
  }

  bool elements(const Path& truth, const StrokeHead& head, Point at,
                Path path, std::uint64_t kind) {
    model_.begin({at, head.closed, head.width, head.elements, 0});
    Vec last;
    for (std::uint64_t k = 0; head.closed ? k < head.elements : heads_.code_more(coder(), k < truth.elements.size(), k, last, kind); ++k) {
      if (k == left_) return false;
      Path::Element element;
      if (k < truth.elements.size()) {
        element = changed(truth.elements[static_cast<std::size_t>(k)],
                          [&](std::int32_t v) { return v / unit_; });
      }
      if (side_.damaged() || !model_.code(coder(), element)) return false;
      bool fits = true;
      path.elements.push_back(changed(element, [&](std::int32_t v) {
        fits &= v >= -kMaxVector / unit_ && v <= kMaxVector / unit_;
        return fits ? v * unit_ : 0;
      }));
      if (!fits) return false;
      last = element.kind == Path::Kind::arc ? Vec{element.arc.end.x, element.arc.end.y} : Vec{element.segment.dx, element.segment.dy};
    }
    heads_.set_elements(path.elements.size());
    model_.end();
    VertexBox box;
    box.add(path);
    if (!in_range(box)) return false;
    take(std::move(path));
    return true;
  }

  /// A beginning that is on nothing: from that of the path before.
  Vec code_start(Point truth, std::uint64_t kind) {
    Point from{};
    if (model_.vertices().size() > 0) {
      VertexBox cluster;
      for (std::int32_t id = model_.vertices().size(); id-- > cluster_;) {
        cluster.add(model_.vertices()[id].at.x, model_.vertices()[id].at.y);
      }
      from = {static_cast<std::int32_t>(cluster.right), static_cast<std::int32_t>(cluster.top)};
    }
    cluster_ = model_.vertices().size();
    const auto same = static_cast<std::uint64_t>(anchored_ & 7U);
    const std::int64_t dy = starts_.signed_number(
        coder(), kDown, std::int64_t{truth.y} - from.y,
        {0, join_values(1, kind), join_values(2, same),
         join_values(3, clip_value(move_.y, 30)),
         join_values(4, clip_value(move_.x, 30)), join_values(5, kind, same)});
    const std::uint64_t level = static_cast<std::uint64_t>(
        std::bit_width(static_cast<std::uint64_t>(std::abs(dy))));
    const std::uint64_t down = dy < 0 ? 64 + level : level;
    const std::int64_t dx = starts_.signed_number(
        coder(), kRight, std::int64_t{truth.x} - from.x,
        {down, join_values(1, kind, down), join_values(2, same, down),
         join_values(3, clip_value(move_.x, 30), down),
         join_values(4, dy), join_values(5, kind, same)});
    return {from.x + dx, from.y + dy};
  }

  Point code_rest(Point truth, std::uint64_t kind) {
    if (unit_ == 1) return {};
    const int bits = frame_.unit_bits;
    const auto x = sequence_.small(
        coder(), kRestX, static_cast<unsigned>(truth.x), bits,
        {kind, join_values(1, rest_.x, rest_.y), 2, 3, 4, 5});
    const auto y = sequence_.small(
        coder(), kRestY, static_cast<unsigned>(truth.y), bits,
        {join_values(kind, x), join_values(1, rest_.x, rest_.y, x),
         join_values(2, x), 3, 4, 5});
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }

  bool code_anchored(Point truth, std::uint64_t kind, int role) {
    if (model_.vertices().size() == 0) return false;
    const bool found = anchors_.finds(model_.vertices(), truth);
    const bool anchored = sequence_.flag(
        coder(), kAnchored, found,
        {join_values(0, role), join_values(1, kind), join_values(2, anchored_ & 1U, role),
         join_values(3, anchored_ & 15U, role),
         join_values(4, kind, was_word_, anchored_ & 1U), join_values(5, past_[0].klass, role)});
    anchored_ = anchored_ << 1 | (anchored ? 1U : 0U);
    return anchored;
  }

  void follow(const Path& path) {
    const UnitPoint point = in_units(path.origin, unit_);
    model_.begin({point.at, path.closed, path.width, path.elements.size(), 0});
    for (const Path::Element& element : path.elements) {
      model_.follow(
          changed(element, [&](std::int32_t v) { return v / unit_; }));
    }
    model_.end();
  }

  void take(Path path) {
    left_ -= path.elements.size();
    side_.add(std::move(path));
    ++done_;
  }

  void remember(const ShapePast& now) {
    layout_.advance(shape_, now.klass);
    past_[2] = past_[1];
    past_[1] = past_[0];
    past_[0] = now;
  }

  static bool in_range(std::int64_t v) {
    return v >= -kMaxCoord && v <= kMaxCoord;
  }
  static bool in_range(const VertexBox& box) {
    return in_range(box.left) && in_range(box.top) && in_range(box.right) &&
           in_range(box.bottom);
  }

  Side& side_;
  std::uint64_t count_;
  std::uint64_t left_;  ///< elements of the paths to come
  std::uint64_t done_ = 0;
  StrokeFrame frame_;
  std::int32_t unit_ = 1;

  // What learns.
  NumberSequence& sequence_;
  NumberSequence& starts_;
  ShapeSequence& layouts_;
  StrokeAnchor& anchors_;
  StrokeHeadModel& heads_;
  PathModel& model_;

  // What is remembered of this payload.
  std::vector<StrokeWord> words_;
  std::vector<VertexBox> boxes_;  ///< about their origins
  ShapeLayout layout_{kMaxCoord, kMaxCoord};
  ShapePasts past_{};
  Placed shape_;
  unsigned was_word_ = 0;
  unsigned history_ = 0;
  unsigned anchored_ = 0;
  Point rest_;
  Point start_;  ///< where the last path began that was told alone
  std::int32_t cluster_ = 0;
  Point move_;   ///< to there from the one before
};

}  // namespace unstep::codec
