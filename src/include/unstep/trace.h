#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/grid.h"
#include "unstep/result.h"
#include "unstep/reverse.h"

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

/// Thins the ink to lines one pixel wide: every pixel left is the end of a
/// line, or holds two things together. Ink (8-connected) keeps its pieces and
/// its holes (4-connected paper), so their numbers and the Euler number stay;
/// a piece without holes that is as long as it is wide may become a pixel.
/// Lines are where the middle of the ink is, within a pixel; their ends are up
/// to half the width short of the ink's.
///
/// Time: words of 64 pixels that still change, for each pixel of half the
/// width. Memory: a twentieth of the bitmap. `progress` counts pixels taken
/// off; after `cancelled` the ink is partly thinned, its topology the same.
Status thin(Bitmap& ink, const Progress& progress = {});

/// A line of a drawing: a pen's way along the middle of the ink.
struct Stroke {
  /// Steps that one pen draws.
  struct Piece {
    std::size_t steps = 0;
    std::int32_t width = 0;  ///< of the pen, in half pixels, at least 1
  };
  Chain chain;  ///< 8-connected, pixels, y down; a dot has no steps
  /// The line is this many half pixels, -1..1, beside the middles of the
  /// pixels: where an even number of pixels wide, its middle is between two.
  Point shift;
  /// In order, together all steps; one if the width is the same all along.
  std::vector<Piece> pieces;
  /// Strokes that touch have the same number: a letter, a net of lines.
  std::uint32_t group = 0;
};

/// The ink as strokes: thinned, freed from what noise and the ends of thick
/// lines add to a skeleton, and joined at junctions with what continues
/// straightest, so that a crossing is two strokes and a T keeps its bar as one;
/// what is left over ends on the others. A ring is a closed stroke, a spot a
/// dot. Ends are where a pen with a round tip would stop to reach as far as the
/// ink does. Widths come from the distances to paper; where they change by more
/// than two pixels a stroke has pieces. Ink that these strokes miss by more
/// than 2.24 pixels, or by 2 where four pixels are (blots on lines, filled
/// shapes), is dotted with pens that reach its edge.
///
/// Strokes that touch stand together, groups in the order of reading and large
/// ones last; in a group strokes come after those on which they begin.
///
/// The same ink gives the same strokes on every machine. invalid_argument for
/// an empty bitmap, limit_exceeded for a skeleton of more than 2^31 pixels.
/// Memory: three times the bitmap and about 40 bytes a pixel of the skeleton.
Result<std::vector<Stroke>> trace_strokes(const Bitmap& ink,
                                          const Progress& progress = {});

/// Strokes as a drawing of stroked paths (Paint::stroke), a path for each
/// piece, within `tolerance` grid units of the chains (Euclidean Frechet
/// distance); tolerance 0 keeps every step. Pieces of a stroke follow each
/// other, each from where the one before ends. Scale is 2 or, for finer
/// tolerances, path_scale(); pixel (x, y) has its middle at (x + 1/2, y + 1/2),
/// as render_paths() has it. out_of_range as reverse_tolerance().
struct StrokeOptions {
  Rational tolerance{1, 1};
  Effort effort = Effort::standard;
  bool arcs = true;
  /// few_bytes: cheap for UstpWriter, still within the tolerance. Small groups
  /// of strokes that are alike become the same paths; paths begin on others.
  /// From a tolerance of 1 on, lines are not moved by Stroke::shift.
  LineAim aim = LineAim::few_lines;
  /// The ink that the strokes are of, if what is drawn shall be within two
  /// pixels of it, or the tolerance and one, and it of what is drawn: paths are
  /// then nearer to their chains where that is needed, pens narrower, and dots
  /// cover what is left; with few_bytes dots alone, and beside lines only where
  /// these miss ink. Of its size as the canvas; not owned.
  const Bitmap* ink = nullptr;
};
Result<Drawing> stroke_paths(std::span<const Stroke> strokes,
                             const Canvas& canvas,
                             const StrokeOptions& options);

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
