// The measured worst deviation of every interpolator from the true line or
// circle, by following every tick in long double. Prints CSV: what, method,
// tag, extent, worst distance, the worst curve. docs/algorithms.md quotes it,
// docs/plots/deviation.py draws it.
//
//   lines: every segment with |dx|, |dy| <= extent / 2 while extent <= 128,
//          400 random ones of at most `extent` per axis above;
//   arcs:  200 random ones, a third full circles, ends at the grid point
//          nearest to the circle, radius up to `extent`.

#include <cstdio>
#include <random>

#include "unit/interpolate_oracle.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

struct Worst {
  long double distance = 0;
  Point a;  ///< the delta, or the centre
  Point b;  ///< the arc's end
  bool failed = false;
};

void line(Method method, Segment s, Worst& worst) {
  const auto run = Interpolator::line(method, s);
  if (!run) {
    worst.failed = true;
    return;
  }
  const oracle::Trace t = oracle::follow_line(*run, s);
  worst.failed = worst.failed || !t.legal || t.x != s.dx || t.y != s.dy;
  if (t.worst > worst.distance)
    worst = {t.worst, {s.dx, s.dy}, {}, worst.failed};
}

Worst lines(Method method, std::int32_t extent) {
  Worst worst;
  if (extent <= 128) {
    for (std::int32_t x = -extent / 2; x <= extent / 2; ++x)
      for (std::int32_t y = -extent / 2; y <= extent / 2; ++y)
        line(method, {x, y}, worst);
    return worst;
  }
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int32_t> delta(-extent, extent);
  for (int i = 0; i < 400; ++i)
    line(method, {delta(random), delta(random)}, worst);
  return worst;
}

Worst arcs(Method method, std::int32_t extent) {
  Worst worst;
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int32_t> centre(-extent, extent);
  std::uniform_real_distribution<double> angle(0, 6.28);
  for (int i = 0; i < 200; ++i) {
    Arc arc{{centre(random) * 7 / 10, centre(random) * 7 / 10}, {}, i % 2 == 0};
    if (arc.centre == Point{}) continue;
    if (i % 3 != 0) {
      const double radius = std::hypot(arc.centre.x, arc.centre.y);
      const double phi = angle(random);
      arc.end.x = static_cast<std::int32_t>(
          std::lround(arc.centre.x + radius * std::cos(phi)));
      arc.end.y = static_cast<std::int32_t>(
          std::lround(arc.centre.y + radius * std::sin(phi)));
    }
    const auto run = Interpolator::arc(method, arc);
    if (!run) {
      worst.failed = true;
      continue;
    }
    const oracle::Trace t = oracle::follow_arc(*run, arc);
    worst.failed =
        worst.failed || !t.legal || t.x != arc.end.x || t.y != arc.end.y;
    if (t.worst > worst.distance)
      worst = {t.worst, arc.centre, arc.end, worst.failed};
  }
  return worst;
}

int print_all() {
  bool failed = false;
  std::printf("what,method,tag,extent,worst,curve\n");
  for (const MethodInfo& info : methods()) {
    for (const std::int32_t extent : {16, 64, 128, 1024, 8192, 65536}) {
      for (const bool arc : {false, true}) {
        if (!(arc ? info.arcs : info.lines)) continue;
        if (info.method == Method::gate_level && extent > 8192) continue;
        const Worst w =
            arc ? arcs(info.method, extent) : lines(info.method, extent);
        std::printf("%s,%.*s,%.*s,%d,%.4Lf,%d %d %d %d\n", arc ? "arc" : "line",
                    static_cast<int>(info.name.size()), info.name.data(),
                    static_cast<int>(info.tag.size()), info.tag.data(), extent,
                    w.distance, w.a.x, w.a.y, w.b.x, w.b.y);
        failed = failed || w.failed;
      }
    }
  }
  return failed ? 1 : 0;
}

}  // namespace
}  // namespace unstep

int main() { return unstep::print_all(); }
