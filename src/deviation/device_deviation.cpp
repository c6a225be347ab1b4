#include <algorithm>
#include <cstdlib>
#include <string>

#include "unstep/deviation.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

Error differ(std::size_t path, const char* what) {
  return {
      ErrorCode::invalid_argument,
      "chain and path " + std::to_string(path + 1) + " have different " + what};
}

/// The largest difference on an axis along one chain and what was drawn of it.
Status compare(const Chain& chain, const Chain& drawn, YAxis axis,
               std::size_t index, Deviation& worst) {
  if (chain.origin != drawn.origin) return differ(index, "origins");
  if (chain.steps.size() != drawn.steps.size()) {
    return differ(index, "numbers of steps");
  }
  std::int64_t off_x = 0;
  std::int64_t off_y = 0;
  Point at = chain.origin;
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    if (chain.steps[i] > 7) return differ(index, "steps");
    const Point a = step_delta(chain.steps[i], axis);
    const Point b = step_delta(drawn.steps[i], axis);
    off_x += a.x - b.x;
    off_y += a.y - b.y;
    at = {at.x + a.x, at.y + a.y};
    const auto off =
        static_cast<double>(std::max(std::abs(off_x), std::abs(off_y)));
    if (off <= worst.distance) continue;
    worst = {off, index, i + 1, static_cast<double>(at.x),
             static_cast<double>(at.y)};
  }
  return off_x == 0 && off_y == 0 ? Status{} : differ(index, "ends");
}

}  // namespace

Result<Deviation> measure_device_deviation(const Drawing& chains,
                                           const Drawing& paths) {
  if (chains.chains.size() != paths.paths.size()) {
    return Error{ErrorCode::invalid_argument,
                 "the numbers of chains and paths differ"};
  }
  Deviation worst;
  for (std::size_t i = 0; i < paths.paths.size(); ++i) {
    const auto& elements = paths.paths[i].elements;
    const bool lines = std::ranges::all_of(elements, [](const auto& element) {
      return element.kind == Path::Kind::segment;
    });
    if (!lines || paths.scale != 1) return differ(i, "kinds of elements");
    Drawing one;
    one.canvas = paths.canvas;
    one.paths = {paths.paths[i]};
    const Result<Drawing> drawn =
        step_paths(one, {Method::device, 1.0, chains.chains[i].steps.size()});
    if (!drawn) {
      if (drawn.error().code != ErrorCode::limit_exceeded) {
        return drawn.error();
      }
      return differ(i, "numbers of steps");
    }
    const Status same = compare(chains.chains[i], drawn->chains[0],
                                chains.canvas.y_axis, i, worst);
    if (!same) return same.error();
  }
  return worst;
}

}  // namespace unstep
