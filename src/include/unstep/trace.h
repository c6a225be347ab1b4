#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "unstep/bitmap.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// Ink to contours and back; pulses of encoders to unit steps.
namespace unstep {

/// Called for each contour; return false to stop.
using ContourVisitor = std::function<bool(const Chain& contour)>;

/// Visits every contour of the ink once, outer and hole: the closed
/// 4-connected chains on the cracks between ink and paper pixels. Pixels
/// outside the raster are paper. Grid point (x, y), y down, is the upper left
/// corner of pixel (x, y), so points run over 0..width by 0..height.
///
/// Order: by the first horizontal crack of each contour in raster order. A
/// contour starts at the left end of that crack and goes east (outer contours
/// are clockwise as seen, ink on the right hand; holes have paper on the
/// right hand). At a saddle point (two ink pixels touching at a corner) ink is
/// 8-connected: the walk keeps both ink pixels in one contour.
///
/// invalid_argument for an empty bitmap; cancelled if the visitor stopped.
/// Memory: two bits per grid point besides the longest contour.
Status trace_contours(const Bitmap& ink, const ContourVisitor& visit);

/// Draws closed 4-connected chains (raster, y down) by parity fill: a pixel is
/// ink if a ray from it crosses an odd number of vertical cracks. The inverse
/// of trace_contours. invalid_argument if a chain is not closed or uses odd
/// codes, out_of_range if it leaves 0..width x 0..height.
Result<Bitmap> fill_contours(std::span<const Chain> contours,
                             std::int32_t width, std::int32_t height);

/// The counts of one encoder with two channels in quadrature: the pulse former
/// of a photogrammetric automaton of 1976 (programmable modules of "Zenit"),
/// which makes count pulses out of the edges of two signals 90 degrees apart
/// and picks every edge or one a cycle.
///
///     QuadratureDecoder x(4);
///     for (const auto& [a, b] : samples) position += x.sample(a, b);
class QuadratureDecoder {
 public:
  /// Counts of a cycle: 4, every edge; 2, the edges of A; 1, the edges of A
  /// while B is low. Other values mean 4.
  explicit QuadratureDecoder(int counts) : counts_(counts) {}

  /// The next sample: +1, 0 or -1. The first one only tells where to begin. A
  /// rising before B counts up.
  int sample(bool a, bool b) {
    const bool was_a = a_;
    const bool was_b = b_;
    a_ = a;
    b_ = b;
    illegal_ = false;
    if (!begun_) {
      begun_ = true;
      return 0;
    }
    if (a == was_a && b == was_b) return 0;
    if (a != was_a && b != was_b) {
      illegal_ = true;
      return 0;
    }
    if (a == was_a) {  // an edge of B
      const bool counted = counts_ != 1 && counts_ != 2;
      return counted ? (b == a ? 1 : -1) : 0;
    }
    if (counts_ == 1 && b) return 0;
    return a != b ? 1 : -1;
  }

  /// True if both channels changed with the last sample, which therefore
  /// counted nothing: two edges, up or down, cannot be told apart.
  [[nodiscard]] bool is_illegal() const { return illegal_; }

 private:
  int counts_;
  bool begun_ = false;
  bool illegal_ = false;
  bool a_ = false;
  bool b_ = false;
};

/// Draws the paths of a drawing (not its chains) on its canvas. Pixel (x, y)
/// covers the grid unit from (x, y) to (x + 1, y + 1); with YAxis::up the
/// canvas is the same, its last row at the bottom.
///
/// Paint::fill: the closed paths together, by even-odd filling: a pixel is ink
/// if its centre is inside. A centre on a line counts as right of it, one level
/// with a corner as below it (as numbers y grow, if down), so that polygons
/// that share edges share no pixel. A path along the cracks of a contour fills
/// what fill_contours() fills. Open paths are left out.
/// Paint::stroke: every path by a pen with round ends: a pixel is ink if its
/// centre is at most half the width from the path. Width 0 draws an 8-connected
/// line of the pixels (x, y) nearest to the points (x, y) of the path, so that
/// a path along pixels draws these pixels.
///
/// Exact in integers; arcs are flattened to within 1/64 of a grid unit. Paths
/// may leave the canvas: time is bounded by their elements and what is seen of
/// them (rows each crosses; for strokes times the logarithm of the width),
/// memory by the canvas.
///
/// invalid_argument for a canvas without size or, when filling, a closed path
/// that does not return; out_of_range for coordinates outside their range, a
/// negative width or a scale outside 1..kMaxScale.
Result<Bitmap> render_paths(const Drawing& drawing);

}  // namespace unstep
