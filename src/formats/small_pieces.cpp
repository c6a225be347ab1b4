#include "formats/small_pieces.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace unstep::imaging {
namespace {

std::uint64_t* row_of(const unstep_bits& ink, int y) {
  return ink.words + ink.words_per_row * static_cast<std::size_t>(y);
}

/// Rows first to last - 1 as bytes, 1 where the pieces are.
cv::Mat unpack(const unstep_bits& ink, int first, int last, bool of_paper) {
  cv::Mat pixels(last - first, ink.width, CV_8UC1);
  const std::uint64_t wanted = of_paper ? 0 : 1;
  for (int y = first; y < last; ++y) {
    const std::uint64_t* words = row_of(ink, y);
    auto* row = pixels.ptr<std::uint8_t>(y - first);
    for (int x = 0; x < ink.width; ++x) {
      const std::uint64_t bit = words[x / 64] >> (63 - x % 64) & 1;
      row[x] = bit == wanted ? 1 : 0;
    }
  }
  return pixels;
}

/// What is to go of the pieces of a band.
class Judge {
 public:
  Judge(const unstep_bits& ink, std::uint64_t area, bool of_paper)
      : ink_(ink), area_(area), of_paper_(of_paper) {}

  /// One flag a label of the band that starts at row `first`.
  [[nodiscard]] std::vector<bool> judge(const cv::Mat& stats, int first) const {
    std::vector<bool> goes(static_cast<std::size_t>(stats.rows));
    for (int label = 1; label < stats.rows; ++label) {
      const auto* row = stats.ptr<std::int32_t>(label);
      const auto pixels = static_cast<std::uint64_t>(row[cv::CC_STAT_AREA]);
      const int left = row[cv::CC_STAT_LEFT];
      const int top = row[cv::CC_STAT_TOP] + first;
      const bool at_edge = left == 0 || top == 0 ||
                           left + row[cv::CC_STAT_WIDTH] == ink_.width ||
                           top + row[cv::CC_STAT_HEIGHT] == ink_.height;
      goes[static_cast<std::size_t>(label)] =
          pixels <= area_ && !(of_paper_ && at_edge);
    }
    return goes;
  }

 private:
  const unstep_bits& ink_;
  std::uint64_t area_;
  bool of_paper_;
};

/// The last row of a piece, in which it is counted.
int last_row(const cv::Mat& stats, int label, int first) {
  const auto* row = stats.ptr<std::int32_t>(label);
  return first + row[cv::CC_STAT_TOP] + row[cv::CC_STAT_HEIGHT] - 1;
}

}  // namespace

/// A piece of at most `area` pixels spans at most `area` rows. Seen in a window
/// that reaches `area` rows beyond both sides of a band, a piece that meets the
/// band is either whole or has more than `area` pixels in the window. All
/// windows see the page as it was.
PiecesRemoved remove_small_pieces(unstep_bits& ink, std::uint64_t area,
                                  bool of_paper) {
  PiecesRemoved removed;
  if (area == 0) return removed;
  const int margin = static_cast<int>(
      std::min<std::uint64_t>(area, static_cast<std::uint64_t>(ink.height)));
  const int rows = std::max(512, margin);
  const Judge judge(ink, area, of_paper);
  const std::vector<std::uint64_t> original(
      ink.words,
      ink.words + ink.words_per_row * static_cast<std::size_t>(ink.height));
  const unstep_bits before{ink.width, ink.height, ink.words_per_row,
                           const_cast<std::uint64_t*>(original.data())};
  for (int begin = 0; begin < ink.height; begin += rows) {
    const int end = std::min(begin + rows, ink.height);
    const int first = std::max(begin - margin, 0);
    const int last = std::min(end + margin, ink.height);
    const cv::Mat pixels = unpack(before, first, last, of_paper);
    cv::Mat labels;
    cv::Mat stats;
    cv::Mat centres;
    cv::connectedComponentsWithStats(pixels, labels, stats, centres,
                                     of_paper ? 4 : 8, CV_32S);
    const std::vector<bool> goes = judge.judge(stats, first);
    for (int label = 1; label < stats.rows; ++label) {
      const int row = last_row(stats, label, first);
      const bool is_here = row >= begin && row < end;
      if (is_here && goes[static_cast<std::size_t>(label)]) ++removed.pieces;
    }
    for (int y = begin; y < end; ++y) {
      const auto* row = labels.ptr<std::int32_t>(y - first);
      std::uint64_t* words = row_of(ink, y);
      for (int x = 0; x < ink.width; ++x) {
        if (!goes[static_cast<std::size_t>(row[x])]) continue;
        words[x / 64] ^= std::uint64_t{1} << (63 - x % 64);
        ++removed.pixels;
      }
    }
  }
  return removed;
}

}  // namespace unstep::imaging
