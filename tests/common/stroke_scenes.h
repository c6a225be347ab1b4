#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "unstep/trace.h"

/// Drawings of lines whose ends and widths are known, drawn by round pens.
namespace unstep::testing {

struct Place {
  double x = 0;
  double y = 0;
};

/// A line of a scene; of a ring or a dot both ends are the same place.
struct TrueStroke {
  Place from;
  Place to;
  bool ring = false;
};

enum class SceneKind { line, arc, crossing, tee, ring, dot };
inline constexpr std::array kSceneKinds{SceneKind::line,     SceneKind::arc,
                                        SceneKind::crossing, SceneKind::tee,
                                        SceneKind::ring,     SceneKind::dot};

struct Scene {
  Bitmap ink;
  std::vector<TrueStroke> strokes;
};

/// One thing on a page of its own.
class SceneMaker {
 public:
  SceneMaker(SceneKind kind, int width, std::uint32_t seed)
      : kind_(kind), width_(width), random_(seed) {}

  Scene make(bool noise) {
    side_ = 16 * width_ + 120;
    drawing_.canvas = {side_, side_, YAxis::down};
    drawing_.scale = kScale;
    drawing_.paint = Paint::stroke;
    switch (kind_) {
      case SceneKind::line: line(); break;
      case SceneKind::arc: arc(); break;
      case SceneKind::crossing: crossing(); break;
      case SceneKind::tee: tee(); break;
      case SceneKind::ring: ring(); break;
      case SceneKind::dot: dot(); break;
    }
    scene_.ink = *render_paths(drawing_);
    if (noise) roughen();
    return std::move(scene_);
  }

 private:
  static constexpr std::int32_t kScale = 8;

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 8) /
                                 static_cast<double>(1U << 24));
  }
  static Point grid(Place p) {
    return {static_cast<std::int32_t>(std::lround(p.x * kScale)),
            static_cast<std::int32_t>(std::lround(p.y * kScale))};
  }
  static Place polar(Place from, double angle, double length) {
    return {from.x + length * std::cos(angle),
            from.y + length * std::sin(angle)};
  }
  Place centre() {
    return {side_ / 2.0 + between(-4, 4), side_ / 2.0 + between(-4, 4)};
  }
  double angle() { return between(0, 2 * std::numbers::pi); }

  void draw(const std::vector<Place>& places) {
    Path path;
    path.width = width_ * kScale;
    path.origin = grid(places[0]);
    Point at = path.origin;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Point next = grid(places[i]);
      path.elements.push_back(
          {Path::Kind::segment, {next.x - at.x, next.y - at.y}, {}});
      at = next;
    }
    drawing_.paths.push_back(path);
    scene_.strokes.push_back({places.front(), places.back(), false});
  }

  void line() {
    const double a = angle();
    const double half = between(2.0 * width_ + 10, 6.0 * width_ + 40);
    const Place c = centre();
    draw({polar(c, a, half), polar(c, a, -half)});
  }

  std::vector<Place> bow(Place c, double radius, double start, double sweep) {
    std::vector<Place> places;
    const int n = 8 + static_cast<int>(radius * std::abs(sweep));
    for (int i = 0; i <= n; ++i) {
      places.push_back(polar(c, start + sweep * i / n, radius));
    }
    return places;
  }

  void arc() {
    const double radius = between(2.5 * width_ + 15, 5.0 * width_ + 40);
    draw(bow(centre(), radius, angle(), between(1.0, 4.5)));
  }

  void ring() {
    const double radius = between(2.0 * width_ + 6, 5.0 * width_ + 30);
    draw(bow(centre(), radius, angle(), 2 * std::numbers::pi));
    scene_.strokes.back().ring = true;
  }

  void dot() {
    const Place c = centre();
    draw({c});
  }

  void crossing() {
    const double a = angle();
    const double b = a + between(0.6, 2.5);
    const double reach = 3.0 * width_ + 15;
    const Place c = centre();
    for (const double d : {a, b}) {
      draw({polar(c, d, between(reach, 2 * reach)),
            polar(c, d, -between(reach, 2 * reach))});
    }
  }

  void tee() {
    const double a = angle();
    const double b = a + between(0.9, 2.2);
    const double reach = 3.0 * width_ + 15;
    const Place c = centre();
    draw({polar(c, a, between(reach, 2 * reach)),
          polar(c, a, -between(reach, 2 * reach))});
    draw({polar(c, b, between(reach, 2 * reach)), c});
  }

  /// One in eight pixels at the edges changes, as in a scan; one wide lines
  /// would fall into pieces.
  void roughen() {
    if (width_ < 3) return;
    const Bitmap clean = scene_.ink;
    for (std::int32_t y = 1; y + 1 < side_; ++y) {
      for (std::int32_t x = 1; x + 1 < side_; ++x) {
        const bool ink = clean.get(x, y);
        const bool edge =
            clean.get(x - 1, y) != ink || clean.get(x + 1, y) != ink ||
            clean.get(x, y - 1) != ink || clean.get(x, y + 1) != ink;
        if (edge && random_() % 8 == 0) scene_.ink.set(x, y, !ink);
      }
    }
  }

  SceneKind kind_;
  int width_;
  std::int32_t side_ = 0;
  std::mt19937 random_;
  Drawing drawing_;
  Scene scene_;
};

/// First and last place of a stroke, pixels.
inline TrueStroke ends_of(const Stroke& stroke) {
  Point at = stroke.chain.origin;
  const auto place = [&](Point p) {
    return Place{p.x + 0.5 + 0.5 * stroke.shift.x,
                 p.y + 0.5 + 0.5 * stroke.shift.y};
  };
  const Place from = place(at);
  for (const Step step : stroke.chain.steps) {
    const Point move = step_delta(step, YAxis::down);
    at = {at.x + move.x, at.y + move.y};
  }
  return {from, place(at), stroke.chain.closed};
}

/// How many strokes of the scene are found: as one piece, within `reach` pixels
/// at both ends. None if there are more or fewer strokes than there should be.
inline std::size_t count_found(const Scene& scene,
                               const std::vector<Stroke>& strokes,
                               double reach) {
  if (strokes.size() != scene.strokes.size()) return 0;
  const auto near = [&](Place a, Place b) {
    return std::hypot(a.x - b.x, a.y - b.y) <= reach;
  };
  std::size_t found = 0;
  for (const TrueStroke& wanted : scene.strokes) {
    found += std::ranges::any_of(strokes, [&](const Stroke& stroke) {
      if (stroke.pieces.size() != 1) return false;
      const TrueStroke ends = ends_of(stroke);
      if (wanted.ring) return ends.ring;
      return !ends.ring &&
             ((near(ends.from, wanted.from) && near(ends.to, wanted.to)) ||
              (near(ends.from, wanted.to) && near(ends.to, wanted.from)));
    });
  }
  return found;
}

}  // namespace unstep::testing
