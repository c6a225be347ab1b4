#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "unit/method_test_name.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

std::vector<Step> by_ticks(Method method, Segment segment) {
  auto run = Interpolator::line(method, segment);
  EXPECT_TRUE(run);
  std::vector<Step> steps;
  for (Tick t = run->next(); t.kind != Tick::Kind::done; t = run->next())
    if (t.kind == Tick::Kind::step) steps.push_back(t.step);
  return steps;
}

// The bulk form writes eight bytes at a time: guard bytes behind the output
// must survive.
std::vector<Step> in_bulk(Method method, const std::vector<Segment>& segments,
                          std::size_t size) {
  constexpr Step kGuard = 0xA5;
  std::vector<Step> out(size + 32, kGuard);
  const auto n = interpolate(method, segments, std::span(out).first(size));
  EXPECT_TRUE(n) << n.error().message;
  if (n) {
    EXPECT_EQ(*n, size);
  }
  for (std::size_t i = size; i < out.size(); ++i) EXPECT_EQ(out[i], kGuard);
  out.resize(size);
  return out;
}

class BulkMethods : public testing::TestWithParam<Method> {};

TEST_P(BulkMethods, GiveTheStepsOfNextForEverySegmentUpTo100) {
  for (std::int32_t x = 0; x <= 100; ++x) {
    for (std::int32_t y = 0; y <= 100; ++y) {
      const std::int32_t sign_x = (x + y) % 2 == 0 ? 1 : -1;
      const std::int32_t sign_y = (x / 2 + y) % 2 == 0 ? 1 : -1;
      const Segment s{sign_x * x, sign_y * y};
      const std::vector<Step> steps = by_ticks(GetParam(), s);
      ASSERT_EQ(in_bulk(GetParam(), {s}, steps.size()), steps)
          << s.dx << ',' << s.dy;
    }
  }
}

TEST_P(BulkMethods, GiveTheStepsOfNextForRandomLists) {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    std::vector<Segment> segments;
    std::vector<Step> steps;
    const int limit = 1 << (1 + round % 15);
    std::uniform_int_distribution<std::int32_t> delta(-limit, limit);
    for (unsigned i = 0; i < 1 + random() % 20; ++i) {
      Segment s{delta(random), delta(random)};
      if (random() % 8 == 0) s.dx = static_cast<std::int32_t>(random() % 3);
      if (random() % 8 == 0) s.dy = static_cast<std::int32_t>(random() % 3);
      segments.push_back(s);
      const std::vector<Step> one = by_ticks(GetParam(), s);
      if (GetParam() != Method::rate_multiplier) {
        ASSERT_EQ(step_count(GetParam(), s), one.size());
      }
      steps.insert(steps.end(), one.begin(), one.end());
    }
    ASSERT_EQ(in_bulk(GetParam(), segments, steps.size()), steps) << round;
  }
}

TEST_P(BulkMethods, RefuseAnOutputThatIsTooShort) {
  std::vector<Step> out(9);
  const std::vector<Segment> segments{{5, 5}, {3, 3}};
  const auto n = interpolate(GetParam(), segments, std::span(out).first(5));
  ASSERT_FALSE(n);
  EXPECT_EQ(n.error().code, ErrorCode::limit_exceeded);
}

INSTANTIATE_TEST_SUITE_P(All, BulkMethods,
                         testing::Values(Method::device, Method::evaluation,
                                         Method::evaluation8,
                                         Method::gate_level,
                                         Method::rate_multiplier),
                         oracle::test_name);

TEST(Bulk, DrawsNothingForNoSegments) {
  EXPECT_EQ(*interpolate(Method::device, {}, {}), 0U);
}

TEST(Bulk, RefusesMethodsThatMakeNoUnitStepsOfLines) {
  const std::vector<Segment> segments{{1, 1}};
  std::vector<Step> out(8);
  for (const Method m :
       {Method::circular, Method::increments, Method::general}) {
    const auto n = interpolate(m, segments, out);
    ASSERT_FALSE(n);
    EXPECT_EQ(n.error().code, ErrorCode::unsupported);
  }
}

TEST(Bulk, EqualsThePlainReferenceLoop) {
  const Segment s{-98'765, 43'210};
  std::vector<Step> plain(step_count(Method::device, s));
  EXPECT_EQ(device_steps_reference(s, plain), plain.size());
  EXPECT_EQ(in_bulk(Method::device, {s}, plain.size()), plain);
}

}  // namespace
}  // namespace unstep
