#include <new>
#include <utility>

#include "strokes/cover.h"
#include "strokes/pen_set.h"
#include "strokes/stroke_order.h"
#include "trace/edge_noise.h"
#include "trace/skeleton_graph.h"
#include "trace/skeleton_pruning.h"
#include "trace/stroke_route.h"
#include "trace/stroke_shape.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

std::vector<trace::Spot> all_spots(const trace::SkeletonGraph& graph) {
  std::vector<trace::Spot> spots;
  for (const trace::Junction& junction : graph.junctions) {
    spots.insert(spots.end(), junction.spots.begin(), junction.spots.end());
  }
  for (const trace::Branch& branch : graph.branches) {
    spots.insert(spots.end(), branch.spots.begin(), branch.spots.end());
  }
  return spots;
}

Result<std::vector<Stroke>> trace_all(const Bitmap& scanned,
                                      const Progress& progress) {
  Bitmap ink = scanned;
  if (const Status smoothed = trace::smooth_edges(ink); !smoothed) {
    return smoothed.error();
  }
  // Thinning is the first half.
  const Progress first_half = [&](std::uint64_t done, std::uint64_t total) {
    return !progress || progress(done, 2 * total);
  };
  Bitmap skeleton = ink;
  if (const Status thinned = thin(skeleton, first_half); !thinned) {
    return thinned.error();
  }
  Result<trace::SkeletonGraph> graph = trace::graph_of(ink, skeleton);
  if (!graph) return graph.error();
  const std::vector<trace::Spot> spots = all_spots(*graph);
  prune_spurs(*graph);
  std::vector<trace::Route> routes = trace::routes_of(ink, *graph);
  *graph = {};
  std::vector<Stroke> strokes;
  strokes.reserve(routes.size());
  for (std::size_t i = 0; i < routes.size(); ++i) {
    trace::fit_ends(ink, routes[i]);
    strokes.push_back(trace::shape_of(ink, routes[i]));
    routes[i] = {};
    if (progress && i % 256 == 0 &&
        !progress(routes.size() + i, 2 * routes.size())) {
      return Error{ErrorCode::cancelled, "cancelled"};
    }
  }
  strokes::share_pens(strokes);
  const Status covered = strokes::cover_missing(ink, spots, strokes);
  if (!covered) return covered.error();
  strokes::order_strokes(strokes);
  if (progress && !progress(1, 1)) {
    return Error{ErrorCode::cancelled, "cancelled"};
  }
  return strokes;
}

}  // namespace

Result<std::vector<Stroke>> trace_strokes(const Bitmap& ink,
                                          const Progress& progress) {
  if (ink.pixels() == 0) {
    return Error{ErrorCode::invalid_argument, "a bitmap of 0 x 0 pixels"};
  }
  try {
    return trace_all(ink, progress);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory"};
  }
}

}  // namespace unstep
