#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "vector_testing.h"

namespace unstep {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using namespace vector_testing;

VectorPage svg(const std::string& body, const std::string& attributes = "",
               const VectorReadOptions& options = {}) {
  return read(VectorFormat::svg,
              "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" +
                  body + "</svg>",
              options);
}

std::vector<Path> paths(const std::string& body) {
  return svg(body).drawing.paths;
}

std::string error_of(const std::string& body) {
  const auto pages =
      read_vector("<svg>" + body + "</svg>", VectorFormat::svg, {});
  return pages ? "no error" : pages.error().message;
}

/// A path of that data, stroked by a pen of width 1.
std::vector<Path> stroked(const std::string& data) {
  return paths("<path fill='none' stroke='#000' d='" + data + "'/>");
}

TEST(SvgReader, ReadsAbsoluteAndRelativeLines) {
  const std::vector<Path> expected{
      {{1, 2}, false, 1, {line(3, 4), line(5, 0), line(0, 6), line(-1, -1)}}};
  EXPECT_EQ(stroked("M1 2 4 6H9V12L8 11"), expected);
  EXPECT_EQ(stroked("m1,2 3,4h5v6l-1-1"), expected);
  EXPECT_EQ(stroked(" M 1 2 l 3 +4 h.5e1 v 6 -1 l 0 0"),
            (std::vector<Path>{{{1, 2},
                                false,
                                1,
                                {line(3, 4), line(5, 0), line(0, 6),
                                 line(0, -1), line(0, 0)}}}));
}

TEST(SvgReader, ReadsSeveralSubpaths) {
  EXPECT_EQ(stroked("m1 1h2v2zm5 5h1z"),
            (std::vector<Path>{
                {{1, 1}, true, 1, {line(2, 0), line(0, 2), line(-2, -2)}},
                {{6, 6}, true, 1, {line(1, 0), line(-1, 0)}}}));
  // After z, a line begins where the subpath began.
  EXPECT_EQ(stroked("M1 1H5V5Zl2 3"),
            (std::vector<Path>{
                {{1, 1}, true, 1, {line(4, 0), line(0, 4), line(-4, -4)}},
                {{1, 1}, false, 1, {line(2, 3)}}}));
}

TEST(SvgReader, ClosesFilledPaths) {
  EXPECT_EQ(paths("<path d='M1 1h2v2'/>"),
            (std::vector<Path>{
                {{1, 1}, true, 0, {line(2, 0), line(0, 2), line(-2, -2)}}}));
}

TEST(SvgReader, KeepsCircularArcs) {
  EXPECT_EQ(stroked("M10 10a5 5 0 0 0 -5 -5"),
            (std::vector<Path>{
                {{10, 10}, false, 1, {arc({-5, 0}, {-5, -5}, true)}}}));
  EXPECT_EQ(stroked("M10 10a5 5 0 1 1-5-5"),
            (std::vector<Path>{
                {{10, 10}, false, 1, {arc({-5, 0}, {-5, -5}, false)}}}));
  EXPECT_EQ(stroked("M10 10a5 5 0 11-5-5"),
            (std::vector<Path>{
                {{10, 10}, false, 1, {arc({-5, 0}, {-5, -5}, false)}}}));
  // A radius that does not reach grows.
  EXPECT_EQ(
      stroked("M0 0A1 1 0 0 1 10 0"),
      (std::vector<Path>{{{0, 0}, false, 1, {arc({5, 0}, {10, 0}, false)}}}));
}

TEST(SvgReader, MakesOneCircleOfTwoArcs) {
  EXPECT_EQ(
      stroked("M10 10a5 5 0 0 1 10 0 5 5 0 0 1-10 0z"),
      (std::vector<Path>{{{10, 10}, true, 1, {arc({5, 0}, {0, 0}, false)}}}));
}

TEST(SvgReader, FlattensCurvesWithinTheTolerance) {
  VectorReadOptions options;
  options.curve_tolerance = 0.25;
  const Drawing drawing =
      svg("<path d='M0 0C0 100 100 100 100 0z'/>", "", options).drawing;
  ASSERT_EQ(drawing.paths.size(), 1U);
  const Path& path = drawing.paths[0];
  EXPECT_GT(path.elements.size(), 5U);
  EXPECT_LT(path.elements.size(), 40U);
  // Every point of the curve is near a line of the path.
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0, s = 1 - t;
    const double x = (3 * s * t * t + t * t * t) * 100;
    const double y = (3 * s * s * t + 3 * s * t * t) * 100;
    double best = 1e9;
    double px = path.origin.x, py = path.origin.y;
    for (const Path::Element& element : path.elements) {
      const double dx = element.segment.dx, dy = element.segment.dy;
      const double qx = x * drawing.scale - px, qy = y * drawing.scale - py;
      const double u = std::clamp(
          (qx * dx + qy * dy) / std::max(1.0, dx * dx + dy * dy), 0.0, 1.0);
      best = std::min(best, std::hypot(qx - u * dx, qy - u * dy));
      px += dx, py += dy;
    }
    EXPECT_LE(best / drawing.scale, 0.25) << "at " << t;
  }
}

TEST(SvgReader, ReadsAllKindsOfCurves) {
  // The same parabola four times.
  VectorReadOptions options;
  options.curve_tolerance = 1;
  const auto points = [&](const std::string& data) {
    return svg("<path d='" + data + "'/>", "", options).drawing.paths;
  };
  const auto expected = points("M0 0C20 40 40 60 60 60");
  ASSERT_EQ(expected.size(), 1U);
  EXPECT_EQ(points("M0 0Q30 60 60 60"), expected);
  EXPECT_EQ(points("m0 0q30 60 60 60"), expected);
  EXPECT_EQ(points("M0 0c20 40 40 60 60 60"), expected);
  EXPECT_EQ(points("M0 0C0 10 10 20 20 20S40 30 40 40"),
            points("M0 0C0 10 10 20 20 20C30 20 40 30 40 40"));
  EXPECT_EQ(points("M0 0Q0 20 20 20T40 40"),
            points("M0 0Q0 20 20 20Q40 20 40 40"));
}

TEST(SvgReader, ReadsTheShapes) {
  EXPECT_EQ(paths("<rect x='1' y='2' width='30' height='40'/>"),
            (std::vector<Path>{
                {{1, 2},
                 true,
                 0,
                 {line(30, 0), line(0, 40), line(-30, 0), line(0, -40)}}}));
  EXPECT_EQ(paths("<polygon points='1,2 3,4, 5 2'/>"),
            (std::vector<Path>{
                {{1, 2}, true, 0, {line(2, 2), line(2, -2), line(-4, 0)}}}));
  EXPECT_EQ(paths("<polyline fill='none' stroke='red' points='1 2 3 4'/>"),
            (std::vector<Path>{{{1, 2}, false, 1, {line(2, 2)}}}));
  EXPECT_EQ(paths("<line stroke='black' x2='5' y2='1'/>"),
            (std::vector<Path>{{{0, 0}, false, 1, {line(5, 1)}}}));
  EXPECT_EQ(
      paths("<circle cx='10' cy='20' r='5'/>"),
      (std::vector<Path>{{{15, 20}, true, 0, {arc({-5, 0}, {0, 0}, false)}}}));
  EXPECT_EQ(paths("<rect width='30' height='20' rx='5'/>"),
            (std::vector<Path>{{{5, 0},
                                true,
                                0,
                                {line(20, 0), arc({0, 5}, {5, 5}, false),
                                 line(0, 10), arc({-5, 0}, {-5, 5}, false),
                                 line(-20, 0), arc({0, -5}, {-5, -5}, false),
                                 line(0, -10), arc({5, 0}, {5, -5}, false)}}}));
}

TEST(SvgReader, FlattensEllipses) {
  const Drawing drawing =
      svg("<ellipse cx='50' cy='50' rx='50' ry='25'/>").drawing;
  ASSERT_EQ(drawing.paths.size(), 1U);
  double x = drawing.paths[0].origin.x, y = drawing.paths[0].origin.y;
  for (const Path::Element& element : drawing.paths[0].elements) {
    const double ex = x / drawing.scale / 50 - 1;
    const double ey = y / drawing.scale / 25 - 2;
    EXPECT_NEAR(ex * ex + ey * ey, 1, 0.01);
    x += element.segment.dx, y += element.segment.dy;
  }
}

TEST(SvgReader, AppliesTransformations) {
  const std::string shape = "<path d='M1 1h2v3z'/>";
  const auto first = [&](const std::string& transform) {
    return paths("<g transform='" + transform + "'>" + shape + "</g>").at(0);
  };
  EXPECT_EQ(first("translate(10)").origin, (Point{11, 1}));
  EXPECT_EQ(first("translate(10,20) scale(2)").origin, (Point{12, 22}));
  EXPECT_EQ(first("scale(2 -1)").origin, (Point{2, -1}));
  EXPECT_EQ(first("matrix(0 1 -1 0 5 5)").origin, (Point{4, 6}));
  EXPECT_EQ(first("rotate(90)").elements[0], line(0, 2));
  EXPECT_EQ(first("rotate(180, 1, 1)").elements[0], line(-2, 0));
  EXPECT_EQ(first("skewX(45)").origin, (Point{2, 1}));
  EXPECT_EQ(first("skewY(45)").origin, (Point{1, 2}));
  // A mirror turns arcs.
  EXPECT_EQ(
      paths("<g transform='scale(-1 1)'><circle r='5'/></g>"),
      (std::vector<Path>{{{-5, 0}, true, 0, {arc({5, 0}, {0, 0}, true)}}}));
}

TEST(SvgReader, FlattensCirclesThatATransformationStretches) {
  const auto stretched = paths("<circle transform='scale(2 1)' r='50'/>");
  ASSERT_EQ(stretched.size(), 1U);
  EXPECT_GT(stretched[0].elements.size(), 20U);
}

TEST(SvgReader, KeepsDecimalsInTheScale) {
  EXPECT_EQ(svg("<path d='M.125 0H10.3V2'/>").drawing.scale, 1000);
  EXPECT_EQ(svg("<path d='M.125 0H10.5V2'/>").drawing.scale, 8);
  EXPECT_EQ(svg("<path d='M1 0H10V2'/>").drawing.scale, 1);
  const VectorPage page = svg("<path d='M.12345678 0H10V2'/>");
  EXPECT_EQ(page.drawing.scale, 1000000);
  EXPECT_THAT(page.notes, ElementsAre("coordinates are rounded to multiples "
                                      "of 1/1000000"));
  // Far away there is room for fewer.
  EXPECT_EQ(svg("<path d='M.12345678 0H100000V2'/>").drawing.scale, 10000);
}

TEST(SvgReader, SumsOfManyDecimalsStayDecimals) {
  std::string data = "M0 0";
  for (int i = 0; i < 10000; ++i) data += "l.1.3";
  const VectorPage page = svg("<path d='" + data + "'/>");
  EXPECT_EQ(page.drawing.scale, 10);
  EXPECT_EQ(page.drawing.paths.at(0).elements.back(), line(-10000, -30000));
  EXPECT_THAT(page.notes, IsEmpty());
}

TEST(SvgReader, ReadsPhysicalSizeAsResolution) {
  const auto info = [](const std::string& attributes) {
    return svg("", attributes).info.resolution;
  };
  EXPECT_EQ(info("width='8.47058824in' height='11.2244898in' "
                 "preserveAspectRatio='none' viewBox='0 0 1728 1100'"),
            (Resolution{{204, 1}, {98, 1}, Resolution::Unit::inch}));
  EXPECT_EQ(info("width='210mm' height='297mm' viewBox='0 0 210 297'"),
            (Resolution{{1000, 1}, {1000, 1}, Resolution::Unit::metre}));
  EXPECT_EQ(info("width='72pt' height='72pt' viewBox='0 0 300 300'"),
            (Resolution{{300, 1}, {300, 1}, Resolution::Unit::inch}));
  EXPECT_EQ(info("width='10cm' height='10cm'"),
            (Resolution{{96, 1}, {96, 1}, Resolution::Unit::inch}));
  EXPECT_FALSE(info("width='100' height='100'").known());
}

TEST(SvgReader, TakesTheCanvasFromTheViewBox) {
  const VectorPage page = svg("<path d='M5 5h1v1'/>", "viewBox='-5 3 90.5 40'");
  EXPECT_EQ(page.drawing.canvas, (Canvas{91, 40, YAxis::down}));
  EXPECT_EQ(page.drawing.paths.at(0).origin, (Point{10, 2}));
  EXPECT_THAT(page.notes, ElementsAre("the canvas is rounded up to 91 x 40"));
  EXPECT_EQ(svg("", "width='20' height='10px'").drawing.canvas,
            (Canvas{20, 10, YAxis::down}));
  EXPECT_EQ(svg("").drawing.canvas, (Canvas{0, 0, YAxis::down}));
}

TEST(SvgReader, TellsFilledFromStroked) {
  const std::string square = " d='M0 0h4v4h-4z'/>";
  EXPECT_EQ(svg("<path" + square).drawing.paint, Paint::fill);
  const Drawing pen =
      svg("<path style='fill:none;stroke:#00f;stroke-width:.5'" + square)
          .drawing;
  EXPECT_EQ(pen.paint, Paint::stroke);
  EXPECT_EQ(pen.scale, 10);
  EXPECT_EQ(pen.paths.at(0).width, 5);
  EXPECT_EQ(svg("<g fill='none' stroke='#000' stroke-width='2'><path "
                "transform='scale(3)'" +
                square + "</g>")
                .drawing.paths.at(0)
                .width,
            6);
  EXPECT_THAT(paths("<path fill='none'" + square), IsEmpty());
  EXPECT_THAT(paths("<path display='none'" + square), IsEmpty());
  EXPECT_THAT(paths("<g style='display:none'><path" + square + "</g>"),
              IsEmpty());
  EXPECT_THAT(paths("<path visibility='hidden'" + square), IsEmpty());
  EXPECT_THAT(paths("<path fill-opacity='0'" + square), IsEmpty());
}

TEST(SvgReader, AppliesPlainStyleRules) {
  const Drawing drawing =
      svg("<defs><style>/* c */ .a, .b { fill : none; stroke:#000 } "
          "#w{stroke-width:4}</style></defs>"
          "<path class='x b' id='w' d='M0 0h3'/>")
          .drawing;
  EXPECT_EQ(drawing.paint, Paint::stroke);
  EXPECT_EQ(drawing.paths.at(0).width, 4);
}

TEST(SvgReader, FollowsUses) {
  EXPECT_EQ(paths("<defs><path id='a' d='M0 0h1v1'/></defs>"
                  "<use href='#a' x='5'/><use xlink:href='#a' "
                  "transform='translate(0 7)'/>")
                .size(),
            2U);
  const auto symbol = paths(
      "<symbol id='s' viewBox='0 0 10 10'><path d='M1 1h1v1'/></symbol>"
      "<use href='#s' x='100' width='20' height='20'/>");
  ASSERT_EQ(symbol.size(), 1U);
  EXPECT_EQ(symbol[0].origin, (Point{102, 2}));
  EXPECT_EQ(symbol[0].elements[0], line(2, 0));
}

TEST(SvgReader, NestsViewports) {
  const auto nested = paths(
      "<svg x='10' y='20' width='40' height='80' viewBox='5 5 20 20'>"
      "<path d='M5 5h1v1'/></svg>");
  ASSERT_EQ(nested.size(), 1U);
  // Scaled by 2 and centred in the higher box.
  EXPECT_EQ(nested[0].origin, (Point{10, 40}));
  EXPECT_EQ(nested[0].elements[0], line(2, 0));
}

TEST(SvgReader, NamesWhatItLeavesOut) {
  const VectorPage page = svg(
      "<text>a</text><text>b</text><image/><path stroke-dasharray='1 2' "
      "fill='url(#g)' d='M0 0h1v1'/><rect fill='#fff' width='9' height='9'/>"
      "<sodipodi:namedview/><linearGradient id='g'/>");
  EXPECT_THAT(page.notes, Contains("2 <text> left out"));
  EXPECT_THAT(page.notes, Contains("1 <image> left out"));
  EXPECT_THAT(page.notes, Contains("dashes are drawn as whole lines"));
  EXPECT_THAT(page.notes, Contains("gradients and patterns are ink"));
  EXPECT_THAT(page.notes,
              Contains("1 shapes in a light colour are left out as paper"));
  EXPECT_EQ(page.notes.size(), 5U);
  const VectorPage both =
      svg("<path d='M0 0h1v1'/><path fill='none' stroke='#000' d='M0 0h9'/>");
  EXPECT_EQ(both.drawing.paint, Paint::stroke);
  EXPECT_THAT(both.notes, Contains("1 filled shapes are kept as outlines: "
                                   "others are stroked"));
}

TEST(SvgReader, NamesThePlaceOfErrors) {
  EXPECT_EQ(error_of("<path d='M1 1L2'/>"),
            "byte 6, <path>: path data, character 7: expected a number");
  EXPECT_EQ(error_of("<path d='L2 2'/>"),
            "byte 6, <path>: path data, character 1: expected a move first");
  EXPECT_EQ(error_of("<path d='M1 1X'/>"),
            "byte 6, <path>: path data, character 5: unknown command");
  EXPECT_EQ(error_of("<path d='M1 1zz3'/>"),
            "byte 6, <path>: path data, character 7: expected a command");
  EXPECT_THAT(error_of("<path d='M1 1e999'/>"), HasSubstr("a number"));
  EXPECT_THAT(error_of("<path d='M2e9 0h1'/>"), HasSubstr("a coordinate"));
  EXPECT_THAT(error_of("<g transform='turn(3)'/>"), HasSubstr("transform"));
  EXPECT_THAT(error_of("<polygon points='1 2 3'/>"), HasSubstr("points"));
  EXPECT_THAT(error_of("<circle r='wide'/>"), HasSubstr("r is not a length"));
  EXPECT_THAT(error_of("<g>"), HasSubstr("byte "));
  EXPECT_EQ(read_vector("<html/>", VectorFormat::svg, {}).error().code,
            ErrorCode::bad_magic);
}

TEST(SvgReader, EndsUsesOfThemselves) {
  EXPECT_THAT(error_of("<g id='a'><use href='#a'/></g>"),
              HasSubstr("more than 256 deep"));
  // Twenty levels of ten uses each.
  std::string bomb = "<defs><path id='l0' d='M0 0h1v1'/>";
  for (int level = 1; level <= 20; ++level) {
    bomb += "<g id='l" + std::to_string(level) + "'>";
    for (int i = 0; i < 10; ++i) {
      bomb += "<use href='#l" + std::to_string(level - 1) + "'/>";
    }
    bomb += "</g>";
  }
  bomb += "</defs><use href='#l20'/>";
  VectorReadOptions options;
  options.limits.max_memory = 1 << 20;
  const auto pages =
      read_vector("<svg>" + bomb + "</svg>", VectorFormat::svg, options);
  ASSERT_FALSE(pages);
  EXPECT_EQ(pages.error().code, ErrorCode::limit_exceeded);
}

TEST(SvgReader, BoundsTheDepthOfElements) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  for (int i = 0; i < 100000; ++i) deep += "</g>";
  EXPECT_THAT(error_of(deep), HasSubstr("more than 256 deep"));
}

}  // namespace
}  // namespace unstep
