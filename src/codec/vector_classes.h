#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "grid/vector_classes.h"

/// What models make of vectors: classes of distance and contexts.
namespace unstep::codec {

using vectors::direction_of;
using vectors::fine_angle;
using vectors::kDirections;
using vectors::kNoDirection;
using vectors::length_class;
using vectors::shortened;
using vectors::size_of;
using vectors::turned_back;
using vectors::Vec;

/// Where b is, seen from a. Points are not of this namespace, so that this is
/// not found without it.
inline Vec operator-(const Point& a, const Point& b) {
  return vectors::between(b, a);
}

/// How far an expected value lies from the threshold of a decision, in
/// quarters of its weight: 8..15 at or above, 7..0 below.
[[nodiscard]] inline std::uint32_t distance_class(std::int64_t expected,
                                                  std::int64_t threshold,
                                                  std::int64_t weight) {
  const std::int64_t d = expected - threshold;
  const auto size = static_cast<std::uint32_t>(
      std::min<std::int64_t>(7, std::abs(d) * 4 / weight));
  return d < 0 ? 7 - size : 8 + size;
}

/// Joins small numbers to a context; each `more` takes 8 bits.
[[nodiscard]] constexpr std::uint64_t joined(std::uint64_t first) {
  return first;
}
template <class... More>
[[nodiscard]] constexpr std::uint64_t joined(std::uint64_t first, int next,
                                             More... more) {
  return joined(first << 8 | static_cast<std::uint8_t>(next), more...);
}

}  // namespace unstep::codec
