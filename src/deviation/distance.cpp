#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "deviation/pairing.h"
#include "deviation/segment_grid.h"
#include "unstep/deviation.h"

namespace unstep {
namespace deviation {
namespace {

using Polylines = std::vector<std::vector<Place>>;

/// In grid units from (0, 0), runs of equal steps as one line.
std::vector<Place> joined(const Chain& chain, YAxis axis) {
  std::int64_t x = chain.origin.x;
  std::int64_t y = chain.origin.y;
  const auto here = [&] {
    return Place{static_cast<long double>(x), static_cast<long double>(y)};
  };
  std::vector<Place> out{here()};
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    const Point delta = step_delta(chain.steps[i], axis);
    x += delta.x;
    y += delta.y;
    if (i + 1 == chain.steps.size() || chain.steps[i + 1] != chain.steps[i])
      out.push_back(here());
  }
  return out;
}

std::vector<Line> lines_of(const Polylines& polylines) {
  std::vector<Line> out;
  for (const auto& polyline : polylines) {
    if (polyline.size() == 1) out.push_back({polyline[0], polyline[0]});
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
      out.push_back({polyline[i], polyline[i + 1]});
  }
  return out;
}

Distance::Worst worst_of(const std::vector<Line>& lines,
                         const SegmentGrid& others, double resolution) {
  Distance::Worst worst;
  for (const Line& line : lines) {
    const auto parts = static_cast<std::size_t>(
        std::ceil(distance(line.from, line.to) / resolution));
    for (std::size_t i = 0; i <= parts; ++i) {
      const long double t = parts == 0 ? 0
                                       : static_cast<long double>(i) /
                                             static_cast<long double>(parts);
      const Place place{line.from.x + t * (line.to.x - line.from.x),
                        line.from.y + t * (line.to.y - line.from.y)};
      const auto found = static_cast<double>(others.nearest(place));
      if (found > worst.distance)
        worst = {found, static_cast<double>(place.x),
                 static_cast<double>(place.y)};
    }
  }
  return worst;
}

Status check_each(const Drawing& chains, const Drawing& paths) {
  for (std::size_t i = 0; i < chains.chains.size(); ++i) {
    Status valid = check_chain(chains.chains[i], chains.canvas.y_axis);
    if (!valid)
      return Error{
          ErrorCode::invalid_argument,
          "chain " + std::to_string(i + 1) + ": " + valid.error().message};
  }
  for (std::size_t i = 0; i < paths.paths.size(); ++i) {
    Status valid = check_path(paths.paths[i]);
    if (!valid)
      return Error{ErrorCode::invalid_argument,
                   path_name(i) + valid.error().message};
  }
  if (paths.scale < 1 || paths.scale > Drawing::kMaxScale)
    return Error{ErrorCode::invalid_argument, "the scale is out of range"};
  return {};
}

}  // namespace
}  // namespace deviation

Result<Distance> measure_distance(const Drawing& chains, const Drawing& paths,
                                  double resolution) {
  using namespace deviation;
  if (!(resolution >= 1.0 / 1024 && resolution <= 1024))
    return Error{ErrorCode::out_of_range,
                 "the resolution must be within 2^-10..2^10"};
  if (Status valid = check_each(chains, paths); !valid) return valid.error();
  Polylines left;
  for (const Chain& chain : chains.chains)
    left.push_back(joined(chain, chains.canvas.y_axis));
  Polylines right;
  const long double unit = 1.0L / paths.scale;
  for (const Path& path : paths.paths)
    right.push_back(polyline_of(path, paths.scale,
                                {path.origin.x * unit, path.origin.y * unit},
                                resolution / 256));
  const std::vector<Line> left_lines = lines_of(left);
  const std::vector<Line> right_lines = lines_of(right);
  if (left_lines.empty() && right_lines.empty()) return Distance();
  if (left_lines.empty() || right_lines.empty())
    return Error{ErrorCode::invalid_argument,
                 left_lines.empty() ? "there are paths but no chains"
                                    : "there are chains but no paths"};
  return Distance{worst_of(left_lines, SegmentGrid(right_lines), resolution),
                  worst_of(right_lines, SegmentGrid(left_lines), resolution)};
}

}  // namespace unstep
