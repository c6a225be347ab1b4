#include <algorithm>
#include <cmath>

#include "formats/tile_light.h"

/// From pixels to tiles and back.
namespace unstep::imaging {
namespace {

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

/// Thresholds of a row of pixels in the middle of each tile, 1/64 of a level.
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
