#include <gtest/gtest.h>

#include <random>

#include "vector_testing.h"

namespace unstep {
namespace {

using namespace vector_testing;

/// Whole circles and quarters: what every format can say exactly.
Path::Element random_element(std::mt19937& random) {
  std::uniform_int_distribution<std::int32_t> side(-400, 400);
  const std::int32_t x = side(random);
  const std::int32_t y = side(random);
  switch (random() % 4) {
    case 0: {
      const Point centre{x == 0 ? 1 : x, y};
      // To the point that lies a quarter further: the centre's own move turned.
      const bool clockwise = random() % 2 == 0;
      const std::int32_t sign = clockwise ? 1 : -1;
      return arc(centre,
                 {centre.x - sign * centre.y, centre.y + sign * centre.x},
                 clockwise);
    }
    case 1: return arc({x == 0 ? 1 : x, y}, {0, 0}, false);
    default: return line(x, y == 0 ? 1 : y);
  }
}

Path random_path(std::mt19937& random, bool closed) {
  std::uniform_int_distribution<std::int32_t> place(0, 2000);
  Path path{{place(random), place(random)}, closed, 0, {}};
  Point at = path.origin;
  const std::size_t count = 2 + random() % 6;
  for (std::size_t i = 0; i < count; ++i) {
    Path::Element element = random_element(random);
    // Two circles on end, or a circle after an arc of it, may be joined.
    if (element.kind == Path::Kind::arc && !path.elements.empty() &&
        path.elements.back().kind == Path::Kind::arc) {
      element = line(7, 9);
    }
    const bool is_arc = element.kind == Path::Kind::arc;
    at.x += is_arc ? element.arc.end.x : element.segment.dx;
    at.y += is_arc ? element.arc.end.y : element.segment.dy;
    path.elements.push_back(element);
  }
  if (closed) {
    if (at == path.origin) {
      path.elements.push_back(line(1, 1));
      at = {at.x + 1, at.y + 1};
    }
    path.elements.push_back(line(path.origin.x - at.x, path.origin.y - at.y));
  }
  return path;
}

/// Every coordinate times `factor`.
Drawing scaled(Drawing drawing, std::int32_t factor) {
  drawing.scale = 1;
  for (Path& path : drawing.paths) {
    path.origin = {path.origin.x * factor, path.origin.y * factor};
    path.width *= factor;
    for (Path::Element& element : path.elements) {
      element.segment.dx *= factor;
      element.segment.dy *= factor;
      for (Point* p : {&element.arc.centre, &element.arc.end}) {
        *p = {p->x * factor, p->y * factor};
      }
    }
  }
  return drawing;
}

/// Equal, whatever the scale in which both say it.
void expect_same(const Drawing& a, const Drawing& b) {
  EXPECT_EQ(a.canvas, b.canvas);
  EXPECT_EQ(a.paint, b.paint);
  ASSERT_EQ(std::max(a.scale, b.scale) % std::min(a.scale, b.scale), 0);
  const std::int32_t common = std::max(a.scale, b.scale);
  EXPECT_EQ(scaled(a, common / a.scale).paths,
            scaled(b, common / b.scale).paths);
}

class VectorRoundTrip : public testing::TestWithParam<std::int32_t> {};

TEST_P(VectorRoundTrip, SvgGivesTheSamePaths) {
  std::mt19937 random(20260101);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const bool fill = round % 2 == 0;
    Drawing drawing{{3000, 3000, YAxis::down},
                    {},
                    {},
                    GetParam(),
                    fill ? Paint::fill : Paint::stroke};
    for (int i = 0; i < 4; ++i) {
      drawing.paths.push_back(random_path(random, fill || i % 2 == 0));
    }
    PageInfo info{"page <1>", {}, {{"key", " value\t\n"}}};
    const auto sevenths = static_cast<std::uint32_t>(302 + random() % 6);
    info.resolution = {{sevenths, 7}, {300, 1}, Resolution::Unit::inch};
    const Written written = write(VectorFormat::svg, drawing, info);
    EXPECT_TRUE(written.notes.empty());
    const VectorPage page = read(VectorFormat::svg, written.text);
    expect_same(page.drawing, drawing);
    EXPECT_EQ(page.info, info);
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, VectorRoundTrip,
                         testing::Values(1, 2, 16, 100, 1000));

TEST(VectorRoundTrip, DxfGivesTheSamePaths) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    Drawing drawing{{0, 0, YAxis::up}, {}, {}, 10, Paint::stroke};
    for (int i = 0; i < 4; ++i) {
      drawing.paths.push_back(random_path(random, i % 2 == 0));
    }
    expect_same(
        read(VectorFormat::dxf, write(VectorFormat::dxf, drawing).text).drawing,
        drawing);
  }
}

TEST(VectorRoundTrip, HpglGivesTheSamePathsInPlotterUnits) {
  std::mt19937 random(11);
  PageInfo info;
  info.resolution = {{1016, 1}, {1016, 1}, Resolution::Unit::inch};
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    Drawing drawing{{0, 0, YAxis::up}, {}, {}, 1, Paint::stroke};
    for (int i = 0; i < 4; ++i) {
      drawing.paths.push_back(random_path(random, i % 2 == 0));
    }
    const VectorPage page =
        read(VectorFormat::hpgl, write(VectorFormat::hpgl, drawing, info).text);
    expect_same(page.drawing, drawing);
    EXPECT_EQ(page.info, info);
  }
}

TEST(VectorRoundTrip, ChainTextGivesTheSameChains) {
  Drawing drawing{{9, 9, YAxis::up}, {}, {}, 1, Paint::fill};
  drawing.chains = {{{1, 2}, Connectivity::eight, false, {0, 1, 7}}};
  const Written written = write(VectorFormat::freeman, drawing);
  EXPECT_EQ(read(VectorFormat::freeman, written.text).drawing, drawing);
  Result<VectorWriter> writer = VectorWriter::create(
      VectorFormat::freeman, [](std::string_view) { return Status{}; });
  drawing.paths = {square({0, 0}, 1)};
  const Status refused = writer->add_page(drawing, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_argument);
}

TEST(RecogniseVector, KnowsWhatTheWritersWrite) {
  const Drawing drawing{{9, 9, YAxis::down}, {}, {}, 1, Paint::fill};
  for (const VectorFormat format :
       {VectorFormat::svg, VectorFormat::dxf, VectorFormat::hpgl,
        VectorFormat::pdf, VectorFormat::json, VectorFormat::freeman}) {
    EXPECT_EQ(recognise_vector(write(format, drawing).text), format);
  }
}

TEST(RecogniseVector, KnowsWhatOthersWrite) {
  EXPECT_EQ(recognise_vector("\xef\xbb\xbf<?xml version='1.0'?>\n<!-- svg --> "
                             "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' "
                             "'x'>\n<svg width='3'/>"),
            VectorFormat::svg);
  EXPECT_EQ(recognise_vector("<s:svg xmlns:s='x'>"), VectorFormat::svg);
  EXPECT_EQ(recognise_vector("  0\r\nSECTION\r\n"), VectorFormat::dxf);
  EXPECT_EQ(recognise_vector("999\nby hand\n0\nSECTION\n"), VectorFormat::dxf);
  EXPECT_EQ(recognise_vector("\x1b%0BIN;SP1"), VectorFormat::hpgl);
  EXPECT_EQ(recognise_vector("in;sp1;pu"), VectorFormat::hpgl);
  EXPECT_EQ(recognise_vector("# by hand\n\nopen8 0 0: 1"),
            VectorFormat::freeman);
  for (const char* other : {"", "<html><body/></html>", "{\"a\": 1}", "P4\n1 1",
                            "Info: no plotter", "# only a comment", "0\n1\n"}) {
    EXPECT_FALSE(recognise_vector(other)) << other;
  }
}

}  // namespace
}  // namespace unstep
