#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "codec/byte_reader.h"
#include "codec/byte_writer.h"
#include "codec/checksum.h"
#include "codec/text_rules.h"
#include "unit/container_testing.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

using codec::ByteReader;
using codec::ByteWriter;
using testing::Bytes;
using testing::random_ink;
using testing::write_pages;

TEST(UstpReader, NamesAPageThatIsNotThere) {
  const Bytes file = write_pages(std::vector{random_ink(5, 5, 1)}, {});
  const Result<UstpReader> reader = testing::open(file);
  ASSERT_TRUE(reader);
  const Result<Page> page = reader->read_page(1);
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().code, ErrorCode::out_of_range);
  EXPECT_EQ(page.error().message, "page 2 of 1");
}

TEST(UstpReader, AppliesItsLimitsToEachPage) {
  const std::vector pages{random_ink(100, 10, 1), random_ink(10, 10, 2)};
  const Bytes file = write_pages(pages, {});
  for (const DecodeLimits& limits :
       {DecodeLimits{999, 0, 1U << 30}, DecodeLimits{1000, 0, 159}}) {
    DecodeOptions options;
    options.limits = limits;
    const Result<UstpReader> reader = UstpReader::open(file, options);
    ASSERT_TRUE(reader) << "what is in a file can be seen within any limit";
    const Result<Page> page = reader->read_page(0);
    ASSERT_FALSE(page);
    EXPECT_EQ(page.error().code, ErrorCode::limit_exceeded);
  }
  DecodeOptions options;
  options.limits.max_pixels = 1000;
  const Result<UstpReader> reader = UstpReader::open(file, options);
  EXPECT_EQ(reader->read_page(0)->ink, pages[0]);
}

TEST(UstpReader, StaysUsableAfterADamagedPage) {
  std::vector<codec::PageParts> pages;
  std::vector<Bitmap> ink;
  for (unsigned i = 0; i < 3; ++i) {
    ink.push_back(random_ink(20, 20, i));
    pages.push_back(testing::stored_page(ink.back(), 1));
  }
  pages[1].blocks[0].encoded.payload[9] ^= 0x40;
  const Bytes file = *codec::block_form(pages, {});
  const Result<UstpReader> reader = testing::open(file);
  ASSERT_TRUE(reader) << reader.error().message;
  const Result<Page> bad = reader->read_page(1);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().message.find("page 2: block 1 (byte "), 0U)
      << bad.error().message;
  EXPECT_EQ(reader->read_page(0)->ink, ink[0]);
  EXPECT_EQ(reader->read_page(2)->ink, ink[2]);
}

TEST(UstpReader, TellsWhereEachPayloadIs) {
  const Bitmap ink = random_ink(64, 12, 4);
  EncodeOptions options;
  options.bands = 3;
  const Bytes file = write_pages(std::vector{ink}, options);
  const Result<UstpReader> reader = testing::open(file);
  ASSERT_TRUE(reader);
  std::uint64_t end = 0;
  for (const PageEntry::Block& block : reader->info().pages[0].blocks) {
    EXPECT_GT(block.offset, end);
    end = block.offset + block.bytes;
    ASSERT_LE(end, file.size());
    // A band decodes from its bytes alone.
    Bitmap band = *Bitmap::create(64, block.rows);
    ASSERT_TRUE(
        codec::decode_ink({block.coder, block.revision, block.table},
                          std::span(file).subspan(block.offset, block.bytes),
                          band, 0, block.rows, {}, {}));
    for (std::int32_t y = 0; y < block.rows; ++y) {
      EXPECT_EQ(band.row(y)[0], ink.row(block.first_row + y)[0]);
    }
  }
}

TEST(ByteReader, ReadsWhatByteWriterWrites) {
  const std::vector<std::uint64_t> numbers{0,
                                           1,
                                           127,
                                           128,
                                           16383,
                                           16384,
                                           (std::uint64_t{1} << 63) - 1,
                                           std::uint64_t{1} << 63,
                                           ~std::uint64_t{0}};
  const std::vector<std::int32_t> coordinates{0,   1,         -1,        64,
                                              -65, kMaxCoord, -kMaxCoord};
  ByteWriter out;
  for (const std::uint64_t number : numbers) out.varint(number);
  for (const std::int32_t coordinate : coordinates) {
    out.coordinate(coordinate);
  }
  out.u32(0x01020304);
  out.u64(0x0102030405060708);
  ByteReader in(out.view(), 100, ErrorCode::truncated);
  for (const std::uint64_t number : numbers) {
    EXPECT_EQ(in.varint("n", ~std::uint64_t{0}), number);
  }
  for (const std::int32_t coordinate : coordinates) {
    EXPECT_EQ(in.coordinate("c"), coordinate);
  }
  EXPECT_EQ(in.u32("u"), 0x01020304U);
  EXPECT_EQ(in.u64("u"), 0x0102030405060708U);
  in.expect_end("test");
  EXPECT_TRUE(in.ok());
  EXPECT_EQ(in.position(), 100 + out.size());
}

TEST(ByteReader, KeepsItsFirstErrorWithItsPlace) {
  const Bytes bytes{0x05, 0x80, 0x00, 0x07};
  ByteReader in(bytes, 40, ErrorCode::truncated);
  EXPECT_EQ(in.varint("first", 9), 5U);
  EXPECT_EQ(in.varint("second", 9), 0U);
  EXPECT_EQ(in.u8("third"), 0U);
  in.bytes("fourth", 100);
  ASSERT_FALSE(in.ok());
  EXPECT_EQ(in.error().code, ErrorCode::corrupt);
  EXPECT_EQ(in.error().message, "byte 41: second has superfluous bytes");
}

TEST(Checksum, SplitIsTheInverseOfJoin) {
  const Bytes first{1, 2, 3};
  const Bytes second{9, 8, 7, 6, 5};
  Bytes both = first;
  both.insert(both.end(), second.begin(), second.end());
  const std::uint32_t joined = codec::crc_join(
      codec::crc_bytes(first), codec::crc_bytes(second), second.size());
  EXPECT_EQ(joined, codec::crc_bytes(both));
  EXPECT_EQ(codec::crc_split(joined, codec::crc_bytes(first), second.size()),
            codec::crc_bytes(second));
}

TEST(Checksum, CoversTheCanonicalBytesOfChains) {
  const std::vector<Chain> chains{{{-2, 258}, Connectivity::four, true, {0, 4}},
                                  {{1, 0}, Connectivity::eight, false, {}}};
  const Bytes canonical{0xfe, 0xff, 0xff, 0xff, 2, 1, 0, 0, 5, 2, 0, 0,
                        0,    0,    0,    0,    0, 0, 4, 1, 0, 0, 0, 0,
                        0,    0,    0,    8,    0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(codec::crc_chains(chains), codec::crc_bytes(canonical));
  EXPECT_EQ(codec::chain_bytes(2, 2), canonical.size());
}

TEST(Checksum, OfBandsJoinsToThatOfThePage) {
  // Some rows are taken together: fewer, as many, more, and a rest.
  for (const std::int32_t rows : {4, 32, 33, 100}) {
    const Bitmap ink = random_ink(70, rows + 5, 8);
    const std::uint32_t joined = codec::crc_join(codec::crc_rows(ink, 0, rows),
                                                 codec::crc_rows(ink, rows, 5),
                                                 5 * codec::row_bytes(70));
    EXPECT_EQ(joined, ink.crc32()) << rows;
  }
}

TEST(TextRules, AcceptsUtf8AndNothingElse) {
  for (const char* text :
       {"", "plain", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf",
        "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_TRUE(codec::is_text(text));
  }
  for (const char* text :
       {"\x80", "\xc1\xbf", "\xc2", "\xe0\x9f\xbf", "\xed\xa0\x80",
        "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82",
        "\xe2\x28\xa1"}) {
    EXPECT_FALSE(codec::is_text(text));
  }
  EXPECT_FALSE(codec::is_text(std::string_view("\0", 1)));
}

}  // namespace
}  // namespace unstep
