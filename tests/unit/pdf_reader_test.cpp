#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "formats/external_program.h"
#include "raster_test_support.h"

namespace unstep {
namespace {

using test::error_of;
using test::has_note;

test::Bytes bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

/// A page with one image of 16 x 8 pixels of one bit, at 72 per inch.
struct PdfPage {
  std::string image = "/ColorSpace/DeviceGray";
  int rotation = 0;
  int side = 1;  ///< the page is so many times as wide and as high
  bool has_image = true;
};

/// Left half 1, right half 0, but the first row is all 1.
test::Bytes make_pdf(const std::vector<PdfPage>& pages) {
  std::vector<std::string> objects{"<</Type/Catalog/Pages 2 0 R>>", ""};
  std::string kids;
  for (const PdfPage& page : pages) {
    const std::size_t number = objects.size() + 1;
    const auto ref = [](std::size_t n) { return std::to_string(n) + " 0 R"; };
    kids += ref(number) + " ";
    const std::string box =
        std::to_string(16 * page.side) + " " + std::to_string(8 * page.side);
    objects.push_back("<</Type/Page/Parent 2 0 R/MediaBox[0 0 " + box +
                      "]/Rotate " + std::to_string(page.rotation) +
                      "/Contents " + ref(number + 1) +
                      "/Resources<</XObject<</I " + ref(number + 2) + ">>>>>>");
    const std::string content =
        page.has_image ? "q 16 0 0 8 0 0 cm /I Do Q" : "0 0 m 9 9 l S";
    objects.push_back("<</Length " + std::to_string(content.size()) +
                      ">>stream\n" + content + "\nendstream");
    std::string rows = "\xff\xff";
    for (int y = 1; y < 8; ++y) rows += std::string("\xff\0", 2);
    objects.push_back(
        "<</Type/XObject/Subtype/Image/Width 16/Height 8"
        "/BitsPerComponent 1" +
        page.image + "/Length " + std::to_string(rows.size()) + ">>stream\n" +
        rows + "\nendstream");
  }
  objects[1] = "<</Type/Pages/Kids[" + kids + "]/Count " +
               std::to_string(pages.size()) + ">>";
  std::string pdf = "%PDF-1.4\n";
  std::string table = "xref\n0 " + std::to_string(objects.size() + 1) +
                      "\n0000000000 65535 f \n";
  for (std::size_t i = 0; i < objects.size(); ++i) {
    std::string offset = std::to_string(pdf.size());
    table += std::string(10 - offset.size(), '0') + offset + " 00000 n \n";
    pdf += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const std::size_t at = pdf.size();
  pdf += table + "trailer<</Size " + std::to_string(objects.size() + 1) +
         "/Root 1 0 R>>\nstartxref\n" + std::to_string(at) + "\n%%EOF\n";
  return bytes_of(pdf);
}

class PdfReader : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto there = run_program({"pdfimages", "-v"}, {}); !there) {
      GTEST_SKIP() << "pdfimages is not installed: " << there.error().message;
    }
  }
};

std::string first_rows(const RasterPage& page) {
  std::string text;
  for (std::int32_t y = 0; y < 2; ++y) {
    for (std::int32_t x = 0; x < page.ink.width(); ++x) {
      text += page.ink.get(x, y) ? '1' : '0';
    }
    text += ' ';
  }
  return text;
}

TEST_F(PdfReader, GivesTheImageOfAPage) {
  const RasterPage page = test::read_raster(make_pdf({{}}));
  EXPECT_EQ(first_rows(page), "0000000000000000 0000000011111111 ");
  EXPECT_EQ(page.info.resolution,
            (Resolution{{72, 1}, {72, 1}, Resolution::Unit::inch}));
  EXPECT_TRUE(page.lossless);
  EXPECT_TRUE(has_note(page, "text and lines of the PDF"));
  EXPECT_FALSE(has_note(page, "covers"));
}

TEST_F(PdfReader, SeesWhichBitsOfAStencilPaint) {
  const auto rows = [](const char* kind) {
    return first_rows(test::read_raster(make_pdf({{kind}})));
  };
  EXPECT_EQ(rows("/ImageMask true"), "0000000000000000 0000000011111111 ");
  EXPECT_EQ(rows("/ImageMask true/Decode[1 0]"),
            "1111111111111111 1111111100000000 ");
  EXPECT_EQ(rows("/ColorSpace/DeviceGray/Decode[1 0]"),
            "1111111111111111 1111111100000000 ");
}

TEST_F(PdfReader, AppliesTheRotationOfPages) {
  PdfPage turned;
  turned.rotation = 90;
  const RasterPage page = test::read_raster(make_pdf({turned}));
  ASSERT_EQ(page.ink.width(), 8);
  ASSERT_EQ(page.ink.height(), 16);
  // Clockwise: the left half is at the top, the first row at the right.
  EXPECT_EQ(page.ink.ink(), 8U * 7U);
  EXPECT_FALSE(page.ink.get(0, 0));
  EXPECT_TRUE(page.ink.get(0, 15));
  EXPECT_FALSE(page.ink.get(7, 15));
  EXPECT_TRUE(has_note(page, "rotation of 90 degrees applied"));
}

TEST_F(PdfReader, TellsOfPagesWithoutImagesAndSmallOnes) {
  PdfPage empty;
  empty.has_image = false;
  PdfPage small;
  small.side = 2;
  Result<RasterReader> file =
      RasterReader::open(make_pdf({{}, empty, small}), {});
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->format(), "pdf");
  ASSERT_EQ(file->page_count(), 2U);
  const Result<RasterPage> first = file->read(0);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_TRUE(has_note(*first, "1 of 3 pages have no image"));
  EXPECT_EQ(first->info.name, "page 1");
  const Result<RasterPage> last = file->read(1);
  ASSERT_TRUE(last) << last.error().message;
  EXPECT_EQ(last->info.name, "page 3");
  EXPECT_TRUE(has_note(*last, "the image covers 25 % of the page"));
}

TEST_F(PdfReader, RefusesWhatHasNoImageOrIsDamaged) {
  PdfPage empty;
  empty.has_image = false;
  EXPECT_EQ(error_of(make_pdf({empty})).substr(0, 40),
            "unsupported: no page of this PDF is an i");
  EXPECT_NE(error_of(bytes_of("%PDF-1.4\nnothing")), "no error");
  RasterReadOptions options;
  options.limits.max_pixels = 100;
  EXPECT_EQ(error_of(make_pdf({{}}), options).substr(0, 15), "limit_exceeded:");
  const test::Bytes file = make_pdf({{}});
  for (std::size_t size = 30; size < file.size(); size += 97) {
    EXPECT_EQ(error_of({file.begin(),
                        file.begin() + static_cast<std::ptrdiff_t>(size)})
                  .find('\n'),
              std::string::npos);
  }
}

TEST_F(PdfReader, LeavesNothingInTheTemporaryFolder) {
  const std::string folder = testing::TempDir() + "unstep_pdf_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  ::setenv("TMPDIR", folder.c_str(), 1);
  (void)test::read_raster(make_pdf({{}}));
  (void)error_of(bytes_of("%PDF-1.4\nnothing"));
  ::unsetenv("TMPDIR");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove_all(folder);
}

TEST(ExternalProgram, SaysWhatIsMissingOrFails) {
  EXPECT_EQ(run_program({"no-such-program"}, {}).error().message,
            "the program no-such-program cannot be started: No such file or "
            "directory");
  EXPECT_EQ(run_program({"false"}, {}).error().message, "false: exit code 1");
  EXPECT_EQ(
      run_program({"ls", "/no such folder"}, {}).error().message.substr(0, 4),
      "ls: ");
  EXPECT_EQ(*run_program({"printf", "%s", "a;b $c `d`"}, {}), "a;b $c `d`");
  RunLimits limits;
  limits.output_bytes = 10;
  EXPECT_EQ(run_program({"printf", "12345678901"}, limits).error().code,
            ErrorCode::limit_exceeded);
}

TEST(ExternalProgram, NamesThePackageThatAPdfNeeds) {
  const char* path = std::getenv("PATH");
  const std::string kept = path != nullptr ? path : "";
  ::setenv("PATH", "/nonexistent", 1);
  const std::string error = error_of(make_pdf({{}}));
  ::setenv("PATH", kept.c_str(), 1);
  EXPECT_EQ(error,
            "unsupported: PDF: the program pdfimages cannot be started: No "
            "such file or directory (Debian: poppler-utils)");
}

}  // namespace
}  // namespace unstep
