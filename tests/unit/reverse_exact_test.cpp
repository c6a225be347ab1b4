#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "reverse/fast_recogniser.h"
#include "reverse/segment_recogniser.h"
#include "unit/digital_segment_testing.h"
#include "unstep/formats.h"
#include "unstep/interpolate.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using reverse::FastRecogniser;
using reverse::SegmentRecogniser;
using reverse::SegmentState;
using reverse::WordPoint;
using testing::below;
using testing::letters_of;
using testing::Steps;

std::vector<SegmentState> states_by_letters(const Steps& steps,
                                            Connectivity connectivity) {
  std::vector<SegmentState> states;
  SegmentRecogniser open(connectivity);
  for (const Step step : steps) {
    if (open.push(step)) continue;
    states.push_back(open.state());
    open = SegmentRecogniser(connectivity);
    open.push(step);
  }
  if (!steps.empty()) states.push_back(open.state());
  return states;
}

std::vector<SegmentState> states_by_comparing(const Steps& steps,
                                              Connectivity connectivity) {
  std::vector<SegmentState> states;
  const FastRecogniser fast(connectivity);
  const std::span<const Step> all(steps);
  for (std::size_t at = 0; at < steps.size(); at += states.back().n)
    states.push_back(fast.longest(all.subspan(at)));
  return states;
}

std::string text_of(const Steps& steps) {
  std::string text;
  for (const Step step : steps) text += static_cast<char>('0' + step);
  return text.substr(0, 400);
}

/// Both recognisers agree; streaming gives the same segments; drawing them
/// gives the steps.
void check_open(const Steps& steps, Connectivity connectivity) {
  const auto states = states_by_letters(steps, connectivity);
  ASSERT_EQ(states_by_comparing(steps, connectivity), states) << text_of(steps);
  std::vector<DigitalSegment> expected;
  for (const SegmentState& state : states) expected.push_back(state.segment());

  ExactReverse stream(connectivity);
  std::vector<DigitalSegment> streamed;
  DigitalSegment closed;
  for (const Step step : steps)
    if (stream.push(step, closed) == Pushed::segment)
      streamed.push_back(closed);
  if (stream.finish(closed)) streamed.push_back(closed);
  ASSERT_EQ(streamed, expected) << text_of(steps);

  const auto whole = reverse_exact({{}, connectivity, false, steps});
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->start, 0U);
  ASSERT_EQ(whole->segments, expected);
  Steps drawn(steps.size());
  const auto count = interpolate(expected, drawn);
  ASSERT_TRUE(count) << count.error().message;
  EXPECT_EQ(*count, steps.size());
  ASSERT_EQ(drawn, steps);
}

/// Is the word a digital straight segment? By definition: some line a / w with
/// w <= n and some phase draws it. Neighbourhood is not looked at.
bool is_straight(const Steps& word) {
  const auto n = static_cast<std::uint32_t>(word.size());
  for (std::uint32_t w = 1; w <= n; ++w)
    for (std::uint32_t a = 0; a <= w; ++a)
      for (std::uint32_t r = 0; r < w; ++r)
        if (letters_of({0, 1, n, a, w, r}) == word) return true;
  return false;
}

TEST(ReverseExact, TakesEveryShortWordThatALineDraws) {
  for (std::uint32_t n = 1; n <= 9; ++n) {
    for (std::uint32_t bits = 0; bits < 1U << n; ++bits) {
      Steps word;
      for (std::uint32_t i = 0; i < n; ++i)
        word.push_back(static_cast<Step>(bits >> i & 1));
      const bool one = states_by_letters(word, Connectivity::eight).size() == 1;
      ASSERT_EQ(one, is_straight(word)) << text_of(word);
    }
  }
}

TEST(ReverseExact, NothingAndOneStep) {
  check_open({}, Connectivity::eight);
  for (Step step = 0; step < 8; ++step) check_open({step}, Connectivity::eight);
  DigitalSegment closed;
  ExactReverse stream(Connectivity::four);
  EXPECT_FALSE(stream.finish(closed));
  EXPECT_EQ(stream.open().n, 0U);
  EXPECT_EQ(stream.push(3, closed), Pushed::refused);
  EXPECT_EQ(stream.push(8, closed), Pushed::refused);
  EXPECT_EQ(stream.push(2, closed), Pushed::open);
  EXPECT_EQ(stream.open(), (DigitalSegment{2, 2, 1, 0, 1, 0}));
  EXPECT_EQ(stream.push(2, closed), Pushed::open);
  EXPECT_EQ(stream.push(6, closed), Pushed::segment);
  EXPECT_EQ(closed, (DigitalSegment{2, 2, 2, 0, 1, 0}));
}

TEST(ReverseExact, OnlyNeighboursShareASegment) {
  for (Step first = 0; first < 8; ++first) {
    for (Step second = 0; second < 8; ++second) {
      const int apart = (second - first) & 7;
      const auto count = [&](Connectivity connectivity) {
        return states_by_comparing({first, second}, connectivity).size();
      };
      EXPECT_EQ(count(Connectivity::eight) == 1,
                apart == 0 || apart == 1 || apart == 7);
      if (first % 2 == 0 && second % 2 == 0) {
        EXPECT_EQ(count(Connectivity::four) == 1, apart != 4);
      }
    }
  }
}

TEST(ReverseExact, RandomStepsAndRandomLines) {
  std::mt19937 random(1995);
  for (const auto connectivity : {Connectivity::four, Connectivity::eight}) {
    for (int i = 0; i < 400; ++i)
      check_open(testing::random_chain(random, connectivity), connectivity);
  }
}

TEST(ReverseExact, EveryLineOfALengthInEveryPhase) {
  for (std::uint32_t w = 1; w <= 20; ++w)
    for (std::uint32_t a = 0; a <= w; ++a)
      for (std::uint32_t r = 0; r < w; ++r)
        check_open(letters_of({5, 4, 70, a, w, r}), Connectivity::eight);
}

/// Words whose line tilts as often or as late as can be, and that break at the
/// last moment: Fibonacci words, long lines with one letter changed.
TEST(ReverseExact, AdversarialChains) {
  Steps before{2};
  Steps fibonacci{2, 4};
  while (fibonacci.size() < 30'000) {
    Steps next = fibonacci;
    next.insert(next.end(), before.begin(), before.end());
    before = std::exchange(fibonacci, next);
  }
  check_open(fibonacci, Connectivity::four);

  std::mt19937 random(7);
  for (const std::uint32_t w : {1U, 2U, 3U, 15U, 16U, 17U, 255U, 1597U}) {
    for (int i = 0; i < 60; ++i) {
      const std::uint32_t a = below(random, w + 1);
      Steps steps = letters_of({1, 2, 4000, a, w, below(random, w)});
      Step& changed = steps[below(random, 4000)];
      changed = static_cast<Step>(i % 3 == 0 ? below(random, 8) : 3U - changed);
      check_open(steps, Connectivity::eight);
    }
  }
}

/// A state near the greatest length: at point n of the line a / w from phase 0
/// with all its leaning points known.
SegmentRecogniser far_along(std::uint32_t n, std::uint32_t a, std::uint32_t w,
                            std::uint32_t lower) {
  const auto ones = [&](std::uint32_t i) {
    return static_cast<std::uint32_t>(std::uint64_t{a} * i / w);
  };
  const std::uint32_t last_upper = n / w * w;
  const std::uint32_t last_lower = (n - lower) / w * w + lower;
  const SegmentState state{0, 1, n, a, w, {0, 0}, {lower, ones(lower)}};
  return {Connectivity::eight,
          state,
          {last_upper, ones(last_upper)},
          {last_lower, ones(last_lower)},
          ones(n)};
}

TEST(ReverseExact, TheLongestSegmentsAreSplitAt32Bits) {
  // 2^31 - 1 is prime: lower leaning points i with a i = -1 mod w.
  constexpr std::uint32_t w = 2147483647;
  constexpr std::uint32_t a = 1073741824;  // 1 / 2 mod w
  constexpr std::uint32_t lower = w - 2;
  SegmentRecogniser open = far_along(reverse::kMaxSegment - 100, a, w, lower);
  for (std::uint64_t i = reverse::kMaxSegment - 100; i < reverse::kMaxSegment;
       ++i) {
    const bool one = a * (i + 1) / w > a * i / w;
    ASSERT_TRUE(open.push(one ? 1 : 0)) << i;
  }
  EXPECT_EQ(open.state().segment(),
            (DigitalSegment{0, 1, reverse::kMaxSegment, a, w, 0}));
  EXPECT_FALSE(open.push(0));
  EXPECT_FALSE(open.push(1));
}

TEST(ReverseExact, AVeryLongLineCanStillTilt) {
  // Three runs of w - 1 zeros and a one, then w zeros.
  constexpr std::uint32_t w = (1U << 30) - 1;
  SegmentRecogniser open = far_along(4 * w - 1, 1, w, w - 1);
  ASSERT_TRUE(open.push(0));
  EXPECT_EQ(open.state(),
            (SegmentState{0, 1, 4 * w, 3, 3 * w + 1, {3 * w, 3}, {w - 1, 0}}));
  EXPECT_FALSE(open.push(0));
}

TEST(ReverseExact, RefusesForeignCodesByIndex) {
  const auto error = [](Connectivity connectivity, Steps steps) {
    const auto result = reverse_exact({{}, connectivity, false, steps});
    EXPECT_FALSE(result);
    return result ? std::string() : result.error().message;
  };
  EXPECT_EQ(error(Connectivity::eight, Steps{0, 1, 8}),
            "step 2 has code 8, not 0 to 7");
  Steps steps(40, 2);
  steps[17] = 3;
  EXPECT_EQ(error(Connectivity::four, steps),
            "step 17 has code 3, not 0, 2, 4 or 6");
}

std::size_t fewest_of_all_starts(const Chain& chain) {
  std::size_t fewest = chain.steps.size() + 1;
  Steps steps = chain.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    fewest =
        std::min(fewest, states_by_letters(steps, chain.connectivity).size());
    std::rotate(steps.begin(), steps.begin() + 1, steps.end());
  }
  return fewest;
}

/// Exact from its start on; the number of segments beside the least.
std::size_t closed_segments(const Chain& chain) {
  const auto result = reverse_exact(chain);
  EXPECT_TRUE(result);
  Steps steps = chain.steps;
  std::rotate(steps.begin(),
              steps.begin() + static_cast<std::ptrdiff_t>(result->start),
              steps.end());
  std::vector<DigitalSegment> greedy;
  for (const SegmentState& s : states_by_letters(steps, chain.connectivity))
    greedy.push_back(s.segment());
  EXPECT_EQ(result->segments, greedy) << text_of(chain.steps);
  return result->segments.size();
}

TEST(ReverseExact, ClosedChainsStartWhereTheFewestSegmentsAre) {
  std::mt19937 random(3);
  std::size_t not_least = 0;
  for (int i = 0; i < 300; ++i) {
    Chain chain{{}, Connectivity::four, true, {}};
    if (i % 2 == 0) chain.connectivity = Connectivity::eight;
    chain.steps = testing::random_chain(random, chain.connectivity);
    chain.steps.resize(std::min<std::size_t>(chain.steps.size(), 150));
    const std::size_t least = fewest_of_all_starts(chain);
    const std::size_t found = closed_segments(chain);
    ASSERT_LE(found, least + 1) << text_of(chain.steps);
    if (found > least) ++not_least;
  }
  EXPECT_EQ(not_least, 0U);
}

TEST(ReverseExact, AClosedChainThatIsOneLineIsOneLap) {
  const Chain chain{{}, Connectivity::eight, true, Steps(5, 3)};
  const auto result = reverse_exact(chain);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->segments,
            (std::vector<DigitalSegment>{{3, 3, 5, 0, 1, 0}}));
  EXPECT_TRUE(
      reverse_exact({{}, Connectivity::eight, true, {}})->segments.empty());
}

TEST(ReverseExact, ContoursOfRealDrawings) {
  for (const char* name : {"crown.png", "molecule-8bit.png", "glyph.pbm"}) {
    auto bytes =
        read_file(std::string(UNSTEP_SOURCE_DIR "/samples/") + name, 1 << 24);
    ASSERT_TRUE(bytes);
    RasterReadOptions options;
    options.threshold = {Threshold::Kind::fixed, 128};
    auto reader = RasterReader::open(std::move(*bytes), options);
    ASSERT_TRUE(reader) << reader.error().message;
    const auto page = reader->read(0);
    ASSERT_TRUE(page) << page.error().message;
    const Status traced = trace_contours(page->ink, [](const Chain& contour) {
      check_open(contour.steps, contour.connectivity);
      closed_segments(contour);
      return true;
    });
    EXPECT_TRUE(traced);
  }
}

}  // namespace
}  // namespace unstep
