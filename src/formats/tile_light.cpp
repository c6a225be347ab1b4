#include "formats/tile_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace unstep::imaging {
namespace {

/// The share of a page's contrast that counts as an edge, and how many sigmas
/// of its noise (a window without edges spans about six).
constexpr double kEdgeShare = 0.35;
constexpr double kEdgeSigmas = 12;
constexpr double kLeastEdge = 16;
/// Edges must reach this many times above what noise does for local
/// thresholds to be trusted.
constexpr double kTrusted = 1.6;
constexpr int kSmallestPage = 64;
/// The threshold stays away from the darkest pixel by this share of the
/// window's contrast.
constexpr float kAboveDarkest = 0.2F;

/// The running minimum, maximum and sums of a row of tiles, column by column.
class TileRow {
 public:
  explicit TileRow(std::size_t width)
      : means_(width),
        darkest_(width),
        lightest_(width),
        sums_(width),
        squares_(width) {}

  void start() {
    std::fill(darkest_.begin(), darkest_.end(), std::uint8_t{255});
    std::fill(lightest_.begin(), lightest_.end(), std::uint8_t{0});
    std::fill(sums_.begin(), sums_.end(), std::uint16_t{0});
    std::fill(squares_.begin(), squares_.end(), 0U);
  }

  /// Sums fit: 8 rows of at most 255, and of 255^2.
  void add(const std::uint8_t* row, const std::uint8_t* below) {
    const std::size_t width = means_.size();
    for (std::size_t x = 0; x + 1 < width; ++x) {
      means_[x] = static_cast<std::uint8_t>(
          (row[x] + row[x + 1] + below[x] + below[x + 1] + 2) >> 2);
    }
    means_[width - 1] =
        static_cast<std::uint8_t>((row[width - 1] + below[width - 1] + 1) >> 1);
    for (std::size_t x = 0; x < width; ++x) {
      darkest_[x] = std::min(darkest_[x], means_[x]);
      lightest_[x] = std::max(lightest_[x], means_[x]);
    }
    for (std::size_t x = 0; x < width; ++x) {
      const std::uint16_t mean = means_[x];
      sums_[x] = static_cast<std::uint16_t>(sums_[x] + mean);
      squares_[x] += static_cast<std::uint32_t>(mean * mean);
    }
  }

  void finish(int rows, int y, Tiles& tiles) const {
    for (int tile = 0; tile < tiles.mean.cols; ++tile) {
      const std::size_t begin = static_cast<std::size_t>(tile) * kTile;
      const std::size_t end = std::min(begin + kTile, means_.size());
      std::uint8_t darkest = 255;
      std::uint8_t lightest = 0;
      std::uint32_t sum = 0;
      std::uint32_t square = 0;
      for (std::size_t x = begin; x < end; ++x) {
        darkest = std::min(darkest, darkest_[x]);
        lightest = std::max(lightest, lightest_[x]);
        sum += sums_[x];
        square += squares_[x];
      }
      const auto count =
          static_cast<float>(static_cast<std::size_t>(rows) * (end - begin));
      tiles.darkest.at<std::uint8_t>(y, tile) = darkest;
      tiles.lightest.at<std::uint8_t>(y, tile) = lightest;
      tiles.mean.at<float>(y, tile) = static_cast<float>(sum) / count;
      tiles.square.at<float>(y, tile) = static_cast<float>(square) / count;
    }
  }

 private:
  std::vector<std::uint8_t> means_;
  std::vector<std::uint8_t> darkest_;
  std::vector<std::uint8_t> lightest_;
  std::vector<std::uint16_t> sums_;
  std::vector<std::uint32_t> squares_;
};

/// The value that a share of the values is below; 0 of nothing.
double quantile(std::vector<float>& values, double share) {
  if (values.empty()) return 0;
  const auto index = static_cast<std::ptrdiff_t>(
      share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

/// Sigma of the 2 x 2 means of the quarter of tiles that has the least.
double noise_of(const Tiles& tiles) {
  std::vector<float> variances;
  variances.reserve(tiles.mean.total());
  for (int y = 0; y < tiles.mean.rows; ++y) {
    const auto* mean = tiles.mean.ptr<float>(y);
    const auto* square = tiles.square.ptr<float>(y);
    for (int x = 0; x < tiles.mean.cols; ++x) {
      variances.push_back(square[x] - mean[x] * mean[x]);
    }
  }
  return std::sqrt(std::max(quantile(variances, 0.25), 0.0));
}

/// Windows of 3 x 3 tiles and which of them hold edges.
struct Windows {
  cv::Mat darkest;
  cv::Mat lightest;
  cv::Mat edge;             ///< CV_8U, 255 or 0
  double contrast = 0;      ///< of three quarters of the edges
  double page_share = 0.8;  ///< contrast of the best edges as a share of light
};

std::vector<float> contrasts(const Windows& windows, double above,
                             bool as_share) {
  std::vector<float> found;
  for (int y = 0; y < windows.darkest.rows; ++y) {
    const auto* dark = windows.darkest.ptr<std::uint8_t>(y);
    const auto* light = windows.lightest.ptr<std::uint8_t>(y);
    for (int x = 0; x < windows.darkest.cols; ++x) {
      const int contrast = light[x] - dark[x];
      if (contrast <= above) continue;
      found.push_back(as_share ? static_cast<float>(contrast) /
                                     static_cast<float>(light[x])
                               : static_cast<float>(contrast));
    }
  }
  return found;
}

Windows look_around(const Tiles& tiles, double least) {
  Windows windows;
  const cv::Mat around = cv::getStructuringElement(cv::MORPH_RECT, {3, 3});
  cv::erode(tiles.darkest, windows.darkest, around);
  cv::dilate(tiles.lightest, windows.lightest, around);
  std::vector<float> found = contrasts(windows, least, false);
  if (!found.empty()) windows.contrast = quantile(found, 0.75);
  const double edge = std::max(least, kEdgeShare * windows.contrast);
  found = contrasts(windows, edge, true);
  if (!found.empty()) windows.page_share = quantile(found, 0.95);
  windows.edge = windows.lightest - windows.darkest > edge;
  return windows;
}

cv::Mat at_edges(const Windows& windows) {
  cv::Mat out(windows.edge.size(), CV_32F, cv::Scalar(0));
  const auto page_share = static_cast<float>(windows.page_share);
  for (int y = 0; y < out.rows; ++y) {
    for (int x = 0; x < out.cols; ++x) {
      if (windows.edge.at<std::uint8_t>(y, x) == 0) continue;
      const float dark = windows.darkest.at<std::uint8_t>(y, x);
      const float light = windows.lightest.at<std::uint8_t>(y, x);
      const float depth = ((light - dark) + page_share * light) / 4;
      out.at<float>(y, x) =
          std::max(dark + kAboveDarkest * (light - dark), light - depth);
    }
  }
  cv::Mat mask;
  windows.edge.convertTo(mask, CV_32F, 1.0 / 255);
  cv::Mat sum;
  cv::Mat count;
  cv::boxFilter(out, sum, CV_32F, {3, 3}, {-1, -1}, false);
  cv::boxFilter(mask, count, CV_32F, {3, 3}, {-1, -1}, false);
  cv::Mat smooth(out.size(), CV_32F, cv::Scalar(0));
  cv::divide(sum, count, smooth);
  return smooth.mul(mask);
}

/// Goes from tile to tile, a ring at a time, so that no order of tiles shows.
class Spread {
 public:
  Spread(const Tiles& tiles, double page_share, cv::Mat& thresholds,
         cv::Mat known)
      : tiles_(tiles),
        of_paper_(static_cast<float>(1 - page_share / 2)),
        thresholds_(thresholds),
        known_(std::move(known)) {}

  void run() {
    std::vector<cv::Point> ring;
    for (int y = 0; y < known_.rows; ++y) {
      for (int x = 0; x < known_.cols; ++x) {
        if (known_.at<std::uint8_t>(y, x) != 0) ring.emplace_back(x, y);
      }
    }
    while (!ring.empty()) ring = next(ring);
  }

 private:
  static constexpr std::uint8_t kKnown = 255;
  static constexpr std::uint8_t kWaiting = 1;

  template <class Visit>
  void around(cv::Point tile, const Visit& visit) {
    for (int y = std::max(tile.y - 1, 0);
         y <= std::min(tile.y + 1, known_.rows - 1); ++y) {
      for (int x = std::max(tile.x - 1, 0);
           x <= std::min(tile.x + 1, known_.cols - 1); ++x) {
        visit(cv::Point(x, y));
      }
    }
  }

  std::vector<cv::Point> next(const std::vector<cv::Point>& ring) {
    std::vector<cv::Point> found;
    for (const cv::Point tile : ring) {
      around(tile, [&](cv::Point near) {
        std::uint8_t& state = known_.at<std::uint8_t>(near);
        if (state != 0) return;
        state = kWaiting;
        found.push_back(near);
      });
    }
    std::vector<float> values;
    values.reserve(found.size());
    for (const cv::Point tile : found) values.push_back(value_of(tile));
    for (std::size_t i = 0; i < found.size(); ++i) {
      thresholds_.at<float>(found[i]) = values[i];
      known_.at<std::uint8_t>(found[i]) = kKnown;
    }
    return found;
  }

  float value_of(cv::Point tile) {
    float sum = 0;
    int count = 0;
    around(tile, [&](cv::Point near) {
      if (known_.at<std::uint8_t>(near) != kKnown) return;
      sum += thresholds_.at<float>(near);
      ++count;
    });
    const float inherited = sum / static_cast<float>(count);
    const float mean = tiles_.mean.at<float>(tile);
    return mean >= inherited ? mean * of_paper_ : inherited;
  }

  const Tiles& tiles_;
  float of_paper_;
  cv::Mat& thresholds_;
  cv::Mat known_;
};

/// The light of tiles that are paper throughout.
void measure_paper(const Tiles& tiles, const Windows& windows,
                   const cv::Mat& thresholds, unstep_page_light& light) {
  std::vector<float> levels;
  for (int y = 0; y < thresholds.rows; ++y) {
    for (int x = 0; x < thresholds.cols; ++x) {
      const float mean = tiles.mean.at<float>(y, x);
      if (windows.edge.at<std::uint8_t>(y, x) == 0 &&
          mean >= thresholds.at<float>(y, x)) {
        levels.push_back(mean);
      }
    }
  }
  light.darkest = quantile(levels, 0.02);
  light.lightest = quantile(levels, 0.98);
}

/// Thresholds of a row of pixels, at the left edge of each tile's middle:
/// 1/64 of a level.
void interpolate_row(const cv::Mat& thresholds, int y,
                     std::vector<std::int32_t>& row) {
  const int twice = 2 * y + 1 - kTile;  // from the middle of tile row 0
  const int above = std::max(twice, 0) / (2 * kTile);
  const int below = std::min(above + 1, thresholds.rows - 1);
  const float part =
      static_cast<float>(std::max(twice, 0) % (2 * kTile)) / (2.0F * kTile);
  const auto* upper = thresholds.ptr<float>(above);
  const auto* lower = thresholds.ptr<float>(below);
  for (int x = 0; x < thresholds.cols; ++x) {
    const float value = upper[x] + (lower[x] - upper[x]) * part;
    row[static_cast<std::size_t>(x)] =
        static_cast<std::int32_t>(std::lround(value * 64));
  }
}

}  // namespace

Tiles survey(const unstep_plane& grey) {
  const cv::Size size((grey.width + kTile - 1) / kTile,
                      (grey.height + kTile - 1) / kTile);
  Tiles tiles{cv::Mat(size, CV_8U), cv::Mat(size, CV_8U), cv::Mat(size, CV_32F),
              cv::Mat(size, CV_32F)};
  TileRow row(static_cast<std::size_t>(grey.width));
  const auto at = [&grey](int y) {
    return grey.pixels +
           grey.stride * static_cast<std::size_t>(std::min(y, grey.height - 1));
  };
  for (int y = 0; y < size.height; ++y) {
    const int end = std::min((y + 1) * kTile, grey.height);
    row.start();
    for (int line = y * kTile; line < end; ++line) {
      row.add(at(line), at(line + 1));
    }
    row.finish(end - y * kTile, y, tiles);
  }
  return tiles;
}

cv::Mat sauvola(const Tiles& tiles) {
  constexpr double kSlope = 0.34;
  constexpr double kRange = 128;
  cv::Mat mean;
  cv::Mat square;
  cv::boxFilter(tiles.mean, mean, CV_32F, {5, 5});
  cv::boxFilter(tiles.square, square, CV_32F, {5, 5});
  const cv::Mat variance = square - mean.mul(mean);
  cv::Mat deviation;
  cv::sqrt(cv::max(variance, 0.0), deviation);
  return mean.mul(1 + kSlope * (deviation / kRange - 1));
}

cv::Mat between_levels(const Tiles& tiles, unstep_page_light& light) {
  light = {};
  light.noise = 2 * noise_of(tiles);
  const double least = std::max(kLeastEdge, kEdgeSigmas * light.noise / 2);
  const Windows windows = look_around(tiles, least);
  light.contrast = windows.contrast;
  light.fits = windows.contrast >= kTrusted * least &&
                       std::min(tiles.mean.rows, tiles.mean.cols) >=
                           kSmallestPage / kTile
                   ? 1
                   : 0;
  if (windows.contrast == 0) {  // a blank page, or one that is all ink
    const double mean = cv::mean(tiles.mean)[0];
    light.darkest = light.lightest = mean;
    return cv::Mat(tiles.mean.size(), CV_32F, cv::Scalar(mean < 128 ? 256 : 0));
  }
  cv::Mat thresholds = at_edges(windows);
  Spread(tiles, windows.page_share, thresholds, windows.edge.clone()).run();
  measure_paper(tiles, windows, thresholds, light);
  return thresholds;
}

/// 64 times a pixel against 64 times a threshold below 2^9: far inside int32.
void cut(const unstep_plane& grey, const cv::Mat& thresholds,
         unstep_bits& ink) {
  const auto tiles = static_cast<std::size_t>(thresholds.cols);
  const auto width = static_cast<std::size_t>(grey.width);
  std::vector<std::int32_t> middles(tiles);
  // The pixels begin half a tile in, so that each step of the loop goes from
  // the middle of a tile to the middle of the next.
  constexpr std::size_t kLead = kTile / 2;
  std::vector<std::uint8_t> line(ink.words_per_row * 64 + 2 * kTile);
  std::vector<std::uint8_t> dark(line.size());
  for (int y = 0; y < grey.height; ++y) {
    interpolate_row(thresholds, y, middles);
    const std::uint8_t* pixels =
        grey.pixels + grey.stride * static_cast<std::size_t>(y);
    std::copy(pixels, pixels + width,
              line.begin() + static_cast<std::ptrdiff_t>(kLead));
    for (std::size_t i = 0; i <= tiles; ++i) {
      const std::int32_t from = middles[i == 0 ? 0 : i - 1];
      const std::int32_t step = middles[std::min(i, tiles - 1)] - from;
      for (std::size_t k = 0; k < kTile; ++k) {
        const auto part = static_cast<std::int32_t>(2 * k + 1);
        const std::int32_t threshold = from + step * part / (2 * kTile);
        dark[i * kTile + k] = 64 * line[i * kTile + k] < threshold ? 1 : 0;
      }
    }
    // Words may reach beyond the last tile, whose rest has no pixels either.
    std::fill(dark.begin() + static_cast<std::ptrdiff_t>(kLead + width),
              dark.end(), std::uint8_t{0});
    std::uint64_t* words =
        ink.words + ink.words_per_row * static_cast<std::size_t>(y);
    for (std::size_t word = 0; word < ink.words_per_row; ++word) {
      const std::uint8_t* at = dark.data() + kLead + word * 64;
      std::uint64_t bits = 0;
      for (std::size_t k = 0; k < 64; ++k) bits = bits << 1 | at[k];
      words[word] = bits;
    }
  }
}

}  // namespace unstep::imaging
