#include "formats/colour_rows.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace unstep {
namespace {

/// The values met so far, in order.
struct Values {
  std::optional<Colour> first;
  std::optional<Colour> second;
  bool more = false;
};

/// Packs 1 where the pixel is the second value. False at a third value.
bool pack_row(std::span<const Colour> pixels, Values& values,
              std::span<std::uint64_t> words) {
  if (!values.first) values.first = pixels.front();
  const Colour first = *values.first;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Colour pixel = pixels[i];
    if (pixel == first) continue;
    if (!values.second) values.second = pixel;
    if (pixel != *values.second) {
      values.more = true;
      return false;
    }
    words[i / 64] |= std::uint64_t{1} << (63 - i % 64);
  }
  return true;
}

/// Reads until the end or a third value.
Result<Values> pack(ColourRows& rows, Bitmap& ink) {
  Values values;
  std::vector<Colour> row(static_cast<std::size_t>(ink.width()));
  if (Status started = rows.start(); !started) return started.error();
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    if (Status read = rows.next(row); !read) return read.error();
    if (!pack_row(row, values, ink.row(y))) break;
  }
  return values;
}

void invert(Bitmap& ink) {
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::uint64_t& word : ink.row(y)) word = ~word;
    ink.row(y).back() &= ink.last_word_mask();
  }
}

/// Turns "second value" into "ink".
void settle(const Values& values, RasterPage& page) {
  const Colour first = *values.first;
  if (!values.second) {
    const bool is_ink = luminance(first) < 128;
    if (is_ink) invert(page.ink);
    const Palette palette =
        is_ink ? Palette{first, kWhite} : Palette{kBlack, first};
    if (palette != Palette{}) {
      page.notes.push_back("every pixel is " + to_string(first) +
                           "; taken as " + (is_ink ? "ink" : "paper"));
    }
    keep_palette(palette, page.info.metadata);
    return;
  }
  const Colour second = *values.second;
  // Equal luminance: the order of the colour numbers decides, so that the
  // choice never depends on which colour comes first in the image.
  const bool second_is_ink = std::pair(weighted_luminance(second), second) <
                             std::pair(weighted_luminance(first), first);
  if (!second_is_ink) invert(page.ink);
  keep_palette(second_is_ink ? Palette{second, first} : Palette{first, second},
               page.info.metadata);
}

/// Otsu's method (N. Otsu, A threshold selection method from gray-level
/// histograms, 1979): the split with the greatest variance between classes.
/// Returns the first level that is paper, as cv::threshold's result + 1.
int otsu_level(const std::array<std::uint64_t, 256>& histogram) {
  double count = 0;
  double sum = 0;
  for (std::size_t i = 0; i < 256; ++i) {
    count += static_cast<double>(histogram[i]);
    sum += static_cast<double>(i) * static_cast<double>(histogram[i]);
  }
  double below = 0;
  double sum_below = 0;
  double best = -1;
  int level = 128;
  for (std::size_t i = 0; i < 255; ++i) {
    below += static_cast<double>(histogram[i]);
    sum_below += static_cast<double>(i) * static_cast<double>(histogram[i]);
    const double above = count - below;
    if (below == 0 || above == 0) continue;
    const double gap = sum_below / below - (sum - sum_below) / above;
    const double variance = below * above * gap * gap;
    if (variance > best) {
      best = variance;
      level = static_cast<int>(i) + 1;
    }
  }
  return level;
}

Result<int> choose_level(ColourRows& rows, const Bitmap& ink,
                         const Threshold& threshold) {
  if (threshold.kind == Threshold::Kind::fixed) return threshold.level;
  std::array<std::uint64_t, 256> histogram{};
  std::vector<Colour> row(static_cast<std::size_t>(ink.width()));
  if (Status started = rows.start(); !started) return started.error();
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    if (Status read = rows.next(row); !read) return read.error();
    for (const Colour pixel : row) ++histogram[luminance(pixel)];
  }
  return otsu_level(histogram);
}

Status apply_threshold(ColourRows& rows, std::uint32_t level, Bitmap& ink) {
  std::vector<Colour> row(static_cast<std::size_t>(ink.width()));
  if (Status started = rows.start(); !started) return started.error();
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    if (Status read = rows.next(row); !read) return read.error();
    const std::span<std::uint64_t> words = ink.row(y);
    for (std::uint64_t& word : words) word = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (luminance(row[i]) < level) {
        words[i / 64] |= std::uint64_t{1} << (63 - i % 64);
      }
    }
  }
  return {};
}

/// True if a fixed threshold would not part the two values.
bool would_differ(const Values& values, const Threshold& threshold) {
  if (threshold.kind != Threshold::Kind::fixed || !values.second) return false;
  const auto level = static_cast<std::uint32_t>(threshold.level);
  return (luminance(*values.first) < level) ==
         (luminance(*values.second) < level);
}

}  // namespace

Status read_colours(ColourRows& rows, std::int32_t width, std::int32_t height,
                    const Threshold& threshold, RasterPage& page) {
  Result<Bitmap> ink = Bitmap::create(width, height);
  if (!ink) return ink.error();
  page.ink = std::move(*ink);
  const Result<Values> values = pack(rows, page.ink);
  if (!values) return values.error();
  if (!values->more) {
    settle(*values, page);
    if (would_differ(*values, threshold)) {
      page.notes.emplace_back(
          "at most two values: the darker is ink, the threshold is not used");
    }
    return {};
  }
  if (threshold.kind == Threshold::Kind::none) {
    return Error{ErrorCode::invalid_argument,
                 "more than two pixel values; give --threshold N|otsu to make "
                 "it bilevel (not lossless)"};
  }
  const Result<int> level = choose_level(rows, page.ink, threshold);
  if (!level) return level.error();
  page.lossless = false;
  page.notes.push_back(
      "grey or colour pixels thresholded, not lossless: luminance below " +
      std::to_string(*level) + " is ink" +
      (threshold.kind == Threshold::Kind::otsu ? " (otsu)" : ""));
  return apply_threshold(rows, static_cast<std::uint32_t>(*level), page.ink);
}

}  // namespace unstep
