#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/context.h"
#include "codec/deep_model.h"
#include "codec/shape_pixels.h"

namespace unstep::codec {

/// The pixels of shapes for the max effort, in two DeepModels. Beside the
/// pixels around it sees where the edges above run and, of a shape that refers
/// to another: seven rows of it, where the two differed so far, what other
/// shapes of the class had at this place, and two of them.
class DeepShapePixels {
 public:
  static constexpr int kGateRare = 100;      ///< of 65536
  static constexpr std::int32_t kReach = 3;  ///< rows of the reference
  static constexpr std::int32_t kLook = 20;  ///< 11 pixels ahead are seen
  static constexpr bool kSeesOthers = true;

  explicit DeepShapePixels(int table_bits)
      : free_(table_bits, kFreeSizes), told_(table_bits, kToldSizes) {}

  static std::uint64_t memory(int table_bits) {
    return Free::memory(table_bits, kFreeSizes) +
           Told::memory(table_bits, kToldSizes);
  }

  void skip() {}

  template <class Coder, class Order>
  bool code(Coder& coder, bool truth, std::int32_t x,
            const typename Order::Near& n, const Order& order) {
    const int gate = entropy::stretch(n.gate);
    if (!order.refers()) {
      look(n, x, order);
      free_.set_extra(0, gate);
      return free_.code(coder, truth, free_choice_);
    }
    look_at_reference(n, x, order);
    told_.set_extra(0, gate);
    return told_.code(coder, truth, told_choice_);
  }

 private:
  using Free = DeepModel<16, 1, 5, 2>;
  using Told = DeepModel<20, 1, 5, 2>;
  static constexpr Free::Choice kFreeSizes{
      {512, 128, 1024, 1024, 1024}, {512, 1024}, 32};
  static constexpr Told::Choice kToldSizes{
      {512, 128, 1024, 1024, 1024}, {512, 1024}, 32};

  /// Where the colour changes first from x - 8 on, 0..19, and that colour.
  static std::uint64_t edge(std::uint64_t window) {
    const std::uint64_t from = window << 24;
    const std::uint64_t ink = from >> 63;
    const std::uint64_t other = ink != 0 ? ~from : from;
    return static_cast<std::uint64_t>(std::min(std::countl_zero(other), 19)) |
           ink << 5;
  }
  /// How long the run before x is, 0..31, and its colour.
  static std::uint64_t run(std::uint64_t window) {
    const std::uint64_t left = window >> 32;
    const std::uint64_t ink = left & 1;
    const std::uint64_t other = ink != 0 ? ~left : left;
    return static_cast<std::uint64_t>(std::min(std::countr_zero(other), 31)) |
           ink << 5;
  }

  template <class Near, class Order>
  void look(const Near& n, std::int32_t x, const Order& order) {
    const auto cut = Order::cut;
    const auto before = Order::before;
    const std::uint64_t r3 = order.above(3, x);
    const std::uint64_t r4 = order.above(4, x);
    const std::uint64_t r5 = order.above(5, x);
    const std::uint64_t r6 = order.above(6, x);
    const std::uint64_t place = order.place(x);
    const std::uint64_t three =
        cut(n.r1, 1, 1) | cut(n.r2, 1, 1) << 3 | cut(r3, 1, 1) << 6;
    const std::uint64_t close = before(n.r0, 6) | cut(n.r1, 4, 4) << 6 |
                                cut(n.r2, 3, 3) << 15 | cut(r3, 2, 2) << 22;
    const std::uint64_t edges = edge(n.r1) | edge(n.r2) << 6;

    std::size_t i = 0;
    const auto ask = [&](std::uint64_t value) { free_.ask_mixed(i++, value); };
    ask(close);
    ask(before(n.r0, 8) | cut(n.r1, 6, 6) << 8 | cut(n.r2, 5, 5) << 21 |
        cut(r3, 4, 4) << 32 | cut(r4, 2, 2) << 41);
    ask(mix(before(n.r0, 9) | cut(n.r1, 7, 7) << 9 | cut(n.r2, 6, 6) << 24 |
                cut(r3, 5, 5) << 37,
            cut(r4, 4, 4) | cut(r5, 3, 3) << 9 | cut(r6, 2, 2) << 16));
    ask(before(n.r0, 16) | cut(n.r1, 8, 11) << 16);
    ask(before(n.r0, 7) | cut(n.r1, 5, 1) << 7);
    ask(before(n.r0, 2) | cut(n.r1, 1, 8) << 2 | cut(n.r2, 0, 8) << 12 |
        cut(r3, 0, 7) << 21);
    ask(before(n.r0, 8) | cut(n.r1, 8, 1) << 8 | cut(n.r2, 7, 0) << 18 |
        cut(r3, 7, 0) << 26);
    ask(before(n.r0, 5) | cut(n.r1, 3, 3) << 5 | cut(n.r2, 3, 3) << 12 |
        cut(r3, 1, 1) << 19);
    ask(cut(n.r1, 3, 3) | cut(n.r2, 3, 3) << 7 | cut(r3, 3, 3) << 14 |
        cut(r4, 3, 3) << 21 | cut(r5, 3, 3) << 28 | cut(r6, 3, 3) << 35);
    ask(three | cut(r4, 1, 1) << 9 | cut(r5, 1, 1) << 12 | cut(r6, 1, 1) << 15 |
        (n.corner & 3) << 18);
    ask(mix(close, place & 1023));
    ask(n.corner | place << 5);
    ask(n.near);
    ask(edges | run(n.r0) << 12);
    ask(edges | edge(r3) << 12 | edge(r4) << 18 | run(n.r0) << 24);
    ask(edges | edge(r3) << 12 | edge(r4) << 18 | run(n.r0) << 24 |
        edge(r5) << 30 | edge(r6) << 36);

    const std::uint64_t shape = before(n.r0, 3) | cut(n.r1, 2, 3) << 3;
    const std::uint64_t column = three | (n.corner & 1) << 9;
    free_choice_ = {{shape, n.corner | (n.r2 >> 31 & 3) << 5,
                     (place & 31) | (place >> 10 & 31) << 5, column,
                     edge(n.r1) * 16 + (run(n.r0) & 15)},
                    {shape, column},
                    n.corner};
  }

  template <class Near, class Order>
  void look_at_reference(const Near& n, std::int32_t x, const Order& order) {
    const auto cut = Order::cut;
    const auto before = Order::before;
    const ShapeReference& reference = order.reference();
    const auto row = [&](int k) { return order.matched(k, x); };
    const std::uint64_t r3 = order.above(3, x);
    const std::uint64_t r4 = order.above(4, x);
    const std::uint64_t r5 = order.above(5, x);
    const std::uint64_t r6 = order.above(6, x);
    const std::uint64_t mid = row(0);
    const std::uint64_t here = mid >> 31 & 1;
    const std::uint64_t seven = mix(
        cut(row(-2), 3, 3) | cut(row(-1), 3, 3) << 7 | cut(mid, 3, 3) << 14 |
            cut(row(1), 3, 3) << 21 | cut(row(2), 3, 3) << 28,
        cut(row(-3), 2, 2) | cut(row(3), 2, 2) << 5);
    const std::uint64_t close = before(n.r0, 6) | cut(n.r1, 4, 4) << 6 |
                                cut(n.r2, 3, 3) << 15 | cut(r3, 2, 2) << 22;
    // Where the shape differed from its reference.
    const std::uint64_t d0 = n.r0 ^ mid;
    const std::uint64_t d1 = n.r1 ^ row(-1);
    const std::uint64_t d2 = n.r2 ^ row(-2);
    const std::uint64_t differed =
        before(d0, 3) | cut(d1, 1, 1) << 3 | cut(d2, 1, 1) << 6 | here << 9;
    // The place in the class.
    const std::uint64_t at =
        mix(reference.klass,
            static_cast<std::uint64_t>(x + reference.x) << 32 ^
                static_cast<std::uint64_t>(order.y() + reference.y));
    const std::array<std::uint64_t, 2> others{
        block_of(reference.others[0], x, order.y()),
        block_of(reference.others[1], x, order.y())};
    const std::uint64_t both = cross(others[0]) | cross(others[1]) << 6;

    std::size_t i = 0;
    const auto ask = [&](std::uint64_t value) { told_.ask_mixed(i++, value); };
    ask(n.block | order.place(x) << 9);
    ask(close);
    ask(before(n.r0, 8) | cut(n.r1, 6, 6) << 8 | cut(n.r2, 5, 5) << 21 |
        cut(r3, 4, 4) << 32 | cut(r4, 2, 2) << 41);
    ask(before(n.r0, 3) | cut(n.r1, 2, 6) << 3 | cut(n.r2, 2, 6) << 12 |
        cut(r3, 2, 5) << 21);
    ask(before(n.r0, 1) | cut(n.r1, 1, 3) << 1 | cut(n.r2, 1, 1) << 6 |
        cut(r3, 1, 1) << 9 | cut(r4, 1, 1) << 12 | cut(r5, 1, 1) << 15 |
        cut(r6, 1, 1) << 18);
    ask(seven);
    ask(mix(n.block, close));
    ask(mix(seven, n.near));
    ask(mix(n.block, before(d0, 6) | cut(d1, 4, 4) << 6 | cut(d2, 3, 3) << 15 |
                         cut(r3 ^ row(-3), 2, 2) << 22));
    ask(mix(n.block, before(d0, 3) | cut(d1, 2, 2) << 3 | cut(d2, 1, 1) << 8));
    ask(at);
    ask(mix(at, n.block));
    ask(mix(at, here | (n.corner & 3) << 1));
    ask(mix(at, n.block | n.corner << 9));
    ask(mix(n.block, both));
    ask(mix(n.block | n.corner << 9, others[0]));
    ask(mix(cut(mid, 1, 1) | (row(-1) >> 31 & 1) << 3 |
                (row(1) >> 31 & 1) << 4 | n.corner << 5,
            both));
    ask(mix(others[0], others[1]));
    ask(mix(cut(mid, 4, 6) | cut(row(1), 4, 6) << 11 | cut(row(2), 3, 5) << 22,
            n.corner));
    ask(mix(cut(mid, 0, 5) | cut(row(1), 2, 4) << 6 | cut(row(2), 2, 2) << 13 |
                cut(row(3), 1, 1) << 18,
            n.near));

    const std::uint64_t place = order.place(x);
    told_choice_ = {{n.block, n.corner | std::uint64_t{order.quality()} << 5,
                     differed, (place & 31) | (place >> 10 & 31) << 5,
                     mix(both, here) * kGolden >> 54},
                    {n.block, differed},
                    n.corner};
  }

  /// Nine pixels of another shape, and a bit that there is one.
  static std::uint64_t block_of(const ShapeCanvas* other, std::int32_t x,
                                std::int32_t y) {
    if (other == nullptr) return 0;
    const auto three = [&](std::int32_t k) {
      return ShapeCanvas::window(other->row(y + k), x) >> 30 & 7;
    };
    return three(0) | three(-1) << 3 | three(1) << 6 | 512;
  }
  /// The middle five of them.
  static std::uint64_t cross(std::uint64_t block) {
    return (block & 7) | (block >> 4 & 1) << 3 | (block >> 7 & 1) << 4 |
           (block >> 9) << 5;
  }

  Free free_;
  Told told_;
  Free::Choice free_choice_;
  Told::Choice told_choice_;
};

}  // namespace unstep::codec
