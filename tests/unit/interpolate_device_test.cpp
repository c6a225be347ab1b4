#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "unstep/interpolate.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

using Axis = DeviceRegisters::Axis;

struct Fig4Row {
  char step;
  std::int64_t x, y, f;
  bool and4, and5, t11, and19;
};

// Fig. 4 of SU 1089551, segment (7, 3).
constexpr std::array<Fig4Row, 10> kFig4{{
    {'x', 6, 3, -1, true, false, true, false},
    {'x', 5, 3, 2, true, false, true, false},
    {'y', 5, 2, -3, false, true, true, false},
    {'x', 4, 2, -1, true, false, true, false},
    {'x', 3, 2, 1, true, false, true, false},
    {'y', 3, 1, -2, false, true, true, false},
    {'x', 2, 1, -1, true, false, true, false},
    {'x', 1, 1, 0, true, false, true, false},
    {'y', 1, 0, -1, false, true, true, false},
    {'x', 0, 0, -1, true, false, true, true},
}};

TEST(Device, DrawsTheSegmentOfFig4RowByRow) {
  DeviceRegisters device;
  GateNet net;
  device.start(7, 3);
  net.start(7, 3);
  EXPECT_EQ(device.f, -4);
  EXPECT_EQ(net.registers().f, -4);
  for (const Fig4Row& row : kFig4) {
    const Axis axis = row.step == 'x' ? Axis::x : Axis::y;
    EXPECT_EQ(device.clock(), axis);
    EXPECT_EQ(net.clock(), axis);
    const DeviceRegisters gates = net.registers();
    EXPECT_EQ(device, gates);
    EXPECT_EQ(gates.x, row.x);
    EXPECT_EQ(gates.y, row.y);
    EXPECT_EQ(gates.f, row.f);
    EXPECT_EQ(net.signals().and4, row.and4);
    EXPECT_EQ(net.signals().and5, row.and5);
    EXPECT_EQ(net.signals().trigger11, row.t11);
    EXPECT_EQ(net.signals().and19, row.and19);
  }
  EXPECT_FALSE(net.registers().forward) << "AND 19 resets trigger 11";
  EXPECT_EQ(net.clock(), Axis::none);
  EXPECT_EQ(device.clock(), Axis::none);
}

struct Fig5Row {
  char step;
  std::int64_t x, y, f;
  bool and15, and5, and16, or17;
};

constexpr std::array<Fig5Row, 11> kFig5{{
    {'x', 1, 0, 0, true, false, false, false},
    {'y', 1, 1, -1, false, true, false, false},
    {'x', 2, 1, 0, true, false, false, false},
    {'x', 3, 1, 1, true, false, false, false},
    {'y', 3, 2, -2, false, true, false, false},
    {'x', 4, 2, 0, true, false, false, false},
    {'x', 5, 2, 2, true, false, false, false},
    {'y', 5, 3, -3, false, true, false, false},
    {'x', 6, 3, 0, true, false, false, false},
    {'x', 7, 3, 3, true, false, false, false},
    {'x', 8, 3, 6, false, false, true, true},
}};

TEST(Device, ApproximatesTheStepsOfFig5RowByRow) {
  DeviceReverse device;
  GateReverse net;
  Segment segment;
  Segment net_segment;
  for (const Fig5Row& row : kFig5) {
    const Step step = row.step == 'x' ? 0 : 2;
    const Pushed expected = row.or17 ? Pushed::segment : Pushed::open;
    EXPECT_EQ(device.push(step, segment), expected);
    EXPECT_EQ(net.push(step, net_segment), expected);
    const DeviceRegisters gates = net.device().registers();
    EXPECT_EQ(device.device(), gates);
    EXPECT_EQ(gates.x, row.x);
    EXPECT_EQ(gates.y, row.y);
    EXPECT_EQ(gates.f, row.f);
    EXPECT_EQ(net.device().signals().and15, row.and15);
    EXPECT_EQ(net.device().signals().and5, row.and5);
    EXPECT_EQ(net.device().signals().and16, row.and16);
    EXPECT_EQ(net.device().signals().or17, row.or17);
  }
  EXPECT_EQ(segment, (Segment{8, 3}));
  EXPECT_EQ(net_segment, (Segment{8, 3}));
  EXPECT_FALSE(device.finish(segment));
}

TEST(Device, GatesEqualRegistersForEverySegmentUpTo64) {
  for (int xk = 0; xk <= 64; ++xk) {
    for (int yk = 0; yk <= 64; ++yk) {
      DeviceRegisters device;
      GateNet net;
      device.start(xk, yk);
      net.start(xk, yk);
      ASSERT_EQ(device, net.registers()) << xk << ',' << yk;
      Axis axis = Axis::none;
      int steps = 0;
      do {
        axis = device.clock();
        steps += axis != Axis::none;
        ASSERT_EQ(net.clock(), axis) << xk << ',' << yk << " step " << steps;
        ASSERT_EQ(device, net.registers()) << xk << ',' << yk;
      } while (axis != Axis::none);
      EXPECT_EQ(steps, xk + yk);
    }
  }
}

TEST(Device, GatesEqualRegistersForAMillionRandomReverseSteps) {
  std::mt19937 random(1984);
  for (const bool one_quadrant : {true, false}) {
    DeviceReverse device;
    GateReverse net;
    for (int i = 0; i < 1'000'000; ++i) {
      const auto step =
          static_cast<Step>(random() % (one_quadrant ? 2 : 4) * 2);
      Segment a;
      Segment b;
      const Pushed pushed = device.push(step, a);
      ASSERT_EQ(net.push(step, b), pushed) << i;
      ASSERT_EQ(a, b) << i;
      ASSERT_EQ(device.device(), net.device().registers()) << i;
    }
  }
}

TEST(Device, KeepsItsRangeProofAtTheLimits) {
  // First and last million steps, |F| and sign invariants all along them.
  constexpr std::int64_t kMax = std::int64_t{1} << 31;  // |INT32_MIN|
  for (const auto& [xk, yk] :
       std::vector<std::pair<std::int64_t, std::int64_t>>{
           {kMax, kMax}, {kMax, kMax - 1}, {kMax, 1}, {1, kMax}, {kMax, 3}}) {
    DeviceRegisters device;
    device.start(xk, yk);
    for (int i = 0; i < 1'000'000; ++i) {
      ASSERT_NE(device.clock(), Axis::none);
      if (device.x >= 1 && device.y >= 1) {
        ASSERT_GE(device.f, -device.x);
        ASSERT_LE(device.f, device.y - 1);
      }
    }
  }
  GateNet net;
  DeviceRegisters device;
  net.start(kMax, kMax - 5);
  device.start(kMax, kMax - 5);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(net.clock(), device.clock());
    ASSERT_EQ(net.registers(), device);
  }
}

}  // namespace
}  // namespace unstep
