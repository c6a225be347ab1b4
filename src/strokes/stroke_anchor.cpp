#include "strokes/stroke_anchor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "grid/vector_classes.h"

namespace unstep::strokes {
namespace {

using vectors::Vec;

/// Vertices that a beginning may be told from, as coder 25 has it.
constexpr std::size_t kReach = 48;

/// A vertex, and the line that leads to it.
struct Vertex {
  Point at;
  Point before;
  bool line = false;
};

class Anchorer {
 public:
  Anchorer(std::vector<Piece>& pieces, const Rational& tolerance,
           std::int32_t scale)
      : pieces_(pieces), check_(tolerance, scale) {
    reach_ = static_cast<std::int32_t>(std::uint64_t{tolerance.numerator} *
                                       static_cast<std::uint64_t>(scale) /
                                       tolerance.denominator);
  }

  void run() {
    std::size_t group_begin = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (i > 0 && pieces_[i].group != pieces_[i - 1].group) group_begin = i;
      if (i > group_begin && !pieces_[i].repeated) move_to_anchor(pieces_[i]);
      remember(pieces_[i]);
    }
  }

 private:
  /// Where a point is that coder 25 sees.
  static Point seen(const Piece& piece, Point at) {
    return {at.x + (piece.shift.x > 0 ? 1 : 0),
            at.y + (piece.shift.y > 0 ? 1 : 0)};
  }

  void remember(const Piece& piece) {
    Point at = seen(piece, piece.path.origin);
    vertices_.push_back({at, at, false});
    for (const Path::Element& element : piece.path.elements) {
      const bool arc = element.kind == Path::Kind::arc;
      const Point before = at;
      at.x += arc ? element.arc.end.x : element.segment.dx;
      at.y += arc ? element.arc.end.y : element.segment.dy;
      vertices_.push_back({at, before, true});
    }
  }

  /// 0 at a vertex, 1 on a line, 2 neither.
  [[nodiscard]] int rank(Point p) const {
    int best = 2;
    std::size_t asked = 0;
    for (auto v = vertices_.rbegin(); v != vertices_.rend() && asked < kReach;
         ++v, ++asked) {
      if (v->at == p) return 0;
      if (best == 2 && v->line && on_line(*v, p)) best = 1;
    }
    return best;
  }

  static bool on_line(const Vertex& v, Point p) {
    const Vec line = vectors::between(v.before, v.at);
    const Vec d = vectors::between(v.before, p);
    const bool wide = std::abs(line.x) >= std::abs(line.y);
    const std::int64_t n = vectors::size_of(line);
    const std::int64_t k =
        wide ? (line.x < 0 ? -d.x : d.x) : (line.y < 0 ? -d.y : d.y);
    if (k < 1 || k >= n || n >> 20 != 0) return false;
    const std::int64_t twice = 2 * (wide ? line.y : line.x) * k;
    const std::int64_t other =
        twice >= 0 ? (twice + n) / (2 * n) : -((-twice + n) / (2 * n));
    return other == (wide ? d.y : d.x);
  }

  void move_to_anchor(Piece& piece) {
    struct Try {
      int rank;
      std::int32_t far;
      Point by;
    };
    std::vector<Try> tries;
    for (std::int32_t dy = -reach_; dy <= reach_; ++dy) {
      for (std::int32_t dx = -reach_; dx <= reach_; ++dx) {
        Point p = seen(piece, piece.path.origin);
        p = {p.x + dx, p.y + dy};
        const int r = rank(p);
        if (r == 2) continue;
        tries.push_back({r, dx * dx + dy * dy, {dx, dy}});
      }
    }
    std::ranges::sort(tries, [](const Try& a, const Try& b) {
      return a.far + a.rank != b.far + b.rank ? a.far + a.rank < b.far + b.rank
             : a.by.y != b.by.y               ? a.by.y < b.by.y
                                              : a.by.x < b.by.x;
    });
    for (const Try& t : tries) {
      if (t.far == 0) return;
      // All of it, or the first vertex alone.
      for (const bool all : {true, false}) {
        if (const auto moved = moved_path(piece.path, t.by, all);
            moved && check_.within(piece.chain, *moved)) {
          keep_own(piece);
          piece.path = *moved;
          return;
        }
      }
    }
  }

  static std::optional<Path> moved_path(const Path& path, Point by, bool all) {
    Path moved = path;
    moved.origin = {path.origin.x + by.x, path.origin.y + by.y};
    if (all) return moved;
    if (path.closed || path.elements.empty() ||
        path.elements[0].kind == Path::Kind::arc) {
      return std::nullopt;
    }
    Segment& first = moved.elements[0].segment;
    first = {first.dx - by.x, first.dy - by.y};
    if (first.dx == 0 && first.dy == 0) return std::nullopt;
    return moved;
  }

  std::vector<Piece>& pieces_;
  PathCheck check_;
  std::int32_t reach_ = 0;
  std::vector<Vertex> vertices_;
};

}  // namespace

void anchor_paths(std::vector<Piece>& pieces, const Rational& tolerance,
                  std::int32_t scale) {
  Anchorer(pieces, tolerance, scale).run();
}

}  // namespace unstep::strokes
