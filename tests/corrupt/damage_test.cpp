#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "corrupt/file_surgery.h"
#include "unit/container_testing.h"
#include "unit/path_testing.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

using testing::arc;
using testing::Bytes;
using testing::decode_all;
using testing::Decoded;
using testing::ink_of;
using testing::line;
using testing::random_ink;
using testing::stored_page;
using testing::write_pages;

struct Sample {
  std::string name;
  Bytes file;
};

PageInfo rich_info() {
  return {"sheet 1",
          {{300, 1}, {1181, 10}, Resolution::Unit::inch},
          {{"tiff:Artist", "somebody"}}};
}

Bytes rich_file(int bands) {
  EncodeOptions options;
  options.bands = bands;
  options.metadata = {{"title", "two pages"}};
  return write_pages(std::vector{random_ink(19, 14, 1), random_ink(33, 9, 2)},
                     options, rich_info());
}

Bytes with_resolution(const Bitmap& ink) {
  PageInfo info;
  info.resolution = rich_info().resolution;
  return write_pages(std::vector{ink}, {}, info);
}

Drawing strokes() {
  Drawing drawing;
  drawing.canvas = {40, 30, YAxis::down};
  drawing.chains = {
      {{3, 4}, Connectivity::four, true, {0, 0, 0, 6, 6, 4, 4, 4, 2, 2}},
      {{-2, 9}, Connectivity::eight, false, {0, 1, 0, 1, 7, 0, 0, 6, 5}},
      {{30, 20}, Connectivity::eight, true, {}},
      {{7, 8}, Connectivity::eight, false, std::vector<Step>(2000, 7)}};
  drawing.chains.back().steps[999] = 6;
  return drawing;
}

Bytes write_chains(EncodeOptions options, const PageInfo& info) {
  UstpWriter writer(std::move(options));
  const Status added = writer.add_page(strokes(), info);
  EXPECT_TRUE(added) << added.error().message;
  const Result<Bytes> file = writer.finish();
  EXPECT_TRUE(file) << file.error().message;
  return file ? *file : Bytes{};
}

Bytes write_paths(EncodeOptions options, const PageInfo& info) {
  Drawing drawing;
  drawing.canvas = {40, 30, YAxis::down};
  drawing.paths = {
      {{3, 4}, true, 0, {line(9, 0), line(0, 7), line(-9, -7)}},
      {{12, 5}, true, 2, {arc({3, 0}, {6, 0}), line(-6, 0)}},
      {{-2, 9}, false, 0, {line(5, 2), line(5, 3), arc({4, 3}, {})}}};
  UstpWriter writer(std::move(options));
  const Status added =
      writer.add_page(drawing, info, {Fidelity::Kind::tolerance, {1, 1}});
  EXPECT_TRUE(added) << added.error().message;
  const Result<Bytes> file = writer.finish();
  EXPECT_TRUE(file) << file.error().message;
  return file ? *file : Bytes{};
}

/// What `unstep batch` adds to every file.
EncodeOptions batch_options() {
  EncodeOptions options;
  options.metadata = {{"unstep:source-size", "4711"},
                      {"unstep:source-crc32", "0badcafe"}};
  return options;
}

/// A ring and a bar: curves, corners, a hole.
Bitmap icon() {
  Bitmap ink = *Bitmap::create(31, 27);
  for (std::int32_t y = 0; y < 27; ++y) {
    for (std::int32_t x = 0; x < 31; ++x) {
      const std::int32_t r = (x - 12) * (x - 12) + (y - 13) * (y - 13);
      ink.set(x, y, (r >= 36 && r <= 110) || (x > 24 && x < 28 && y > 2));
    }
  }
  return ink;
}

/// Files whose every payload comes from an arithmetic coder.
std::vector<Sample> coded_samples() {
  return {
      {"coded white", write_pages(std::vector{*Bitmap::create(8, 8)}, {})},
      {"coded dot",
       write_pages(std::vector{ink_of({"...", ".#.", "..."})}, {})},
      {"icon", with_resolution(icon())},
      {"chains from batch", write_chains(batch_options(), {})},
      {"paths", write_paths({}, {})},
  };
}

std::vector<Sample> samples() {
  const Bitmap glyph =
      ink_of({"........", ".######.", ".#....#.", ".#.##.#.",  //
              ".#.##.#.", ".#....#.", ".######.", "........"});
  const Bitmap noise = random_ink(37, 23, 9);
  const std::vector stored_bands{stored_page(noise, 3, rich_info())};
  return {
      {"white", write_pages(std::vector{*Bitmap::create(8, 8)}, {})},
      {"glyph", write_pages(std::vector{glyph}, {})},
      {"noise", write_pages(std::vector{noise}, {})},
      {"resolution", with_resolution(glyph)},
      {"two pages", rich_file(1)},
      {"two pages in bands", rich_file(3)},
      {"stored", *codec::short_form(stored_page(noise, 1), {})},
      {"stored bands", *codec::block_form(stored_bands, {})},
      {"paths from batch", write_paths(batch_options(), rich_info())},
  };
}

/// An error with a message, or the very same pages.
void expect_harmless(const Bytes& damaged, const Decoded& intact) {
  const Result<Decoded> decoded = decode_all(damaged);
  if (decoded) {
    EXPECT_TRUE(testing::same(*decoded, intact)) << "another drawing";
    return;
  }
  EXPECT_FALSE(decoded.error().message.empty());
  EXPECT_EQ(decoded.error().message.find('\n'), std::string::npos);
  EXPECT_NE(decoded.error().code, ErrorCode::internal)
      << decoded.error().message;
}

TEST(Damage, TruncationAtEveryByteIsAnErrorOrHarmless) {
  for (const Sample& sample : samples()) {
    const Result<Decoded> intact = decode_all(sample.file);
    ASSERT_TRUE(intact) << sample.name << ": " << intact.error().message;
    for (std::size_t size = 0; size < sample.file.size(); ++size) {
      SCOPED_TRACE(sample.name + " cut to " + std::to_string(size));
      expect_harmless(
          Bytes(sample.file.begin(),
                sample.file.begin() + static_cast<std::ptrdiff_t>(size)),
          *intact);
    }
  }
}

TEST(Damage, TruncatedBlockFormIsAlwaysAnError) {
  const Bytes file = rich_file(2);
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_FALSE(decode_all(std::span(file).first(size))) << size;
  }
}

TEST(Damage, EveryFlippedBitIsAnErrorOrHarmless) {
  for (const Sample& sample : samples()) {
    const Result<Decoded> intact = decode_all(sample.file);
    ASSERT_TRUE(intact) << sample.name << ": " << intact.error().message;
    Bytes damaged = sample.file;
    for (std::size_t bit = 0; bit < 8 * damaged.size(); ++bit) {
      SCOPED_TRACE(sample.name + " bit " + std::to_string(bit));
      const auto mask = static_cast<std::uint8_t>(1U << bit % 8);
      damaged[bit / 8] ^= mask;
      expect_harmless(damaged, *intact);
      damaged[bit / 8] ^= mask;
    }
  }
}

TEST(Damage, EveryFlippedBitOutsideAPayloadIsAnError) {
  for (const Sample& sample : samples()) {
    Bytes damaged = sample.file;
    const Result<UstpReader> reader = testing::open(sample.file);
    ASSERT_TRUE(reader);
    // In the block form a CRC covers the payload too.
    const bool short_form = reader->info().form == FileInfo::Form::short_form;
    const std::size_t end =
        short_form
            ? static_cast<std::size_t>(reader->info().pages[0].blocks[0].offset)
            : damaged.size();
    for (std::size_t bit = 0; bit < 8 * end; ++bit) {
      const auto mask = static_cast<std::uint8_t>(1U << bit % 8);
      damaged[bit / 8] ^= mask;
      EXPECT_FALSE(decode_all(damaged)) << sample.name << " bit " << bit;
      damaged[bit / 8] ^= mask;
    }
  }
}

/// An arithmetic coder's payload has one spelling: no flip or cut gives the
/// same drawing again.
TEST(Damage, AnyChangeOfACodedFileIsAnError) {
  for (const Sample& sample : coded_samples()) {
    const Result<Decoded> intact = decode_all(sample.file);
    ASSERT_TRUE(intact) << sample.name << ": " << intact.error().message;
    Bytes damaged = sample.file;
    for (std::size_t bit = 0; bit < 8 * damaged.size(); ++bit) {
      const auto mask = static_cast<std::uint8_t>(1U << bit % 8);
      damaged[bit / 8] ^= mask;
      EXPECT_FALSE(decode_all(damaged)) << sample.name << " bit " << bit;
      damaged[bit / 8] ^= mask;
    }
    for (std::size_t size = 0; size < damaged.size(); ++size) {
      EXPECT_FALSE(decode_all(std::span(damaged).first(size)))
          << sample.name << " cut to " << size;
    }
  }
}

TEST(Damage, AppendedBytesAreAnError) {
  for (const Sample& sample : samples()) {
    for (const int extra : {0x00, 0x0a, 0xff}) {
      Bytes longer = sample.file;
      longer.push_back(static_cast<std::uint8_t>(extra));
      EXPECT_FALSE(decode_all(longer)) << sample.name << " + " << extra;
    }
  }
}

TEST(Damage, TextModeTransferIsRecognised) {
  for (const Sample& sample : samples()) {
    Bytes to_unix;
    Bytes to_dos;
    Bytes seven_bits;
    for (std::size_t i = 0; i < sample.file.size(); ++i) {
      const std::uint8_t byte = sample.file[i];
      const bool before_lf =
          i + 1 < sample.file.size() && sample.file[i + 1] == '\n';
      if (byte != '\r' || !before_lf) to_unix.push_back(byte);
      if (byte == '\n') to_dos.push_back('\r');
      to_dos.push_back(byte);
      seven_bits.push_back(byte & 0x7f);
    }
    for (const Bytes& file : {to_unix, to_dos, seven_bits}) {
      const Result<Decoded> decoded = decode_all(file);
      ASSERT_FALSE(decoded);
      EXPECT_EQ(decoded.error().code, ErrorCode::bad_magic);
    }
  }
}

}  // namespace
}  // namespace unstep
