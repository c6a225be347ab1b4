// Thinning against OpenCV's (module ximgproc of opencv_contrib, Guo and Hall,
// one thread):
//
//     thinning_bench IMAGE...
//
// A line for each bilevel image: seconds of both, their ratio, and whether the
// Euler number (ink 8-connected) and the number of pieces are the input's.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc.hpp>
#include <utility>

#include "unstep/formats.h"
#include "unstep/trace.h"

namespace {

using namespace unstep;
using Clock = std::chrono::steady_clock;

cv::Mat pixels_of(const Bitmap& ink) {
  cv::Mat pixels(ink.height(), ink.width(), CV_8U);
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      pixels.at<std::uint8_t>(y, x) = ink.get(x, y) ? 255 : 0;
    }
  }
  return pixels;
}

/// Of 8-connected ink, by quads (S. Gray, 1971).
std::int64_t euler_number(const cv::Mat& pixels) {
  const auto at = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < pixels.cols && y < pixels.rows &&
                   pixels.at<std::uint8_t>(y, x) != 0
               ? 1
               : 0;
  };
  std::int64_t sum = 0;
  for (int y = -1; y < pixels.rows; ++y) {
    for (int x = -1; x < pixels.cols; ++x) {
      const int a = at(x, y);
      const int d = at(x + 1, y + 1);
      const int ones = a + at(x + 1, y) + at(x, y + 1) + d;
      sum += ones == 1 ? 1 : ones == 3 ? -1 : ones == 2 && a == d ? -2 : 0;
    }
  }
  return sum / 4;
}

std::pair<std::int64_t, int> topology_of(const cv::Mat& pixels) {
  cv::Mat labels;
  return {euler_number(pixels), cv::connectedComponents(pixels, labels, 8)};
}

double seconds(Clock::time_point from) {
  return std::chrono::duration<double>(Clock::now() - from).count();
}

bool run(const char* file) {
  const auto bytes = read_file(file, std::uint64_t{1} << 30);
  if (!bytes) return false;
  auto reader = RasterReader::open(*bytes, {});
  if (!reader) return false;
  const auto page = reader->read(0);
  if (!page) return false;
  const cv::Mat before = pixels_of(page->ink);
  Bitmap ink = page->ink;
  const auto begin = Clock::now();
  if (!thin(ink)) return false;
  const double ours = seconds(begin);
  cv::Mat thinned;
  const auto middle = Clock::now();
  cv::ximgproc::thinning(before, thinned, cv::ximgproc::THINNING_GUOHALL);
  const double theirs = seconds(middle);
  const auto wanted = topology_of(before);
  std::printf(
      "%s: %.4f s, OpenCV %.4f s, %.0f times as fast; topology %s, "
      "OpenCV's %s\n",
      file, ours, theirs, theirs / ours,
      topology_of(pixels_of(ink)) == wanted ? "kept" : "BROKEN",
      topology_of(thinned) == wanted ? "kept" : "broken");
  return topology_of(pixels_of(ink)) == wanted;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: thinning_bench IMAGE...\n");
    return 2;
  }
  cv::setNumThreads(1);
  bool good = true;
  for (int i = 1; i < argc; ++i) good = run(argv[i]) && good;
  return good ? 0 : 1;
}
