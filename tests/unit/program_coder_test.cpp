#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "codec/block_coder.h"
#include "codec/program_line.h"
#include "unstep/codec.h"
#include "unstep/program.h"

/// Coder 28: every text comes back byte for byte.
namespace unstep::codec {
namespace {

std::uint64_t lines_of(const std::string& text) {
  return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Bytes of the payload.
std::size_t round_trip(const std::string& text) {
  const Result<EncodedBlock> block = encode_program(text, {});
  EXPECT_TRUE(block);
  if (!block) return 0;
  const Result<std::string> back = decode_program(
      block->name, block->payload, lines_of(text), text.size(), {});
  EXPECT_TRUE(back) << back.error().message;
  if (back) {
    EXPECT_EQ(*back, text);
  }
  return block->payload.size();
}

std::string circle(int count) {
  std::string text = "G21 G90\nG0 X10 Y0\nG1 F600\n";
  for (int i = 1; i <= count; ++i) {
    ProgramLine line;
    line.words = 3;
    const double angle = 6.28 * i / count;
    line.value[0] = std::llround(1e5 * std::cos(angle)) * 1000;
    line.value[1] = std::llround(1e5 * std::sin(angle)) * 1000;
    append_line(text, line);
    text += '\n';
  }
  return text;
}

TEST(program_line, is_a_motion_only_in_the_one_spelling) {
  for (const char* text : {"G1 X1.5 Y-2", "G0", "X0.0000001", "G2 I5 J-0.5",
                           "Z-100 F300 S1000", "X199999999.9999999"}) {
    const auto line = parse_line(text);
    ASSERT_TRUE(line) << text;
    std::string again;
    append_line(again, *line);
    EXPECT_EQ(again, text);
  }
  for (const char* text :
       {"",      "G01 X1", "G1X1",       "X1.50",       "X-0",    "X01",
        "Y1 X1", "X1 X2",  "X1 ",        " X1",         "G4 P1",  "G1 X",
        "X1.",   "X.5",    "X300000000", "X1.00000001", "X1  Y2", "G1 ",
        "x1",    "M2",     "(X1)"}) {
    EXPECT_FALSE(parse_line(text)) << text;
  }
}

TEST(program_coder, gives_back_every_byte) {
  for (const char* text :
       {"", "\n", "\n\n\n", "G1\n", "X1\n", "M2\n", "(\xff\x01 odd)\r\n%\n",
        "G91\nX1 Y1\nX1 Y1\nX1 Y1\nG90\nX5 Y5\n", "G2 I5\nG3 I-5\nG2 X1 R3\n",
        "X200000000 Y-200000000\nX-200000000 Y200000000\nX0\nY0\n",
        "G91\nX200000000\nX200000000\nX200000000\n",
        "M83\nG1 X1 E0.5\nX2 E0.5\nX4 E1\n", "A1 B2 C3 U4 V5 W6 K7\n"}) {
    round_trip(text);
  }
}

TEST(program_coder, gives_back_the_programs) {
  for (const char* name : {"arcs.ngc", "inch.ngc", "incremental.ngc",
                           "offsets.ngc", "parameters.ngc", "tiny.ngc"}) {
    std::ifstream in(UNSTEP_SOURCE_DIR "/tests/programs/" + std::string(name),
                     std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    ASSERT_FALSE(text.empty()) << name;
    round_trip(text);
    const Result<Program> program = read_gcode(text, {});
    ASSERT_TRUE(program) << program.error().message;
    GcodeWriteOptions as_it_is;
    as_it_is.add_end = false;
    round_trip(*write_gcode(*program, as_it_is));
  }
}

TEST(program_coder, gives_back_random_lines) {
  std::mt19937 random(7);
  std::string text;
  for (int i = 0; i < 600; ++i) {
    ProgramLine line;
    line.motion = static_cast<int>(random() % 8) - 1;
    if (line.motion > 3) line.motion = -1;
    line.words = random() & random() & 0xffff;
    if (line.motion < 0 && line.words == 0) line.words = 1;
    for (std::int64_t& value : line.value) {
      const auto shift = static_cast<unsigned>(random() % 50);
      value = static_cast<std::int64_t>(
          (std::uint64_t{random()} << 32 | random()) >> 14 >> shift);
      value = std::min(value, kMaxProgramNumber);
      if (random() % 2 == 0) value = -value;
    }
    append_line(text, line);
    text += '\n';
  }
  round_trip(text);
}

TEST(program_coder, forgets_old_motions_alike_on_both_sides) {
  std::string text;
  for (int i = 0; i < 70'000; ++i) {
    text += i % 2 == 0 ? "X" : "Y";
    text += std::to_string(i % 1000);
    text += '\n';
  }
  EXPECT_LT(round_trip(text), 2000U);
}

TEST(program_coder, foresees_smooth_curves) {
  // Two numbers of five digits a line, and each is a step of a circle.
  EXPECT_LT(round_trip(circle(2000)), 2000U * 8 / 8);
}

TEST(program_coder, refuses_a_last_line_without_an_end) {
  EXPECT_FALSE(encode_program("X1", {}));
}

TEST(program_coder, is_sound_when_damaged) {
  const std::string text = circle(8) + "(comment)\nM2\n";
  const Result<EncodedBlock> block = encode_program(text, {});
  ASSERT_TRUE(block);
  for (std::size_t size = 0; size < block->payload.size(); size += 3) {
    const std::span<const std::uint8_t> cut(block->payload.data(), size);
    EXPECT_FALSE(
        decode_program(block->name, cut, lines_of(text), text.size(), {}));
  }
  std::vector<std::uint8_t> bytes = block->payload;
  for (std::size_t bit = 0; bit < bytes.size() * 8; bit += 5) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    const auto back =
        decode_program(block->name, bytes, lines_of(text), text.size(), {});
    if (back) {
      EXPECT_EQ(back->size(), text.size());
    }
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
  }
}

TEST(program_page, is_kept_by_a_file_with_its_tolerance) {
  UstpWriter writer({});
  const std::string text = circle(20);
  ASSERT_TRUE(
      writer.add_program(text, {}, {Fidelity::Kind::tolerance, {1, 200}}));
  Result<std::vector<std::uint8_t>> file = writer.finish();
  ASSERT_TRUE(file);
  const Result<UstpReader> reader = UstpReader::open(*file, {});
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(reader->info().pages[0].kind, PageKind::program);
  EXPECT_EQ(reader->info().pages[0].blocks[0].lines, 23U);
  const Result<Page> page = reader->read_page(0);
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_EQ(page->program, text);
  EXPECT_EQ(page->fidelity.tolerance, (Rational{1, 200}));
  // Every flip of a bit is found, and every cut.
  for (std::size_t bit = 0; bit < file->size() * 8; bit += bit < 152 ? 3 : 97) {
    (*file)[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    const Result<UstpReader> damaged = UstpReader::open(*file, {});
    if (damaged) {
      EXPECT_FALSE(damaged->read_page(0)) << bit;
    }
    (*file)[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
  }
  for (std::size_t size = 0; size < file->size(); size += size < 24 ? 1 : 29) {
    const auto cut = UstpReader::open({file->data(), size}, {});
    if (cut) {
      EXPECT_FALSE(cut->read_page(0)) << size;
    }
  }
}

TEST(program_page, counts_against_the_limits) {
  UstpWriter writer({});
  ASSERT_TRUE(writer.add_program(circle(2000), {}));
  const Result<std::vector<std::uint8_t>> file = writer.finish();
  DecodeOptions options;
  options.limits.max_memory = 10'000;
  const Result<UstpReader> reader = UstpReader::open(*file, options);
  ASSERT_TRUE(reader);
  const Result<Page> page = reader->read_page(0);
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().code, ErrorCode::limit_exceeded);
}

TEST(program_page, has_no_resolution_and_no_device) {
  PageInfo info;
  info.resolution = {{1, 1}, {1, 1}, Resolution::Unit::inch};
  EXPECT_FALSE(UstpWriter({}).add_program("X1\n", info));
  EXPECT_FALSE(
      UstpWriter({}).add_program("X1\n", {}, {Fidelity::Kind::device, {}}));
}

}  // namespace
}  // namespace unstep::codec
