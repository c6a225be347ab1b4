#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/context.h"
#include "codec/pixel_mixer.h"
#include "codec/pixel_rows.h"
#include "codec/pixel_slots.h"
#include "entropy/logistic.h"
#include "entropy/mixer.h"

namespace unstep::codec {

namespace detail {

/// Of 256: how far a probability goes to that of a larger context, by its age.
constexpr std::array<std::int16_t, 256> make_pixel_blend() {
  std::array<std::int16_t, 256> weights{};
  for (std::size_t n = 0; n < weights.size(); ++n) {
    weights[n] = static_cast<std::int16_t>(420 * n / (2 * n + 3));
  }
  return weights;
}
inline constexpr auto kPixelBlend = make_pixel_blend();

}  // namespace detail

/// The contexts of pixels beyond the nearest ones.
namespace pixel_contexts {

[[nodiscard]] inline std::uint64_t small(const PixelWindow& w) {
  return w.before(6) | w.cut(1, 4, 4) << 6 | w.cut(2, 3, 3) << 15 |
         w.cut(3, 2, 2) << 22;
}
[[nodiscard]] inline std::uint64_t middle(const PixelWindow& w) {
  return w.before(8) | w.cut(1, 6, 6) << 8 | w.cut(2, 5, 5) << 21 |
         w.cut(3, 4, 4) << 32 | w.cut(4, 2, 2) << 41;
}
[[nodiscard]] inline std::uint64_t large(const PixelWindow& w) {
  return w.before(9) | w.cut(1, 7, 7) << 9 | w.cut(2, 6, 6) << 24 |
         w.cut(3, 5, 5) << 37 | w.cut(4, 4, 4) << 48;
}
[[nodiscard]] inline std::uint64_t wide(const PixelWindow& w) {
  return w.before(12) | w.cut(1, 10, 9) << 12 | w.cut(2, 8, 8) << 32 |
         (w.cut(3, 7, 7) * 0x3a8f05c5ULL << 28);
}

}  // namespace pixel_contexts

/// The nearest 16 pixels, moved towards what is known of 27 and of 57 pixels by
/// how much that is. For speed: no mixer.
class BlendedPixels {
 public:
  static constexpr int kBits = 16;  ///< log2 of the slots of a context
  static constexpr unsigned kRare = 3000U;

  static constexpr std::uint64_t memory() {
    return 2 * PixelTable::memory(kBits);
  }

  void skip() {}

  template <class Coder>
  bool code(Coder& coder, bool truth, const PixelWindow& window,
            std::uint64_t /*near*/, int near_p) {
    int p = near_p;
    const auto move = [&p](const PixelSlot& slot) {
      p += (slot.p - p) * detail::kPixelBlend[slot.age()] >> 8;
    };
    PixelTable::Found small = small_.find(pixel_contexts::small(window), p);
    move(small.slot);
    PixelTable::Found large = large_.find(pixel_contexts::large(window), p);
    move(large.slot);
    const bool bit = coder.code(truth, std::clamp(p, 24, 65512));
    small.learn(bit);
    large.learn(bit);
    return bit;
  }

 private:
  PixelTable small_{kBits};
  PixelTable large_{kBits};
};

/// Four contexts of 16 to 63 pixels, mixed.
class MixedPixels {
 public:
  static constexpr int kBits = 16;
  static constexpr unsigned kRare = 1000U;
  static constexpr std::size_t kContexts = 4;

  static constexpr std::uint64_t memory() {
    return kContexts * PixelTable::memory(kBits);
  }

  void skip() {}

  template <class Coder>
  bool code(Coder& coder, bool truth, const PixelWindow& window,
            std::uint64_t near, int /*near_p*/) {
    std::array<PixelTable::Found, kContexts> found{
        tables_[0].find(near), tables_[1].find(pixel_contexts::small(window)),
        tables_[2].find(pixel_contexts::middle(window)),
        tables_[3].find(pixel_contexts::wide(window))};
    auto& inputs = mixer_.inputs();
    for (std::size_t i = 0; i < kContexts; ++i) {
      inputs[i] = static_cast<std::int16_t>(entropy::stretch(found[i].slot.p));
      inputs[kContexts + i] = static_cast<std::int16_t>(
          (found[i].slot.p - 32768) * kTrust[found[i].slot.age()] >> 16);
    }
    const int x = mixer_.mix({window.before(3) | window.cut(1, 2, 3) << 3});
    const bool bit =
        coder.code(truth, std::clamp(entropy::squash(x), 24, 65512));
    mixer_.update(bit);
    for (PixelTable::Found& f : found) f.learn(bit);
    return bit;
  }

 private:
  using Mixer = entropy::Mixer<2 * kContexts, 1>;
  static constexpr Mixer::Inputs initial() {
    Mixer::Inputs weights{};
    weights.fill(6144 / kContexts);
    return weights;
  }

  std::array<PixelTable, kContexts> tables_{
      PixelTable(kBits), PixelTable(kBits), PixelTable(kBits),
      PixelTable(kBits)};
  Mixer mixer_{{512}, std::array<Mixer::Inputs, 1>{initial()}};
};

/// Eight contexts of up to 64 pixels, mixed and refined: for dither and scans.
/// While a pixel is coded the slots of the next one are on their way.
class DeepPixels {
 public:
  static constexpr int kBits = 17;
  static constexpr unsigned kRare = 3600U;

  static std::uint64_t memory() {
    return PixelMixer::memory(kBits) + (std::uint64_t{1} << 18);
  }

  /// The next pixel that code() gets is not the one after the last.
  void skip() { ahead_.skip(); }

  template <class Coder>
  bool code(Coder& coder, bool truth, const PixelWindow& window,
            std::uint64_t /*near*/, int /*near_p*/) {
    const bool before = window.before(1) != 0;
    const PixelMixer::Places& places =
        ahead_.move_on([&](PixelMixer::Places& here) { find(window, here); },
                       [&](PixelMixer::Places& next) {
                         PixelWindow after = window;
                         after.move(false);
                         find(after, next);
                       });
    return mixer_.code(coder, truth, places, before,
                       {window.before(3) | window.cut(1, 2, 3) << 3,
                        window.before(2) | window.cut(1, 1, 1) << 2 |
                            window.cut(2, 0, 1) << 5});
  }

 private:
  /// Of the middle of a window, whatever is just before it.
  void find(PixelWindow window, PixelMixer::Places& places) const {
    window.row[0] &= ~(std::uint64_t{1} << 32);
    mixer_.find({window.near(), pixel_contexts::small(window),
                 pixel_contexts::middle(window), pixel_contexts::wide(window),
                 window.before(3) | window.cut(1, 2, 6) << 3 |
                     window.cut(2, 2, 6) << 12 | window.cut(3, 2, 5) << 21,
                 window.before(1) | window.cut(1, 1, 3) << 1 |
                     window.cut(2, 1, 1) << 6 | window.cut(3, 1, 1) << 9 |
                     window.cut(4, 1, 1) << 12,
                 window.before(7) | window.cut(1, 5, 1) << 7 |
                     window.cut(2, 4, 0) << 14,
                 window.before(16) | window.cut(1, 8, 11) << 16},
                places);
  }

  PixelMixer mixer_{kBits, {512, 128}};
  PixelMixer::Ahead ahead_;
};

}  // namespace unstep::codec
