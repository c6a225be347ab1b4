#include "deviation/pairing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace unstep::deviation {
namespace {

Error invalid(std::string message) {
  return {ErrorCode::invalid_argument, std::move(message)};
}

}  // namespace

Status check_chain(const Chain& chain, YAxis axis) {
  const auto wrong = std::find_if(chain.steps.begin(), chain.steps.end(),
                                  [](Step step) { return step > 7; });
  if (wrong != chain.steps.end())
    return invalid("step " + std::to_string(wrong - chain.steps.begin() + 1) +
                   " of its chain is no direction: " + std::to_string(*wrong));
  const ChainSpan span = span_of(chain, axis, 1);
  if (chain.closed && span.origin != span.end)
    return invalid("its chain is closed but does not return");
  return {};
}

Status check_path(const Path& path) {
  Vector64 at;
  for (const Path::Element& element : path.elements) {
    if (element.kind == Path::Kind::arc && element.arc.end == Point{} &&
        element.arc.centre == Point{})
      return invalid("an arc has no radius");
    at = at + move_of(element);
  }
  if (path.closed && at != Vector64{})
    return invalid("closed but does not return");
  return {};
}

std::string path_name(std::size_t index) {
  return "path " + std::to_string(index + 1) + ": ";
}

ChainSpan span_of(const Chain& chain, YAxis axis, std::int64_t unit) {
  std::array<std::int64_t, 8> count{};
  for (const Step step : chain.steps) ++count[step & 7];
  ChainSpan span{{chain.origin.x * unit, chain.origin.y * unit}, {}};
  span.end = span.origin;
  for (Step step = 0; step < 8; ++step) {
    const Point delta = step_delta(step, axis);
    span.end.x += delta.x * count[step] * unit;
    span.end.y += delta.y * count[step] * unit;
  }
  return span;
}

Status check_pairs(const Drawing& chains, const Drawing& paths) {
  if (chains.chains.size() != paths.paths.size())
    return invalid(std::to_string(chains.chains.size()) + " chains but " +
                   std::to_string(paths.paths.size()) + " paths");
  if (paths.scale < 1 || paths.scale > Drawing::kMaxScale)
    return invalid("the scale of the paths, " + std::to_string(paths.scale) +
                   ", is not within 1.." + std::to_string(Drawing::kMaxScale));
  for (std::size_t i = 0; i < paths.paths.size(); ++i) {
    if (chains.chains[i].closed != paths.paths[i].closed)
      return invalid(path_name(i) + (paths.paths[i].closed
                                         ? "closed, its chain is open"
                                         : "open, its chain is closed"));
    Status valid = check_chain(chains.chains[i], chains.canvas.y_axis);
    if (valid) valid = check_path(paths.paths[i]);
    if (!valid) return invalid(path_name(i) + valid.error().message);
  }
  return {};
}

}  // namespace unstep::deviation
