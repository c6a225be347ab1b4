#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vector_testing.h"

namespace unstep {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using namespace vector_testing;

std::vector<Path> paths(const std::string& text) {
  return read(VectorFormat::hpgl, text).drawing.paths;
}

PageInfo plotter_units() {
  PageInfo info;
  info.resolution = {{1016, 1}, {1016, 1}, Resolution::Unit::inch};
  return info;
}

TEST(HpglWriter, WritesWhatTheReaderReads) {
  Drawing drawing{{0, 0, YAxis::up}, {}, {}, 1, Paint::stroke};
  drawing.paths = {{{1, 2}, false, 0, {line(3, 4), line(5, 0)}},
                   {{100, 100}, false, 0, {arc({-50, 0}, {-50, 50}, false)}},
                   {{100, 100}, true, 0, {arc({-50, 0}, {0, 0}, true)}},
                   {{200, 200},
                    true,
                    0,
                    {line(100, 0), arc({0, 50}, {0, 100}, false), line(-100, 0),
                     arc({0, -50}, {0, -100}, false)}},
                   {{7, 7}, false, 0, {}},
                   {{9, 9}, false, 20, {line(30, 1)}}};
  const Written written = write(VectorFormat::hpgl, drawing, plotter_units());
  EXPECT_THAT(written.notes, IsEmpty());
  const VectorPage page = read(VectorFormat::hpgl, written.text);
  EXPECT_EQ(page.drawing, drawing) << written.text;
  EXPECT_EQ(page.info, plotter_units());
}

TEST(HpglWriter, WritesTheDocumentedForm) {
  Drawing drawing{
      {10, 10, YAxis::down}, {}, {square({1, 1}, 3)}, 1, Paint::fill};
  const Written written = write(VectorFormat::hpgl, drawing);
  EXPECT_EQ(written.text,
            "IN;SP1;\nPU10,90;PD40,90,40,60,10,60,10,90;\nPU;\nSP0;\n");
  EXPECT_THAT(written.notes,
              ElementsAre("HPGL has no even-odd fill: filled areas are "
                          "outlines",
                          "no resolution: a grid unit is 0.25 mm"));
}

TEST(HpglWriter, SaysWhenItRounds) {
  Drawing drawing{{0, 0, YAxis::up}, {}, {}, 1, Paint::stroke};
  drawing.paths = {{{1, 2}, false, 0, {line(3, 40000)}}};
  PageInfo info;
  info.resolution = {{300, 1}, {300, 1}, Resolution::Unit::inch};
  EXPECT_THAT(write(VectorFormat::hpgl, drawing, info).notes,
              ElementsAre("coordinates are rounded to 1/40 mm",
                          "coordinates above 32767, too large for some "
                          "plotters"));
}

TEST(HpglReader, ReadsPensUpAndDown) {
  const std::vector<Path> expected{{{1, 2}, false, 0, {line(3, 4), line(5, 0)}},
                                   {{50, 60}, false, 0, {line(1, 1)}}};
  EXPECT_EQ(paths("IN;SP1;PU1,2;PD4,6,9,6;PU50,60;PD51,61;PU;"), expected);
  EXPECT_EQ(paths("in pa1 2 pd pa4,6 pa 9 6 pu pa50,60 pd51,61 sp"), expected);
  EXPECT_EQ(paths("PA;PU1,2;PD;PR3,4,5,0;PU;PR41,54;PD1,1"), expected);
}

TEST(HpglReader, ReadsCirclesArcsAndRectangles) {
  EXPECT_EQ(
      paths("PU10,20CI5;"),
      (std::vector<Path>{{{15, 20}, true, 0, {arc({-5, 0}, {0, 0}, false)}}}));
  EXPECT_EQ(paths("PU10,0PDAA0,0,90;"),
            (std::vector<Path>{
                {{10, 0}, false, 0, {arc({-10, 0}, {-10, 10}, false)}}}));
  EXPECT_EQ(paths("PU10,0PDAR-10,0,-90;"),
            (std::vector<Path>{
                {{10, 0}, false, 0, {arc({-10, 0}, {-10, -10}, true)}}}));
  EXPECT_EQ(paths("PU1,1EA3,4"),
            (std::vector<Path>{
                {{1, 1},
                 true,
                 0,
                 {line(2, 0), line(0, 3), line(-2, 0), line(0, -3)}}}));
}

/// A number of PE: digits of `base`, the last one from `last` on.
std::string encoded(int value, int base, int last) {
  unsigned left = value < 0 ? static_cast<unsigned>(-value) * 2 + 1
                            : static_cast<unsigned>(value) * 2;
  std::string text;
  for (; left >= static_cast<unsigned>(base);
       left /= static_cast<unsigned>(base)) {
    text += static_cast<char>(63 + left % static_cast<unsigned>(base));
  }
  text += static_cast<char>(last + static_cast<int>(left));
  return text;
}

TEST(HpglReader, ReadsEncodedLines) {
  const std::vector<Path> expected{
      {{100, 200}, false, 0, {line(3, -400), line(-5, 0)}},
      {{-10, 5}, false, 0, {line(1, 1)}}};
  for (const bool seven : {false, true}) {
    const auto pair = [seven](int x, int y) {
      return encoded(x, seven ? 32 : 64, seven ? 95 : 191) +
             encoded(y, seven ? 32 : 64, seven ? 95 : 191);
    };
    const std::string text = std::string("IN;PE") + (seven ? "7" : "") +
                             "<=" + pair(100, 200) + pair(3, -400) +
                             pair(-5, 0) + "<=" + pair(-10, 5) + "\n" +
                             pair(1, 1) + ";PU;";
    EXPECT_EQ(paths(text), expected) << seven;
  }
  const auto fault = read_vector("IN;PE=\x01\x7f;", VectorFormat::hpgl, {});
  ASSERT_FALSE(fault);
  EXPECT_EQ(fault.error().message, "byte 3: a fault in encoded lines");
}

TEST(HpglReader, KeepsUserUnitsAndTheirSize) {
  const VectorPage page = read(
      VectorFormat::hpgl, "IN;IP0,0,4000,4000;SC0,100,0,100;PU1,2;PD3.5,4;PU;");
  EXPECT_EQ(page.drawing.scale, 2);
  EXPECT_EQ(page.drawing.paths.at(0), (Path{{2, 4}, false, 0, {line(5, 4)}}));
  EXPECT_EQ(page.info.resolution,
            (Resolution{{127, 5}, {127, 5}, Resolution::Unit::inch}));
}

TEST(HpglReader, SplitsPagesAndSkipsLabels) {
  const auto pages =
      read_vector("\x1b.(;IN;PD1,1;LBPU no;\x03PU;PG;IN;PU5,5;PD6,6;QQ1,2;",
                  VectorFormat::hpgl, {});
  ASSERT_TRUE(pages) << pages.error().message;
  ASSERT_EQ(pages->size(), 2U);
  EXPECT_EQ((*pages)[0].drawing.paths.size(), 1U);
  EXPECT_THAT((*pages)[0].notes, Contains("1 LB left out"));
  EXPECT_THAT((*pages)[1].notes, Contains("1 QQ left out"));
}

TEST(HpglReader, NamesThePlaceOfErrors) {
  const auto error = [](const std::string& text) {
    const auto pages = read_vector(text, VectorFormat::hpgl, {});
    return pages ? "no error" : pages.error().message;
  };
  EXPECT_EQ(error("IN;PD1;"), "byte 3: a coordinate without its pair");
  EXPECT_EQ(error("IN;PD1,2,*;"), "byte 9: expected a number");
  EXPECT_EQ(error("IN;AA1,2;"), "byte 3: expected 3 numbers");
  EXPECT_EQ(error("IN;P;"), "byte 3: expected an instruction of two letters");
  EXPECT_THAT(error("PD2000000000,0"), HasSubstr("a coordinate beyond"));
  EXPECT_EQ(read_vector("%PDF", VectorFormat::hpgl, {}).error().code,
            ErrorCode::bad_magic);
}

}  // namespace
}  // namespace unstep
