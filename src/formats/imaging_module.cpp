#include "formats/imaging_module.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "formats/small_pieces.h"
#include "formats/tile_light.h"

namespace {

using namespace unstep;

/// Runs the work; what it throws becomes the reason. One thread: those who call
/// have threads of their own.
template <class Work>
int guarded(unstep_reason reason, const Work& work) {
  try {
    cv::setNumThreads(1);
    work();
    return 0;
  } catch (const std::exception& error) {
    std::string line = error.what();
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::snprintf(reason.text, reason.size, "%s", line.c_str());
    return 1;
  }
}

cv::Mat view(const unstep_plane& plane) {
  return {plane.height, plane.width, CV_8UC1, plane.pixels, plane.stride};
}

/// The positions of dark pixels of a page made small, from its middle.
struct DarkPixels {
  std::vector<cv::Point2f> points;
  cv::Size size;
};

DarkPixels find_dark(const unstep_plane& grey, int level) {
  constexpr int kSide = 1400;  // enough for 0.05 degrees
  const cv::Mat page = view(grey);
  const double scale = std::min(
      1.0, static_cast<double>(kSide) / std::max(grey.width, grey.height));
  cv::Mat dark;
  cv::threshold(page, dark, level - 1, 255, cv::THRESH_BINARY_INV);
  cv::Mat reduced;
  cv::resize(dark, reduced, {}, scale, scale, cv::INTER_AREA);
  DarkPixels found{{}, reduced.size()};
  for (int y = 0; y < reduced.rows; ++y) {
    const auto* row = reduced.ptr<std::uint8_t>(y);
    for (int x = 0; x < reduced.cols; ++x) {
      if (row[x] < 64) continue;
      found.points.emplace_back(
          static_cast<float>(x) - static_cast<float>(reduced.cols) / 2,
          static_cast<float>(y) - static_cast<float>(reduced.rows) / 2);
    }
  }
  return found;
}

/// How unevenly the dark pixels lie in rows and columns turned by an angle: the
/// sum of squared differences between neighbours (W. Postl, Detection of linear
/// oblique structures, 1986).
double sharpness(const DarkPixels& dark, double degrees) {
  const double turn = degrees * CV_PI / 180;
  const auto sine = static_cast<float>(std::sin(turn));
  const auto cosine = static_cast<float>(std::cos(turn));
  const int half = (dark.size.width + dark.size.height) / 2 + 2;
  std::vector<float> rows(static_cast<std::size_t>(2 * half));
  std::vector<float> columns(rows.size());
  const auto put = [half](std::vector<float>& bins, float at) {
    const float from_start = at + static_cast<float>(half);
    const auto bin = static_cast<std::size_t>(from_start);
    const float part = from_start - static_cast<float>(bin);
    bins[bin] += 1 - part;
    bins[bin + 1] += part;
  };
  // A page turned counter-clockwise has rows that rise: y falls as x grows.
  for (const cv::Point2f& point : dark.points) {
    put(rows, point.y * cosine + point.x * sine);
    put(columns, point.x * cosine - point.y * sine);
  }
  double sum = 0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double row = rows[i + 1] - rows[i];
    const double column = columns[i + 1] - columns[i];
    sum += row * row + column * column;
  }
  return sum;
}

/// Steps of a quarter of a degree, then finer around the best.
double find_skew(const DarkPixels& dark) {
  double best = 0;
  double best_sharpness = sharpness(dark, 0);
  double step = 0.25;
  const auto look = [&](double from, double to) {
    const double begin = best + from;
    const auto count = static_cast<int>(std::lround((to - from) / step));
    for (int i = 0; i <= count; ++i) {
      const double angle = begin + i * step;
      const double found = sharpness(dark, angle);
      if (found > best_sharpness) {
        best_sharpness = found;
        best = angle;
      }
    }
  };
  look(-kMostSkew, kMostSkew);
  for (step = 0.05; step > 0.005; step /= 5) look(-5 * step, 5 * step);
  return std::clamp(best, -kMostSkew, kMostSkew);
}

}  // namespace

int unstep_imaging_revision() { return kImagingModuleRevision; }

int unstep_imaging_threshold(const unstep_plane* grey, std::int32_t method,
                             unstep_page_light* light, unstep_bits* ink,
                             unstep_reason reason) {
  return guarded(reason, [&] {
    const imaging::Tiles tiles = imaging::survey(*grey);
    cv::Mat thresholds;
    if (method == UNSTEP_METHOD_SAUVOLA) {
      thresholds = imaging::sauvola(tiles);
    } else {
      thresholds = imaging::between_levels(tiles, *light);
      const bool blank = light->contrast == 0;
      if (method == UNSTEP_METHOD_LOCAL_IF_FIT && light->fits == 0 && !blank) {
        return;
      }
    }
    imaging::cut(*grey, thresholds, *ink);
  });
}

int unstep_imaging_skew(const unstep_plane* grey, std::int32_t level,
                        double* degrees, unstep_reason reason) {
  return guarded(reason,
                 [&] { *degrees = find_skew(find_dark(*grey, level)); });
}

int unstep_imaging_turn(const unstep_plane* grey, double degrees,
                        std::uint8_t paper, unstep_plane* out,
                        unstep_reason reason) {
  return guarded(reason, [&] {
    const cv::Mat page = view(*grey);
    cv::Mat turned = view(*out);
    // Positive angles of getRotationMatrix2D are counter-clockwise as seen.
    cv::Mat map = cv::getRotationMatrix2D(
        cv::Point2f(static_cast<float>(grey->width - 1) / 2,
                    static_cast<float>(grey->height - 1) / 2),
        -degrees, 1);
    map.at<double>(0, 2) += (out->width - grey->width) / 2.0;
    map.at<double>(1, 2) += (out->height - grey->height) / 2.0;
    cv::warpAffine(page, turned, map, turned.size(), cv::INTER_LINEAR,
                   cv::BORDER_CONSTANT, cv::Scalar(paper));
  });
}

int unstep_imaging_remove(unstep_bits* ink, std::uint64_t area,
                          std::int32_t of_paper, std::uint64_t* pieces,
                          std::uint64_t* pixels, unstep_reason reason) {
  return guarded(reason, [&] {
    const imaging::PiecesRemoved removed =
        imaging::remove_small_pieces(*ink, area, of_paper != 0);
    *pieces = removed.pieces;
    *pixels = removed.pixels;
  });
}
