#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "unstep/grid.h"

/// What the tests of exact reverse interpolation and its inverse share.
namespace unstep::testing {

using Steps = std::vector<Step>;

/// The steps of a segment by the definition, in 128 bits.
inline Steps letters_of(const DigitalSegment& s) {
  __extension__ using Wide = unsigned __int128;
  Steps steps;
  for (std::uint32_t i = 0; i < s.n; ++i) {
    const Wide here = (Wide{s.a} * i + s.r) / s.w;
    const Wide next = (Wide{s.a} * (Wide{i} + 1) + s.r) / s.w;
    steps.push_back(next > here ? s.s1 : s.s0);
  }
  return steps;
}

/// 0..end - 1.
inline std::uint32_t below(std::mt19937& random, std::uint32_t end) {
  return static_cast<std::uint32_t>(random() % end);
}

/// Random steps, random walks on neighbouring codes and random lines, joined.
inline Steps random_chain(std::mt19937& random, Connectivity connectivity) {
  const unsigned unit = connectivity == Connectivity::four ? 2 : 1;
  const auto code = [unit](unsigned k) {
    return static_cast<Step>(k * unit % 8);
  };
  Steps steps;
  for (unsigned parts = below(random, 12) + 1; parts > 0; --parts) {
    const std::uint32_t n = 1U << below(random, 10);
    const unsigned first = below(random, 8);
    const unsigned kind = below(random, 4);
    if (kind >= 2) {
      const std::uint32_t w = below(random, 2 * n) + 1;
      const std::uint32_t a = below(random, w + 1);
      const unsigned second = kind == 2 ? first + 1 : first + 7;
      const Steps line =
          letters_of({code(first), code(second), n, a, w, below(random, w)});
      steps.insert(steps.end(), line.begin(), line.end());
      continue;
    }
    for (std::uint32_t i = 0; i < n / 4 + 1; ++i)
      steps.push_back(
          code(kind == 0 ? below(random, 8) : first + below(random, 2)));
  }
  return steps;
}

}  // namespace unstep::testing
