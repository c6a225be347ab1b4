#include "reverse/chain_check.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace unstep::reverse {
namespace {

Error invalid(std::size_t step, const std::string& why) {
  return {ErrorCode::invalid_argument,
          "step " + std::to_string(step) + " " + why};
}

/// Whether all codes are of the connectivity; `odd`: the bit they must not
/// have.
bool fits(std::span<const Step> steps, int odd) {
  unsigned all = 0;
  for (const Step step : steps) all |= step;
  return (all & (0xf8U | static_cast<unsigned>(odd))) == 0;
}

/// `x`, `y`: where the chain ends.
Status returns(const Chain& chain, std::int64_t x, std::int64_t y) {
  if (chain.closed && (x != chain.origin.x || y != chain.origin.y)) {
    return Error{ErrorCode::invalid_argument,
                 "a closed chain that does not end at its origin"};
  }
  return {};
}

}  // namespace

Status check_chain(const Chain& chain, YAxis axis, std::int32_t scale) {
  const std::int64_t limit = kMaxCoord / scale;
  const auto inside = [limit](std::int64_t c) {
    return -limit <= c && c <= limit;
  };
  std::array<Point, 8> deltas{};
  for (std::size_t code = 0; code < deltas.size(); ++code) {
    deltas[code] = step_delta(static_cast<Step>(code), axis);
  }
  const int odd = chain.connectivity == Connectivity::four ? 1 : 0;
  std::int64_t x = chain.origin.x;
  std::int64_t y = chain.origin.y;
  if (!inside(x) || !inside(y)) {
    return Error{ErrorCode::invalid_argument,
                 "the origin is outside the range of coordinates"};
  }
  // So far from the limits no step can leave them.
  const auto most = static_cast<std::int64_t>(chain.steps.size());
  const bool far = inside(x + most) && inside(x - most) && inside(y + most) &&
                   inside(y - most);
  if (far && fits(chain.steps, odd)) {
    for (const Step step : chain.steps) {
      x += deltas[step].x;
      y += deltas[step].y;
    }
    return returns(chain, x, y);
  }
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    const Step step = chain.steps[i];
    if (step > 7 || (step & odd) != 0) {
      return invalid(i, "has code " + std::to_string(step) +
                            ", which does not fit the connectivity");
    }
    x += deltas[step].x;
    y += deltas[step].y;
    if (!inside(x) || !inside(y)) {
      return invalid(i, "leaves the range of coordinates");
    }
  }
  return returns(chain, x, y);
}

}  // namespace unstep::reverse
