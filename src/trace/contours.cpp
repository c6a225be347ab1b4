#include <bit>
#include <utility>

#include "trace/contour_turn.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using trace::Quarter;

class ContourTracer {
 public:
  /// `walked`: all paper, of the size of the ink.
  ContourTracer(const Bitmap& ink, Bitmap walked)
      : ink_(ink), walked_(std::move(walked)) {
    contour_.connectivity = Connectivity::four;
    contour_.closed = true;
  }

  Status run(const ContourVisitor& visit) {
    for (std::int32_t y = 0; y < ink_.height(); ++y) {
      for (std::size_t word = 0; word < ink_.words_per_row(); ++word) {
        // The first crack of a contour in raster order is a horizontal one
        // that is not walked yet, and never below the last row.
        while (const std::uint64_t open = cracks(y, word)) {
          const auto x =
              static_cast<std::int32_t>(word * 64) + std::countl_zero(open);
          walk(x, y);
          if (!visit(contour_)) {
            return Error{ErrorCode::cancelled, "stopped by the visitor"};
          }
        }
      }
    }
    return {};
  }

 private:
  /// The horizontal cracks above 64 pixels of row y that are not walked yet.
  [[nodiscard]] std::uint64_t cracks(std::int32_t y, std::size_t word) const {
    const std::uint64_t above = y == 0 ? 0 : ink_.row(y - 1)[word];
    return (above ^ ink_.row(y)[word]) & ~walked_.row(y)[word];
  }

  [[nodiscard]] bool pixel(std::int32_t x, std::int32_t y) const {
    return x >= 0 && y >= 0 && x < ink_.width() && y < ink_.height() &&
           ink_.get(x, y);
  }

  /// Walks the contour that starts at (x, y) towards the east until it is back.
  /// It passes its start once: all its cracks are in this row or below.
  void walk(std::int32_t x, std::int32_t y) {
    const Point start{x, y};
    const bool ink = ink_.get(x, y);
    const auto at = [this](std::int32_t px, std::int32_t py) {
      return pixel(px, py);
    };
    contour_.origin = start;
    contour_.steps.clear();
    Quarter direction = 0;
    do {
      if (direction % 2 == 0 && y < ink_.height()) {
        walked_.set(direction == 0 ? x : x - 1, y, true);
      }
      // Clockwise quarters to counter-clockwise eighths.
      contour_.steps.push_back(static_cast<Step>((8 - 2 * direction) & 7));
      const auto d = static_cast<std::size_t>(direction);
      x += trace::kQuarterDx[d];
      y += trace::kQuarterDy[d];
      direction =
          trace::turned(direction, trace::true_turn(at, x, y, direction, ink));
    } while (Point{x, y} != start);
  }

  const Bitmap& ink_;
  Bitmap walked_;  ///< the walked horizontal cracks above each pixel
  Chain contour_;
};

}  // namespace

Status trace_contours(const Bitmap& ink, const ContourVisitor& visit) {
  if (ink.pixels() == 0) {
    return Error{ErrorCode::invalid_argument, "a bitmap of 0 x 0 pixels"};
  }
  Result<Bitmap> walked = Bitmap::create(ink.width(), ink.height());
  if (!walked) return walked.error();
  return ContourTracer(ink, *std::move(walked)).run(visit);
}

}  // namespace unstep
