#include <gtest/gtest.h>

#include <string>

#include "unit/vector_testing.h"

namespace unstep {
namespace {

using namespace vector_testing;

constexpr VectorFormat kFormats[] = {VectorFormat::svg, VectorFormat::dxf,
                                     VectorFormat::hpgl, VectorFormat::json};

/// A little of everything, written by ourselves.
std::string sample(VectorFormat format) {
  Drawing drawing{{100, 80, YAxis::down}, {}, {}, 4, Paint::stroke};
  drawing.paths = {
      square({8, 8}, 40),
      {{60, 60}, false, 3, {line(3, 4), arc({0, 9}, {9, 9}, false)}},
      {{99, 60}, true, 0, {arc({-20, 0}, {0, 0}, true)}}};
  PageInfo info{"name", {{300, 1}, {300, 1}, Resolution::Unit::inch}, {}};
  if (format == VectorFormat::svg) info.metadata = {{"key", "value"}};
  return write(format, drawing, info).text;
}

/// Errors are one line and not ours; what is read can be written.
void expect_sound(VectorFormat format, const std::string& text,
                  std::string_view what) {
  const auto pages = read_vector(text, format, {});
  if (!pages) {
    EXPECT_NE(pages.error().code, ErrorCode::internal) << what;
    EXPECT_FALSE(pages.error().message.empty()) << what;
    EXPECT_EQ(pages.error().message.find('\n'), std::string::npos) << what;
    return;
  }
  for (const VectorPage& page : *pages) {
    write(VectorFormat::json, page.drawing, page.info);
  }
}

TEST(CorruptVector, TruncationIsNoticedWhereAFileHasAnEnd) {
  for (const VectorFormat format :
       {VectorFormat::svg, VectorFormat::dxf, VectorFormat::json}) {
    const std::string whole = sample(format);
    ASSERT_TRUE(read_vector(whole, format, {}));
    // What follows the end tag or EOF is a line end.
    for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
      EXPECT_FALSE(read_vector(whole.substr(0, size), format, {}))
          << "format " << static_cast<int>(format) << ", " << size << " bytes";
    }
  }
}

TEST(CorruptVector, TruncatedPlotsAreSound) {
  const std::string whole = sample(VectorFormat::hpgl);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    expect_sound(VectorFormat::hpgl, whole.substr(0, size),
                 std::to_string(size));
  }
}

TEST(CorruptVector, EveryFlippedBitIsSound) {
  for (const VectorFormat format : kFormats) {
    std::string text = sample(format);
    for (std::size_t at = 0; at < text.size(); ++at) {
      for (int bit = 0; bit < 8; ++bit) {
        text[at] = static_cast<char>(text[at] ^ (1 << bit));
        expect_sound(format, text,
                     std::to_string(at) + " bit " + std::to_string(bit));
        text[at] = static_cast<char>(text[at] ^ (1 << bit));
      }
    }
  }
}

TEST(CorruptVector, MemoryStaysWithinTheLimit) {
  VectorReadOptions options;
  options.limits.max_memory = 100000;
  std::string many;
  for (int i = 0; i < 20000; ++i) many += "1,1,";
  many += "1,1";
  for (const std::string& text : {"PU0,0;PR;PD" + many + ";"}) {
    const auto pages = read_vector(text, VectorFormat::hpgl, options);
    ASSERT_FALSE(pages);
    EXPECT_EQ(pages.error().code, ErrorCode::limit_exceeded);
  }
  std::string data = "<svg><path d='m0 0";
  for (int i = 0; i < 20000; ++i) data += " 1 1";
  data += "'/></svg>";
  const auto svg = read_vector(data, VectorFormat::svg, options);
  ASSERT_FALSE(svg);
  EXPECT_EQ(svg.error().code, ErrorCode::limit_exceeded);
  const auto json =
      read_vector("{\"unstep\":1,\"pages\":[" + std::string(9000, '['),
                  VectorFormat::json, options);
  ASSERT_FALSE(json);
  EXPECT_EQ(json.error().code, ErrorCode::limit_exceeded);
}

TEST(CorruptVector, HostileNumbersAreSound) {
  for (const char* number :
       {"1e308", "-1e308", "1e-308", "0", "1073741823", "1073741824",
        "99999999999999999999", "nan", "inf", "-", "+", ".", "1e", "0x10"}) {
    const std::string n = number;
    for (const std::string& body :
         {"<path d='M" + n + " 0A" + n + " 1 0 0 1 5 " + n + "z'/>",
          "<circle r='" + n + "'/>", "<circle cx='" + n + "' r='3'/>",
          "<g transform='scale(" + n + ")'><path d='M1 1h3C1 2 3 4 5 6'/></g>",
          "<g transform='matrix(1 0 0 " + n + " 0 0)'><circle r='3'/></g>",
          "<rect width='" + n + "' height='3' rx='" + n + "'/>",
          "<line stroke='red' stroke-width='" + n + "' x2='3'/>"}) {
      expect_sound(VectorFormat::svg, "<svg>" + body + "</svg>", body);
      expect_sound(VectorFormat::svg,
                   "<svg width='" + n + "mm' height='3mm' viewBox='0 0 3 " + n +
                       "'>" + body + "</svg>",
                   body);
    }
    for (const std::string& body :
         {"PU0,0;PDAA" + n + ",5," + n, "CI" + n, "SC0," + n + ",0,1;PD1,1,2,2",
          "IP0,0," + n + ",9;SC0,1,0,1;PD5,5", "PW" + n + ";PD3,4"}) {
      expect_sound(VectorFormat::hpgl, body, body);
    }
    for (const char* code : {"10", "11", "20", "40", "50", "51"}) {
      for (const char* kind : {"LINE", "ARC", "CIRCLE", "ELLIPSE"}) {
        expect_sound(VectorFormat::dxf,
                     std::string("0\nSECTION\n2\nENTITIES\n0\n") + kind +
                         "\n8\n0\n" + code + "\n" + n +
                         "\n10\n1\n20\n2\n11\n3\n21\n4\n40\n5\n50\n6\n51\n7\n"
                         "0\nENDSEC\n0\nEOF\n",
                     std::string(kind) + code + n);
      }
    }
  }
}

}  // namespace
}  // namespace unstep
