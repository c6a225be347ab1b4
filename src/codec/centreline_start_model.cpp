#include "codec/centreline_start_model.h"

#include <algorithm>
#include <bit>
#include <span>

#include "grid/bit_count.h"

namespace unstep::codec {
namespace {

constexpr std::int32_t kNever = -1000;
constexpr int kGateBits = 12;

unsigned log_level(std::uint32_t density) {
  return static_cast<unsigned>(std::bit_width(density / 64));
}

/// Pixels within two columns of ink of this row or the next two.
std::uint64_t near_ink(const PixelPlanes& planes, std::int32_t y,
                       std::int32_t word) {
  std::uint64_t left = 0;
  std::uint64_t here = 0;
  std::uint64_t right = 0;
  for (std::int32_t row = y; row < y + 3; ++row) {
    left |= planes.ink_word(row, word - 1);
    here |= planes.ink_word(row, word);
    right |= planes.ink_word(row, word + 1);
  }
  return here | here << 1 | here << 2 | here >> 1 | here >> 2 | right >> 63 |
         right >> 62 | left << 63 | left << 62;
}

}  // namespace

template <class Decisions>
LineStartModel<Decisions>::LineStartModel(const PixelPlanes& planes,
                                          const VertexRulers& rulers)
    : planes_(planes),
      rulers_(rulers),
      starts_(planes.width(), 1),
      density_((static_cast<std::size_t>(planes.width()) + 63) / 64 + 2),
      last_(static_cast<std::size_t>(planes.width()) + 2, kNever),
      last_in_span_(density_.size() * 64 / kSpan, kNever),
      gates_(std::size_t{1} << kGateBits),
      words_(kTableBits, std::span(kLineStartWeights).subspan(0, 1)),
      spans_(kTableBits, std::span(kLineStartWeights).subspan(1, 1)),
      pixels_(kTableBits, std::span(kLineStartWeights).subspan(2, 1)) {}

template <class Decisions>
std::uint64_t LineStartModel<Decisions>::memory(std::int32_t width) {
  return static_cast<std::uint64_t>(width) * 7 +
         3 * Decisions::memory(kTableBits) + (std::uint64_t{1} << 20);
}

template <class Decisions>
void LineStartModel<Decisions>::begin_row(std::int32_t y) {
  y_ = y;
  row_starts_ = 0;
  row_last_ = kNever;
  if (y % 4 != 0) return;
  for (Density& density : density_) {
    density.quick -= density.quick / 8;
    density.slow -= density.slow / 64;
  }
}

template <class Decisions>
entropy::Counter& LineStartModel<Decisions>::look_at_word(std::uint64_t mask,
                                                          std::int32_t word) {
  const Density* at = &density_[static_cast<std::size_t>(word)];
  const std::uint64_t near = near_ink(planes_, y_, word);
  const auto octave = [](std::uint64_t pixels) {
    return static_cast<unsigned>(
        std::bit_width(static_cast<unsigned>(ones(pixels))));
  };
  sight_ = {log_level(at[1].quick),
            log_level(at[0].quick + at[2].quick),
            log_level(at[1].slow),
            octave(mask),
            octave(mask & near),
            std::min(row_starts_, 3U),
            near};
  const std::uint64_t hash =
      mix(mix(sight_.quick, sight_.beside),
          mix(sight_.slow, mix(sight_.few, sight_.size * 8 + sight_.close))) *
      kGolden;
  return gates_[hash >> (64 - kGateBits)];
}

template <class Decisions>
void LineStartModel<Decisions>::set_word_contexts(std::int32_t word) {
  const Density* at = &density_[static_cast<std::size_t>(word)];
  const auto& [quick, beside, slow, size, close, few, near] = sight_;
  const unsigned wide = log_level((at[0].slow + at[1].slow + at[2].slow) / 2);
  const unsigned sizes = size * 8 + close;
  const auto age = [&](std::size_t k, std::int32_t most) {
    return static_cast<std::uint64_t>(std::min(y_ - at[k].last, most));
  };
  words_.set_contexts(
      {mix(beside * 16 + quick, sizes), mix(slow * 16 + wide, close),
       mix(age(1, 80), slow * 8 + close),
       mix(mix(age(0, 50), age(2, 50)), age(1, 50)),
       mix(rulers_.row(y_), mix(std::min(row_starts_, 7U), slow))});
  word_selectors_ = {sizes, quick * 16 + slow, wide};
}

template <class Decisions>
void LineStartModel<Decisions>::look_at_pixel(std::int32_t x,
                                              std::uint64_t rest) {
  const Density& density = density_[static_cast<std::size_t>(x / 64) + 1];
  const auto left = static_cast<unsigned>(ones(rest));
  const PixelPatch patch = pixel_patch::at(planes_, planes_.at(x, y_), 0);
  const std::uint64_t near = pixel_patch::near(patch);
  const auto gap = static_cast<unsigned>(std::min(x - row_last_, 300));
  const auto age = [&](std::int32_t column, std::int32_t most) {
    return static_cast<std::uint64_t>(
        std::min(y_ - last_[static_cast<std::size_t>(column) + 1], most));
  };
  const std::uint64_t since = age(x, 60);
  const unsigned column = rulers_.column(x);
  const auto from =
      static_cast<std::uint64_t>(std::clamp(x - density.column, -64, 64) + 64);
  pixels_.set_contexts(
      {mix(near, left), mix(gap, 5),
       mix(column, mix(starts_.column(x), gap < 20 ? 1U : 0U)),
       mix(from, static_cast<unsigned>(std::min(y_ - density.last, 3))),
       mix(mix(age(x - 1, 30), age(x + 1, 30)), since)});
  pixel_selectors_ = {left, std::min(gap, 100U), column};
}

template <class Decisions>
void LineStartModel<Decisions>::look_at_span(std::int32_t at,
                                             std::uint64_t span,
                                             std::uint64_t rest) {
  constexpr std::int32_t kSpans = 64 / kSpan;  // of a word
  const Density& density = density_[static_cast<std::size_t>(at / kSpans) + 1];
  const auto left = static_cast<unsigned>(ones(rest));
  const auto size = static_cast<unsigned>(ones(span));
  const auto near = static_cast<unsigned>(ones(span & sight_.near_ink));
  const auto later = static_cast<unsigned>(ones(rest & sight_.near_ink));
  const auto gap =
      static_cast<unsigned>(std::clamp(at * kSpan - row_last_, 0, 300));
  const auto age = [&](std::int32_t which, std::int32_t most) {
    return static_cast<std::uint64_t>(std::min(
        y_ - last_in_span_[static_cast<std::size_t>(which + kSpans)], most));
  };
  const std::uint64_t since = age(at, 60);
  const auto from = static_cast<std::uint64_t>(
      std::clamp(at - density.column / kSpan, -8, 8) + 8);
  const std::uint64_t bits =
      (span & sight_.near_ink) >> (std::countr_zero(span) / kSpan * kSpan);
  spans_.set_contexts({mix(bits, mix(left, since < 20 ? since : 20)),
                       mix(gap, 5), mix(size * 64 + left, near * 64 + later),
                       mix(from, mix(left, static_cast<unsigned>(std::min(
                                               y_ - density.last, 3)))),
                       mix(mix(age(at - 1, 30), age(at + 1, 30)), since)});
  pixel_selectors_ = {left, std::min(gap, 100U), size * 9 + near};
}

template <class Decisions>
void LineStartModel<Decisions>::count(std::int32_t x) {
  ++row_starts_;
  row_last_ = x;
  last_[static_cast<std::size_t>(x) + 1] = y_;
  last_in_span_[static_cast<std::size_t>((x + 64) / kSpan)] = y_;
  starts_.add(x, 0);
  Density& density = density_[static_cast<std::size_t>(x / 64) + 1];
  density.quick += 4096;
  density.slow += 4096;
  density.last = y_;
  density.column = x;
}

template class LineStartModel<DecisionModel<5, 3, true>>;
template class LineStartModel<DeepDecisions<5, 3>>;

}  // namespace unstep::codec
