#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "interpolate/lanes.h"
#include "unit/digital_segment_testing.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

using testing::below;
using testing::letters_of;
using testing::Steps;

constexpr std::uint32_t kMax = std::numeric_limits<std::uint32_t>::max();

/// The bulk form, with room to spare and without, and the plain loop give the
/// steps of the definition.
void check(const std::vector<DigitalSegment>& segments) {
  Steps expected;
  for (const DigitalSegment& s : segments) {
    const Steps steps = letters_of(s);
    expected.insert(expected.end(), steps.begin(), steps.end());
  }
  for (const std::size_t room : {0U, 1U, 15U, 16U, 64U}) {
    Steps out(expected.size() + room, 9);
    const auto count = interpolate(segments, out);
    ASSERT_TRUE(count) << count.error().message;
    ASSERT_EQ(*count, expected.size());
    out.resize(*count);
    const DigitalSegment& s = segments[0];
    ASSERT_EQ(out, expected)
        << "a " << s.a << " w " << s.w << " r " << s.r << " n " << s.n;
  }
  Steps plain(expected.size());
  std::size_t n = 0;
  for (const DigitalSegment& s : segments)
    n += digital_segment_steps_reference(s, std::span(plain).subspan(n));
  ASSERT_EQ(plain, expected);
}

TEST(DigitalSegments, NothingDrawsNothing) {
  EXPECT_EQ(*interpolate(std::span<const DigitalSegment>(), {}), 0U);
}

TEST(DigitalSegments, EverySmallLine) {
  for (std::uint32_t w = 1; w <= interpolation::kSmall + 2; ++w)
    for (std::uint32_t a = 0; a <= w; ++a)
      for (std::uint32_t r = 0; r < w; r += 1 + w / 9)
        check({{0, 7, 41, a, w, r}});
}

TEST(DigitalSegments, PeriodsAtTheLimitsOfEveryLane) {
  std::mt19937 random(11);
  for (const std::uint32_t w :
       {32767U, 32768U, 65536U, 2147483647U, 2147483648U, kMax}) {
    for (const std::uint32_t a : {0U, 1U, w / 2, w - 1, w}) {
      for (const std::uint32_t r : {0U, w / 3, w - 1})
        check({{2, 3, 100, a, w, r}});
      check({{2, 3, 33, below(random, w), w, below(random, w)}});
    }
  }
}

TEST(DigitalSegments, OneAfterAnother) {
  std::mt19937 random(12);
  for (int i = 0; i < 200; ++i) {
    std::vector<DigitalSegment> segments;
    for (std::uint32_t k = below(random, 20) + 1; k > 0; --k) {
      const std::uint32_t w = below(random, 1U << below(random, 20)) + 1;
      const auto s0 = static_cast<Step>(below(random, 4) * 2);
      segments.push_back({s0, static_cast<Step>((s0 + 6) % 8),
                          below(random, 90) + 1, below(random, w + 1), w,
                          below(random, w)});
    }
    check(segments);
  }
}

TEST(DigitalSegments, LanesOfAnyProcessorGiveTheSame) {
  std::mt19937 random(13);
  for (int i = 0; i < 300; ++i) {
    const std::uint32_t w = below(random, 32767) + 1;
    const DigitalSegment s{6, 7, 48, below(random, w + 1), w, below(random, w)};
    interpolation::LaneRule<std::int64_t> rule(s);
    interpolation::Lanes<std::int64_t> lanes(s, rule);
    Steps out(48);
    for (std::size_t at = 0; at < 48; at += interpolation::kBlock) {
      lanes.draw(rule, out.data() + at);
      lanes.advance(rule);
    }
    ASSERT_EQ(out, letters_of(s));
  }
}

TEST(DigitalSegments, AllOtherValuesAreRefusedWithAReason) {
  const auto reason = [](const DigitalSegment& s) {
    Steps out(100);
    const auto drawn =
        interpolate(std::vector<DigitalSegment>{{0, 1, 5, 2, 3, 1}, s}, out);
    const Status valid = validate(s);
    EXPECT_EQ(drawn.operator bool(), valid.operator bool());
    if (drawn || valid) return std::string("valid");
    EXPECT_EQ(drawn.error().code, ErrorCode::invalid_argument);
    EXPECT_EQ(drawn.error().message, "segment 1: " + valid.error().message);
    EXPECT_EQ(out, Steps(100)) << "nothing is written";
    return valid.error().message;
  };
  EXPECT_EQ(reason({0, 0, 1, 0, 1, 0}), "valid");
  EXPECT_EQ(reason({0, 7, 1, 1, 1, 0}), "valid");
  EXPECT_EQ(reason({0, 6, 1, 1, 1, 0}), "valid");
  EXPECT_EQ(reason({0, 4, 1, 1, 1, 0}), "steps 0 and 4 are not neighbours");
  EXPECT_EQ(reason({1, 3, 1, 1, 1, 0}), "steps 1 and 3 are not neighbours");
  EXPECT_EQ(reason({8, 8, 1, 1, 1, 0}), "steps 8 and 8 are not neighbours");
  EXPECT_EQ(reason({0, 1, 0, 1, 1, 0}), "has no steps");
  EXPECT_EQ(reason({0, 1, 1, 3, 2, 0}), "a = 3 is above w = 2");
  EXPECT_EQ(reason({0, 1, 1, 2, 2, 2}), "r = 2 is not below w = 2");
  EXPECT_EQ(reason({0, 1, 1, 0, 0, 0}), "r = 0 is not below w = 0");
}

TEST(DigitalSegments, ATooShortOutputIsRefusedBeforeItIsWritten) {
  const std::vector<DigitalSegment> segments(3, {0, 1, kMax, 1, 3, 0});
  Steps out(7, 5);
  const auto drawn = interpolate(segments, out);
  ASSERT_FALSE(drawn);
  EXPECT_EQ(drawn.error().code, ErrorCode::limit_exceeded);
  EXPECT_EQ(drawn.error().message,
            "the segments make 12884901885 steps, the output has room for 7");
  EXPECT_EQ(out, Steps(7, 5));
}

}  // namespace
}  // namespace unstep
