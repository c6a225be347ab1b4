#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/number_model.h"
#include "codec/path_coder.h"
#include "codec/vector_classes.h"
#include "entropy/counter.h"

namespace unstep::codec {

/// Predicts everything of a path but its elements.
class PathHeadModel {
 public:
  PathHeadModel() {
    closed_[1] = NumberModel::expected(250);
    new_width_ = NumberModel::expected(6);
    for (auto& sets : elements_) {
      for (std::size_t i = 0; i < sets.size(); ++i) {
        sets[i].expect(kElementWidths[std::min<std::size_t>(i, 7)],
                       kElementDigits);
      }
    }
    for (SignedNumberModel& set : turns_) set.expect(kTurnWidths, {}, 128);
  }

  /// `model` codes where the path starts. `left`: the elements that
  /// are left of the payload. `last`: it is the last path and has all of them.
  /// The result is what was coded, not checked.
  template <class Coder, class Model>
  PathHead code(Coder& coder, const PathHead& head, Model& model,
                std::uint64_t left, bool last) {
    PathHead h;
    h.closed = NumberModel::decide(coder, closed_[before_.closed ? 1 : 0],
                                   head.closed);
    h.width = code_width(coder, head.width);
    const std::size_t kind = h.closed ? 1 : 0;
    h.elements = last ? left
                      : elements_[kind][size_class(before_.elements)].code(
                            coder, head.elements);
    code_origin(coder, head.origin, model, h);
    if (h.closed && h.elements > 1) code_turn(coder, head.turn, h);
    before_ = h;
    return h;
  }

  /// Whether the last head cannot be: a number out of its range.
  [[nodiscard]] bool outside() const { return outside_; }

 private:
  /// By the size class of the path before, the last of that and all above.
  static constexpr std::array<std::array<std::uint8_t, 9>, 8> kElementWidths{{
      {252, 252, 236, 185, 143, 120, 104, 63, 128},
      {252, 252, 125, 92, 76, 90, 106, 103, 132},
      {252, 252, 32, 82, 118, 135, 96, 57, 128},
      {252, 252, 86, 80, 82, 94, 116, 144, 128},
      {252, 252, 141, 76, 58, 94, 66, 62, 199},
      {252, 252, 145, 102, 43, 90, 157, 106, 128},
      {252, 252, 108, 147, 89, 30, 37, 128, 128},
      {252, 252, 62, 113, 101, 79, 128, 57, 128},
  }};
  static constexpr std::array<std::uint8_t, 1> kTurnWidths{10};
  static constexpr std::array<std::uint8_t, 11> kElementDigits{
      128, 92, 218, 102, 88, 111, 127, 155, 124, 161, 125};

  static bool in_range(std::int64_t coordinate) {
    return coordinate >= -kMaxCoord && coordinate <= kMaxCoord;
  }
  static std::size_t size_class(std::uint64_t size) {
    return std::min<std::size_t>(static_cast<std::size_t>(std::bit_width(size)),
                                 11);
  }

  template <class Coder>
  std::int32_t code_width(Coder& coder, std::int32_t width) {
    if (!NumberModel::decide(coder, new_width_, width != before_.width)) {
      return before_.width;
    }
    const std::uint64_t coded =
        width_.code(coder, static_cast<std::uint64_t>(width));
    if (coded > static_cast<std::uint64_t>(kMaxCoord)) {
      outside_ = true;
      return 0;
    }
    return static_cast<std::int32_t>(coded);
  }

  template <class Coder, class Model>
  void code_origin(Coder& coder, Point origin, Model& model, PathHead& h) {
    const Vec start = model.code_start(coder, origin);
    if (!in_range(start.x) || !in_range(start.y)) {
      outside_ = true;
      return;
    }
    h.origin = {static_cast<std::int32_t>(start.x),
                static_cast<std::int32_t>(start.y)};
  }

  /// A number for each small number of elements, then for each doubling.
  template <class Coder>
  void code_turn(Coder& coder, std::int64_t turn, PathHead& h) {
    const std::size_t set =
        h.elements < 12 ? static_cast<std::size_t>(h.elements)
                        : 8 + std::min<std::size_t>(size_class(h.elements), 11);
    h.turn = turns_[set].code(coder, turn);
    const auto size = static_cast<std::uint64_t>(h.turn < 0 ? -h.turn : h.turn);
    if (size > h.elements / 2) outside_ = true;
  }

  std::array<entropy::Counter, 2> closed_;
  entropy::Counter new_width_;
  NumberModel width_;
  std::array<std::array<NumberModel, 12>, 2> elements_;
  std::array<SignedNumberModel, 20> turns_;
  PathHead before_;
  bool outside_ = false;
};

}  // namespace unstep::codec
