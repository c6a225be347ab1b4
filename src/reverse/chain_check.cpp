#include "reverse/chain_check.h"

#include <cstddef>
#include <string>

namespace unstep::reverse {
namespace {

Error invalid(std::size_t step, const std::string& why) {
  return {ErrorCode::invalid_argument,
          "step " + std::to_string(step) + " " + why};
}

}  // namespace

Status check_chain(const Chain& chain, YAxis axis, std::int32_t scale) {
  const std::int64_t limit = kMaxCoord / scale;
  const auto inside = [limit](std::int64_t c) {
    return -limit <= c && c <= limit;
  };
  const int odd = chain.connectivity == Connectivity::four ? 1 : 0;
  std::int64_t x = chain.origin.x;
  std::int64_t y = chain.origin.y;
  if (!inside(x) || !inside(y)) {
    return Error{ErrorCode::invalid_argument,
                 "the origin is outside the range of coordinates"};
  }
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    const Step step = chain.steps[i];
    if (step > 7 || (step & odd) != 0) {
      return invalid(i, "has code " + std::to_string(step) +
                            ", which does not fit the connectivity");
    }
    const Point delta = step_delta(step, axis);
    x += delta.x;
    y += delta.y;
    if (!inside(x) || !inside(y)) {
      return invalid(i, "leaves the range of coordinates");
    }
  }
  if (chain.closed && (x != chain.origin.x || y != chain.origin.y)) {
    return Error{ErrorCode::invalid_argument,
                 "a closed chain that does not end at its origin"};
  }
  return {};
}

}  // namespace unstep::reverse
