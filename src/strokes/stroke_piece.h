#pragma once

#include <cstdint>
#include <vector>

#include "unstep/deviation.h"
#include "unstep/grid.h"

namespace unstep::strokes {

/// What one pen draws of a stroke, and the path that stands for it.
struct Piece {
  Chain chain;
  std::int32_t width = 0;  ///< half pixels
  Point shift;             ///< as Stroke::shift
  std::uint32_t group = 0;
  bool repeated = false;  ///< one of a group that has others' paths, or lends
  /// What was laid before it was made like others, if it was.
  bool changed = false;
  Path own_path;
  std::int32_t own_width = 0;
  Point own_shift;
  std::size_t times = 0;  ///< it was laid again
  Path path;              ///< in 1 / path_scale() pixels, not shifted
};

/// Keeps what a piece is before it becomes like others.
inline void keep_own(Piece& piece) {
  if (piece.changed) return;
  piece.changed = true;
  piece.own_path = piece.path;
  piece.own_width = piece.width;
  piece.own_shift = piece.shift;
}
/// Gives it back.
inline void restore_own(Piece& piece) {
  piece.path = piece.own_path;
  piece.width = piece.own_width;
  piece.shift = piece.own_shift;
  piece.changed = piece.repeated = false;
}

/// Whether a path may stand for a chain.
class PathCheck {
 public:
  PathCheck(const Rational& tolerance, std::int32_t scale)
      : tolerance_(tolerance) {
    paths_.scale = scale;
    chains_.chains.resize(1);
    paths_.paths.resize(1);
  }

  [[nodiscard]] bool within(const Chain& chain, const Path& path) {
    chains_.chains[0] = chain;
    paths_.paths[0] = path;
    return bool{check_deviation(chains_, paths_, tolerance_)};
  }

 private:
  Rational tolerance_;
  Drawing chains_;
  Drawing paths_;
};

[[nodiscard]] inline Point end_of(const Path& path) {
  Point at = path.origin;
  for (const Path::Element& element : path.elements) {
    const bool arc = element.kind == Path::Kind::arc;
    at.x += arc ? element.arc.end.x : element.segment.dx;
    at.y += arc ? element.arc.end.y : element.segment.dy;
  }
  return at;
}

/// The pieces' paths with their pens. out_of_range if the page is too large for
/// half pixels.
Result<Drawing> drawing_of(const std::vector<Piece>& pieces,
                           const Canvas& canvas, std::int32_t scale);

}  // namespace unstep::strokes
