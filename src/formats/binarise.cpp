#include "formats/binarise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "formats/colour.h"
#include "formats/histogram.h"
#include "formats/imaging_loader.h"
#include "formats/page_limits.h"

namespace unstep {
namespace {

using Invert = PixelWork::Invert;

/// Turning a page resamples it; below this it would do more harm than good.
constexpr double kLeastSkew = 0.05;

std::string decimals(const char* format, double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

Histogram histogram_of(GreyPage& grey) {
  // Four tables, so that equal neighbours need not wait for each other.
  std::array<Histogram, 4> parts{};
  const std::span<const std::uint8_t> pixels = grey.pixels();
  for (std::size_t i = 0; i < pixels.size(); ++i) ++parts[i % 4][pixels[i]];
  Histogram sum{};
  for (std::size_t i = 0; i < sum.size(); ++i) {
    for (const Histogram& part : parts) sum[i] += part[i];
  }
  return sum;
}

void invert(GreyPage& grey, Histogram& histogram) {
  for (std::uint8_t& pixel : grey.pixels()) {
    pixel = static_cast<std::uint8_t>(255 - pixel);
  }
  std::reverse(histogram.begin(), histogram.end());
}

void threshold_at(GreyPage& grey, int level, Bitmap& ink) {
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    pack_below(grey.row(y), static_cast<std::uint32_t>(level), ink.row(y));
  }
}

/// Turns the page by minus its skew; the canvas grows so that all stays. False
/// if it is straight.
Result<bool> straighten(GreyPage& grey, int level, std::uint8_t paper,
                        const DecodeLimits& limits, std::uint64_t other_bytes,
                        std::vector<std::string>& work) {
  const Result<double> skew = imaging::skew(grey, level);
  if (!skew) return skew.error();
  const std::string angle = decimals("%.2f degrees", std::abs(*skew));
  if (std::abs(*skew) < kLeastSkew) {
    work.push_back("deskew: turned by " + angle + ", left so");
    return false;
  }
  const double turn = std::abs(*skew) * std::acos(-1.0) / 180;
  const auto side = [turn](double along, double across) {
    return static_cast<std::int32_t>(
        std::ceil(along * std::cos(turn) + across * std::sin(turn)));
  };
  // Sides below 2^30 and their quarter at most (kMostSkew): below 2^31.
  Result<GreyPage> turned = GreyPage::create(
      side(grey.width(), grey.height()), side(grey.height(), grey.width()),
      limits, other_bytes + grey.pixels().size());
  if (!turned) return turned.error();
  if (Status done = imaging::turn(grey, *skew, paper, *turned); !done) {
    return done.error();
  }
  work.push_back("deskew: was turned by " + angle +
                 (*skew > 0 ? " counter-clockwise" : " clockwise"));
  grey = *std::move(turned);
  return true;
}

std::string paper_text(const PageLight& light) {
  return "paper is " + decimals("%.0f", light.darkest) + " to " +
         decimals("%.0f", light.lightest);
}

/// Thresholds of the surroundings, or one level where they do not fit.
Status threshold_locally(GreyPage& grey, int otsu, Threshold::Kind kind,
                         RasterPage& page) {
  const Result<PageLight> light = imaging::threshold(grey, kind, page.ink);
  if (!light) return light.error();
  if (kind == Threshold::Kind::sauvola) {
    page.work.emplace_back("threshold by sauvola");
    return {};
  }
  if (light->contrast == 0) {
    page.work.push_back("local threshold: blank page, " + paper_text(*light));
    return {};
  }
  if (kind == Threshold::Kind::local || light->fits) {
    page.work.push_back((kind == Threshold::Kind::local ? "" : "auto: ") +
                        ("local threshold, " + paper_text(*light)));
    return {};
  }
  page.work.push_back("auto: " + level_text(Threshold::Kind::otsu, otsu) +
                      ", as contrast is " + decimals("%.0f", light->contrast) +
                      " and noise " + decimals("%.1f", light->noise));
  threshold_at(grey, otsu, page.ink);
  return {};
}

void to_grey(const Bitmap& ink, GreyPage& grey) {
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    const std::span<const std::uint64_t> words = ink.row(y);
    const std::span<std::uint8_t> row = grey.row(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
      row[x] = (words[x / 64] >> (63 - x % 64) & 1) != 0 ? 0 : 255;
    }
  }
}

/// Of a bilevel page. Its ink is turned as black on white and cut at half.
Status deskew_ink(const RasterReadOptions& options, RasterPage& page) {
  Result<GreyPage> grey =
      GreyPage::create(page.ink.width(), page.ink.height(), options.limits, 0);
  if (!grey) return grey.error();
  to_grey(page.ink, *grey);
  const Result<bool> turned =
      straighten(*grey, 128, 255, options.limits, 0, page.work);
  if (!turned) return turned.error();
  if (!*turned) return {};
  Result<Bitmap> ink = Bitmap::create(grey->width(), grey->height());
  if (!ink) return ink.error();
  page.ink = *std::move(ink);
  threshold_at(*grey, 128, page.ink);
  page.lossless = false;
  return {};
}

Status remove_pieces(std::uint64_t area, bool of_paper, RasterPage& page) {
  if (area == 0) return {};
  const Result<imaging::Removed> removed =
      imaging::remove_small_pieces(page.ink, area, of_paper);
  if (!removed) return removed.error();
  page.work.push_back(std::to_string(removed->pieces) +
                      (of_paper ? " holes" : " specks") + " of at most " +
                      std::to_string(area) + " px " +
                      (of_paper ? "filled" : "removed") + " (" +
                      std::to_string(removed->pixels) + " px)");
  if (removed->pixels > 0) page.lossless = false;
  return {};
}

/// Items of the list as one line.
std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) {
    text += (text.empty() ? "" : "; ") + item;
  }
  return text;
}

}  // namespace

Result<GreyPage> GreyPage::create(std::int32_t width, std::int32_t height,
                                  const DecodeLimits& limits,
                                  std::uint64_t other_bytes) {
  const auto w = static_cast<std::uint64_t>(width);
  const auto h = static_cast<std::uint64_t>(height);
  const std::uint64_t bytes = w * h;
  if (Status fits = check_page(limits, w, h, bytes + other_bytes); !fits) {
    return fits.error();
  }
  GreyPage page;
  page.width_ = width;
  page.height_ = height;
  page.pixels_.resize(static_cast<std::size_t>(bytes));
  return page;
}

std::string level_text(Threshold::Kind kind, int level) {
  return "luminance below " + std::to_string(level) + " is ink" +
         (kind == Threshold::Kind::otsu ? " (otsu)" : "");
}

void pack_below(std::span<const std::uint8_t> row, std::uint32_t level,
                std::span<std::uint64_t> words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto part =
        row.subspan(i * 64, std::min<std::size_t>(64, row.size() - i * 64));
    std::uint64_t bits = 0;
    for (const std::uint8_t pixel : part) {
      bits = bits << 1 | (pixel < level ? 1U : 0U);
    }
    words[i] = bits << (64 - part.size());
  }
}

Status binarise(GreyPage grey, const RasterReadOptions& options,
                std::uint64_t other_bytes, RasterPage& page) {
  const Threshold& threshold = options.threshold;
  Histogram histogram = histogram_of(grey);
  int otsu = otsu_level(histogram);
  const Invert wanted = options.work.invert;
  if (wanted == Invert::yes ||
      (wanted == Invert::automatic && share_below(histogram, otsu) > 0.5)) {
    invert(grey, histogram);
    otsu = otsu_level(histogram);
    page.work.emplace_back("inverted");
  }
  if (options.work.deskew) {
    const Result<bool> turned =
        straighten(grey, otsu, mode_above(histogram, otsu), options.limits,
                   other_bytes, page.work);
    if (!turned) return turned.error();
    Result<Bitmap> ink = Bitmap::create(grey.width(), grey.height());
    if (!ink) return ink.error();
    page.ink = *std::move(ink);
  }
  if (threshold.kind == Threshold::Kind::fixed ||
      threshold.kind == Threshold::Kind::otsu) {
    const bool fixed = threshold.kind == Threshold::Kind::fixed;
    const int level = fixed ? threshold.level : otsu;
    page.work.push_back(level_text(threshold.kind, level));
    threshold_at(grey, level, page.ink);
    return {};
  }
  return threshold_locally(grey, otsu, threshold.kind, page);
}

void invert(Bitmap& ink) {
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::uint64_t& word : ink.row(y)) word = ~word;
    ink.row(y).back() &= ink.last_word_mask();
  }
}

void invert_ink(Invert wanted, RasterPage& page) {
  const bool mostly_ink = page.ink.ink() > page.ink.pixels() / 2;
  if (wanted == Invert::no || (wanted == Invert::automatic && !mostly_ink)) {
    return;
  }
  invert(page.ink);
  page.work.emplace_back("inverted");
  if (!page.lossless) return;
  const Palette palette = find_palette(page.info.metadata).value_or(Palette{});
  std::erase_if(page.info.metadata,
                [](const auto& pair) { return pair.first == kPaletteKey; });
  keep_palette({palette.paper, palette.ink}, page.info.metadata);
}

Status finish_pixels(const RasterReadOptions& options, RasterPage& page) {
  const PixelWork& work = options.work;
  const bool thresholded = !page.work.empty();
  if (!thresholded) {
    invert_ink(work.invert, page);
    if (work.deskew) {
      if (Status done = deskew_ink(options, page); !done) return done;
    }
  }
  if (Status done = remove_pieces(work.despeckle, false, page); !done) {
    return done;
  }
  if (Status done = remove_pieces(work.fill_holes, true, page); !done) {
    return done;
  }
  if (page.work.empty()) return {};
  const std::string text = joined(page.work);
  page.info.metadata.emplace_back("unstep:pixels", text);
  page.notes.push_back(
      (thresholded     ? "grey or colour pixels thresholded, not lossless: "
       : page.lossless ? "pixels: "
                       : "pixels changed, not lossless: ") +
      text);
  return {};
}

}  // namespace unstep
