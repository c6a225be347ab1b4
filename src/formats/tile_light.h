#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "formats/imaging_module.h"

/// What a page looks like in tiles of 8 x 8 pixels, for local thresholds. Part
/// of the module that holds OpenCV.
namespace unstep::imaging {

inline constexpr int kTile = 8;

/// One value a tile. All are of the means of 2 x 2 pixels, which halves the
/// noise.
struct Tiles {
  cv::Mat darkest;   ///< CV_8U
  cv::Mat lightest;  ///< CV_8U
  cv::Mat mean;      ///< CV_32F
  cv::Mat square;    ///< CV_32F, mean of squares
};

[[nodiscard]] Tiles survey(const unstep_plane& grey);

/// Sauvola's threshold (J. Sauvola and M. Pietikainen, Adaptive document image
/// binarization, 2000), m (1 + k (s / 128 - 1)) with k = 0.34 over windows of 5
/// x 5 tiles. CV_32F, one value a tile.
[[nodiscard]] cv::Mat sauvola(const Tiles& tiles);

/// A threshold between the ink and the paper around. Where a window of 3 x 3
/// tiles has contrast it lies below the lightest by half of the mean of the
/// window's contrast and of the page's (as a share of the light): half way for
/// broad strokes, nearer to the paper for lines so thin that the scanner has
/// blurred them away in part. From there it spreads over tiles without
/// contrast, following the light of the paper; a tile darker than the threshold
/// of its neighbours is ink throughout and takes theirs.
/// The idea of midpoints is J. Bernsen's (Dynamic thresholding of grey-level
/// images, 1986); he leaves places without contrast open.
[[nodiscard]] cv::Mat between_levels(const Tiles& tiles,
                                     unstep_page_light& light);

/// Pixels below the thresholds, interpolated between the middles of tiles.
void cut(const unstep_plane& grey, const cv::Mat& thresholds, unstep_bits& ink);

}  // namespace unstep::imaging
