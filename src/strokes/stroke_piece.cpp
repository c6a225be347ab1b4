#include "strokes/stroke_piece.h"

#include <utility>

namespace unstep::strokes {
namespace {

/// Makes coordinates `factor` times finer. Pixels are below 2^30 / 2^9, but
/// wider pages may leave the range.
bool refine(Path& path, std::int32_t factor, Point offset) {
  const auto fits = [&](std::int64_t v) {
    return v * factor >= -kMaxCoord / 2 && v * factor <= kMaxCoord / 2;
  };
  const auto scale = [&](Point& p) {
    if (!fits(p.x) || !fits(p.y)) return false;
    p = {p.x * factor, p.y * factor};
    return true;
  };
  if (!scale(path.origin)) return false;
  path.origin = {path.origin.x + offset.x, path.origin.y + offset.y};
  for (Path::Element& element : path.elements) {
    Point move{element.segment.dx, element.segment.dy};
    if (!scale(move) || !scale(element.arc.centre) || !scale(element.arc.end)) {
      return false;
    }
    element.segment = {move.x, move.y};
  }
  return true;
}

}  // namespace

Result<Drawing> drawing_of(const std::vector<Piece>& pieces,
                           const Canvas& canvas, std::int32_t scale) {
  // Middles of pixels, and half pixels, are on this grid.
  const std::int32_t factor = scale == 1 ? 2 : 1;
  Drawing drawing;
  drawing.canvas = canvas;
  drawing.paint = Paint::stroke;
  drawing.scale = scale * factor;
  const std::int32_t half = drawing.scale / 2;
  drawing.paths.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    Path path = piece.path;
    const Point middle{half * (1 + piece.shift.x), half * (1 + piece.shift.y)};
    if (!refine(path, factor, middle)) {
      return Error{ErrorCode::out_of_range,
                   "the page is too large for half pixels"};
    }
    path.width = piece.width * half;
    drawing.paths.push_back(std::move(path));
  }
  return drawing;
}

}  // namespace unstep::strokes
