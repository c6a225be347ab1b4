#include "formats/tile_light.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace unstep::imaging {
namespace {

/// The share of a page's contrast that counts as an edge, and how many sigmas
/// of its noise (a window without edges spans about six).
constexpr double kEdgeShare = 0.35;
constexpr double kEdgeSigmas = 12;
constexpr double kLeastEdge = 16;
/// What looks like noise of more levels than that is taken for ink everywhere:
/// better a spotted page than a blank one.
constexpr double kMostNoise = 12;
/// Edges must reach this many times above what noise does for local
/// thresholds to be trusted.
constexpr double kTrusted = 1.15;
constexpr int kSmallestPage = 64;
/// The threshold stays away from the darkest pixel by this share of the
/// window's contrast.
constexpr float kAboveDarkest = 0.2F;

/// The value that a share of the values is below; 0 of nothing.
double quantile(std::vector<float>& values, double share) {
  if (values.empty()) return 0;
  const auto index = static_cast<std::ptrdiff_t>(
      share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

/// Sigma of the 2 x 2 means, from the twentieth of tiles that has the least: on
/// dense drawings most tiles hold ink. Of noise alone these have less than the
/// rest, by the factor.
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
  constexpr double kOfTheRest = 1.2;
  return kOfTheRest * std::sqrt(std::max(quantile(variances, 0.05), 0.0));
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

}  // namespace

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
  Windows windows = look_around(tiles, least);
  const bool unsure = windows.contrast == 0 && light.noise > kMostNoise;
  if (unsure) windows = look_around(tiles, kLeastEdge);
  light.contrast = windows.contrast;
  light.fits = !unsure && windows.contrast >= kTrusted * least &&
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

}  // namespace unstep::imaging
