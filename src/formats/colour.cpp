#include "formats/colour.h"

#include <array>
#include <charconv>
#include <cstdio>

namespace unstep {
namespace {

std::optional<Colour> parse_colour(std::string_view text) {
  if (text.empty() || text[0] != '#') return std::nullopt;
  text.remove_prefix(1);
  if (text.size() != 6 && text.size() != 12) return std::nullopt;
  const std::size_t digits = text.size() / 3;
  std::array<std::uint32_t, 3> samples{};
  for (std::size_t i = 0; i < 3; ++i) {
    const char* begin = text.data() + i * digits;
    const auto [end, error] =
        std::from_chars(begin, begin + digits, samples[i], 16);
    if (error != std::errc{} || end != begin + digits) return std::nullopt;
    if (digits == 2) samples[i] *= 257;
  }
  return make_colour(samples[0], samples[1], samples[2]);
}

}  // namespace

bool is_8_bit(Colour colour) {
  return red_of(colour) % 257 == 0 && green_of(colour) % 257 == 0 &&
         blue_of(colour) % 257 == 0;
}

std::string to_string(Colour colour) {
  std::array<char, 16> text{};
  if (is_8_bit(colour)) {
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x",
                  red_of(colour) / 257, green_of(colour) / 257,
                  blue_of(colour) / 257);
  } else {
    std::snprintf(text.data(), text.size(), "#%04x%04x%04x", red_of(colour),
                  green_of(colour), blue_of(colour));
  }
  return text.data();
}

void keep_palette(const Palette& palette, Metadata& metadata) {
  if (palette == Palette{}) return;
  metadata.emplace_back(
      kPaletteKey, to_string(palette.ink) + "," + to_string(palette.paper));
}

std::optional<Palette> find_palette(const Metadata& metadata) {
  for (const auto& [key, value] : metadata) {
    if (key != kPaletteKey) continue;
    const std::size_t comma = value.find(',');
    if (comma == std::string::npos) return std::nullopt;
    const std::string_view text = value;
    const auto ink = parse_colour(text.substr(0, comma));
    const auto paper = parse_colour(text.substr(comma + 1));
    if (!ink || !paper) return std::nullopt;
    return Palette{*ink, *paper};
  }
  return std::nullopt;
}

}  // namespace unstep
