#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "unstep/grid.h"
#include "unstep/trace.h"

/// Chains to try reverse interpolation on.
namespace unstep::testing {

inline Chain open_chain(std::vector<Step> steps, Point origin = {}) {
  return {origin, Connectivity::eight, false, std::move(steps)};
}

/// Steps that mostly keep their direction: 1 in `turning` turns by an eighth.
inline Chain random_chain(std::mt19937& random, std::size_t steps,
                          std::uint32_t turning) {
  std::vector<Step> result(steps);
  std::uint32_t step = random() % 8;
  for (Step& code : result) {
    if (random() % turning == 0) step += random() % 2 == 0 ? 1U : 7U;
    code = static_cast<Step>(step % 8);
  }
  return open_chain(result);
}

/// There and back again: a closed chain around nothing.
inline Chain retraced(Chain chain) {
  const std::vector<Step> there = chain.steps;
  for (auto step = there.rbegin(); step != there.rend(); ++step) {
    chain.steps.push_back(static_cast<Step>((*step + 4) % 8));
  }
  chain.closed = true;
  return chain;
}

inline std::vector<Chain> contours_of(const Bitmap& ink) {
  std::vector<Chain> contours;
  (void)trace_contours(ink, [&](const Chain& contour) {
    contours.push_back(contour);
    return true;
  });
  return contours;
}

/// Blots: pixels that follow their neighbours with a probability of
/// `sticking` / 256.
inline Bitmap blots(std::mt19937& random, std::int32_t size,
                    std::uint32_t sticking) {
  Bitmap ink = *Bitmap::create(size, size);
  for (std::int32_t y = 0; y < size; ++y) {
    for (std::int32_t x = 0; x < size; ++x) {
      bool pixel = random() % 2 == 0;
      if (x > 0 && random() % 256 < sticking) pixel = ink.get(x - 1, y);
      if (y > 0 && random() % 256 < sticking) pixel = ink.get(x, y - 1);
      ink.set(x, y, pixel);
    }
  }
  return ink;
}

/// The contour pixels of a disc and, for `inner` > 0, of a ring.
inline Bitmap disc(std::int32_t radius, std::int32_t inner = 0) {
  const std::int32_t size = 2 * radius + 3;
  Bitmap ink = *Bitmap::create(size, size);
  for (std::int32_t y = 0; y < size; ++y) {
    for (std::int32_t x = 0; x < size; ++x) {
      const std::int32_t dx = x - radius - 1;
      const std::int32_t dy = y - radius - 1;
      const std::int32_t d = dx * dx + dy * dy;
      ink.set(x, y, d <= radius * radius && d >= inner * inner);
    }
  }
  return ink;
}

}  // namespace unstep::testing
