#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "deviation/curves.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// Chains and paths, one to one, checked before anything is measured.
namespace unstep::deviation {

/// The end of an element relative to its start.
[[nodiscard]] inline Vector64 move_of(const Path::Element& element) {
  return element.kind == Path::Kind::segment
             ? Vector64{element.segment.dx, element.segment.dy}
             : Vector64{element.arc.end.x, element.arc.end.y};
}

/// invalid_argument if the numbers differ, a pair is half closed, a step is no
/// code, a closed curve does not return or an arc has no radius.
Status check_pairs(const Drawing& chains, const Drawing& paths);

/// What is wrong with one of them alone.
Status check_chain(const Chain& chain, YAxis axis);
Status check_path(const Path& path);

/// Ends of a chain in path units.
struct ChainSpan {
  Vector64 origin;
  Vector64 end;
};
[[nodiscard]] ChainSpan span_of(const Chain& chain, YAxis axis,
                                std::int64_t unit);

/// "path 3: " and so on.
[[nodiscard]] std::string path_name(std::size_t index);

}  // namespace unstep::deviation
