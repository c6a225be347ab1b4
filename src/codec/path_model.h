#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/number_model.h"
#include "codec/path_coder.h"
#include "entropy/counter.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// Predicts the elements of paths. Encoder and decoder run the same object in
/// step; everything is integer.
class PathModel {
 public:
  explicit PathModel(std::uint64_t /*elements*/) {}

  void begin(const PathHead& head) {
    origin_ = at_ = head.origin;
    closed_ = head.closed;
    left_ = head.elements;
  }
  void end() {}

  /// Where the last path started.
  [[nodiscard]] Point start() const { return origin_; }

  /// Codes the next element and goes along it. False if it cannot be.
  template <class Coder>
  bool code(Coder& coder, Path::Element& element) {
    const bool arc = NumberModel::decide(coder, arc_[was_arc_ ? 1 : 0],
                                         element.kind == Path::Kind::arc);
    was_arc_ = arc;
    Point move =
        arc ? element.arc.end : Point{element.segment.dx, element.segment.dy};
    if (closed_ && left_ == 1) {
      move = {origin_.x - at_.x, origin_.y - at_.y};
    } else if (!code_move(coder, ends_, move)) {
      return false;
    }
    if (arc) {
      Arc coded;
      coded.end = move;
      coded.centre = element.arc.centre;
      if (!code_move(coder, centres_, coded.centre)) return false;
      if (coded.centre == Point{}) return false;
      coded.clockwise =
          NumberModel::decide(coder, clockwise_, element.arc.clockwise);
      element = {Path::Kind::arc, {}, coded};
    } else {
      element = {Path::Kind::segment, {move.x, move.y}, {}};
    }
    at_ = {at_.x + move.x, at_.y + move.y};
    --left_;
    return true;
  }

 private:
  template <class Coder>
  bool code_move(Coder& coder, std::array<SignedNumberModel, 2>& models,
                 Point& move) const {
    const std::int64_t dx = models[0].code(coder, move.x);
    const std::int64_t dy = models[1].code(coder, move.y);
    const auto in_range = [](std::int64_t v) {
      return v >= -kMaxCoord && v <= kMaxCoord;
    };
    if (!in_range(at_.x + dx) || !in_range(at_.y + dy)) return false;
    move = {static_cast<std::int32_t>(dx), static_cast<std::int32_t>(dy)};
    return true;
  }

  Point origin_;
  Point at_;
  bool closed_ = false;
  bool was_arc_ = false;
  std::uint64_t left_ = 0;
  std::array<entropy::Counter, 2> arc_;
  entropy::Counter clockwise_;
  std::array<SignedNumberModel, 2> ends_;
  std::array<SignedNumberModel, 2> centres_;
};

}  // namespace unstep::codec
