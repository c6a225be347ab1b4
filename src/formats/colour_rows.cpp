#include "formats/colour_rows.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "formats/binarise.h"
#include "formats/histogram.h"

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

Result<int> choose_level(ColourRows& rows, const Bitmap& ink,
                         const Threshold& threshold) {
  if (threshold.kind == Threshold::Kind::fixed) return threshold.level;
  Histogram histogram{};
  std::vector<std::uint8_t> row(static_cast<std::size_t>(ink.width()));
  if (Status started = rows.start(); !started) return started.error();
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    if (Status read = rows.next_luminance(row); !read) return read.error();
    for (const std::uint8_t pixel : row) ++histogram[pixel];
  }
  return otsu_level(histogram);
}

Status apply_threshold(ColourRows& rows, std::uint32_t level, Bitmap& ink) {
  std::vector<std::uint8_t> row(static_cast<std::size_t>(ink.width()));
  if (Status started = rows.start(); !started) return started.error();
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    if (Status read = rows.next_luminance(row); !read) return read.error();
    pack_below(row, level, ink.row(y));
  }
  return {};
}

Result<GreyPage> read_grey(ColourRows& rows, std::int32_t width,
                           std::int32_t height,
                           const RasterReadOptions& options,
                           std::uint64_t other_bytes) {
  Result<GreyPage> grey =
      GreyPage::create(width, height, options.limits, other_bytes);
  if (!grey) return grey;
  if (Status started = rows.start(); !started) return started.error();
  for (std::int32_t y = 0; y < height; ++y) {
    if (Status read = rows.next_luminance(grey->row(y)); !read) {
      return read.error();
    }
  }
  return grey;
}

/// True if a fixed threshold would not part the two values.
bool would_differ(const Values& values, const Threshold& threshold) {
  if (threshold.kind != Threshold::Kind::fixed || !values.second) return false;
  const auto level = static_cast<std::uint32_t>(threshold.level);
  return (luminance(*values.first) < level) ==
         (luminance(*values.second) < level);
}

}  // namespace

Status ColourRows::next_luminance(std::span<std::uint8_t> row) {
  colours_.resize(row.size());
  if (Status read = next(colours_); !read) return read;
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = static_cast<std::uint8_t>(luminance(colours_[i]));
  }
  return {};
}

Status read_colours(ColourRows& rows, std::int32_t width, std::int32_t height,
                    const RasterReadOptions& options, std::uint64_t other_bytes,
                    RasterPage& page) {
  const Threshold& threshold = options.threshold;
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
  page.lossless = false;
  switch (threshold.kind) {
    case Threshold::Kind::none:
      return Error{ErrorCode::invalid_argument,
                   "more than two pixel values; give --threshold auto, a "
                   "level or another method to make it bilevel (not lossless)"};
    case Threshold::Kind::fixed:
    case Threshold::Kind::otsu: {
      if (options.work.deskew) break;  // turns the greys
      const Result<int> level = choose_level(rows, page.ink, threshold);
      if (!level) return level.error();
      page.work.push_back(level_text(threshold.kind, *level));
      Status done =
          apply_threshold(rows, static_cast<std::uint32_t>(*level), page.ink);
      if (done) invert_ink(options.work.invert, page);
      return done;
    }
    default: break;
  }
  Result<GreyPage> grey = read_grey(rows, width, height, options, other_bytes);
  if (!grey) return grey.error();
  return binarise(*std::move(grey), options, other_bytes, page);
}

}  // namespace unstep
