// Makes a grey scan out of a bilevel page: enlarged to A4 at 600 dpi if asked,
// skewed, blurred, lit unevenly, noisy. The same arguments give the same
// pixels (the noise is our own; only interpolation is OpenCV's).
//
//     make_scan IN OUT.pgm [TRUTH.pbm] [name=value]...
//
// a4=0|1, skew=degrees, blur=sigma in px, noise=sigma in levels, ink=level,
// paper=level, gradient=share of light lost from corner to corner, gutter=share
// lost at the left edge, seed=N. TRUTH.pbm is the page as it should come out:
// enlarged and skewed alike, then cut at one half.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "unstep/formats.h"

namespace {

using namespace unstep;

constexpr int kPageWidth = 4960;  // A4 at 600 dpi
constexpr int kPageHeight = 7016;

using Settings = std::map<std::string, double>;

Result<cv::Mat> read_page(const char* name) {
  Result<std::vector<std::uint8_t>> bytes = read_file(name, 1U << 30);
  if (!bytes) return bytes.error();
  Result<RasterReader> file = RasterReader::open(*std::move(bytes), {});
  if (!file) return file.error();
  const Result<RasterPage> page = file->read(0);
  if (!page) return page.error();
  cv::Mat grey(page->ink.height(), page->ink.width(), CV_8UC1);
  for (std::int32_t y = 0; y < grey.rows; ++y) {
    for (std::int32_t x = 0; x < grey.cols; ++x) {
      grey.at<std::uint8_t>(y, x) = page->ink.get(x, y) ? 0 : 255;
    }
  }
  return grey;
}

/// Enlarged to the paper and turned about its middle in one step.
cv::Mat placed(const cv::Mat& page, Settings& with) {
  const bool a4 = with["a4"] != 0;
  if (!a4 && with["skew"] == 0) return page;
  const cv::Size size = a4 ? cv::Size(kPageWidth, kPageHeight) : page.size();
  const double scale = std::min(static_cast<double>(size.width) / page.cols,
                                static_cast<double>(size.height) / page.rows);
  const cv::Point2f middle(static_cast<float>(page.cols) / 2,
                           static_cast<float>(page.rows) / 2);
  cv::Mat map = cv::getRotationMatrix2D(middle, with["skew"], scale);
  map.at<double>(0, 2) += (size.width - page.cols) / 2.0;
  map.at<double>(1, 2) += (size.height - page.rows) / 2.0;
  cv::Mat out;
  cv::warpAffine(page, out, map, size, cv::INTER_CUBIC, cv::BORDER_CONSTANT,
                 cv::Scalar(255));
  return out;
}

/// About normal: the sum of eight bytes of a random word (SplitMix64, G. L.
/// Steele and others, Fast splittable pseudorandom number generators, 2014).
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}
  double next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t word = state_;
    word = (word ^ word >> 30) * 0xbf58476d1ce4e5b9U;
    word = (word ^ word >> 27) * 0x94d049bb133111ebU;
    word ^= word >> 31;
    int sum = 0;
    for (; word != 0; word >>= 8) sum += static_cast<int>(word & 255);
    constexpr double kSigma = 209.02;  // sqrt(8 (256^2 - 1) / 12)
    return (sum - 8 * 127.5) / kSigma;
  }

 private:
  std::uint64_t state_;
};

void light(cv::Mat& grey, Settings& with) {
  Noise noise(static_cast<std::uint64_t>(with["seed"]));
  const double ink = with["ink"];
  const double contrast = (with["paper"] - ink) / 255;
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      const double across = static_cast<double>(x) / grey.cols;
      const double down = static_cast<double>(y) / grey.rows;
      const double shine = 1 - with["gradient"] * (across + down) / 2 -
                           with["gutter"] * std::exp(-across / 0.06);
      std::uint8_t& pixel = grey.at<std::uint8_t>(y, x);
      const double seen = (ink + contrast * pixel) * std::max(shine, 0.0) +
                          with["noise"] * noise.next();
      pixel = static_cast<std::uint8_t>(std::clamp(seen + 0.5, 0.0, 255.0));
    }
  }
}

bool write_pgm(const char* name, const cv::Mat& grey) {
  std::FILE* file = std::fopen(name, "wb");
  if (file == nullptr) return false;
  std::fprintf(file, "P5\n%d %d\n255\n", grey.cols, grey.rows);
  bool good = true;
  for (int y = 0; y < grey.rows && good; ++y) {
    const auto width = static_cast<std::size_t>(grey.cols);
    good = std::fwrite(grey.ptr(y), 1, width, file) == width;
  }
  return std::fclose(file) == 0 && good;
}

bool write_truth(const char* name, const cv::Mat& grey) {
  Result<Bitmap> ink = Bitmap::create(grey.cols, grey.rows);
  Result<RasterWriter> writer = RasterWriter::create(RasterFormat::pbm);
  if (!ink || !writer) return false;
  for (std::int32_t y = 0; y < grey.rows; ++y) {
    for (std::int32_t x = 0; x < grey.cols; ++x) {
      ink->set(x, y, grey.at<std::uint8_t>(y, x) < 128);
    }
  }
  if (!writer->add_page(*ink, {}, nullptr)) return false;
  const auto bytes = writer->finish();
  return bytes && write_file(name, *bytes, true);
}

}  // namespace

int main(int argc, char** argv) {
  Settings with{{"a4", 0},        {"skew", 0},     {"blur", 0.7},
                {"noise", 6},     {"ink", 45},     {"paper", 230},
                {"gradient", .3}, {"gutter", 0.3}, {"seed", 1}};
  std::vector<const char*> names;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
      names.push_back(argv[i]);
    } else if (with.count(text.substr(0, equals)) == 0) {
      std::fprintf(stderr, "make_scan: no setting %s\n", argv[i]);
      return 2;
    } else {
      with[text.substr(0, equals)] = std::atof(text.c_str() + equals + 1);
    }
  }
  if (names.size() < 2 || names.size() > 3) {
    std::fprintf(stderr, "usage: make_scan IN OUT.pgm [TRUTH.pbm] [N=V]...\n");
    return 2;
  }
  const Result<cv::Mat> page = read_page(names[0]);
  if (!page) {
    std::fprintf(stderr, "make_scan: %s: %s\n", names[0],
                 page.error().message.c_str());
    return 1;
  }
  cv::Mat grey = placed(*page, with).clone();
  if (names.size() == 3 && !write_truth(names[2], grey)) return 1;
  if (with["blur"] > 0) cv::GaussianBlur(grey, grey, {}, with["blur"]);
  light(grey, with);
  return write_pgm(names[1], grey) ? 0 : 1;
}
