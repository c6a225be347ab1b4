#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "vector_testing.h"

namespace unstep {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using namespace vector_testing;

/// Lines from words: "0 LINE 10 1.5" and so on.
std::string lines(std::string words) {
  for (char& c : words) {
    if (c == ' ') c = '\n';
  }
  return words + "\n";
}

std::string entities(const std::string& words) {
  return lines("0 SECTION 2 ENTITIES " + words + " 0 ENDSEC 0 EOF");
}

Drawing dxf(const std::string& words) {
  return read(VectorFormat::dxf, entities(words)).drawing;
}

std::string error_of(const std::string& text) {
  const auto pages = read_vector(text, VectorFormat::dxf, {});
  return pages ? "no error" : pages.error().message;
}

Drawing pens() {
  Drawing drawing{{100, 80, YAxis::up}, {}, {}, 1, Paint::stroke};
  drawing.paths = {
      {{1, 2}, false, 0, {line(3, 4)}},
      {{10, 10}, false, 0, {arc({-5, 0}, {-5, 5}, false)}},
      {{10, 10}, true, 0, {arc({-5, 0}, {0, 0}, true)}},
      {{20, 20},
       true,
       2,
       {line(10, 0), arc({0, 5}, {0, 10}, false), line(-10, 0),
        arc({0, -5}, {0, -10}, false)}},
      {{50, 50}, false, 0, {line(3, -4), arc({0, 9}, {9, 9}, false)}},
      {{7, 7}, false, 0, {}}};
  return drawing;
}

TEST(DxfWriter, WritesWhatTheReaderReads) {
  const Written written = write(VectorFormat::dxf, pens());
  EXPECT_THAT(written.notes, IsEmpty());
  const VectorPage page = read(VectorFormat::dxf, written.text);
  EXPECT_THAT(page.notes, IsEmpty());
  Drawing expected = pens();
  // A circle has no side where it begins or that it turns to.
  expected.paths[2] = {{10, 10}, true, 0, {arc({-5, 0}, {0, 0}, false)}};
  EXPECT_EQ(page.drawing, expected);
}

TEST(DxfWriter, TurnsRastersAndNamesWhatIsLost) {
  Drawing drawing{
      {100, 80, YAxis::down}, {}, {square({0, 0}, 10)}, 1, Paint::fill};
  PageInfo info;
  info.name = "a";
  info.metadata = {{"b", "c"}};
  const Written written = write(VectorFormat::dxf, drawing, info);
  EXPECT_EQ(written.notes.size(), 3U);
  EXPECT_THAT(written.notes,
              Contains("DXF has no even-odd fill: filled areas are outlines"));
  const Drawing back = read(VectorFormat::dxf, written.text).drawing;
  EXPECT_EQ(back.canvas, (Canvas{100, 80, YAxis::up}));
  ASSERT_EQ(back.paths.size(), 1U);
  EXPECT_EQ(back.paths[0],
            (Path{{0, 80},
                  true,
                  0,
                  {line(10, 0), line(0, -10), line(-10, 0), line(0, 10)}}));
}

TEST(DxfWriter, WritesMillimetresOrInches) {
  const Drawing drawing{{1000, 500, YAxis::up},
                        {},
                        {{{300, 150}, false, 0, {line(3, 6)}}},
                        1,
                        Paint::stroke};
  PageInfo info;
  info.resolution = {{300, 1}, {300, 1}, Resolution::Unit::inch};
  const VectorPage inches =
      read(VectorFormat::dxf, write(VectorFormat::dxf, drawing, info).text);
  EXPECT_EQ(inches.info.resolution,
            (Resolution{{1, 1}, {1, 1}, Resolution::Unit::inch}));
  EXPECT_EQ(inches.drawing.scale, 100);
  EXPECT_EQ(inches.drawing.paths.at(0),
            (Path{{100, 50}, false, 0, {line(1, 2)}}));
  info.resolution = {{100, 1}, {100, 1}, Resolution::Unit::centimetre};
  const std::string text = write(VectorFormat::dxf, drawing, info).text;
  EXPECT_THAT(text, HasSubstr("$INSUNITS\n70\n4\n"));
  EXPECT_THAT(text, HasSubstr("10\n30.0\n20\n15.0\n11\n30.3\n21\n15.6\n"));
}

TEST(DxfWriter, WritesChainsAsPolylines) {
  Drawing drawing{{9, 9, YAxis::up}, {}, {}, 1, Paint::stroke};
  drawing.chains = {{{1, 1}, Connectivity::eight, false, {0, 0, 1, 1, 1}}};
  EXPECT_EQ(read(VectorFormat::dxf, write(VectorFormat::dxf, drawing).text)
                .drawing.paths,
            (std::vector<Path>{{{1, 1}, false, 0, {line(2, 0), line(3, 3)}}}));
}

TEST(DxfReader, ReadsLightPolylinesWithBulges) {
  EXPECT_EQ(dxf("0 LWPOLYLINE 8 0 90 3 70 1 43 2.0 10 0 20 0 10 10.0 20 0.0 "
                "42 1.0 10 10 20 10")
                .paths,
            (std::vector<Path>{
                {{0, 0},
                 true,
                 2,
                 {line(10, 0), arc({0, 5}, {0, 10}, false), line(-10, -10)}}}));
}

TEST(DxfReader, RoundsTheEndsOfArcsAsCurves) {
  const Drawing drawing =
      dxf("0 ARC 8 0 10 0 20 0 40 100 50 30 51 60 0 LINE 8 0 10 0 20 0 11 100 "
          "21 100");
  // The line is whole; the arc does not ask for more than a tenth of a
  // thousandth of the side.
  EXPECT_EQ(drawing.scale, 100);
  const Arc& made = drawing.paths.at(0).elements.at(0).arc;
  EXPECT_EQ(drawing.paths[0].origin, (Point{8660, 5000}));
  EXPECT_EQ(made.centre, (Point{-8660, -5000}));
  EXPECT_FALSE(made.clockwise);
}

TEST(DxfReader, FlattensEllipsesAndSplines) {
  const Drawing ellipse =
      dxf("0 ELLIPSE 8 0 10 0 20 0 11 50 21 0 40 0.5 41 0.0 42 "
          "6.283185307179586");
  ASSERT_EQ(ellipse.paths.size(), 1U);
  EXPECT_TRUE(ellipse.paths[0].closed);
  EXPECT_GT(ellipse.paths[0].elements.size(), 20U);
  // One Bezier as a spline: the middle is known.
  const Drawing spline = dxf(
      "0 SPLINE 8 0 70 8 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 "
      "0 10 0 20 80 10 80 20 80 10 80 20 0");
  ASSERT_EQ(spline.paths.size(), 1U);
  std::int32_t highest = 0, y = spline.paths[0].origin.y;
  for (const Path::Element& element : spline.paths[0].elements) {
    highest = std::max(highest, y += element.segment.dy);
  }
  EXPECT_NEAR(static_cast<double>(highest) / spline.scale, 60, 0.1);
}

TEST(DxfReader, InsertsBlocks) {
  const std::string text = lines(
      "0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 1 20 1 0 LINE 8 0 10 1 20 1 11 3 21 "
      "1 0 ENDBLK 0 ENDSEC 0 SECTION 2 ENTITIES 0 INSERT 8 0 2 B 10 10 20 10 "
      "41 2 42 2 50 90 0 INSERT 2 B 8 0 70 2 44 5 0 INSERT 2 Z 0 ENDSEC 0 EOF");
  const VectorPage page = read(VectorFormat::dxf, text);
  EXPECT_EQ(page.drawing.paths,
            (std::vector<Path>{{{10, 10}, false, 0, {line(0, 4)}},
                               {{0, 0}, false, 0, {line(2, 0)}},
                               {{5, 0}, false, 0, {line(2, 0)}}}));
  EXPECT_THAT(page.notes, Contains("1 INSERT of an unknown block left out"));
}

TEST(DxfReader, EndsBlocksInThemselves) {
  const std::string text = lines(
      "0 SECTION 2 BLOCKS 0 BLOCK 2 B 0 INSERT 2 B 0 INSERT 2 B 0 ENDBLK 0 "
      "ENDSEC 0 SECTION 2 ENTITIES 0 INSERT 2 B 0 ENDSEC 0 EOF");
  EXPECT_THAT(error_of(text), HasSubstr("blocks in blocks more than 32 deep"));
}

TEST(DxfReader, MirrorsEntitiesSeenFromBehind) {
  EXPECT_EQ(dxf("0 CIRCLE 8 0 10 10 20 5 40 2 230 -1").paths.at(0).origin,
            (Point{-12, 5}));
}

TEST(DxfReader, NamesWhatItLeavesOut) {
  const VectorPage page =
      read(VectorFormat::dxf,
           entities("0 TEXT 8 a 0 HATCH 8 b 0 LINE 8 a 67 1 0 3DFACE 8 0"));
  EXPECT_THAT(page.notes, Contains("1 TEXT left out"));
  EXPECT_THAT(page.notes, Contains("1 HATCH left out"));
  EXPECT_THAT(page.notes, Contains("layers are merged"));
  EXPECT_THAT(page.notes, Contains("1 entity of paper space left out"));
}

TEST(DxfReader, NamesThePlaceOfErrors) {
  EXPECT_EQ(error_of(lines("0 SECTION 2 ENTITIES 0 LINE 8")),
            "line 7: the file ends before its EOF");
  EXPECT_EQ(error_of(lines("0 SECTION 2 ENTITIES x LINE 8 0")),
            "line 5: expected the number of a group");
  EXPECT_THAT(error_of(entities("0 LINE 8 0 10 2e9 20 0")),
              HasSubstr("a coordinate beyond"));
  EXPECT_EQ(read_vector("<svg/>", VectorFormat::dxf, {}).error().code,
            ErrorCode::bad_magic);
  EXPECT_EQ(
      read_vector("AutoCAD Binary DXF\r\n", VectorFormat::dxf, {}).error().code,
      ErrorCode::unsupported);
}

}  // namespace
}  // namespace unstep
