#pragma once

#include <vector>

#include "unstep/grid.h"

namespace unstep::bench {

/// The ink pixel on the right hand of a crack that leaves p by `step`.
inline Point right_pixel(Point p, Step step) {
  switch (step) {
    case 0: return p;
    case 6: return {p.x - 1, p.y};
    case 4: return {p.x - 1, p.y - 1};
    default: return {p.x, p.y - 1};
  }
}

inline Step step_between(Point a, Point b) {
  for (Step step = 0; step < 8; ++step) {
    const Point move = step_delta(step, YAxis::down);
    if (a.x + move.x == b.x && a.y + move.y == b.y) return step;
  }
  return 0;  // neighbours along a border touch
}

/// The border pixels of a contour in its order: a crack after a right turn is
/// of the pixel before, after a left turn of the diagonal neighbour.
inline Chain border_of(const Chain& contour) {
  std::vector<Point> pixels;
  Point at = contour.origin;
  for (const Step step : contour.steps) {
    const Point pixel = right_pixel(at, step);
    if (pixels.empty() || pixels.back() != pixel) pixels.push_back(pixel);
    const Point move = step_delta(step, YAxis::down);
    at = {at.x + move.x, at.y + move.y};
  }
  while (pixels.size() > 1 && pixels.back() == pixels[0]) pixels.pop_back();
  Chain border{pixels[0], Connectivity::eight, true, {}};
  for (std::size_t i = 0; pixels.size() > 1 && i < pixels.size(); ++i) {
    border.steps.push_back(
        step_between(pixels[i], pixels[(i + 1) % pixels.size()]));
  }
  return border;
}

}  // namespace unstep::bench
