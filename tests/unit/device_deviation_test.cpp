#include <gtest/gtest.h>

#include <random>

#include "unstep/deviation.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

struct Pair {
  Drawing chains;
  Drawing paths;
};

/// A random 4-connected chain and the device's segments of it.
Pair reversed(std::size_t steps, YAxis axis, unsigned seed) {
  std::mt19937 random(seed);
  Chain chain{{5, -3}, Connectivity::four, false, {}};
  for (std::size_t i = 0; i < steps; ++i) {
    chain.steps.push_back(static_cast<Step>(random() % 4 * 2));
  }
  Path path;
  path.origin = chain.origin;
  for (const Segment& segment : *reverse_device(chain.steps)) {
    const std::int32_t dy = axis == YAxis::up ? segment.dy : -segment.dy;
    path.elements.push_back({Path::Kind::segment, {segment.dx, dy}, {}});
  }
  Pair pair;
  pair.chains.canvas.y_axis = pair.paths.canvas.y_axis = axis;
  pair.chains.chains = {chain};
  pair.paths.paths = {path};
  return pair;
}

TEST(DeviceDeviation, IsAtMostOneForTheDevicesOwnSegments) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    for (const YAxis axis : {YAxis::up, YAxis::down}) {
      const Pair pair = reversed(500, axis, seed);
      const auto found = measure_device_deviation(pair.chains, pair.paths);
      ASSERT_TRUE(found) << found.error().message << " seed " << seed;
      EXPECT_LE(found->distance, 1.0) << "seed " << seed;
    }
  }
}

TEST(DeviceDeviation, NamesTheStepWhereALineIsTooFar) {
  Pair pair;
  pair.chains.chains = {{{0, 0},
                         Connectivity::four,
                         false,
                         {0, 0, 0, 0, 0, 0, 2, 2, 2, 2, 2, 2}}};
  pair.chains.canvas.y_axis = pair.paths.canvas.y_axis = YAxis::up;
  Path path;
  path.elements = {{Path::Kind::segment, {6, 6}, {}}};
  pair.paths.paths = {path};
  const auto found = measure_device_deviation(pair.chains, pair.paths);
  ASSERT_TRUE(found);
  // The device draws it as a stair: (2, 3) after five steps.
  EXPECT_EQ(found->distance, 3.0);
  EXPECT_EQ(found->path, 0U);
  EXPECT_EQ(found->step, 5U);
  EXPECT_EQ(found->x, 5.0);
}

TEST(DeviceDeviation, RefusesPathsOfOtherChains) {
  Pair pair = reversed(20, YAxis::up, 1);
  pair.chains.chains[0].steps.pop_back();
  EXPECT_EQ(measure_device_deviation(pair.chains, pair.paths).error().code,
            ErrorCode::invalid_argument);
  pair.paths.paths.clear();
  EXPECT_EQ(measure_device_deviation(pair.chains, pair.paths).error().code,
            ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace unstep
