#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "unstep/grid.h"

/// Distances by brute force: both curves as dense samples, the discrete
/// Frechet distance of these by its table. Written from the definitions alone.
namespace unstep::testing {

using Sample = std::pair<long double, long double>;
using Samples = std::vector<Sample>;

inline long double apart(const Sample& a, const Sample& b) {
  return std::hypot(a.first - b.first, a.second - b.second);
}

inline void sample_line(Samples& out, Sample to, long double spacing) {
  const Sample from = out.back();
  const auto parts =
      std::max(1, static_cast<int>(std::ceil(apart(from, to) / spacing)));
  for (int i = 1; i <= parts; ++i) {
    const long double t = static_cast<long double>(i) / parts;
    out.emplace_back(from.first + t * (to.first - from.first),
                     from.second + t * (to.second - from.second));
  }
}

inline Samples samples_of(const Chain& chain, YAxis axis, long double spacing) {
  Samples out{{chain.origin.x, chain.origin.y}};
  for (const Step step : chain.steps) {
    const Point delta = step_delta(step, axis);
    const Sample at{std::round(out.back().first),
                    std::round(out.back().second)};
    sample_line(out, {at.first + delta.x, at.second + delta.y}, spacing);
  }
  return out;
}

/// As grid.h defines the curve of an Arc.
inline void sample_arc(Samples& out, const Arc& arc, long double unit,
                       long double spacing) {
  const Sample from = out.back();
  long double cx = arc.centre.x;
  long double cy = arc.centre.y;
  const long double ex = arc.end.x;
  const long double ey = arc.end.y;
  long double turn = 2 * std::numbers::pi_v<long double>;
  if (arc.end != Point{}) {
    const long double k = (cx * -ey + cy * ex) / (ex * ex + ey * ey);
    cx = ex / 2 - ey * k;
    cy = ey / 2 + ex * k;
    const long double first = std::atan2(-cy, -cx);
    const long double last = std::atan2(ey - cy, ex - cx);
    turn = arc.clockwise ? first - last : last - first;
    if (turn <= 0) turn += 2 * std::numbers::pi_v<long double>;
  }
  const long double radius = std::hypot(cx, cy);
  const long double first = std::atan2(-cy, -cx);
  const int parts =
      std::max(2, static_cast<int>(std::ceil(turn * radius * unit / spacing)));
  for (int i = 1; i <= parts; ++i) {
    const long double angle =
        first + (arc.clockwise ? -1 : 1) * turn * i / parts;
    out.emplace_back(from.first + (cx + radius * std::cos(angle)) * unit,
                     from.second + (cy + radius * std::sin(angle)) * unit);
  }
}

inline Samples samples_of(const Path& path, std::int32_t scale,
                          long double spacing) {
  const long double unit = 1.0L / scale;
  Samples out{{path.origin.x * unit, path.origin.y * unit}};
  for (const Path::Element& element : path.elements) {
    if (element.kind == Path::Kind::arc) {
      sample_arc(out, element.arc, unit, spacing);
    } else {
      const Sample from = out.back();
      sample_line(out,
                  {from.first + element.segment.dx * unit,
                   from.second + element.segment.dy * unit},
                  spacing);
    }
  }
  return out;
}

/// Between the true Frechet distance of the curves and that plus the spacing.
inline long double discrete_frechet(const Samples& a, const Samples& b) {
  std::vector<long double> row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    long double diagonal = 0;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const long double above = row[j];
      long double before = 0;
      if (i > 0 && j > 0) before = std::min({above, diagonal, row[j - 1]});
      if (i > 0 && j == 0) before = above;
      if (i == 0 && j > 0) before = row[j - 1];
      row[j] = std::max(before, apart(a[i], b[j]));
      diagonal = above;
    }
  }
  return row.back();
}

/// The same with the start of the closed `a` free.
inline long double discrete_frechet_closed(const Samples& a, const Samples& b) {
  long double best = discrete_frechet(a, b);
  const std::size_t n = a.size() - 1;
  Samples turned(a.begin(), a.end() - 1);
  for (std::size_t i = 0; i < n; ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (apart(turned[0], b[0]) >= best) continue;
    Samples closed = turned;
    closed.push_back(turned[0]);
    best = std::min(best, discrete_frechet(closed, b));
  }
  return best;
}

/// The larger of the two one-sided distances of the samples.
inline long double discrete_hausdorff(const Samples& a, const Samples& b) {
  long double worst = 0;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const Sample& p : *from) {
      long double nearest = apart(p, to->front());
      for (const Sample& q : *to) nearest = std::min(nearest, apart(p, q));
      worst = std::max(worst, nearest);
    }
  }
  return worst;
}

}  // namespace unstep::testing
