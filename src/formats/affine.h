#pragma once

#include <cmath>

#include "formats/real_drawing.h"

namespace unstep {

/// x' = a x + c y + e, y' = b x + d y + f.
struct Affine {
  double a = 1;
  double b = 0;
  double c = 0;
  double d = 1;
  double e = 0;
  double f = 0;

  [[nodiscard]] RealPoint operator()(RealPoint p) const {
    return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
  }
  /// Without the translation.
  [[nodiscard]] RealPoint turn(RealPoint p) const {
    return {a * p.x + c * p.y, b * p.x + d * p.y};
  }
  [[nodiscard]] double determinant() const { return a * d - b * c; }
  /// The mean factor of lengths.
  [[nodiscard]] double factor() const {
    return std::sqrt(std::fabs(determinant()));
  }
  /// Whether circles stay circles.
  [[nodiscard]] bool is_similarity() const {
    const double size =
        std::fabs(a) + std::fabs(b) + std::fabs(c) + std::fabs(d);
    const double limit = 1e-9 * size;
    return (std::fabs(a - d) <= limit && std::fabs(b + c) <= limit) ||
           (std::fabs(a + d) <= limit && std::fabs(b - c) <= limit);
  }
  /// First `inner`, then this.
  [[nodiscard]] Affine operator*(const Affine& inner) const {
    return {a * inner.a + c * inner.b,     b * inner.a + d * inner.b,
            a * inner.c + c * inner.d,     b * inner.c + d * inner.d,
            a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f};
  }
};

/// What a figure is drawn with: a circular or elliptical arc from the current
/// point as SVG and DXF describe it, through a transformation.
class FigurePen {
 public:
  FigurePen(RealDrawing& out, const Affine& transform)
      : out_(out), transform_(transform) {}

  /// Where the path already is.
  void start_at(RealPoint p) { at_ = p; }
  void move_to(RealPoint p) {
    at_ = p;
    out_.move_to(transform_(p));
  }
  void line_to(RealPoint p) {
    at_ = p;
    out_.line_to(transform_(p));
  }
  void cubic_to(RealPoint a, RealPoint b, RealPoint end) {
    at_ = end;
    out_.cubic_to(transform_(a), transform_(b), transform_(end));
  }
  void close() { out_.close(); }

  /// An arc of a circle around `centre` or, if the transformation makes one, of
  /// an ellipse. `ascending`: from +x to +y.
  void arc_to(RealPoint centre, RealPoint end, bool ascending);
  void circle(RealPoint centre, bool ascending);
  /// Around an ellipse with the axes turned by `angle` radians.
  void ellipse_to(RealPoint centre, RealPoint radii, double angle,
                  RealPoint end, bool ascending, bool full);
  [[nodiscard]] RealPoint at() const { return at_; }

 private:
  RealDrawing& out_;
  const Affine& transform_;
  RealPoint at_;
};

}  // namespace unstep
