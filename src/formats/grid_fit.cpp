#include "formats/grid_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace unstep {
namespace {

/// Shares of the tolerance: what flattening may take and what rounding of
/// flattened points and centres may; the rest is for ellipse_to.
constexpr double kFlattening = 0.85;
constexpr double kRounding = 0.1;

/// Files give radii with few digits, svg_path_data.cpp to within half of this:
/// an arc may always deviate by so much, in units of the file, if the tolerance
/// is twice as large.
constexpr double kArcRounding = 1.0 / 256;

/// The least tolerance, as a part of the larger side: finer than the grid.
constexpr double kLeastTolerance = 1e-6;

constexpr double kFinest = 1e6;  ///< a power of ten, <= kMaxScale

/// Whether value * scale is a whole number but for the rounding of doubles.
bool is_whole(double value, double scale) {
  const double scaled = value * scale;
  return std::fabs(scaled - std::nearbyint(scaled)) <=
         1e-5 + std::fabs(scaled) * 1e-14;
}

class GridFit {
 public:
  GridFit(RealDrawing& source, double tolerance,
          std::vector<std::string>& notes)
      : source_(source), tolerance_(tolerance), notes_(notes) {}

  Result<Drawing> fit(const Canvas& canvas, Paint paint);

 private:
  void measure();
  [[nodiscard]] double finest() const;
  void choose_scale();
  [[nodiscard]] bool holds(double scale) const;
  [[nodiscard]] bool holds_widths(double scale) const;
  [[nodiscard]] bool holds_arcs(double scale) const;
  [[nodiscard]] std::optional<Arc> rounded(RealPoint from,
                                           const RealPiece& piece,
                                           double scale) const;
  [[nodiscard]] Point on_grid(RealPoint at, double scale) const;
  void convert(const RealPath& source, Path& path);
  void line_to(Point at, Path& path);
  void flatten_cubic(RealPoint from, const RealPiece& piece, Path& path);
  void flatten_arc(RealPoint from, const RealPiece& piece, Path& path);

  RealDrawing& source_;
  double tolerance_;
  std::vector<std::string>& notes_;
  double side_ = 0;      ///< the larger one of the box of the vertices
  double farthest_ = 0;  ///< the largest coordinate
  bool curved_ = false;  ///< there are cubics
  double scale_ = 1;
  Point at_;  ///< the end of the path that is made
};

/// Calls visit(from, piece) for every piece.
template <class Visit>
bool all_pieces(const std::vector<RealPath>& paths, const Visit& visit) {
  for (const RealPath& path : paths) {
    RealPoint at = path.origin;
    for (const RealPiece& piece : path.pieces) {
      if (!visit(at, piece)) return false;
      at = piece.end;
    }
  }
  return true;
}

void GridFit::measure() {
  constexpr double kFar = std::numeric_limits<double>::max();
  RealPoint low{kFar, kFar};
  RealPoint high{-kFar, -kFar};
  const auto include = [&](RealPoint p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  };
  for (const RealPath& path : source_.paths()) include(path.origin);
  all_pieces(source_.paths(), [&](RealPoint from, const RealPiece& piece) {
    include(piece.end);
    if (piece.kind == RealPiece::Kind::cubic) {
      include(piece.a);
      include(piece.b);
      curved_ = true;
    } else if (piece.kind == RealPiece::Kind::circle) {
      include(piece.a + piece.a - from);
    }
    return true;
  });
  if (low.x > high.x) return;
  side_ = std::max(high.x - low.x, high.y - low.y);
  farthest_ = std::max({std::fabs(low.x), std::fabs(low.y), std::fabs(high.x),
                        std::fabs(high.y)});
}

/// The finest scale that has room, a power of ten.
double GridFit::finest() const {
  double scale = kFinest;
  while (scale > 1 && (farthest_ + 1) * scale > kMaxCoord) scale /= 10;
  return scale;
}

bool GridFit::holds(double scale) const {
  // What is computed may be rounded if that is little beside the tolerance.
  const bool rounds = kRounding * tolerance_ * scale >= 0.71;
  const auto fits = [scale, rounds](RealPoint p, bool computed) {
    return (computed && rounds) ||
           (is_whole(p.x, scale) && is_whole(p.y, scale));
  };
  for (const RealPath& path : source_.paths()) {
    if (!fits(path.origin, path.computed)) return false;
  }
  return all_pieces(source_.paths(),
                    [&fits](RealPoint, const RealPiece& piece) {
                      return fits(piece.end, piece.computed);
                    });
}

bool GridFit::holds_widths(double scale) const {
  const auto& paths = source_.paths();
  return std::all_of(paths.begin(), paths.end(), [scale](const RealPath& path) {
    return is_whole(path.width, scale);
  });
}

bool GridFit::holds_arcs(double scale) const {
  const double allowed = kRounding * tolerance_ * scale;
  if (curved_ && allowed < 0.71) return false;  // rounding to the grid
  return all_pieces(source_.paths(),
                    [&](RealPoint from, const RealPiece& piece) {
                      return piece.kind == RealPiece::Kind::line ||
                             piece.kind == RealPiece::Kind::cubic ||
                             rounded(from, piece, scale).has_value();
                    });
}

void GridFit::choose_scale() {
  const double finest_scale = finest();
  double decimal = 1;
  while (decimal < finest_scale && !holds(decimal)) decimal *= 10;
  const bool exact = holds(decimal);
  // Binary fractions have as many decimals as binary digits, or more.
  double binary = 1;
  while (exact && binary < decimal && !holds(binary)) binary *= 2;
  const bool is_binary = exact && decimal > 1 && binary < decimal;
  scale_ = is_binary ? binary : decimal;
  const double step = is_binary ? 2 : 10;
  const auto may_grow = [&](double limit) {
    return scale_ * step <= std::min(limit, finest_scale);
  };
  while (may_grow(1000) && !holds_widths(scale_)) scale_ *= step;
  while (may_grow(finest_scale) && !holds_arcs(scale_)) scale_ *= step;
  if (!exact) {
    notes_.push_back("coordinates are rounded to multiples of 1/" +
                     std::to_string(static_cast<std::int64_t>(scale_)));
  }
  if (!holds_widths(scale_)) {
    notes_.push_back("widths of pens are rounded to multiples of 1/" +
                     std::to_string(static_cast<std::int64_t>(scale_)));
  }
}

Point GridFit::on_grid(RealPoint at, double scale) const {
  static constexpr double kMax = kMaxCoord;
  const auto round = [scale](double value) {
    return static_cast<std::int32_t>(
        std::clamp(std::round(value * scale), -kMax, kMax));
  };
  return {round(at.x), round(at.y)};
}

/// The arc with its centre on the grid, if it then keeps close enough. Of the
/// grid points around the centre the one that both ends are most equally far
/// from is taken; the interpolators want them within one unit.
std::optional<Arc> GridFit::rounded(RealPoint from, const RealPiece& piece,
                                    double scale) const {
  const Point start = on_grid(from, scale);
  const Point end = on_grid(piece.end, scale);
  const Point centre = on_grid(piece.a, scale);
  const bool full = piece.kind == RealPiece::Kind::circle;
  // Ends that the grid does not tell apart: no circle was meant.
  if (!full && start == end) return std::nullopt;
  const auto distance = [](Point p, double x, double y) {
    return std::hypot(p.x - x, p.y - y);
  };
  double best = std::numeric_limits<double>::max();
  Point chosen = centre;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (full && (dx != 0 || dy != 0)) continue;
      const double x = centre.x + dx;
      const double y = centre.y + dy;
      const double off =
          std::fabs(distance(start, x, y) - distance(end, x, y)) +
          0.01 * std::hypot(x - piece.a.x * scale, y - piece.a.y * scale);
      if (off >= best) continue;
      best = off;
      chosen = {centre.x + dx, centre.y + dy};
    }
  }
  const double from_x = from.x * scale;
  const double from_y = from.y * scale;
  const double exact =
      std::hypot(from_x - piece.a.x * scale, from_y - piece.a.y * scale);
  const double shift =
      std::hypot(chosen.x - piece.a.x * scale, chosen.y - piece.a.y * scale);
  const double allowed = std::max(kRounding * tolerance_,
                                  std::min(kArcRounding, 0.5 * tolerance_)) *
                         scale;
  // The sagitta changes by no more than the shift times what the ends leave.
  const double chord =
      std::hypot(piece.end.x * scale - from_x, piece.end.y * scale - from_y);
  const double apothem =
      std::sqrt(std::max(0.0, exact * exact - chord * chord / 4));
  const double small = full || chord == 0 ? 1 : (exact - apothem) / exact;
  const bool large =
      full ||
      piece.ascending == ((piece.end.x - from.x) * (piece.a.y - from.y) -
                              (piece.end.y - from.y) * (piece.a.x - from.x) <
                          0);
  const double effect = shift * (large ? 2 : std::min(2.0, 2 * small));
  if (effect > allowed && shift > 1e-6 * scale) return std::nullopt;
  Arc arc;
  arc.centre = {chosen.x - start.x, chosen.y - start.y};
  arc.end = {end.x - start.x, end.y - start.y};
  arc.clockwise = !piece.ascending;
  if (arc.centre == Point{}) return std::nullopt;
  if (std::max(std::abs(arc.centre.x), std::abs(arc.centre.y)) > kMaxCoord) {
    return std::nullopt;
  }
  if (!full && std::fabs(distance(start, chosen.x, chosen.y) -
                         distance(end, chosen.x, chosen.y)) > 1) {
    return std::nullopt;
  }
  return arc;
}

void GridFit::line_to(Point at, Path& path) {
  Path::Element element;
  element.segment = {at.x - at_.x, at.y - at_.y};
  path.elements.push_back(element);
  source_.use_memory(2 * sizeof(Path::Element));
  at_ = at;
}

/// Equal steps of the parameter: n of them keep within d (d - 1) / 8 times the
/// largest second difference over n^2 of a curve of degree d (Wang's formula).
void GridFit::flatten_cubic(RealPoint from, const RealPiece& piece,
                            Path& path) {
  const RealPoint p = from - 2 * piece.a + piece.b;
  const RealPoint q = piece.a - 2 * piece.b + piece.end;
  const double bend = std::max(std::hypot(p.x, p.y), std::hypot(q.x, q.y));
  const double parts =
      std::ceil(std::sqrt(0.75 * bend / (kFlattening * tolerance_)));
  const auto count = static_cast<int>(std::clamp(parts, 1.0, 1e6));
  for (int i = 1; i < count && source_.status(); ++i) {
    const double t = static_cast<double>(i) / count;
    const double s = 1 - t;
    const RealPoint at = s * s * s * from + 3 * s * s * t * piece.a +
                         3 * s * t * t * piece.b + t * t * t * piece.end;
    const Point next = on_grid(at, scale_);
    if (next != at_) line_to(next, path);
  }
  line_to(on_grid(piece.end, scale_), path);
}

/// Arcs that the grid has no centre for.
void GridFit::flatten_arc(RealPoint from, const RealPiece& piece, Path& path) {
  const RealPoint start = from - piece.a;
  const RealPoint end = piece.end - piece.a;
  const double radius = std::hypot(start.x, start.y);
  const double begin = std::atan2(start.y, start.x);
  double sweep = std::atan2(end.y, end.x) - begin;
  constexpr double kTurn = 2 * std::numbers::pi;
  if (piece.kind == RealPiece::Kind::circle) sweep = 0;
  if (piece.ascending && sweep <= 0) sweep += kTurn;
  if (!piece.ascending && sweep >= 0) sweep -= kTurn;
  const double cosine = std::max(0.5, 1 - kFlattening * tolerance_ / radius);
  const double part = 2 * std::acos(std::min(cosine, 1 - 1e-12));
  const auto count = static_cast<int>(std::ceil(std::fabs(sweep) / part));
  for (int i = 1; i < count && source_.status(); ++i) {
    const double angle = begin + sweep * i / count;
    const Point next = on_grid(
        piece.a + radius * RealPoint{std::cos(angle), std::sin(angle)}, scale_);
    if (next != at_) line_to(next, path);
  }
  line_to(on_grid(piece.end, scale_), path);
}

void GridFit::convert(const RealPath& source, Path& path) {
  path.origin = on_grid(source.origin, scale_);
  path.closed = source.closed;
  path.width = on_grid({source.width, 0}, scale_).x;
  if (source.width > 0 && path.width == 0) path.width = 1;
  at_ = path.origin;
  RealPoint from = source.origin;
  path.elements.reserve(source.pieces.size());
  for (const RealPiece& piece : source.pieces) {
    if (!source_.status()) return;
    switch (piece.kind) {
      case RealPiece::Kind::line:
        line_to(on_grid(piece.end, scale_), path);
        break;
      case RealPiece::Kind::cubic: flatten_cubic(from, piece, path); break;
      case RealPiece::Kind::arc:
      case RealPiece::Kind::circle: {
        const std::optional<Arc> arc = rounded(from, piece, scale_);
        if (!arc) {
          flatten_arc(from, piece, path);
          break;
        }
        Path::Element element;
        element.kind = Path::Kind::arc;
        element.arc = *arc;
        path.elements.push_back(element);
        at_ = {at_.x + arc->end.x, at_.y + arc->end.y};
        break;
      }
    }
    from = piece.end;
  }
}

Result<Drawing> GridFit::fit(const Canvas& canvas, Paint paint) {
  if (!source_.status()) return source_.status().error();
  measure();
  if (tolerance_ <= 0) tolerance_ = side_ / 1000;
  tolerance_ = std::max({tolerance_, side_ * kLeastTolerance, 1e-9});
  choose_scale();
  Drawing drawing;
  drawing.canvas = canvas;
  drawing.paint = paint;
  drawing.scale = static_cast<std::int32_t>(scale_);
  drawing.paths.reserve(source_.paths().size());
  for (const RealPath& path : source_.paths()) {
    convert(path, drawing.paths.emplace_back());
    if (!source_.status()) return source_.status().error();
  }
  return drawing;
}

}  // namespace

Result<Drawing> fit_to_grid(RealDrawing& source, const Canvas& canvas,
                            Paint paint, double tolerance,
                            std::vector<std::string>& notes) {
  return GridFit(source, tolerance, notes).fit(canvas, paint);
}

}  // namespace unstep
