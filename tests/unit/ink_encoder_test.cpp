#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "unit/container_testing.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

std::size_t file_size(const Page& page, Effort effort) {
  EncodeOptions options;
  options.effort = effort;
  UstpWriter writer(options);
  EXPECT_TRUE(writer.add_page(page.ink, page.info));
  return writer.finish()->size();
}

/// Pages of text, blots, thin lines, dither and single pixels.
TEST(Efforts, MaxIsNeverLargerThanStandard) {
  const std::filesystem::path folder =
      std::filesystem::path(UNSTEP_SOURCE_DIR) / "tests/golden/valid";
  int pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ustp") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::vector<std::uint8_t> file{std::istreambuf_iterator<char>(in),
                                         {}};
    const Result<UstpReader> reader = UstpReader::open(file, {});
    ASSERT_TRUE(reader);
    const Result<Page> page = reader->read_page(0);
    ASSERT_TRUE(page);
    if (page->kind != PageKind::ink) continue;
    ++pages;
    EXPECT_LE(file_size(*page, Effort::max), file_size(*page, Effort::standard))
        << entry.path();
  }
  EXPECT_GT(pages, 15);
}

}  // namespace
}  // namespace unstep
