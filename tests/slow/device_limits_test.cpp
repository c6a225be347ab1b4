#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "unit/device_search.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

using testing::Axis;
using testing::Search;

TEST(DeviceGuaranteeAtLength, HoldsForEveryPathOfUpTo25Steps) {
  Search search{25};
  std::vector<std::uint8_t> word;
  search.all_paths({}, word, 0);
  EXPECT_EQ(search.words, (1U << 26) - 2) << "every path of 1..25 steps";
  EXPECT_EQ(search.worst, 1);
}

TEST(DeviceGuaranteeAtLength, HoldsForEveryOneSegmentWordOfUpTo400Steps) {
  Search search{400};
  std::vector<std::uint8_t> word;
  search.one_segment({}, word);
  EXPECT_GT(search.words, 10'000'000U);
  EXPECT_EQ(search.worst, 1);
}

/// The first million ticks of the interpolator are the device's.
void expect_same_beginning(Segment segment, DeviceRegisters device) {
  Interpolator run = *Interpolator::line(Method::device, segment);
  for (int i = 0; i < 1'000'000; ++i) {
    const bool along_x = device.clock() == Axis::x;
    const Tick tick = run.next();
    ASSERT_EQ(tick.dx, along_x ? (segment.dx < 0 ? -1 : 1) : 0) << i;
    ASSERT_EQ(tick.dy, along_x ? 0 : (segment.dy < 0 ? -1 : 1)) << i;
  }
}

TEST(DeviceAtTheLimit, DrawsTheLongestLineToItsEnd) {
  constexpr Segment kLongest{std::numeric_limits<std::int32_t>::min(),
                             std::numeric_limits<std::int32_t>::max()};
  constexpr std::int64_t kX = std::int64_t{1} << 31;
  constexpr std::int64_t kY = kX - 1;
  DeviceRegisters device;
  device.start(kX, kY);
  expect_same_beginning(kLongest, device);
  std::uint64_t steps = 0;
  // kX * (way along y) - kY * (way along x): how far off the true line; at
  // most 2^31 for each unit, so no overflow while the device is near it.
  std::int64_t off = 0;
  std::int64_t least = 0;
  std::int64_t most = 0;
  while (device.forward) {
    off += device.clock() == Axis::x ? -kY : kX;
    least = std::min(least, off);
    most = std::max(most, off);
    ++steps;
  }
  EXPECT_EQ(steps, static_cast<std::uint64_t>(kX + kY));
  EXPECT_EQ(off, 0) << "not at the end of the line";
  EXPECT_GE(least, -kX) << "more than a unit from the line";
  EXPECT_LE(most, kX) << "more than a unit from the line";
}

}  // namespace
}  // namespace unstep
