#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "codec/number_sequence.h"
#include "codec/vector_classes.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// What is told of a path before its first point.
struct StrokeHead {
  bool closed = false;
  std::int32_t width = 0;
  std::uint64_t elements = 0;
};

/// Predicts heads: a pen is told by how recently it was used.
class StrokeHeadModel {
 public:
  enum Field : std::uint8_t {
    kClosed,
    kPen,
    kNewPen,
    kElements,
    kMoreElements
  };
  static constexpr std::size_t kPens = 16;  ///< that are remembered

  explicit StrokeHeadModel(int table_bits) : sequence_(table_bits) {}

  void restart() {
    pens_.clear();
    before_ = {};
  }

  /// `kind` is what is known of the path; `most` elements at most. False if
  /// the head cannot be.
  template <class Coder>
  bool code(Coder& coder, StrokeHead& head, std::uint64_t kind,
            std::uint64_t most) {
    const StrokeHead& a = before_[0];
    const StrokeHead& b = before_[1];
    StrokeHead h;
    if (!code_pen(coder, head.width, kind, h.width)) return false;
    h.closed = sequence_.flag(
        coder, kClosed, head.closed,
        {kind, join_values(1, h.width), join_values(2, a.closed, b.closed),
         join_values(3, a.width == h.width, a.closed, a.elements),
         join_values(4, size(a.elements), size(b.elements)), 5});
    if (h.closed) {
      h.elements = sequence_.number(
          coder, kElements, static_cast<std::uint32_t>(head.elements),
          {join_values(0, kind), join_values(1, h.width),
           join_values(2, size(a.elements), kind),
           join_values(3, size(a.elements), size(b.elements)),
           join_values(4, a.elements), 5});
      if (h.elements > most) return false;
    }
    before_[1] = before_[0];
    before_[0] = h;
    head = h;
    return true;
  }

  /// Whether an open path goes on after `n` elements, of which the last went
  /// so far.
  template <class Coder>
  bool code_more(Coder& coder, bool more, std::uint64_t n, const Vec& last,
                 std::uint64_t kind) {
    const StrokeHead& a = before_[1];
    const std::uint64_t count = std::min<std::uint64_t>(n, 12);
    const auto length = static_cast<std::uint64_t>(length_class(size_of(last)));
    return sequence_.flag(
        coder, kMoreElements, more,
        {join_values(0, count), join_values(1, count, kind),
         join_values(2, count, length), join_values(3, count, before_[0].width),
         join_values(4, count, a.elements, a.closed),
         join_values(5, std::min<std::uint64_t>(count, 2), length,
                     direction_of(last))});
  }
  void set_elements(std::uint64_t n) { before_[0].elements = n; }

  /// A path with this pen was not coded here.
  void pass(std::int32_t width) { use(width); }

 private:
  static std::uint64_t size(std::uint64_t elements) {
    return static_cast<std::uint64_t>(std::bit_width(elements));
  }

  void use(std::int32_t width) {
    const auto found = std::find(pens_.begin(), pens_.end(), width);
    if (found != pens_.end()) {
      std::rotate(pens_.begin(), found, found + 1);
      return;
    }
    if (pens_.size() == kPens) pens_.pop_back();
    pens_.insert(pens_.begin(), width);
  }

  template <class Coder>
  bool code_pen(Coder& coder, std::int32_t truth, std::uint64_t kind,
                std::int32_t& width) {
    const auto found = std::find(pens_.begin(), pens_.end(), truth);
    const auto rank = static_cast<std::uint32_t>(found - pens_.begin());
    const std::int32_t last = pens_.empty() ? 0 : pens_[0];
    const auto read = sequence_.number(
        coder, kPen, rank,
        {join_values(0, pens_.size()), join_values(1, kind),
         join_values(2, last, pens_.size() < 2 ? 0 : pens_[1]),
         join_values(3, last, kind),
         join_values(4, before_[0].elements, pens_.size()),
         join_values(5, before_[0].width == before_[1].width, kind)});
    if (read > pens_.size()) return false;
    if (read < pens_.size()) {
      width = pens_[read];
    } else {
      const std::int64_t fresh =
          last + sequence_.signed_number(
                     coder, kNewPen, std::int64_t{truth} - last,
                     {0, join_values(1, last), join_values(2, pens_.size()),
                      join_values(3, kind), 4, 5});
      if (fresh < 0 || fresh > kMaxCoord) return false;
      width = static_cast<std::int32_t>(fresh);
    }
    use(width);
    return true;
  }

  NumberSequence sequence_;
  std::vector<std::int32_t> pens_;  ///< the latest first
  std::array<StrokeHead, 2> before_;
};

}  // namespace unstep::codec
