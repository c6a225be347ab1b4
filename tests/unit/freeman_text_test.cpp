#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "unstep/formats.h"

namespace unstep {
namespace {

Drawing parse(std::string_view text) {
  Result<Drawing> drawing = parse_freeman(text, {});
  EXPECT_TRUE(drawing) << drawing.error().message;
  return drawing ? std::move(*drawing) : Drawing{};
}

std::string error_of(std::string_view text, const DecodeLimits& limits = {}) {
  const Result<Drawing> drawing = parse_freeman(text, limits);
  return drawing ? "no error" : drawing.error().message;
}

TEST(FreemanText, ReadsTheDocumentedForms) {
  const Drawing drawing = parse(
      "# a square and two lines\r\n"
      "canvas 100 50 up\r\n"
      "closed4 10 10: 00 22\n"
      "  44 66  # back\n"
      "open8 -5 7:0123 open8 0 0:\n"
      "\tclosed8\t1 1 : 04\n");
  EXPECT_EQ(drawing.canvas, (Canvas{100, 50, YAxis::up}));
  ASSERT_EQ(drawing.chains.size(), 4U);
  EXPECT_EQ(
      drawing.chains[0],
      (Chain{{10, 10}, Connectivity::four, true, {0, 0, 2, 2, 4, 4, 6, 6}}));
  EXPECT_EQ(drawing.chains[1],
            (Chain{{-5, 7}, Connectivity::eight, false, {0, 1, 2, 3}}));
  EXPECT_EQ(drawing.chains[2], (Chain{{0, 0}, Connectivity::eight, false, {}}));
  EXPECT_EQ(drawing.chains[3],
            (Chain{{1, 1}, Connectivity::eight, true, {0, 4}}));
}

TEST(FreemanText, TakesAnUnboundedCanvasWithYDownIfNoneIsGiven) {
  EXPECT_EQ(parse("").canvas, (Canvas{0, 0, YAxis::down}));
  EXPECT_EQ(parse("canvas 3 4").canvas, (Canvas{3, 4, YAxis::down}));
  EXPECT_EQ(parse("# only a comment").chains.size(), 0U);
}

TEST(FreemanText, NamesLineAndColumnOfErrors) {
  EXPECT_EQ(error_of("open8 1 2: 08"),
            "line 1, column 13: expected a step, 0 to 7");
  EXPECT_EQ(error_of("# x\nopen4 1 2: 01"),
            "line 2, column 13: odd step in a 4-connected chain");
  EXPECT_EQ(error_of("closed8 1 2: 00"),
            "line 1, column 1: closed chain ends at 3 2, not at its origin");
  EXPECT_EQ(error_of("\n\nopen 1 2:"), "line 3, column 1: unknown keyword");
  EXPECT_EQ(error_of("open8 1:"), "line 1, column 8: expected a y coordinate");
  EXPECT_EQ(error_of("open8 1 2 0"),
            "line 1, column 11: expected ':' before the steps");
  EXPECT_EQ(error_of("open8 1 1073741824:"),
            "line 1, column 9: a y coordinate out of range; it is -1073741823 "
            "to 1073741823");
  EXPECT_EQ(error_of("open8 1 99999999999999999999:").substr(0, 46),
            "line 1, column 9: a y coordinate out of range;");
  EXPECT_EQ(error_of("open8 1073741823 0: 40\n0"),
            "line 2, column 1: the step leaves the coordinate range of "
            "-1073741823 to 1073741823");
  EXPECT_EQ(error_of("open8 1 2: 0\ncanvas 1 1"),
            "line 2, column 1: the canvas is given once, before the first "
            "chain");
  EXPECT_EQ(error_of("canvas 1 1 sideways"),
            "line 1, column 12: expected up, down or the end of the line");
  EXPECT_EQ(error_of("canvas 1 1 up 7"),
            "line 1, column 15: expected the end of the line");
  EXPECT_EQ(error_of("0123").substr(0, 36),
            "line 1, column 1: expected a keyword");
  EXPECT_EQ(error_of("open8 0 0: 1\x01").substr(0, 37),
            "line 1, column 13: expected a step, 0");
}

TEST(FreemanText, ChecksTheLimitsBeforeItAllocates) {
  DecodeLimits limits;
  limits.max_steps = 5;
  EXPECT_EQ(error_of("open8 0 0: 000\nopen8 0 0: 000", limits),
            "line 2, column 1: more than the limit of 5 steps");
  limits = {};
  limits.max_memory = 1000;
  EXPECT_NE(error_of("open8 0 0: " + std::string(2000, '0'), limits)
                .find("memory limit"),
            std::string::npos);
  std::string many;
  for (int i = 0; i < 100; ++i) many += "open8 0 0:\n";
  EXPECT_NE(error_of(many, limits).find("memory limit"), std::string::npos);
}

Chain random_chain(std::mt19937& random) {
  Chain chain;
  chain.connectivity =
      random() % 2 == 0 ? Connectivity::four : Connectivity::eight;
  chain.closed = random() % 2 == 0;
  chain.origin = {static_cast<std::int32_t>(random() % 2000) - 1000,
                  static_cast<std::int32_t>(random() % 2000) - 1000};
  const std::size_t length = random() % 200;
  const bool four = chain.connectivity == Connectivity::four;
  for (std::size_t i = 0; i < length; ++i) {
    chain.steps.push_back(
        static_cast<Step>(four ? random() % 4 * 2 : random() % 8));
  }
  if (chain.closed) {  // retrace
    for (std::size_t i = length; i-- > 0;) {
      chain.steps.push_back(static_cast<Step>((chain.steps[i] + 4) % 8));
    }
  }
  return chain;
}

TEST(FreemanText, WritesWhatItReadsBackEqual) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    Drawing drawing;
    drawing.canvas = {static_cast<std::int32_t>(random() % 1000),
                      static_cast<std::int32_t>(random() % 1000),
                      random() % 2 == 0 ? YAxis::up : YAxis::down};
    for (std::size_t n = random() % 5; n > 0; --n) {
      drawing.chains.push_back(random_chain(random));
    }
    EXPECT_EQ(parse(write_freeman(drawing)), drawing) << write_freeman(drawing);
  }
}

TEST(FreemanText, WritesTheExtremesOfTheRange) {
  Drawing drawing;
  drawing.canvas = {kMaxCoord, kMaxCoord, YAxis::up};
  drawing.chains.push_back(
      {{kMaxCoord, -kMaxCoord}, Connectivity::eight, false, {3, 7}});
  drawing.chains.push_back(
      {{-kMaxCoord, kMaxCoord}, Connectivity::four, true, {}});
  EXPECT_EQ(parse(write_freeman(drawing)), drawing);
}

TEST(FreemanText, WrapsLongChains) {
  Drawing drawing;
  drawing.chains.push_back(
      {{0, 0}, Connectivity::eight, false, std::vector<Step>(1000, 7)});
  const std::string text = write_freeman(drawing);
  std::size_t longest = 0;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
    end = text.find('\n', at);
    longest = std::max(longest, end - at);
  }
  EXPECT_LE(longest, 80U);
  EXPECT_EQ(parse(text), drawing);
}

TEST(FreemanText, SurvivesTruncationAndFlippedBits) {
  const std::string good = "canvas 9 9 up\nclosed4 1 2: 0246\nopen8 -3 4: 17\n";
  for (std::size_t size = 0; size < good.size(); ++size) {
    (void)parse_freeman(good.substr(0, size), {});
  }
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    std::string bad = good;
    bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ 1 << bit % 8);
    const Result<Drawing> drawing = parse_freeman(bad, {});
    if (!drawing) {
      EXPECT_TRUE(drawing.error().message.starts_with("line ")) << bad;
    }
  }
}

}  // namespace
}  // namespace unstep
