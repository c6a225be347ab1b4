#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "unstep/codec.h"

/// Colours of two-valued images and how a page's metadata keeps them.
namespace unstep {

/// Three 16-bit samples: red << 32 | green << 16 | blue. 8-bit samples are
/// widened by repetition (0xab -> 0xabab), so equality is exact.
using Colour = std::uint64_t;

/// An 8-bit sample as 16 bits.
[[nodiscard]] constexpr std::uint32_t widen(std::uint32_t sample) {
  return sample * 257;
}

inline constexpr Colour kBlack = 0;
inline constexpr Colour kWhite = 0xffff'ffff'ffffU;

[[nodiscard]] constexpr Colour make_colour(std::uint32_t red,
                                           std::uint32_t green,
                                           std::uint32_t blue) {
  return std::uint64_t{red} << 32 | std::uint64_t{green} << 16 | blue;
}
[[nodiscard]] constexpr Colour make_grey(std::uint32_t value) {
  return make_colour(value, value, value);
}
[[nodiscard]] constexpr std::uint32_t red_of(Colour c) {
  return static_cast<std::uint32_t>(c >> 32 & 0xffff);
}
[[nodiscard]] constexpr std::uint32_t green_of(Colour c) {
  return static_cast<std::uint32_t>(c >> 16 & 0xffff);
}
[[nodiscard]] constexpr std::uint32_t blue_of(Colour c) {
  return static_cast<std::uint32_t>(c & 0xffff);
}

/// The colour seen over white; samples and alpha are 0..65535.
[[nodiscard]] constexpr Colour over_white(Colour c, std::uint32_t alpha) {
  const auto mix = [alpha](std::uint32_t v) {
    return (std::uint64_t{v} * alpha + std::uint64_t{65535} * (65535 - alpha) +
            32767) /
           65535;
  };
  return mix(red_of(c)) << 32 | mix(green_of(c)) << 16 | mix(blue_of(c));
}

/// Rec. 601 weights of OpenCV's cvtColor, unrounded: 32768 * luminance16.
[[nodiscard]] constexpr std::uint64_t weighted_luminance(Colour c) {
  return std::uint64_t{9798} * red_of(c) + std::uint64_t{19235} * green_of(c) +
         std::uint64_t{3735} * blue_of(c);
}

/// Luminance 0..255, as cvtColor(COLOR_RGB2GRAY) gives it for 8-bit samples;
/// 16-bit samples are rounded to 8 bits first.
[[nodiscard]] constexpr std::uint32_t luminance(Colour c) {
  const auto narrow = [](std::uint32_t v) { return (v * 255 + 32895) >> 16; };
  return (9798 * narrow(red_of(c)) + 19235 * narrow(green_of(c)) +
          3735 * narrow(blue_of(c)) + 16384) >>
         15;
}

/// Page metadata key of the two colours, "ink,paper", when they are not black
/// and white: "#112233,#ffffff", or four digits a sample where 8 bits do not
/// do.
inline constexpr std::string_view kPaletteKey = "palette";

struct Palette {
  Colour ink = kBlack;
  Colour paper = kWhite;
  friend bool operator==(const Palette&, const Palette&) = default;
};

[[nodiscard]] std::string to_string(Colour colour);

/// Adds the palette to the metadata unless it is black on white.
void keep_palette(const Palette& palette, Metadata& metadata);

/// The palette that the metadata names; nothing if there is none or its text
/// is not a palette.
[[nodiscard]] std::optional<Palette> find_palette(const Metadata& metadata);

/// True if every sample is an 8-bit one.
[[nodiscard]] bool is_8_bit(Colour colour);

}  // namespace unstep
