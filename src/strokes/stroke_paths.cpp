#include <string>
#include <utility>

#include "grid/chain_end.h"
#include "strokes/stroke_anchor.h"
#include "strokes/stroke_dots.h"
#include "strokes/stroke_piece.h"
#include "strokes/stroke_reach.h"
#include "strokes/stroke_repeat.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using strokes::Piece;

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

Result<std::vector<Piece>> pieces_of(std::span<const Stroke> strokes) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const Stroke& stroke = strokes[i];
    Point at = stroke.chain.origin;
    std::size_t used = 0;
    for (const Stroke::Piece& part : stroke.pieces) {
      if (part.width < 1 || part.steps > stroke.chain.steps.size() - used) {
        return Error{ErrorCode::invalid_argument,
                     "stroke " + std::to_string(i + 1) +
                         ": the pieces do not fit the chain"};
      }
      Piece piece;
      piece.chain = chain_of(stroke, at, used, part.steps);
      piece.width = part.width;
      piece.shift = stroke.shift;
      piece.group = stroke.group;
      at = chain_end(piece.chain, YAxis::down);
      used += part.steps;
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

/// Lays lines and arcs along all pieces.
Status lay_lines(std::vector<Piece>& pieces, const StrokeOptions& options) {
  Drawing chains;
  chains.canvas.y_axis = YAxis::down;
  for (const Piece& piece : pieces) chains.chains.push_back(piece.chain);
  ToleranceOptions lines;
  lines.tolerance = options.tolerance;
  lines.effort = options.effort;
  lines.arcs = options.arcs;
  lines.aim = options.aim;
  lines.may_cross = true;
  Result<Drawing> laid = reverse_tolerance(chains, lines);
  if (!laid) return laid.error();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].path = std::move(laid->paths[i]);
  }
  return {};
}

}  // namespace

Result<Drawing> stroke_paths(std::span<const Stroke> strokes,
                             const Canvas& canvas,
                             const StrokeOptions& options) {
  Result<std::vector<Piece>> pieces = pieces_of(strokes);
  if (!pieces) return pieces.error();
  const bool exact = options.tolerance.numerator == 0;
  const bool few_bytes = !exact && options.aim == LineAim::few_bytes;
  if (few_bytes &&
      options.tolerance.numerator >= options.tolerance.denominator) {
    for (Piece& piece : *pieces) piece.shift = {};
  }
  if (few_bytes && options.ink != nullptr) strokes::drop_dots(*pieces);
  const std::int32_t scale = exact ? 1 : path_scale(options.tolerance);
  if (exact) {
    for (Piece& piece : *pieces) piece.path = path_of_steps(piece.chain);
  } else {
    if (Status laid = lay_lines(*pieces, options); !laid) return laid.error();
    if (few_bytes) {
      strokes::repeat_groups(*pieces, options.tolerance, scale);
      strokes::anchor_paths(*pieces, options.tolerance, scale);
    }
  }
  if (options.ink != nullptr) {
    const Status near = strokes::keep_near(*options.ink, options.tolerance,
                                           scale, few_bytes, *pieces);
    if (!near) return near.error();
  }
  return strokes::drawing_of(*pieces, canvas, scale);
}

}  // namespace unstep
