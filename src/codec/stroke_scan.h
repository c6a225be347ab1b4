#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "codec/block_coder.h"
#include "codec/stroke_coder.h"
#include "codec/stroke_models.h"
#include "codec/stroke_start.h"
#include "codec/stroke_words.h"

namespace unstep::codec {

/// What holds for all paths of a payload.
struct StrokeFrame {
  bool arcs = false;  ///< there are some
  int unit_bits = 0;  ///< vectors are multiples of 2 to this power
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
  /// REQUIRES: `models` have learned the same on both sides.
  StrokeScan(Side& side, StrokeModels& models, std::uint64_t count,
             std::uint64_t elements)
      : side_(side),
        models_(models),
        count_(count),
        left_(elements),
        words_(models),
        starts_(models) {
    models.restart();
  }

  Status run(const BlockProgress& progress) {
    if (count_ == 0) return left_ == 0 ? Status() : damaged();
    code_frame();
    for (std::uint64_t told = 0; done_ < count_; ++told) {
      if (progress && told % 64 == 63 && !progress(done_)) {
        return Error{ErrorCode::cancelled, "cancelled"};
      }
      const StrokeItem truth = side_.item();
      const bool refers =
          words_.code_refers(coder(), truth.refers, starts_.history());
      const bool coded = refers ? again(truth) : fresh(truth);
      if (!coded || side_.damaged()) return damaged();
    }
    return left_ == 0 ? Status() : damaged();
  }

 private:
  enum Field : std::uint8_t { kUnit = 5 };  // after those of StrokeWords
  enum Role : std::uint8_t { kAlone, kInWord, kWord };
  static constexpr std::int64_t kMaxVector = 2 * std::int64_t{kMaxCoord};

  [[nodiscard]] Error damaged() const {
    return {ErrorCode::corrupt,
            "path payload is damaged at path " + std::to_string(done_ + 1)};
  }
  auto& coder() { return side_.coder(); }
  [[nodiscard]] std::int32_t unit() const { return starts_.unit(); }

  void code_frame() {
    const StrokeFrame truth = side_.frame();
    starts_.set_unit_bits(static_cast<int>(models_.items.small(
        coder(), kUnit, static_cast<unsigned>(truth.unit_bits), 2,
        {0, 1, 2, 3, 4, 5})));
    models_.paths.code_arcs(coder(), truth.arcs);
  }

  /// A word that came before.
  bool again(const StrokeItem& truth) {
    const bool new_line =
        words_.code_new_line(coder(), truth.new_line, starts_.history());
    const std::uint32_t klass =
        words_.code_class(coder(), truth.reference, new_line);
    if (klass >= words_.size()) return false;
    const StrokeWord word = words_[klass];
    if (word.count > count_ - done_) return false;
    Point origin;
    if (!place(klass, new_line, origin)) return false;
    const Point first = side_.path(word.first).origin;
    for (std::uint64_t i = 0; i < word.count; ++i) {
      Path path = side_.path(word.first + i);
      if (path.elements.size() > left_) return false;
      // Within the box, whose corners were checked.
      path.origin = {path.origin.x - first.x + origin.x,
                     path.origin.y - first.y + origin.y};
      follow(path);
      take(std::move(path));
    }
    return true;
  }

  /// Where a word begins that came before.
  bool place(std::uint32_t klass, bool new_line, Point& origin) {
    const UnitPoint truth = in_units(side_.path(done_).origin, unit());
    const std::uint64_t kind = join_values(100, klass);
    UnitPoint point;
    point.rest = starts_.code_rest(coder(), truth.rest, kind);
    if (starts_.code_anchored(coder(), truth.at, kind, kWord, words_.last())) {
      const auto at = starts_.on_path(coder(), truth.at, kind);
      if (!at) return false;
      point.at = *at;
      if (!words_.stand(klass, new_line, unit(), point)) return false;
    } else if (!words_.code_place(coder(), klass, new_line, unit(), truth,
                                  point)) {
      return false;
    }
    const std::int64_t x = full(point.at.x, point.rest.x);
    const std::int64_t y = full(point.at.y, point.rest.y);
    const VertexBox& box = words_.box(klass);
    if (!in_range({x + box.left, y + box.top, x + box.right, y + box.bottom})) {
      return false;
    }
    origin = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    return true;
  }

  /// Paths told one by one: one, or those of a new word.
  bool fresh(const StrokeItem& truth) {
    const bool word = words_.code_word(coder(), truth.word, starts_.history());
    if (!word) return one(0);
    const bool new_line =
        words_.code_new_line(coder(), truth.new_line, starts_.history());
    const std::uint64_t first = done_;
    for (std::uint64_t n = 1;; ++n) {
      if (!one(n)) return false;
      if (done_ == count_ ||
          !words_.code_goes_on(coder(), n < truth.count, n,
                               side_.path(done_ - 1).elements.size(),
                               starts_.history(), starts_.rest())) {
        break;
      }
    }
    VertexBox box;
    for (std::uint64_t i = first; i < done_; ++i) box.add(side_.path(i));
    const Point origin = side_.path(first).origin;
    box = {box.left - origin.x, box.top - origin.y, box.right - origin.x,
           box.bottom - origin.y};
    return words_.open({first, done_ - first}, box, new_line, unit(),
                       in_units(origin, unit()));
  }

  /// A path; `in_word` counts those of a new word from 1.
  bool one(std::uint64_t in_word) {
    const Path& truth = side_.path(done_);
    const std::uint64_t kind = std::min<std::uint64_t>(in_word, 4);
    StrokeHead head{truth.closed, truth.width, truth.elements.size()};
    if (!models_.heads.code(coder(), head, kind, left_)) return false;
    UnitPoint point;
    if (!begin(in_units(truth.origin, unit()), head, kind, point)) return false;
    const std::int64_t x = full(point.at.x, point.rest.x);
    const std::int64_t y = full(point.at.y, point.rest.y);
    if (!in_range(x) || !in_range(y)) return false;
    Path path;
    path.closed = head.closed;
    path.width = head.width;
    path.origin = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    models_.paths.begin({point.at, head.closed, head.width, head.elements, 0});
    if (!elements(truth, head, kind, path)) return false;
    models_.paths.end();
    VertexBox box;
    box.add(path);
    if (!in_range(box)) return false;
    take(std::move(path));
    return true;
  }

  bool begin(const UnitPoint& truth, const StrokeHead& head, std::uint64_t kind,
             UnitPoint& point) {
    const std::uint64_t about = join_values(kind, head.closed);
    const Point rest = starts_.rest();
    point.rest = starts_.code_rest(
        coder(), truth.rest, join_values(200, head.width, rest.x * 8 + rest.y));
    if (starts_.code_anchored(coder(), truth.at, about,
                              kind > 0 ? kInWord : kAlone, words_.last())) {
      const auto at = starts_.on_path(coder(), truth.at, about);
      if (!at) return false;
      point.at = *at;
    } else {
      const Vec at = starts_.free(coder(), truth.at, about);
      if (!in_range(at.x) || !in_range(at.y)) return false;
      point.at = {static_cast<std::int32_t>(at.x),
                  static_cast<std::int32_t>(at.y)};
    }
    starts_.advance(point);
    return true;
  }

  bool elements(const Path& truth, const StrokeHead& head, std::uint64_t kind,
                Path& path) {
    const auto more = [&](std::uint64_t k, const Vec& last) {
      if (head.closed) return k < head.elements;
      return models_.heads.code_more(coder(), k < truth.elements.size(), k,
                                     last, kind);
    };
    Vec last;
    for (std::uint64_t k = 0; more(k, last); ++k) {
      if (k == left_) return false;
      Path::Element element;
      if (k < truth.elements.size()) {
        element = changed(truth.elements[static_cast<std::size_t>(k)],
                          [&](std::int32_t v) { return v / unit(); });
      }
      if (side_.damaged() || !models_.paths.code(coder(), element)) {
        return false;
      }
      bool fits = true;
      path.elements.push_back(changed(element, [&](std::int32_t v) {
        const std::int64_t whole = std::int64_t{v} * unit();
        fits &= whole >= -kMaxVector && whole <= kMaxVector;
        return fits ? static_cast<std::int32_t>(whole) : 0;
      }));
      if (!fits) return false;
      last = move_of(element);
    }
    models_.heads.set_elements(path.elements.size());
    return true;
  }

  /// Goes along a path that is not coded.
  void follow(const Path& path) {
    const Point at = in_units(path.origin, unit()).at;
    models_.paths.begin({at, path.closed, path.width, path.elements.size(), 0});
    for (const Path::Element& element : path.elements) {
      models_.paths.follow(
          changed(element, [&](std::int32_t v) { return v / unit(); }));
    }
    models_.paths.end();
    models_.heads.pass(path.width);
  }

  void take(Path path) {
    left_ -= path.elements.size();
    side_.add(std::move(path));
    ++done_;
  }

  [[nodiscard]] std::int64_t full(std::int32_t units, std::int32_t rest) const {
    return std::int64_t{units} * unit() + rest;
  }
  static bool in_range(std::int64_t v) {
    return v >= -kMaxCoord && v <= kMaxCoord;
  }
  static bool in_range(const VertexBox& box) {
    return in_range(box.left) && in_range(box.top) && in_range(box.right) &&
           in_range(box.bottom);
  }

  Side& side_;
  StrokeModels& models_;
  std::uint64_t count_;
  std::uint64_t left_;  ///< elements of the paths to come
  std::uint64_t done_ = 0;
  StrokeWords words_;
  StrokeStart starts_;
};

}  // namespace unstep::codec
