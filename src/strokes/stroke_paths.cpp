#include <string>
#include <utility>

#include "grid/chain_end.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

/// The steps as lines, equal ones that follow each other as one.
Path path_of_steps(const Chain& chain) {
  Path path;
  path.origin = chain.origin;
  path.closed = chain.closed;
  for (std::size_t i = 0; i < chain.steps.size();) {
    std::size_t end = i;
    while (end < chain.steps.size() && chain.steps[end] == chain.steps[i]) {
      ++end;
    }
    const Point move = step_delta(chain.steps[i], YAxis::down);
    const auto n = static_cast<std::int32_t>(end - i);
    path.elements.push_back(
        {Path::Kind::segment, {move.x * n, move.y * n}, {}});
    i = end;
  }
  return path;
}

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

/// One piece of a stroke.
Chain chain_of(const Stroke& stroke, Point origin, std::size_t first,
               std::size_t steps) {
  Chain chain;
  chain.origin = origin;
  chain.closed = stroke.chain.closed && steps == stroke.chain.steps.size();
  const auto begin =
      stroke.chain.steps.begin() + static_cast<std::ptrdiff_t>(first);
  chain.steps.assign(begin, begin + static_cast<std::ptrdiff_t>(steps));
  return chain;
}

class StrokePaths {
 public:
  explicit StrokePaths(const StrokeOptions& options) : options_(options) {
    const std::int32_t own = exact() ? 1 : path_scale(options.tolerance);
    factor_ = own == 1 ? 2 : 1;
    scale_ = own * factor_;
  }

  [[nodiscard]] std::int32_t scale() const { return scale_; }

  Status add(const Stroke& stroke, std::vector<Path>& paths) const {
    Point at = stroke.chain.origin;
    std::size_t used = 0;
    for (const Stroke::Piece& piece : stroke.pieces) {
      if (piece.width < 1 || piece.steps > stroke.chain.steps.size() - used) {
        return Error{ErrorCode::invalid_argument,
                     "the pieces do not fit the chain"};
      }
      const Chain chain = chain_of(stroke, at, used, piece.steps);
      Result<Path> path = lines_of(chain);
      if (!path) return path.error();
      const Point middle{scale_ / 2 * (1 + stroke.shift.x),
                         scale_ / 2 * (1 + stroke.shift.y)};
      if (!refine(*path, factor_, middle)) {
        return Error{ErrorCode::out_of_range,
                     "the page is too large for half pixels"};
      }
      path->width = piece.width * (scale_ / 2);
      paths.push_back(*std::move(path));
      at = chain_end(chain, YAxis::down);
      used += piece.steps;
    }
    return {};
  }

 private:
  [[nodiscard]] bool exact() const { return options_.tolerance.numerator == 0; }

  [[nodiscard]] Result<Path> lines_of(const Chain& chain) const {
    if (exact()) return path_of_steps(chain);
    return reverse_tolerance(
        chain, YAxis::down,
        {options_.tolerance, options_.effort, options_.arcs});
  }

  StrokeOptions options_;
  std::int32_t factor_;
  std::int32_t scale_;
};

}  // namespace

Result<Drawing> stroke_paths(std::span<const Stroke> strokes,
                             const Canvas& canvas,
                             const StrokeOptions& options) {
  Drawing drawing;
  drawing.canvas = canvas;
  drawing.paint = Paint::stroke;
  const StrokePaths maker(options);
  drawing.scale = maker.scale();
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const Status added = maker.add(strokes[i], drawing.paths);
    if (!added) {
      return Error{added.error().code, "stroke " + std::to_string(i + 1) +
                                           ": " + added.error().message};
    }
  }
  return drawing;
}

}  // namespace unstep
