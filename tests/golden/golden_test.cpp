#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "codec/container_decoder.h"
#include "codec/metadata_words.h"
#include "corrupt/file_surgery.h"
#include "golden/golden_text.h"
#include "golden/ink_block.h"
#include "unit/container_testing.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

namespace fs = std::filesystem;
using testing::Bytes;

fs::path source_dir() { return UNSTEP_SOURCE_DIR; }

std::vector<fs::path> golden_files(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(source_dir() / "tests" / "golden" / folder)) {
    if (entry.path().extension() == ".ustp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Bytes read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string read_text(const fs::path& path) {
  const Bytes bytes = read(path);
  return {bytes.begin(), bytes.end()};
}

TEST(Golden, ValidFilesDecodeToWhatTheyAlwaysDid) {
  const std::vector<fs::path> files = golden_files("valid");
  ASSERT_GE(files.size(), 10U);
  for (fs::path path : files) {
    SCOPED_TRACE(path.filename());
    const Bytes file = read(path);
    const Result<UstpReader> reader = testing::open(file);
    ASSERT_TRUE(reader) << reader.error().message;
    EXPECT_EQ(testing::text_of(reader->info()),
              read_text(path.replace_extension(".txt")));
    Bytes pbm;
    std::vector<Drawing> drawings;
    std::string paths;
    for (std::size_t i = 0; i < reader->info().pages.size(); ++i) {
      const Result<Page> page = reader->read_page(i);
      ASSERT_TRUE(page) << page.error().message;
      if (page->kind == PageKind::chains) {
        drawings.push_back(page->drawing);
        continue;
      }
      if (page->kind == PageKind::program) {
        EXPECT_EQ(page->program, read_text(path.replace_extension(".ngc")));
        continue;
      }
      if (page->kind == PageKind::paths) {
        paths += testing::text_of(page->drawing.paths);
        continue;
      }
      const Bytes one = testing::pbm_of(page->ink);
      pbm.insert(pbm.end(), one.begin(), one.end());
    }
    if (!pbm.empty()) {
      EXPECT_EQ(pbm, read(path.replace_extension(".pbm")));
    }
    if (!paths.empty()) {
      EXPECT_EQ(paths, read_text(path.replace_extension(".paths")));
    }
    for (const Drawing& drawing : drawings) {
      const Result<Drawing> text =
          parse_freeman(read_text(path.replace_extension(".fc")), {});
      ASSERT_TRUE(text) << text.error().message;
      EXPECT_EQ(drawing, *text);
    }
  }
}

/// So that no model goes unpinned: every name of a coder with its revision
/// stands in a header text.
TEST(Golden, EveryRevisionOfACoderHasFiles) {
  std::string texts;
  for (fs::path path : golden_files("valid")) {
    texts += read_text(path.replace_extension(".txt"));
  }
  const auto expect_one = [&texts](unsigned coder, unsigned revision) {
    const std::string name =
        std::to_string(coder) + "." + std::to_string(revision);
    EXPECT_NE(texts.find("  coder " + name + "."), std::string::npos) << name;
  };
  for (const unsigned coder :
       {codec::kCoderStored, codec::kCoderChains, codec::kCoderPaths,
        codec::kCoderStrokes, codec::kCoderProgram}) {
    expect_one(coder, 0);
  }
  for (unsigned r = 0; r < 256; ++r) {
    const auto revision = static_cast<std::uint8_t>(r);
    if (codec::is_contour_revision(revision))
      expect_one(codec::kCoderContours, r);
    if (codec::is_shape_revision(revision)) expect_one(codec::kCoderShapes, r);
    if (codec::is_centreline_revision(revision))
      expect_one(codec::kCoderCentrelines, r);
    if (codec::is_pixel_revision(revision)) expect_one(codec::kCoderPixels, r);
  }
}

/// The error code is the part of the name before the hyphen.
TEST(Golden, MustFailFilesFailAsTheirNamesSay) {
  const std::vector<fs::path> files = golden_files("must_fail");
  ASSERT_GE(files.size(), 10U);
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename());
    const std::string name = path.stem();
    const auto decoded = testing::decode_all(read(path));
    ASSERT_FALSE(decoded);
    EXPECT_EQ(to_string(decoded.error().code), name.substr(0, name.find('-')))
        << decoded.error().message;
  }
}

/// The parts of a file, its payloads taken as they are.
std::vector<codec::PageParts> parts_of(const Bytes& file) {
  const codec::ParsedFile parsed = *codec::parse_file(file);
  std::vector<codec::PageParts> pages;
  for (std::size_t p = 0; p < parsed.info.pages.size(); ++p) {
    const PageEntry& entry = parsed.info.pages[p];
    codec::PageParts page{
        entry.kind,  entry.canvas, entry.fidelity, entry.scale,
        entry.paint, entry.info,   entry.checksum, {}};
    for (std::size_t b = 0; b < entry.blocks.size(); ++b) {
      const PageEntry::Block& from = entry.blocks[b];
      codec::BlockParts block;
      block.encoded.name = {from.coder, from.revision, from.table};
      const auto start =
          file.begin() + static_cast<std::ptrdiff_t>(from.offset);
      block.encoded.payload.assign(
          start, start + static_cast<std::ptrdiff_t>(from.bytes));
      block.checksum = parsed.proofs[p][b].checksum;
      block.box = from.box;
      block.first_row = from.first_row;
      block.rows = from.rows;
      block.chains = from.chains;
      block.steps = from.steps;
      block.paths = from.paths;
      block.elements = from.elements;
      block.lines = from.lines;
      block.text_bytes = from.text_bytes;
      page.blocks.push_back(std::move(block));
    }
    pages.push_back(std::move(page));
  }
  return pages;
}

TEST(Golden, ContainerOfTheSamePayloadsHasTheSameBytes) {
  int compared = 0;
  for (const fs::path& path : golden_files("valid")) {
    const std::string name = path.stem();
    // Writers make no unknown blocks, and zlib may deflate metadata otherwise.
    if (name.find("unknown") != std::string::npos) continue;
    if (name == "block_two_pages" || name == "short_with_texts") continue;
    SCOPED_TRACE(name);
    const Bytes file = read(path);
    const std::vector<codec::PageParts> pages = parts_of(file);
    const Bytes again = codec::fits_short_form(pages)
                            ? *codec::short_form(pages[0], {})
                            : *codec::block_form(pages, {});
    EXPECT_EQ(again, file);
    ++compared;
  }
  EXPECT_GE(compared, 8);
}

bool is_drawing_row(const std::string& line) {
  return line.size() == 12 &&
         line.find_first_not_of(".#", 4) == std::string::npos;
}

/// Appends the bytes of "  offset  hex bytes  words"; any other line is none.
void append_example_bytes(const std::string& line, Bytes& file) {
  std::istringstream in(line);
  std::size_t offset = 0;
  if (!(in >> offset)) return;
  EXPECT_EQ(offset, file.size()) << line;
  // One blank parts the bytes, two part them from the words.
  std::size_t at = line.find("  ", line.find_first_of("0123456789")) + 2;
  for (;; at += 3) {
    file.push_back(
        static_cast<std::uint8_t>(std::stoul(line.substr(at, 2), nullptr, 16)));
    if (line.compare(at + 2, 2, "  ") == 0) return;
  }
}

/// The example of docs/format.md stands between two marks: the bytes, then
/// the drawing in '.' and '#'.
TEST(Golden, ExampleOfTheFormatDescriptionIsTrue) {
  std::istringstream doc(read_text(source_dir() / "docs" / "format.md"));
  std::string line;
  while (std::getline(doc, line) && line != "<!-- example begins -->") {
  }
  Bytes file;
  std::vector<std::string> rows;
  while (std::getline(doc, line) && line != "<!-- example ends -->") {
    if (is_drawing_row(line)) {
      rows.push_back(line.substr(4));
    } else {
      append_example_bytes(line, file);
    }
  }
  ASSERT_EQ(rows.size(), 8U);
  const auto decoded = testing::decode_all(file);
  ASSERT_TRUE(decoded) << decoded.error().message;
  EXPECT_EQ(decoded->pages[0].ink, testing::ink_of(rows));
  EXPECT_EQ(file, read(source_dir() / "tests" / "golden" / "valid" /
                       "short_glyph_8x8.ustp"));
}

/// A golden file, and its first page.
struct GoldenPage {
  Bytes file;
  Page page;
};
Result<GoldenPage> golden_page(const std::string& name) {
  GoldenPage golden;
  golden.file =
      read(source_dir() / "tests" / "golden" / "valid" / (name + ".ustp"));
  const Result<UstpReader> reader = UstpReader::open(golden.file, {});
  if (!reader) return reader.error();
  Result<Page> page = reader->read_page(0);
  if (!page) return page.error();
  golden.page = *std::move(page);
  return golden;
}

/// The golden files were made by an optimised build; this test runs in every
/// build, without optimisation too. That ties the models to no compiler.
TEST(Golden, EveryBuildMakesTheSameBytes) {
  EncodeOptions standard;
  EncodeOptions fast;
  fast.effort = Effort::fast;
  EncodeOptions bands;
  bands.bands = 2;
  const std::vector<std::pair<std::string, EncodeOptions>> names{
      {"contours_glyph", standard},   {"contours_blots", standard},
      {"contours_blots_fast", fast},  {"contours_two_bands", bands},
      {"shapes_text", standard},      {"centrelines_map", standard},
      {"pixels_dither", standard},    {"pixels_dither_fast", fast},
      {"chains_4_and_8", standard},   {"chains_y_up", standard},
      {"chains_long_lines", standard}};
  for (const auto& [name, options] : names) {
    SCOPED_TRACE(name);
    const Result<GoldenPage> golden = golden_page(name);
    ASSERT_TRUE(golden);
    const Page& page = golden->page;
    UstpWriter writer(options);
    ASSERT_TRUE(page.kind == PageKind::ink
                    ? writer.add_page(page.ink, page.info)
                    : writer.add_page(page.drawing, page.info));
    EXPECT_EQ(*writer.finish(), golden->file);
  }
}

/// Blocks of pages by the coders that they name, whichever an encoder would
/// choose today.
TEST(Golden, EveryBuildMakesTheSamePayloads) {
  int compared = 0;
  for (const fs::path& path : golden_files("valid")) {
    SCOPED_TRACE(path.filename());
    const Bytes file = read(path);
    const Result<UstpReader> reader = UstpReader::open(file, {});
    ASSERT_TRUE(reader);
    const std::vector<codec::PageParts> pages = parts_of(file);
    for (std::size_t p = 0; p < pages.size(); ++p) {
      if (pages[p].kind != PageKind::ink) continue;
      const Result<Page> page = reader->read_page(p);
      ASSERT_TRUE(page);
      for (const codec::BlockParts& block : pages[p].blocks) {
        // zlib may deflate otherwise.
        if (block.encoded.name.coder == codec::kCoderStored) continue;
        const Result<Bytes> payload = testing::encode_rows(
            page->ink, block.first_row, block.rows, block.encoded.name);
        ASSERT_TRUE(payload);
        EXPECT_EQ(*payload, block.encoded.payload);
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 16);
}

/// The words stand between two marks, one a line.
TEST(Golden, WordsOfTheFormatDescriptionAreThoseOfMetadata) {
  std::istringstream doc(read_text(source_dir() / "docs" / "format.md"));
  std::string line;
  while (std::getline(doc, line) && line != "<!-- words begin -->") {
  }
  std::string words;
  while (std::getline(doc, line) && line != "<!-- words end -->") {
    if (line.size() > 4) words += line.substr(4) + '\0';
  }
  EXPECT_EQ(words, codec::kMetadataWords);
}

}  // namespace
}  // namespace unstep
