#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "codec/byte_writer.h"
#include "corrupt/file_surgery.h"
#include "golden/golden_text.h"
#include "golden/ink_block.h"
#include "unit/container_testing.h"
#include "unit/path_testing.h"
#include "unstep/formats.h"

/// make_golden FOLDER: the golden files of coder 0 and of the container.
/// make_golden --paths FOLDER: those of paths.
/// make_golden --program FOLDER NAME: that of the text valid/NAME.ngc.
/// make_golden --ink FOLDER NAME CODER.REVISION.TABLE...: that of the page
/// valid/NAME.pbm, with a block for each coder.
/// make_golden --describe FILE.ustp: the text of a file's header.
namespace unstep::testing {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, std::span<const std::uint8_t> bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

void write_valid(const fs::path& folder, const std::string& name,
                 const Bytes& file) {
  write(folder / "valid" / (name + ".ustp"), file);
  const Result<UstpReader> reader = open(file);
  if (!reader) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(),
                 reader.error().message.c_str());
    return;
  }
  std::ofstream(folder / "valid" / (name + ".txt")) << text_of(reader->info());
  Bytes pbm;
  for (std::size_t i = 0; i < reader->info().pages.size(); ++i) {
    const Bytes page = pbm_of(reader->read_page(i)->ink);
    pbm.insert(pbm.end(), page.begin(), page.end());
  }
  write(folder / "valid" / (name + ".pbm"), pbm);
}

void write_failing(const fs::path& folder, const std::string& name,
                   const Bytes& file) {
  write(folder / "must_fail" / (name + ".ustp"), file);
}

Bitmap glyph() {
  return ink_of({"........", ".######.", ".#....#.", ".#.##.#.",  //
                 ".#.##.#.", ".#....#.", ".######.", "........"});
}

std::vector<codec::PageParts> two_pages() {
  return {
      stored_page(random_ink(37, 23, 1), 3,
                  {"recto",
                   {{600, 1}, {600, 1}, Resolution::Unit::inch},
                   {{"tiff:Artist", "A. Drawer"}}}),
      stored_page(
          random_ink(65, 9, 2), 1,
          {"verso \xc3\xa9", {{204, 1}, {98, 1}, Resolution::Unit::inch}, {}})};
}

/// Bands of 1, 7, 2 and 1 rows.
codec::PageParts uneven_bands() {
  const Bitmap ink = random_ink(130, 11, 3);
  codec::PageParts page = stored_page(ink, 1);
  const codec::BlockParts whole = page.blocks[0];
  page.blocks.clear();
  std::int32_t row = 0;
  for (const std::int32_t rows : {1, 7, 2, 1}) {
    codec::BlockParts block = whole;
    block.first_row = row;
    block.rows = rows;
    block.encoded.payload = *codec::encode_stored(ink, row, rows);
    block.checksum = codec::crc_rows(ink, row, rows);
    block.box = {0, row, 130, static_cast<std::uint32_t>(rows)};
    page.blocks.push_back(block);
    row += rows;
  }
  return page;
}

std::vector<RawBlock> with_unknown_block(std::uint8_t type) {
  const std::vector pages{stored_page(glyph(), 2)};
  std::vector<RawBlock> blocks =
      without_index(take_apart(*codec::block_form(pages, {})));
  blocks.insert(blocks.begin() + 2, RawBlock{type, {1, 2, 3}});
  return blocks;
}

void write_all_valid(const fs::path& folder) {
  const Bitmap white = *Bitmap::create(8, 8);
  const Resolution fax{{204, 1}, {98, 1}, Resolution::Unit::inch};
  const Resolution odd{
      {0xffffffffU, 0xfffffffeU}, {1, 0xffffffffU}, Resolution::Unit::metre};
  const auto short_form = [](const Bitmap& ink, const Resolution& resolution) {
    return *codec::short_form(stored_page(ink, 1, {"", resolution, {}}), {});
  };
  write_valid(folder, "short_white_8x8", short_form(white, {}));
  write_valid(folder, "short_glyph_8x8", short_form(glyph(), {}));
  write_valid(folder, "short_one_pixel", short_form(ink_of({"#"}), {}));
  write_valid(folder, "short_1x300", short_form(random_ink(1, 300, 4), {}));
  write_valid(folder, "short_300x1", short_form(random_ink(300, 1, 5), {}));
  write_valid(folder, "short_fax_resolution",
              short_form(random_ink(40, 20, 6), fax));
  write_valid(folder, "short_odd_resolution", short_form(glyph(), odd));
  write_valid(folder, "short_with_texts",
              *codec::short_form(
                  stored_page(random_ink(20, 10, 7), 1,
                              {"front", fax, {{"tiff:Software", "a scanner"}}}),
                  {{"unstep:source-size", "1234"}}));
  write_valid(folder, "block_two_pages",
              *codec::block_form(two_pages(), Metadata{{"title", "both"}}));
  write_valid(folder, "block_uneven_bands",
              *codec::block_form(std::vector{uneven_bands()}, {}));
  write_valid(folder, "block_unknown_optional_block",
              join(with_unknown_block(0xfe)));
}

void write_all_failing(const fs::path& folder) {
  Bytes version = *codec::short_form(stored_page(glyph(), 1), {});
  version[4] = 1;
  write_failing(folder, "unsupported_version-newer", version);

  Bytes checksum = *codec::short_form(stored_page(glyph(), 1), {});
  checksum[7] ^= 1;
  write_failing(folder, "checksum_mismatch-short", checksum);

  Bytes magic = *codec::short_form(stored_page(glyph(), 1), {});
  magic[2] = '\n';
  write_failing(folder, "bad_magic-line_ends", magic);

  Bytes overlong{0xf5, 0x55, 0x0d, 0x0a, 0x00, 0x88, 0x00, 0x09, 0x00};
  overlong.insert(overlong.end(), 12, 0);
  write_failing(folder, "corrupt-overlong_varint", overlong);

  Bytes huge{0xf5, 0x55, 0x0d, 0x0a, 0x00, 0xff, 0xff, 0xff,
             0xff, 0x03, 0xfe, 0xff, 0xff, 0xff, 0x03, 0x00};
  huge.insert(huge.end(), 12, 0);
  write_failing(folder, "limit_exceeded-huge_canvas", huge);

  write_failing(folder, "unsupported_version-required_block",
                join(with_unknown_block(0x7e)));

  const Bytes block = *codec::block_form(two_pages(), {});
  write_failing(folder, "truncated-no_end",
                Bytes(block.begin(), block.end() - 18));
  Bytes damaged = block;
  damaged[block.size() / 2] ^= 0x10;
  write_failing(folder, "checksum_mismatch-block", damaged);
  Bytes trailing = block;
  trailing.push_back(0);
  write_failing(folder, "corrupt-trailing_byte", trailing);

  std::vector<RawBlock> overlap = without_index(take_apart(block));
  overlap[3].content[1] -= 1;
  write_failing(folder, "corrupt-overlapping_bands", join(overlap));
}

void write_path_file(const fs::path& folder, const std::string& name,
                     const Drawing& drawing, const Fidelity& fidelity,
                     const PageInfo& info) {
  UstpWriter writer{EncodeOptions{}};
  const Status added = writer.add_page(drawing, info, fidelity);
  const Result<Bytes> file = writer.finish();
  if (!added || !file) {
    std::fprintf(
        stderr, "%s: %s\n", name.c_str(),
        added ? file.error().message.c_str() : added.error().message.c_str());
    return;
  }
  write(folder / "valid" / (name + ".ustp"), *file);
  std::ofstream(folder / "valid" / (name + ".txt"))
      << text_of(UstpReader::open(*file, {})->info());
  std::ofstream(folder / "valid" / (name + ".paths")) << text_of(drawing.paths);
}

/// Groups that repeat in lines, paths that begin on others, and others.
void write_words(const fs::path& folder) {
  Drawing words;
  words.canvas = {400, 300, YAxis::down};
  words.scale = 2;
  words.paint = Paint::stroke;
  for (std::int32_t i = 0; i < 45; ++i) {
    const Point at{41 + 38 * (i % 15), 60 + 84 * (i / 15)};
    words.paths.push_back({at, false, 4, {line(0, 20)}});
    words.paths.push_back({{at.x, at.y + (i % 2 == 0 ? 0 : 10)},
                           i % 4 == 1,
                           i % 3 == 0 ? 6 : 4,
                           {line(8, 0), line(2, 4 + i % 5 / 4 * 2),
                            line(-10, -4 - i % 5 / 4 * 2)}});
    if (i % 7 == 6)
      words.paths.push_back({{at.x + 12, at.y - 8}, false, 6, {}});
  }
  words.paths.push_back({{300, 500}, false, 2, {line(60, 0), line(0, -80)}});
  words.paths.push_back({{330, 500}, false, 2, {line(0, 40), line(30, 6)}});
  words.paths.push_back(
      {{360, 420}, false, 2, {arc({10, 10}, {20, 20}, false)}});
  write_path_file(folder, "strokes_words", words,
                  {Fidelity::Kind::tolerance, {1, 1}}, {});
}

/// Each kind of element, start and size that the coder knows.
void write_paths(const fs::path& folder) {
  Drawing shapes;
  shapes.canvas = {200, 150, YAxis::down};
  const auto corner = [](Point centre, Point end) {
    return arc(centre, end, true);
  };
  const Path rounded{
      {20, 10},
      true,
      0,
      {line(60, 0), corner({0, 5}, {5, 5}), line(0, 20),
       corner({-5, 0}, {-5, 5}), line(-60, 0), corner({0, -5}, {-5, -5}),
       line(0, -20), corner({5, 0}, {5, -5})}};
  shapes.paths = {rounded,
                  {{100, 60}, true, 0, {arc({12, 9}, {}, false)}},
                  {{60, 90}, true, 0, {line(0, 0), line(9, 3), line(-9, -3)}},
                  {{3, 4}, true, 0, {}},
                  {{9, 70}, true, 0, {line(1, 0), line(0, 1), line(-1, -1)}}};
  shapes.paths.push_back(rounded);
  shapes.paths.back().origin = {30, 60};
  write_path_file(folder, "paths_shapes", shapes,
                  {Fidelity::Kind::tolerance, {1, 1}}, {});

  Drawing strokes;
  strokes.canvas = {0, 0, YAxis::up};
  strokes.scale = 100;
  strokes.paint = Paint::stroke;
  strokes.paths = random_paths(1, 12, 40);
  strokes.paths.push_back({{-kMaxCoord, kMaxCoord},
                           false,
                           kMaxCoord,
                           {line(2 * kMaxCoord, -2 * kMaxCoord),
                            arc({-kMaxCoord, 1}, {-2 * kMaxCoord, 5})}});
  write_path_file(folder, "paths_strokes", strokes,
                  {Fidelity::Kind::tolerance, {3, 4}},
                  {"strokes", {}, {{"svg:title", "strokes"}}});

  write_words(folder);

  Drawing device;
  device.canvas = {300, 300, YAxis::down};
  device.paths = random_paths(2, 60, 30, false);
  write_path_file(folder, "paths_device", device, {Fidelity::Kind::device, {}},
                  {});
}

/// The text of NAME.ngc there, which is kept.
int write_program(const fs::path& folder, const std::string& name) {
  std::ifstream in(folder / "valid" / (name + ".ngc"), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  UstpWriter writer{EncodeOptions{}};
  const Status added = writer.add_program(text, {});
  const Result<Bytes> file = writer.finish();
  if (!added || !file) return 1;
  write(folder / "valid" / (name + ".ustp"), *file);
  std::ofstream(folder / "valid" / (name + ".txt"))
      << text_of(UstpReader::open(*file, {})->info());
  return 0;
}

/// The page of NAME.pbm there, which is kept; blocks of as many rows each.
int write_ink(const fs::path& folder, const std::string& name,
              std::span<char* const> coders) {
  auto bytes =
      read_file((folder / "valid" / (name + ".pbm")).string(), 1U << 24);
  if (!bytes) return 1;
  auto reader = RasterReader::open(*std::move(bytes), {});
  if (!reader) return 1;
  const Result<RasterPage> raster = reader->read(0);
  if (!raster) return 1;
  const Bitmap& ink = raster->ink;
  const auto bands = static_cast<std::int32_t>(coders.size());
  codec::PageParts page = stored_page(ink, bands);
  for (std::size_t i = 0; i < coders.size(); ++i) {
    unsigned coder = 0;
    unsigned revision = 0;
    unsigned table = 0;
    if (std::sscanf(coders[i], "%u.%u.%u", &coder, &revision, &table) != 3)
      return 2;
    codec::BlockParts& block = page.blocks[i];
    block.encoded.name = {static_cast<std::uint8_t>(coder),
                          static_cast<std::uint8_t>(revision),
                          static_cast<std::uint8_t>(table)};
    Result<Bytes> payload =
        encode_rows(ink, block.first_row, block.rows, block.encoded.name);
    if (!payload) return 1;
    block.encoded.payload = *std::move(payload);
  }
  const std::vector pages{page};
  write_valid(folder, name,
              codec::fits_short_form(pages) ? *codec::short_form(page, {})
                                            : *codec::block_form(pages, {}));
  return 0;
}

int describe(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  const Bytes file{std::istreambuf_iterator<char>(in), {}};
  const Result<UstpReader> reader = open(file);
  if (!reader) {
    std::fprintf(stderr, "%s\n", reader.error().message.c_str());
    return 1;
  }
  std::fputs(text_of(reader->info()).c_str(), stdout);
  return 0;
}

}  // namespace
}  // namespace unstep::testing

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--describe") {
    return unstep::testing::describe(argv[2]);
  }
  if (argc == 3 && std::string(argv[1]) == "--paths") {
    unstep::testing::write_paths(argv[2]);
    return 0;
  }
  if (argc == 4 && std::string(argv[1]) == "--program") {
    return unstep::testing::write_program(argv[2], argv[3]);
  }
  if (argc >= 5 && std::string(argv[1]) == "--ink") {
    return unstep::testing::write_ink(
        argv[2], argv[3], {argv + 4, static_cast<std::size_t>(argc - 4)});
  }
  if (argc != 2 || argv[1][0] == '-') {
    std::fprintf(stderr,
                 "usage: make_golden FOLDER | --paths FOLDER | "
                 "--program FOLDER NAME | "
                 "--ink FOLDER NAME CODER.REVISION.TABLE... | "
                 "--describe FILE.ustp\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder / "valid");
  std::filesystem::create_directories(folder / "must_fail");
  unstep::testing::write_all_valid(folder);
  unstep::testing::write_all_failing(folder);
}
