#include <string>

#include "render/flatten.h"
#include "render/line_raster.h"
#include "render/parity.h"
#include "render/stroke.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using render::LineVisitor;
using render::Place;
using render::SubGrid;
using render::View;

Error path_error(ErrorCode code, std::size_t path, const std::string& reason) {
  return {code, "path " + std::to_string(path + 1) + ": " + reason};
}

bool in_range(std::int64_t v) { return v >= -kMaxCoord && v <= kMaxCoord; }

Point end_of(const Path::Element& element) {
  return element.kind == Path::Kind::segment
             ? Point{element.segment.dx, element.segment.dy}
             : element.arc.end;
}

Status check_path(const Path& path, std::size_t index, Paint paint) {
  if (path.width < 0 || path.width > kMaxCoord)
    return path_error(ErrorCode::out_of_range, index,
                      "width " + std::to_string(path.width) + " is not in 0.." +
                          std::to_string(kMaxCoord));
  Place at{path.origin.x, path.origin.y};
  if (!in_range(at.x) || !in_range(at.y))
    return path_error(ErrorCode::out_of_range, index,
                      "starts outside the coordinate range");
  for (std::size_t i = 0; i < path.elements.size(); ++i) {
    const Point move = end_of(path.elements[i]);
    at = {at.x + move.x, at.y + move.y};
    if (!in_range(at.x) || !in_range(at.y))
      return path_error(
          ErrorCode::out_of_range, index,
          "leaves the coordinate range at element " + std::to_string(i + 1));
  }
  if (paint == Paint::fill && path.closed &&
      at != Place{path.origin.x, path.origin.y})
    return path_error(ErrorCode::invalid_argument, index,
                      "does not return to its origin");
  return {};
}

Status check_drawing(const Drawing& drawing) {
  const Canvas& canvas = drawing.canvas;
  if (canvas.width <= 0 || canvas.height <= 0)
    return Error{ErrorCode::invalid_argument, "the canvas has no size"};
  if (drawing.scale < 1 || drawing.scale > Drawing::kMaxScale)
    return Error{ErrorCode::out_of_range,
                 "scale " + std::to_string(drawing.scale) + " is not in 1.." +
                     std::to_string(Drawing::kMaxScale)};
  for (std::size_t i = 0; i < drawing.paths.size(); ++i) {
    const Status checked = check_path(drawing.paths[i], i, drawing.paint);
    if (!checked) return checked;
  }
  return {};
}

/// Paths as lines on the raster, whose y grows downwards.
class PathLines {
 public:
  PathLines(const Drawing& drawing)
      : grid_(drawing.scale),
        size_{drawing.canvas.width * grid_.per_grid_unit,
              drawing.canvas.height * grid_.per_grid_unit},
        up_(drawing.canvas.y_axis == YAxis::up) {}

  [[nodiscard]] const SubGrid& grid() const { return grid_; }

  /// Half the width: sub-units are even in the path unit.
  [[nodiscard]] std::int64_t radius(const Path& path) const {
    return path.width * (grid_.per_path_unit / 2);
  }

  /// A path without elements is a line without length.
  void visit(const Path& path, const LineVisitor& use) const {
    const std::int64_t unit = grid_.per_path_unit;
    const std::int64_t margin = radius(path) + grid_.per_grid_unit;
    const View view{{-margin, -margin}, {size_.x + margin, size_.y + margin}};
    const LineVisitor line = [&](Place from, Place to) {
      use(on_raster(from), on_raster(to));
    };
    Place at{path.origin.x * unit, path.origin.y * unit};
    if (path.elements.empty()) line(at, at);
    for (const Path::Element& element : path.elements) {
      const Point move = end_of(element);
      const Place next{at.x + move.x * unit, at.y + move.y * unit};
      if (element.kind == Path::Kind::segment) {
        line(at, next);
      } else {
        render::flatten_arc(element.arc, at, grid_, view, line);
      }
      at = next;
    }
  }

 private:
  [[nodiscard]] Place on_raster(Place p) const {
    return up_ ? Place{p.x, size_.y - p.y} : p;
  }

  SubGrid grid_;
  Place size_;
  bool up_;
};

void fill(const Drawing& drawing, const PathLines& lines, Bitmap& ink) {
  for (const Path& path : drawing.paths) {
    if (!path.closed) continue;
    lines.visit(path, [&](Place from, Place to) {
      render::flip_crossings(from, to, lines.grid(), ink);
    });
  }
  for (std::int32_t y = 0; y < ink.height(); ++y)
    render::fill_row(ink.row(y), ink.last_word_mask());
}

void stroke(const Drawing& drawing, const PathLines& lines, Bitmap& ink) {
  for (const Path& path : drawing.paths) {
    const std::int64_t radius = lines.radius(path);
    lines.visit(path, [&](Place from, Place to) {
      if (radius == 0) {
        render::ink_hairline(from, to, lines.grid(), ink);
      } else {
        render::ink_stroke(from, to, radius, lines.grid(), ink);
      }
    });
  }
}

}  // namespace

Result<Bitmap> render_paths(const Drawing& drawing) {
  const Status checked = check_drawing(drawing);
  if (!checked) return checked.error();
  Result<Bitmap> ink =
      Bitmap::create(drawing.canvas.width, drawing.canvas.height);
  if (!ink) return ink;
  const PathLines lines(drawing);
  if (drawing.paint == Paint::fill) {
    fill(drawing, lines, *ink);
  } else {
    stroke(drawing, lines, *ink);
  }
  return ink;
}

}  // namespace unstep
