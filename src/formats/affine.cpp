#include "formats/affine.h"

#include <numbers>

namespace unstep {

void FigurePen::arc_to(RealPoint centre, RealPoint end, bool ascending) {
  if (!transform_.is_similarity()) {
    const RealPoint from = at_ - centre;
    const double radius = std::hypot(from.x, from.y);
    return ellipse_to(centre, {radius, radius}, 0, end, ascending, false);
  }
  const bool mirrored = transform_.determinant() < 0;
  at_ = end;
  out_.arc_to(transform_(centre), transform_(end), ascending != mirrored);
}

void FigurePen::circle(RealPoint centre, bool ascending) {
  if (!transform_.is_similarity()) {
    const RealPoint from = at_ - centre;
    const double radius = std::hypot(from.x, from.y);
    return ellipse_to(centre, {radius, radius}, 0, at_, ascending, true);
  }
  const bool mirrored = transform_.determinant() < 0;
  out_.circle(transform_(centre), ascending != mirrored);
}

void FigurePen::ellipse_to(RealPoint centre, RealPoint radii, double angle,
                           RealPoint end, bool ascending, bool full) {
  const RealPoint axis_x =
      radii.x * RealPoint{std::cos(angle), std::sin(angle)};
  const RealPoint axis_y =
      radii.y * RealPoint{-std::sin(angle), std::cos(angle)};
  const auto angle_of = [&](RealPoint p) {
    const RealPoint q = p - centre;
    return std::atan2((axis_y.x * q.x + axis_y.y * q.y) / (radii.y * radii.y),
                      (axis_x.x * q.x + axis_x.y * q.y) / (radii.x * radii.x));
  };
  constexpr double kTurn = 2 * std::numbers::pi;
  const double begin = angle_of(at_);
  double sweep = full ? 0 : angle_of(end) - begin;
  if (ascending && sweep <= 0) sweep += kTurn;
  if (!ascending && sweep >= 0) sweep -= kTurn;
  at_ = end;
  out_.ellipse_to(transform_(centre), transform_.turn(axis_x),
                  transform_.turn(axis_y), begin, sweep, transform_(end));
}

}  // namespace unstep
