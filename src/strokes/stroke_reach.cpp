#include "strokes/stroke_reach.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "grid/row_distances.h"
#include "strokes/near_pieces.h"
#include "strokes/stroke_dots.h"
#include "unstep/trace.h"

namespace unstep::strokes {
namespace {

/// Of the tolerance, how near a path comes to its chain each time that it is
/// laid again; the last time it keeps every step.
constexpr std::array<double, 5> kFiner{0.9, 0.65, 0.45, 0.3, 0};

Result<Bitmap> draw(const std::vector<Piece>& pieces, const Bitmap& ink,
                    std::int32_t scale) {
  const Result<Drawing> drawing =
      drawing_of(pieces, {ink.width(), ink.height(), YAxis::down}, scale);
  if (!drawing) return drawing.error();
  return render_paths(*drawing);
}

/// The pixels of `a` that are too far from all of `b`.
NearPieces far_pixels(const Bitmap& a, const Bitmap& b, std::int64_t reach) {
  NearPieces places;
  RowDistances distances(b, RowDistances::To::ink);
  for (std::int32_t y = 0; y < a.height(); ++y) {
    const auto here = a.row(y);
    const auto there = b.row(y);
    std::span<const std::int64_t> squares;
    for (std::size_t w = 0; w < here.size(); ++w) {
      std::uint64_t left = here[w] & ~there[w];
      if (left != 0 && squares.empty()) squares = distances.row(y);
      for (; left != 0; left &= left - 1) {
        const auto x =
            static_cast<std::int32_t>(w * 64) + 63 - std::countr_zero(left);
        if (squares[static_cast<std::size_t>(x)] > reach) places.add({x, y});
      }
    }
  }
  return places;
}

/// Lines between points of a chain such that all others are within `bound` of
/// them (D. Douglas and T. Peucker, 1973).
class ChainLines {
 public:
  ChainLines(const Chain& chain, double bound) : bound_(bound) {
    Point at = chain.origin;
    points_.push_back(at);
    for (const Step step : chain.steps) {
      const Point move = step_delta(step, YAxis::down);
      at = {at.x + move.x, at.y + move.y};
      points_.push_back(at);
    }
  }

  Path path(bool closed, std::int32_t scale) {
    std::vector<std::size_t> kept{0};
    std::vector<std::size_t> ends{points_.size() - 1};
    while (!ends.empty()) {
      const std::size_t end = ends.back();
      const std::size_t between = farthest(kept.back(), end);
      if (between != 0) {
        ends.push_back(between);
        continue;
      }
      ends.pop_back();
      if (end != kept.back()) kept.push_back(end);
    }
    Path path;
    path.closed = closed;
    path.origin = {points_[0].x * scale, points_[0].y * scale};
    for (std::size_t i = 1; i < kept.size(); ++i) {
      const Point a = points_[kept[i - 1]];
      const Point b = points_[kept[i]];
      path.elements.push_back({Path::Kind::segment,
                               {(b.x - a.x) * scale, (b.y - a.y) * scale},
                               {}});
    }
    return path;
  }

 private:
  /// The point between two others farthest from their line, 0 if all are near.
  [[nodiscard]] std::size_t farthest(std::size_t first,
                                     std::size_t last) const {
    const Point a = points_[first];
    const double dx = points_[last].x - a.x;
    const double dy = points_[last].y - a.y;
    const double length = dx * dx + dy * dy;
    double most = bound_ * bound_;
    std::size_t found = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double x = points_[i].x - a.x;
      const double y = points_[i].y - a.y;
      const double t =
          length == 0 ? 0 : std::clamp((x * dx + y * dy) / length, 0.0, 1.0);
      const double ex = x - t * dx;
      const double ey = y - t * dy;
      if (ex * ex + ey * ey <= most) continue;
      most = ex * ex + ey * ey;
      found = i;
    }
    return found;
  }

  std::vector<Point> points_;
  double bound_;
};

void lay_again(Piece& piece, const Rational& tolerance, std::int32_t scale,
               PathCheck& check) {
  if (piece.changed) return restore_own(piece);
  if (piece.chain.steps.empty()) return;
  const double bound = static_cast<double>(tolerance.numerator) /
                       tolerance.denominator * kFiner[piece.times];
  if (piece.times + 1 < kFiner.size()) ++piece.times;
  Path path = ChainLines(piece.chain, bound).path(piece.chain.closed, scale);
  if (tolerance.numerator > 0 && !check.within(piece.chain, path)) {
    path = ChainLines(piece.chain, 0).path(piece.chain.closed, scale);
  }
  piece.path = std::move(path);
}

/// Which pieces the pixels belong to.
std::vector<bool> owners_of(NearPieces& pixels,
                            const std::vector<Piece>& pieces) {
  std::vector<bool> found(pieces.size());
  pixels.offer(pieces);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels.piece(i) != NearPieces::kNobody) found[pixels.piece(i)] = true;
  }
  return found;
}

}  // namespace

std::int64_t reach_of(const Rational& tolerance) {
  // At most 1 + 2^20, so its square is below 2^41.
  const double reach =
      1 + static_cast<double>(tolerance.numerator) / tolerance.denominator;
  return std::max<std::int64_t>(4, static_cast<std::int64_t>(reach * reach));
}

Status keep_near(const Bitmap& ink, const Rational& tolerance,
                 std::int32_t scale, bool dots_alone,
                 std::vector<Piece>& pieces) {
  PathCheck check(tolerance, scale);
  const std::int64_t reach = reach_of(tolerance);
  for (std::size_t round = 0; round <= kFiner.size(); ++round) {
    const Result<Bitmap> drawn = draw(pieces, ink, scale);
    if (!drawn) return drawn.error();
    NearPieces beyond = far_pixels(*drawn, ink, reach);
    NearPieces missed;
    if (!dots_alone) missed = far_pixels(ink, *drawn, reach);
    if (beyond.empty() && missed.empty()) break;
    const std::vector<bool> wide = owners_of(beyond, pieces);
    const std::vector<bool> short_of = owners_of(missed, pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!wide[i] && !short_of[i]) continue;
      lay_again(pieces[i], tolerance, scale, check);
      if (wide[i] && round > 0) {
        pieces[i].width = std::max(1, pieces[i].width - 1);
      }
    }
  }
  // A dot between pixels may reach a little less far than it should.
  for (std::size_t known = pieces.size() + 1; known != pieces.size();) {
    known = pieces.size();
    const Result<Bitmap> drawn = draw(pieces, ink, scale);
    if (!drawn) return drawn.error();
    Status dotted = add_dots(ink, *drawn, reach, scale, pieces);
    if (!dotted) return dotted;
  }
  return {};
}

}  // namespace unstep::strokes
