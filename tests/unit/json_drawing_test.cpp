#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vector_testing.h"

namespace unstep {
namespace {

using testing::HasSubstr;
using namespace vector_testing;

Drawing everything() {
  Drawing drawing{{100, 50, YAxis::up}, {}, {}, 12, Paint::stroke};
  drawing.chains = {{{1, 2}, Connectivity::eight, false, {0, 1, 7}},
                    {{3, 4}, Connectivity::four, true, {0, 2, 4, 6}},
                    {{5, 6}, Connectivity::eight, false, {}}};
  drawing.paths = {square({-7, 8}, 9),
                   {{0, 0}, false, 3, {line(1, 2), arc({3, 4}, {6, 0}, true)}},
                   {{9, 9}, true, 0, {arc({0, 5}, {0, 0}, false)}},
                   {{kMaxCoord, -kMaxCoord},
                    false,
                    0,
                    {line(-2 * kMaxCoord, 2 * kMaxCoord)}}};
  return drawing;
}

PageInfo full_info() {
  return {"name \"q\" \\ \n\x01 \xc3\xa4",
          {{204, 1}, {98, 3}, Resolution::Unit::centimetre},
          {{"b", "1"}, {"a", ""}}};
}

TEST(JsonDrawing, ComesBackEqual) {
  const Written written = write(VectorFormat::json, everything(), full_info());
  const VectorPage page = read(VectorFormat::json, written.text);
  EXPECT_EQ(page.drawing, everything());
  EXPECT_EQ(page.info, full_info());
}

TEST(JsonDrawing, HasTheDocumentedForm) {
  Drawing drawing{{4, 3, YAxis::down}, {}, {square({1, 1}, 2)}, 1, Paint::fill};
  drawing.chains = {{{1, 1}, Connectivity::four, true, {0, 6, 4, 2}}};
  EXPECT_EQ(write(VectorFormat::json, drawing).text,
            "{\"unstep\":1,\"pages\":[\n"
            "{\"canvas\":[4,3],\"y\":\"down\",\"scale\":1,\"paint\":\"fill\","
            "\"shapes\":[\n"
            "{\"closed\":true,\"at\":[1,1],\"connectivity\":4,\"steps\":"
            "\"0642\"},\n"
            "{\"closed\":true,\"at\":[1,1],\"path\":[[2,0],[0,2],[-2,0],"
            "[0,-2]]}]}\n]}\n");
}

TEST(JsonDrawing, HoldsSeveralPages) {
  std::string text;
  Result<VectorWriter> writer =
      VectorWriter::create(VectorFormat::json, [&text](std::string_view bytes) {
        text += bytes;
        return Status{};
      });
  ASSERT_TRUE(writer->add_page(everything(), full_info()));
  ASSERT_TRUE(writer->add_page({}, {}));
  ASSERT_TRUE(writer->finish());
  const auto pages = read_vector(text, VectorFormat::json, {});
  ASSERT_TRUE(pages) << pages.error().message;
  ASSERT_EQ(pages->size(), 2U);
  EXPECT_EQ((*pages)[0].drawing, everything());
  EXPECT_EQ((*pages)[1].drawing, Drawing{});
}

TEST(JsonDrawing, NamesThePlaceOfErrors) {
  const auto error = [](const std::string& shape) {
    const auto pages = read_vector(
        "{\"unstep\":1,\"pages\":[{\"canvas\":[9,9],\"shapes\":[{\"at\":[0,0],"
        "\"path\":[]}," +
            shape + "]}]}",
        VectorFormat::json, {});
    return pages ? "no error" : pages.error().message;
  };
  EXPECT_EQ(error("{\"at\":[0,0]}"),
            "page 1, shape 2: expected \"path\" or \"steps\"");
  EXPECT_EQ(error("{\"at\":[0,0],\"closed\":true,\"path\":[[1,1]]}"),
            "page 1, shape 2: a closed path that does not return to its "
            "origin");
  EXPECT_EQ(error("{\"at\":[0,0],\"steps\":\"018\"}"),
            "page 1, shape 2: expected steps of 0 to 7, even if 4-connected");
  EXPECT_THAT(error("{\"at\":[0,2e9],\"path\":[]}"),
              HasSubstr("expected whole numbers"));
  EXPECT_THAT(error("{\"at\":[0,99999999999999999999],\"path\":[]}"),
              HasSubstr("expected whole numbers"));
  EXPECT_THAT(error("{\"at\":[0,18446744073709551615],\"path\":[]}"),
              HasSubstr("a number outside"));
  EXPECT_THAT(error("{\"at\":[0,0],\"closed\":3,\"path\":[]}"),
              HasSubstr("wrong type"));
  EXPECT_THAT(error("{"), HasSubstr("byte "));
  EXPECT_EQ(read_vector("{}", VectorFormat::json, {}).error().code,
            ErrorCode::bad_magic);
  EXPECT_EQ(read_vector("{\"unstep\":2}", VectorFormat::json, {}).error().code,
            ErrorCode::unsupported_version);
}

}  // namespace
}  // namespace unstep
