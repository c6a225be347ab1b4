#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "codec/colour_run.h"
#include "codec/pixel_mixer.h"
#include "codec/shape_glyph.h"
#include "codec/shape_warm_start.h"
#include "entropy/counter.h"

namespace unstep::codec {

/// What a shape refers to.
struct ShapeReference {
  const ShapeCanvas* pixels = nullptr;  ///< aligned with the shape's canvas
  /// For models that look at them: the class, the place of the shape's corner
  /// in the frame that all shapes of the class share, and two more shapes of
  /// the class, aligned likewise, or null.
  std::uint32_t klass = 0;
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::array<const ShapeCanvas*, 2> others{};
};

/// The order in which the pixels of one shape are coded: row by row, seeing
/// those before and, if there is one, the shape that it refers to.
///
/// Where all that a pixel's neighbours say is one colour, a whole run is one
/// decision. Other pixels pass a gate: one counter under the nearest pixels,
/// that codes alone if it is nearly certain. The rest is mixed.
template <class Model>
class ShapePixelOrder {
 public:
  static constexpr int kGateAge = 24;  ///< observations before a gate may
  static constexpr bool kSeesOthers = Model::kSeesOthers;
  /// Rows of the reference that are seen, the middle one being the pixel's.
  static constexpr std::size_t kMatched = 2 * Model::kReach + 1;

  /// For training a warm start.
  [[nodiscard]] const Model& model() const { return model_; }

  explicit ShapePixelOrder(int table_bits)
      : model_(table_bits),
        gates_(std::size_t{1} << 17),
        quiet_(std::size_t{1} << 7) {}

  static std::uint64_t memory(int table_bits) {
    return Model::memory(table_bits) + (1 << 20);
  }

  /// `truth` is null for a decoder. `canvas` must be clear. `reference` may be
  /// null.
  template <class Coder>
  void code(Coder& coder, const Glyph* truth, std::int32_t width,
            std::int32_t height, ShapeCanvas& canvas,
            const ShapeReference* reference) {
    errors_ = errors_before_ = 0;
    reference_ = reference;
    refers_ = reference != nullptr;
    for (std::int32_t y = 0; y < height; ++y) {
      for (std::int32_t k = 0; k < 7; ++k) {
        rows_[static_cast<std::size_t>(k)] = canvas.row(y - k);
      }
      for (std::size_t k = 0; k < kMatched && refers_; ++k) {
        matched_[k] = reference->pixels->row(y - Model::kReach +
                                             static_cast<std::int32_t>(k));
      }
      find_busy(width);
      width_ = width;
      y_ = y;
      place_ = std::min<std::uint64_t>(static_cast<std::uint64_t>(y), 31) |
               static_cast<std::uint64_t>(std::min(height - 1 - y, 31)) << 5;
      look(0);
      model_.skip();
      for (std::int32_t x = 0; x < width;) {
        const std::int32_t end = quiet_end(x, width);
        if (end > x) {
          model_.skip();
          x = code_run(coder, truth, x, end, y, end == width, canvas);
          if (x - first_ < kLook) {
            seen_[0] = view(rows_[0], first_);
          } else {
            look(x);
          }
          continue;
        }
        if (x - first_ >= kLook) look(x);
        if (code_pixel(coder, truth != nullptr && truth->get(x, y), x)) {
          canvas.set(x, y);
          seen_[0] |= std::uint64_t{1} << (31 - (x - first_));
        }
        ++x;
      }
    }
  }

  /// Row y - k, and row y + k of the reference, around x: a window with pixel x
  /// in bit 31.
  [[nodiscard]] std::uint64_t above(std::size_t k, std::int32_t x) const {
    return seen_[k] << (x - first_);
  }
  [[nodiscard]] std::uint64_t matched(int k, std::int32_t x) const {
    return matched_seen_[middle(k)] << (x - first_);
  }
  /// `left` pixels before the middle, the middle and `right` after it.
  static constexpr std::uint64_t cut(std::uint64_t window, int left,
                                     int right) {
    return window >> (31 - right) &
           ((std::uint64_t{1} << (left + right + 1)) - 1);
  }
  /// The pixels before the middle.
  static constexpr std::uint64_t before(std::uint64_t window, int count) {
    return window >> 32 & ((std::uint64_t{1} << count) - 1);
  }

  [[nodiscard]] const ShapeReference& reference() const { return *reference_; }
  [[nodiscard]] bool refers() const { return refers_; }
  [[nodiscard]] std::int32_t y() const { return y_; }
  /// 0..3: how often the reference was wrong lately.
  [[nodiscard]] unsigned quality() const { return quality_of(errors_); }
  /// The same before the last pixel that was looked at.
  [[nodiscard]] unsigned quality_before() const {
    return quality_of(errors_before_);
  }
  /// Distances from the sides of the shape, at most 31: top, bottom, left and
  /// right, five bits each.
  [[nodiscard]] std::uint64_t place(std::int32_t x) const {
    return place_ | static_cast<std::uint64_t>(std::min(x, 31)) << 10 |
           static_cast<std::uint64_t>(std::min(width_ - x, 31)) << 15;
  }
  static std::uint64_t view(ShapeCanvas::Row row, std::int32_t x) {
    return ShapeCanvas::window(row, x);
  }

  /// The nearest pixels.
  struct Near {
    std::uint64_t r0, r1, r2;  ///< windows of this row and the two above
    std::uint64_t near, block, corner;
    int gate;  ///< the probability of the gate
  };
  /// `row`: what of this row is to be seen. The gate is left open.
  [[nodiscard]] Near near(std::int32_t x, std::uint64_t row) const {
    const std::uint64_t r1 = above(1, x);
    const std::uint64_t r2 = above(2, x);
    std::uint64_t block = 0;
    if (refers_) {
      block = cut(matched(0, x), 1, 1) | cut(matched(-1, x), 1, 1) << 3 |
              cut(matched(1, x), 1, 1) << 6;
    }
    return {row,   r1,
            r2,    before(row, 4) | cut(r1, 3, 3) << 4 | cut(r2, 2, 2) << 11,
            block, before(row, 2) | cut(r1, 1, 1) << 2,
            0};
  }

 private:
  static constexpr std::size_t kWords = (kMaxShapeSide + 64) / 64;

  /// The next pixels from x on see these windows, moved.
  void look(std::int32_t x) {
    first_ = x;
    for (std::size_t k = 0; k < rows_.size(); ++k) seen_[k] = view(rows_[k], x);
    for (std::size_t k = 0; k < matched_.size() && refers_; ++k) {
      matched_seen_[k] = view(matched_[k], x);
    }
  }
  /// Marks the pixels of a row whose neighbours are of both colours.
  void find_busy(std::int32_t width) {
    for (std::int32_t i = 0; i * 64 < width; ++i) {
      std::uint64_t any = 0;
      std::uint64_t all = ~std::uint64_t{0};
      const auto see = [&](ShapeCanvas::Row row, std::int32_t reach) {
        for (std::int32_t d = -reach; d <= reach; ++d) {
          const std::uint64_t pixels = view(row, i * 64 + 32 + d);
          any |= pixels;
          all &= pixels;
        }
      };
      if (refers_) {
        see(rows_[1], 1);
        for (std::int32_t k = -1; k <= 1; ++k) see(matched_[middle(k)], 1);
      } else {
        see(rows_[1], 3);
        see(rows_[2], 2);
      }
      const auto u = static_cast<std::size_t>(i);
      busy_[u] = any & ~all;
      ink_[u] = all;
    }
  }

  /// Where the quiet run that begins at x ends; x if it is no quiet pixel.
  [[nodiscard]] std::int32_t quiet_end(std::int32_t x,
                                       std::int32_t width) const {
    auto word = static_cast<std::size_t>(x / 64);
    std::uint64_t busy = busy_[word] << x % 64;
    if ((busy >> 63) != 0) return x;
    const std::uint64_t left = before(view(rows_[0], x), refers_ ? 2 : 4);
    const bool ink = (ink_[word] << x % 64 >> 63) != 0;
    if (left != (!ink ? 0U : refers_ ? 3U : 15U)) return x;
    std::int32_t end = x;
    if (busy == 0) {
      end = x - x % 64 + 64;
      for (++word; end < width && busy_[word] == 0; ++word) end += 64;
      if (end < width) busy = busy_[word];
    }
    if (busy != 0) end += std::countl_zero(busy);
    return std::min(end, width);
  }

  /// One decision whether a quiet run is all of its colour. Returns where to
  /// go on.
  template <class Coder>
  std::int32_t code_run(Coder& coder, const Glyph* truth, std::int32_t x,
                        std::int32_t end, std::int32_t y, bool last,
                        ShapeCanvas& canvas) {
    const bool ink =
        (ink_[static_cast<std::size_t>(x / 64)] << x % 64 >> 63) != 0;
    const std::int32_t change =
        truth != nullptr ? first_other(truth->row(y), x, end, ink) : end;
    const auto length = static_cast<unsigned>(end - x);
    entropy::Counter& counter =
        quiet_[static_cast<unsigned>(std::bit_width(length)) |
               (ink ? 16U : 0U) | (refers_ ? 32U : 0U) | (last ? 64U : 0U)];
    const bool changes = coder.code(change < end, counter.p1_fine());
    counter.update(changes);
    if (!changes) {
      if (ink) canvas.fill(x, end, y);
      return end;
    }
    const std::int32_t low = code_change(coder, change, x, end);
    if (ink) {
      canvas.fill(x, low, y);
    } else {
      canvas.set(low, y);
    }
    return low + 1;
  }

  template <class Coder>
  bool code_pixel(Coder& coder, bool truth, std::int32_t x) {
    Near n = near(x, above(0, x));
    entropy::Counter& gate =
        gates_[refers_ ? 1U << 16 | n.block | n.corner << 9 : n.near];
    n.gate = gate.p;
    const bool likely = gate.p >= 32768;
    const int rare = likely ? 65535 - gate.p : gate.p;
    bool bit = likely;
    if (gate.n >= kGateAge && rare < Model::kGateRare) {
      bit = coder.code(truth != likely, rare + 4) != likely;
      gate.update(bit);
      model_.skip();
      if (bit == likely) return bit;
    } else {
      bit = model_.code(coder, truth, x, n, *this);
      gate.update(bit);
    }
    const bool expected = refers_ && (matched(0, x) >> 31 & 1) != 0;
    errors_before_ = errors_;
    errors_ += (bit != expected ? 4096 : 0) - errors_ / 16;
    return bit;
  }

  static unsigned quality_of(std::int32_t errors) {
    return errors < 1024 ? 0U : errors < 4096 ? 1U : errors < 10240 ? 2U : 3U;
  }

  static constexpr std::size_t middle(int k) {
    return static_cast<std::size_t>(Model::kReach + k);
  }

  Model model_;
  std::vector<entropy::Counter> gates_;
  std::vector<entropy::Counter> quiet_;
  std::int32_t errors_ = 0;
  std::int32_t errors_before_ = 0;
  bool refers_ = false;
  const ShapeReference* reference_ = nullptr;
  std::int32_t y_ = 0;
  std::int32_t width_ = 0;
  std::uint64_t place_ = 0;  ///< of the row, from the top and from the bottom
  /// Windows of the rows below around first_: for x up to kLook - 1 more the
  /// contexts have them whole.
  static constexpr std::int32_t kLook = Model::kLook;
  std::int32_t first_ = 0;
  std::array<std::uint64_t, 7> seen_{};
  std::array<std::uint64_t, kMatched> matched_seen_{};
  std::array<ShapeCanvas::Row, 7> rows_{};  ///< this row and those above
  std::array<ShapeCanvas::Row, kMatched> matched_{};  ///< of the reference
  std::array<std::uint64_t, kWords> busy_{};
  std::array<std::uint64_t, kWords> ink_{};
};

/// Eight contexts, mixed.
class MixedShapePixels {
 public:
  static constexpr int kGateRare = 6000;     ///< of 65536
  static constexpr std::int32_t kReach = 2;  ///< rows of the reference
  static constexpr std::int32_t kLook = 24;  ///< 6 pixels ahead are seen
  static constexpr bool kSeesOthers = false;

  explicit MixedShapePixels(int table_bits)
      : mixer_(table_bits, {1024, 256}, shape_warm::kPixels) {}

  static std::uint64_t memory(int table_bits) {
    return PixelMixer::memory(table_bits);
  }

  template <class Coder, class Order>
  bool code(Coder& coder, bool truth, std::int32_t x,
            const typename Order::Near& n, const Order& order) {
    const auto cut = Order::cut;
    const auto before = Order::before;
    const bool last = (n.corner & 1) != 0;
    const PixelMixer::Places& places = ahead_.move_on(
        [&](PixelMixer::Places& here) {
          find(x, order.quality_before(), order, here);
        },
        [&](PixelMixer::Places& next) {
          find(x + 1, order.quality(), order, next);
        });
    PixelMixer::Chosen chosen;
    if (order.refers()) {
      chosen = {512 + n.block, 128 + (n.corner | order.quality() << 5)};
    } else {
      chosen = {before(n.r0, 3) | cut(n.r1, 2, 3) << 3,
                n.corner | (n.r2 >> 31 & 3) << 5};
    }
    return mixer_.code(coder, truth, places, last, chosen);
  }

  /// The next pixel that code() gets is not the one after the last.
  void skip() { ahead_.skip(); }

  /// For training a warm start.
  [[nodiscard]] const PixelMixer::Mixer& mixer() const {
    return mixer_.mixer();
  }

 private:
  /// Whatever the pixel before is.
  template <class Order>
  void find(std::int32_t x, std::uint64_t quality, const Order& order,
            PixelMixer::Places& places) const {
    const auto cut = Order::cut;
    const auto before = Order::before;
    const typename Order::Near n =
        order.near(x, order.above(0, x) & ~(std::uint64_t{1} << 32));
    const std::uint64_t r3 = order.above(3, x);
    const std::uint64_t r4 = order.above(4, x);
    const std::uint64_t place = order.place(x);
    PixelMixer::Contexts c;
    c[0] = before(n.r0, 6) | cut(n.r1, 4, 4) << 6 | cut(n.r2, 3, 3) << 15 |
           cut(r3, 2, 2) << 22;
    c[1] = before(n.r0, 8) | cut(n.r1, 6, 6) << 8 | cut(n.r2, 5, 5) << 21 |
           cut(r3, 4, 4) << 32 | cut(r4, 2, 2) << 41;
    c[2] = before(n.r0, 3) | cut(n.r1, 2, 6) << 3 | cut(n.r2, 2, 6) << 12 |
           cut(r3, 2, 5) << 21;
    c[3] = before(n.r0, 1) | cut(n.r1, 1, 3) << 1 | cut(n.r2, 1, 1) << 6 |
           cut(r3, 1, 1) << 9 | cut(r4, 1, 1) << 12 |
           cut(order.above(5, x), 1, 1) << 15 |
           cut(order.above(6, x), 1, 1) << 18;
    if (order.refers()) {
      const std::uint64_t kind = 1ULL << 60 | quality << 56;
      const std::uint64_t wide = cut(order.matched(-2, x), 1, 1) |
                                 cut(order.matched(-1, x), 2, 2) << 3 |
                                 cut(order.matched(0, x), 2, 2) << 8 |
                                 cut(order.matched(1, x), 2, 2) << 13 |
                                 cut(order.matched(2, x), 1, 1) << 18;
      c[4] = kind | n.block | n.corner << 9;
      c[5] = kind | wide | (n.r1 >> 31 & 1) << 25;
      c[6] = kind | n.block | n.near << 9;
      c[7] = kind | n.block | place << 9;
    } else {
      c[4] = before(n.r0, 7) | cut(n.r1, 5, 1) << 7;
      c[5] = cut(n.r1, 1, 1) | cut(n.r2, 1, 1) << 3 | cut(r3, 1, 1) << 6 |
             place << 9;
      c[6] = n.corner | place << 5;
      c[7] = n.near;
    }
    mixer_.find(c, places);
  }

  PixelMixer mixer_;
  PixelMixer::Ahead ahead_;
};

using ShapePixels = ShapePixelOrder<MixedShapePixels>;

}  // namespace unstep::codec
