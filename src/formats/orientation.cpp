#include "formats/orientation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace unstep {
namespace {

std::uint64_t reverse_bits(std::uint64_t word) {
  constexpr std::uint64_t k1 = 0x5555555555555555U;
  constexpr std::uint64_t k2 = 0x3333333333333333U;
  constexpr std::uint64_t k4 = 0x0f0f0f0f0f0f0f0fU;
  word = (word >> 1 & k1) | (word & k1) << 1;
  word = (word >> 2 & k2) | (word & k2) << 2;
  word = (word >> 4 & k4) | (word & k4) << 4;
  return __builtin_bswap64(word);
}

/// Last column first. The reversed words start with the unused bits of the
/// row, so they are shifted out.
void mirror_row(std::span<std::uint64_t> words, std::int32_t width) {
  std::reverse(words.begin(), words.end());
  for (std::uint64_t& word : words) word = reverse_bits(word);
  const unsigned unused = (64 - static_cast<unsigned>(width) % 64) % 64;
  if (unused == 0) return;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::uint64_t next = i + 1 < words.size() ? words[i + 1] : 0;
    words[i] = words[i] << unused | next >> (64 - unused);
  }
}

void mirror_columns(Bitmap& ink) {
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    mirror_row(ink.row(y), ink.width());
  }
}

void mirror_rows(Bitmap& ink) {
  for (std::int32_t y = 0; y < ink.height() / 2; ++y) {
    const auto top = ink.row(y);
    const auto bottom = ink.row(ink.height() - 1 - y);
    std::swap_ranges(top.begin(), top.end(), bottom.begin());
  }
}

Result<Bitmap> transpose(const Bitmap& ink) {
  Result<Bitmap> turned = Bitmap::create(ink.height(), ink.width());
  if (!turned) return turned;
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    const auto words = ink.row(y);
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (std::uint64_t left = words[i]; left != 0;) {
        const int bit = std::countl_zero(left);
        turned->set(y, static_cast<std::int32_t>(i) * 64 + bit, true);
        left &= ~(std::uint64_t{1} << (63 - bit));
      }
    }
  }
  return turned;
}

}  // namespace

std::string_view orientation_name(int orientation) {
  static constexpr std::array<std::string_view, 8> kNames{
      "top-left", "top-right", "bottom-right", "bottom-left",
      "left-top", "right-top", "right-bottom", "left-bottom"};
  return kNames.at(static_cast<std::size_t>(orientation - 1));
}

Status apply_orientation(int orientation, Bitmap& ink) {
  if (is_transposed(orientation)) {
    Result<Bitmap> turned = transpose(ink);
    if (!turned) return turned.error();
    ink = std::move(*turned);
  }
  // The name says where the stored row 0 and column 0 are seen: row 0 at the
  // top (1, 2), bottom (3, 4), left (5, 8) or right (6, 7) side.
  if (orientation == 2 || orientation == 3 || orientation == 6 ||
      orientation == 7) {
    mirror_columns(ink);
  }
  if (orientation == 3 || orientation == 4 || orientation == 7 ||
      orientation == 8) {
    mirror_rows(ink);
  }
  return {};
}

}  // namespace unstep
