#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vector_testing.h"

namespace unstep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using namespace vector_testing;

std::string svg(const Drawing& drawing, const PageInfo& info = {}) {
  return write(VectorFormat::svg, drawing, info).text;
}

/// The d of a drawing of these paths, 100 x 50, y down.
std::string data_of(std::vector<Path> paths, std::int32_t scale = 1) {
  Drawing drawing{
      {100, 50, YAxis::down}, {}, std::move(paths), scale, Paint::fill};
  const std::string text = svg(drawing);
  const std::size_t begin = text.find(" d=\"") + 4;
  return text.substr(begin, text.find('"', begin) - begin);
}

TEST(SvgWriter, WritesFilledPathsAsOneEvenOddPath) {
  Drawing drawing{{100, 50, YAxis::down}, {}, {}, 1, Paint::fill};
  drawing.paths = {square({10, 10}, 30), square({20, 20}, 10)};
  EXPECT_EQ(svg(drawing),
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 100 "
            "50\"><path fill-rule=\"evenodd\" d=\"m10 10h30v30h-30zm10 "
            "10h10v10h-10z\"/></svg>\n");
}

TEST(SvgWriter, WritesChainsAsRuns) {
  Drawing drawing{{4, 3, YAxis::down}, {}, {}, 1, Paint::fill};
  drawing.chains = {
      {{1, 1}, Connectivity::four, true, {0, 0, 6, 6, 4, 4, 2, 2}}};
  EXPECT_THAT(svg(drawing), HasSubstr("d=\"m1 1h2v2h-2z\""));
}

TEST(SvgWriter, JoinsNumbersThatNeedNoSeparator) {
  EXPECT_EQ(data_of({{{0, 0},
                      true,
                      0,
                      {line(5, -3), line(-4, 9), line(7, 7), line(-8, -13)}}}),
            "m0 0 5-3-4 9 7 7z");
  EXPECT_EQ(
      data_of({{{5, 5}, true, 0, {line(5, -5), line(-50, 95), line(45, -90)}}},
              10),
      "m.5.5.5-.5-5 9.5z");
}

TEST(SvgWriter, PutsOtherScalesThanPowersOfTenIntoATransform) {
  Drawing drawing{
      {100, 50, YAxis::down}, {}, {square({1, 1}, 16)}, 16, Paint::fill};
  EXPECT_THAT(svg(drawing), HasSubstr("viewBox=\"0 0 100 50\""));
  EXPECT_THAT(svg(drawing),
              HasSubstr("transform=\"scale(0.0625)\" d=\"m1 1h16v16h-16z\""));
}

TEST(SvgWriter, WritesArcsWithTheRadiusAndTheSideOfTheCentre) {
  // A quarter, clockwise with y up: from (5, 0) of the circle to (0, -5),
  // which y down shows above.
  EXPECT_EQ(
      data_of(
          {{{10, 10}, true, 0, {arc({-5, 0}, {-5, -5}, true), line(5, 5)}}}),
      "m10 10a5 5 0 0 0-5-5z");
  EXPECT_EQ(
      data_of(
          {{{10, 10}, true, 0, {arc({-5, 0}, {-5, -5}, false), line(5, 5)}}}),
      "m10 10a5 5 0 1 1-5-5z");
  EXPECT_EQ(data_of({{{10, 10}, true, 0, {arc({-5, 0}, {0, 0}, false)}}}),
            "m10 10a5 5 0 0 1-10 0 5 5 0 0 1 10 0z");
}

TEST(SvgWriter, TurnsDrawingsWithYUp) {
  Drawing drawing{{20, 20, YAxis::up}, {}, {}, 1, Paint::fill};
  drawing.paths = {
      {{5, 0}, true, 0, {arc({-5, 0}, {-5, 5}, false), line(5, -5)}}};
  EXPECT_THAT(svg(drawing), HasSubstr("d=\"m5 20a5 5 0 0 0-5-5z\""));
}

TEST(SvgWriter, WritesOnePathForEachWidthOfPen) {
  Drawing drawing{{20, 20, YAxis::down}, {}, {}, 1, Paint::stroke};
  drawing.paths = {{{1, 1}, false, 2, {line(5, 5)}},
                   {{8, 8}, false, 2, {line(1, 5)}},
                   {{1, 2}, false, 0, {line(5, 5)}}};
  const std::string start =
      "<path fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\" ";
  EXPECT_THAT(
      svg(drawing),
      HasSubstr(start + "stroke-width=\"2\" d=\"m1 1 5 5m2 2 1 5\"/>" + start +
                "vector-effect=\"non-scaling-stroke\" d=\"m1 2 5 "
                "5\"/></svg>"));
}

TEST(SvgWriter, KeepsOpenPathsOfAFilledDrawingOutOfTheFill) {
  Drawing drawing{{20, 20, YAxis::down}, {}, {}, 1, Paint::fill};
  drawing.paths = {
      square({1, 1}, 3), {{0, 0}, false, 0, {line(5, 5)}}, square({9, 9}, 3)};
  const Written written = write(VectorFormat::svg, drawing);
  EXPECT_THAT(written.text, HasSubstr("d=\"m1 1h3v3h-3zm8 8h3v3h-3z\"/>"));
  EXPECT_THAT(written.text, HasSubstr("d=\"m0 0 5 5\"/></svg>"));
  EXPECT_THAT(written.notes,
              ElementsAre("open paths of a filled drawing are written as "
                          "strokes"));
}

TEST(SvgWriter, WritesThePhysicalSize) {
  const Drawing drawing{{1728, 1100, YAxis::down}, {}, {}, 1, Paint::fill};
  PageInfo info;
  info.resolution = {{204, 1}, {98, 1}, Resolution::Unit::inch};
  EXPECT_THAT(svg(drawing, info),
              HasSubstr(" width=\"8.47058824in\" height=\"11.2244898in\" "
                        "preserveAspectRatio=\"none\" viewBox=\"0 0 1728 "
                        "1100\""));
  info.resolution = {{10, 1}, {10, 1}, Resolution::Unit::centimetre};
  EXPECT_THAT(svg(drawing, info), HasSubstr(" width=\"172.8cm\" "
                                            "height=\"110cm\" viewBox"));
  info.resolution = {{4000, 1}, {4000, 1}, Resolution::Unit::metre};
  EXPECT_THAT(svg(drawing, info), HasSubstr(" width=\"432mm\" "
                                            "height=\"275mm\" viewBox"));
}

TEST(SvgWriter, WritesNamesAndMetadataAsXml) {
  PageInfo info;
  info.name = "a <b> & \"c\"\x01";
  info.metadata = {{"tiff:Artist", "line\nbreak"}};
  const Drawing drawing{{1, 1, YAxis::down}, {}, {}, 1, Paint::fill};
  const Written written = write(VectorFormat::svg, drawing, info);
  EXPECT_THAT(written.text,
              HasSubstr("<title>a &lt;b&gt; &amp; &quot;c&quot;</title>"
                        "<metadata xmlns:u=\"urn:unstep\"><u:entry "
                        "key=\"tiff:Artist\">line&#10;break</u:entry>"
                        "</metadata>"));
  EXPECT_THAT(written.notes, ElementsAre(HasSubstr("control characters")));
}

TEST(SvgWriter, ShowsAllOfADrawingWithoutSize) {
  Drawing drawing{
      {0, 0, YAxis::down}, {}, {square({-5, -7}, 20)}, 1, Paint::fill};
  EXPECT_THAT(svg(drawing), HasSubstr("viewBox=\"-5 -7 20 20\""));
}

TEST(VectorWriter, RefusesWhatIsNotADrawing) {
  const auto error = [](const Drawing& drawing) {
    Result<VectorWriter> writer = VectorWriter::create(
        VectorFormat::svg, [](std::string_view) { return Status{}; });
    const Status added = writer->add_page(drawing, {});
    EXPECT_FALSE(added);
    EXPECT_FALSE(writer->finish());
    return added ? "" : added.error().message;
  };
  Drawing drawing{{9, 9, YAxis::down}, {}, {}, 1, Paint::fill};
  drawing.paths = {{{0, 0}, true, 0, {line(1, 0)}}};
  EXPECT_EQ(error(drawing), "a closed path that does not return to its origin");
  drawing.paths = {{{0, 0}, false, 0, {arc({0, 0}, {1, 1}, true)}}};
  EXPECT_EQ(error(drawing), "an arc without a radius");
  drawing.paths = {{{kMaxCoord, 0}, false, 0, {line(1, 0)}}};
  EXPECT_THAT(error(drawing), HasSubstr("leaves the coordinate range"));
  drawing.paths = {};
  drawing.scale = 0;
  EXPECT_EQ(error(drawing), "a scale outside 1 to 1048576");
}

TEST(VectorWriter, HandsTheErrorOfTheSinkOn) {
  Result<VectorWriter> writer =
      VectorWriter::create(VectorFormat::svg, [](std::string_view) -> Status {
        return Error{ErrorCode::io_error, "disk full"};
      });
  Drawing drawing{{9, 9, YAxis::down}, {}, {square({1, 1}, 3)}, 1, Paint::fill};
  EXPECT_TRUE(writer->add_page(drawing, {}));
  const Status finished = writer->finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().message, "disk full");
}

}  // namespace
}  // namespace unstep
