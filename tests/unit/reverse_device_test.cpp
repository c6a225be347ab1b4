#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "unstep/interpolate.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

using Steps = std::vector<Step>;

std::vector<Segment> reversed(const Steps& steps) {
  auto result = reverse_device(steps);
  EXPECT_TRUE(result) << result.error().message;
  return *result;
}

TEST(ReverseDevice, BreaksASegmentWithItsLastStep) {
  EXPECT_EQ(reversed({0, 2, 0, 0, 2, 0, 0, 2, 0, 0, 0}),
            (std::vector<Segment>{{8, 3}}));
  EXPECT_EQ(reversed({0, 2, 2, 2}), (std::vector<Segment>{{1, 2}, {0, 1}}));
}

TEST(ReverseDevice, ClosesBeforeAStepThatChangesASign) {
  EXPECT_EQ(reversed({0, 0, 4, 4}), (std::vector<Segment>{{2, 0}, {-2, 0}}));
  EXPECT_EQ(reversed({0, 2, 0, 6}), (std::vector<Segment>{{2, 1}, {0, -1}}));
  DeviceReverse device;
  Segment segment;
  EXPECT_EQ(device.push(0, segment), Pushed::open);
  EXPECT_EQ(device.push(0, segment), Pushed::open);
  EXPECT_EQ(device.push(4, segment), Pushed::segment);
  EXPECT_EQ(segment, (Segment{2, 0}));
  EXPECT_EQ(device.device().x, 1) << "the step opened the next segment";
}

TEST(ReverseDevice, KeepsAnAxisParallelRunOpenUntilTheEndOfMessage) {
  EXPECT_EQ(reversed(Steps(1000, 4)), (std::vector<Segment>{{-1000, 0}}));
  EXPECT_EQ(reversed(Steps(7, 6)), (std::vector<Segment>{{0, -7}}));
  EXPECT_TRUE(reversed({}).empty());
}

TEST(ReverseDevice, RefusesDiagonalStepsAndNamesThePlace) {
  for (const Step step : Steps{1, 3, 5, 7, 8, 255}) {
    const auto result = reverse_device(Steps{0, 2, step, 0});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::invalid_argument);
    EXPECT_NE(
        result.error().message.find("step 2 has code " + std::to_string(step)),
        std::string::npos);
  }
  DeviceReverse device;
  Segment segment;
  EXPECT_EQ(device.push(0, segment), Pushed::open);
  const DeviceRegisters before = device.device();
  EXPECT_EQ(device.push(1, segment), Pushed::refused);
  EXPECT_EQ(device.device(), before);
}

TEST(ReverseDevice, ClosesASegmentWhenACounterIsFull) {
  DeviceReverse device(3);
  Segment segment;
  std::vector<Segment> segments;
  for (int i = 0; i < 8; ++i)
    if (device.push(4, segment) == Pushed::segment) segments.push_back(segment);
  if (device.finish(segment)) segments.push_back(segment);
  EXPECT_EQ(segments, (std::vector<Segment>{{-3, 0}, {-3, 0}, {-2, 0}}));
}

TEST(ReverseDevice, StartsAFreshMessageAfterFinish) {
  DeviceReverse device;
  Segment segment;
  EXPECT_FALSE(device.finish(segment));
  EXPECT_EQ(device.push(0, segment), Pushed::open);
  EXPECT_TRUE(device.finish(segment));
  EXPECT_EQ(segment, (Segment{1, 0}));
  EXPECT_FALSE(device.finish(segment));
  EXPECT_EQ(device.push(6, segment), Pushed::open);
  EXPECT_TRUE(device.finish(segment));
  EXPECT_EQ(segment, (Segment{0, -1}));
}

// SEEDS A2: 574 of the 1599 segments with 0 <= a, b < 40 do not come back as
// one segment.
TEST(ReverseDevice, DoesNotInvertForwardInGeneral) {
  int not_one = 0;
  for (std::int32_t a = 0; a < 40; ++a) {
    for (std::int32_t b = 0; b < 40; ++b) {
      if (a + b == 0) continue;
      Steps steps;
      DeviceRegisters device;
      device.start(a, b);
      while (device.forward)
        steps.push_back(device.clock() == DeviceRegisters::Axis::x ? 0 : 2);
      not_one += reversed(steps) != std::vector<Segment>{{a, b}};
    }
  }
  EXPECT_EQ(not_one, 574);
}

}  // namespace
}  // namespace unstep
