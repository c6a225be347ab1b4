#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "codec/byte_writer.h"
#include "codec/checksum.h"
#include "codec/container_format.h"
#include "corrupt/file_surgery.h"
#include "unit/container_testing.h"

/// Block forms whose every CRC is right and whose content lies.
namespace unstep {
namespace {

using codec::ByteWriter;
using testing::Bytes;
using testing::decode_all;
using testing::expect_error;
using testing::join;
using testing::random_ink;
using testing::RawBlock;
using testing::stored_page;
using testing::take_apart;
using testing::without_index;

/// header, metadata, page of 2 bands, page of 1 band, index, end
constexpr std::size_t kHeader = 0;
constexpr std::size_t kMetadata = 1;
constexpr std::size_t kPage = 2;
constexpr std::size_t kBand = 3;
constexpr std::size_t kSecondPage = 5;
constexpr std::size_t kIndex = 7;
constexpr std::size_t kEnd = 8;

Bytes intact_file() {
  const std::vector pages{stored_page(random_ink(20, 10, 1), 2),
                          stored_page(random_ink(9, 9, 2), 1)};
  return *codec::block_form(pages, Metadata{{"title", "t"}});
}

std::vector<RawBlock> intact() { return take_apart(intact_file()); }

void expect_corrupt(const std::vector<RawBlock>& blocks,
                    std::string_view reason) {
  expect_error(join(blocks), ErrorCode::corrupt, reason);
}

/// An ink page block of 20 x 10 with these metadata bytes.
RawBlock page_with_metadata(const Bytes& metadata) {
  ByteWriter out;
  out.bytes(Bytes{codec::kDetailsFlag, 20, 10, codec::kTextsFlag, 0});
  out.bytes(metadata);
  out.varint(2);
  out.u32(random_ink(20, 10, 1).crc32());
  return {codec::kPageBlock, out.take()};
}

/// Length and bytes of a name for a page block without details.
void give_name(RawBlock& page, const Bytes& name) {
  Bytes texts{codec::kTextsFlag};
  texts.insert(texts.end(), name.begin(), name.end());
  texts.push_back(0);  // no metadata
  page.content[0] = codec::kDetailsFlag;
  page.content.insert(page.content.begin() + 3, texts.begin(), texts.end());
}

Bytes metadata_list(const std::string& raw, std::uint64_t claimed) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
  Bytes packed(deflateBound(&stream, static_cast<uLong>(raw.size())));
  Bytes bytes(raw.begin(), raw.end());
  stream.next_in = bytes.data();
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  ByteWriter out;
  out.varint(claimed);
  out.varint(packed.size());
  out.bytes(packed);
  return out.take();
}

Bytes metadata_list(const std::string& raw) {
  return metadata_list(raw, raw.size());
}

TEST(HostileBlockForm, RejoinedIntactFileIsTheSame) {
  ASSERT_EQ(join(intact()), intact_file());
  ASSERT_TRUE(decode_all(intact_file()));
}

TEST(HostileBlockForm, IndexMayBeAbsent) {
  const auto decoded = decode_all(join(without_index(intact())));
  ASSERT_TRUE(decoded) << decoded.error().message;
  EXPECT_TRUE(testing::same(*decoded, *decode_all(intact_file())));
}

TEST(HostileBlockForm, UnknownOptionalBlocksAreSkippedAnywhere) {
  const std::vector<RawBlock> blocks = without_index(intact());
  for (std::size_t at = 1; at < blocks.size(); ++at) {
    std::vector<RawBlock> more = blocks;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(at),
                RawBlock{0xfe, {1, 2, 3}});
    const auto decoded = decode_all(join(more));
    ASSERT_TRUE(decoded) << at << ": " << decoded.error().message;
    EXPECT_TRUE(testing::same(*decoded, *decode_all(intact_file())));
    more[at].type = 0x7e;
    expect_error(join(more), ErrorCode::unsupported_version,
                 "block of unknown type 126");
  }
}

TEST(HostileBlockForm, MisplacedBlocksAreErrors) {
  const std::vector<RawBlock> good = intact();
  std::vector<RawBlock> blocks = good;
  blocks.insert(blocks.begin(), RawBlock{0xfe, {}});
  expect_corrupt(blocks, "does not begin with a header");
  for (std::size_t i = 0; i + 1 < good.size(); ++i) {
    blocks = good;
    blocks.insert(blocks.begin() + static_cast<std::ptrdiff_t>(i), good[i]);
    const auto decoded = decode_all(join(blocks));
    EXPECT_FALSE(decoded) << "block " << i << " twice";
  }
  for (std::size_t i = 0; i < good.size(); ++i) {
    if (i == kMetadata || i == kIndex) continue;
    blocks = without_index(good);
    blocks.erase(blocks.begin() +
                 static_cast<std::ptrdiff_t>(i == kEnd ? kEnd - 1 : i));
    EXPECT_FALSE(decode_all(join(blocks))) << "without block " << i;
  }
  for (std::size_t i = 0; i + 1 < good.size(); ++i) {
    blocks = without_index(good);
    if (i + 1 >= blocks.size()) break;
    std::swap(blocks[i], blocks[i + 1]);
    EXPECT_FALSE(decode_all(join(blocks))) << "swapped " << i;
  }
}

TEST(HostileBlockForm, NothingMayFollowTheEndBlock) {
  std::vector<RawBlock> blocks = intact();
  blocks.push_back(blocks[kEnd]);
  expect_corrupt(blocks, "after the end block");
  blocks.back() = RawBlock{0xfe, {}};
  expect_corrupt(blocks, "after the end block");
}

TEST(HostileBlockForm, PagesMustMatchTheHeaderCount) {
  std::vector<RawBlock> blocks = without_index(intact());
  blocks[kHeader].content[1] = 1;
  expect_corrupt(blocks, "more pages than the header says");
  blocks[kHeader].content[1] = 3;
  expect_corrupt(blocks, "before the last page is complete");
  blocks[kHeader].content[1] = 0;
  expect_corrupt(blocks, "without pages");
  blocks = intact();
  blocks[kHeader].content[0] = 1;
  expect_error(join(blocks), ErrorCode::unsupported_version, "fidelity");
  blocks = intact();
  blocks[kHeader].content.push_back(0);
  expect_corrupt(blocks, "1 bytes too many in a block");
}

TEST(HostileBlockForm, BandsMustTileThePageInOrder) {
  // Band content: coder name, first row, rows, checksum, payload.
  const std::vector<RawBlock> good = without_index(intact());
  for (const auto& [first, rows] :
       {std::pair{4, 6}, {6, 4}, {5, 4}, {5, 6}, {0, 5}, {5, 0}}) {
    std::vector<RawBlock> blocks = good;
    blocks[kBand + 1].content[1] = static_cast<std::uint8_t>(first);
    blocks[kBand + 1].content[2] = static_cast<std::uint8_t>(rows);
    expect_corrupt(blocks, "bands do not tile the page");
  }
  std::vector<RawBlock> blocks = good;
  std::swap(blocks[kBand], blocks[kBand + 1]);
  expect_corrupt(blocks, "bands do not tile the page");
  blocks = good;
  blocks[kBand + 1].content[2] = 0xff;
  blocks[kBand + 1].content.insert(blocks[kBand + 1].content.begin() + 3,
                                   {0xff, 0xff, 0xff, 0x03});
  expect_corrupt(blocks, "bands do not tile the page");
}

TEST(HostileBlockForm, PayloadBlocksMustMatchThePageCount) {
  // Page content: flags, width, height, blocks, CRC.
  std::vector<RawBlock> blocks = without_index(intact());
  blocks[kPage].content[3] = 1;
  expect_corrupt(blocks, "bands do not tile the page");
  blocks[kPage].content[3] = 3;
  expect_corrupt(blocks, "page block in the wrong place");
  blocks[kPage].content[3] = 0;
  expect_corrupt(blocks, "page without payload blocks");
  blocks = without_index(intact());
  blocks.insert(blocks.begin() + kSecondPage, blocks[kBand + 1]);
  expect_corrupt(blocks, "payload block without a page");
  blocks = intact();
  for (const int flag : {1, 2, 8, 16}) {
    blocks[kPage].content[0] = static_cast<std::uint8_t>(flag);
    expect_corrupt(blocks, "unknown page flags");
  }
  blocks = intact();
  blocks[kPage].content[0] = codec::kDetailsFlag;
  blocks[kPage].content.insert(blocks[kPage].content.begin() + 3,
                               codec::kFileMetadataFlag);
  expect_corrupt(blocks, "unknown details");
}

TEST(HostileBlockForm, EveryChecksumIsCompared) {
  std::vector<RawBlock> blocks = intact();
  blocks[kPage].content.back() ^= 1;
  expect_error(join(blocks), ErrorCode::checksum_mismatch,
               "contradict the page's");
  blocks = intact();
  blocks[kBand].content[3] ^= 1;
  expect_error(join(blocks), ErrorCode::checksum_mismatch,
               "contradict the page's");
  blocks = intact();
  blocks[kEnd].content[0] ^= 1;
  expect_error(join(blocks), ErrorCode::checksum_mismatch,
               "contradict the drawing's");
}

TEST(HostileBlockForm, SwappedPayloadIsFoundByTheBandChecksum) {
  // The second page's own checksums, another page's payload of its size.
  std::vector<codec::PageParts> pages{stored_page(random_ink(9, 9, 2), 1),
                                      stored_page(random_ink(9, 9, 3), 1)};
  pages[1].blocks[0].encoded = pages[0].blocks[0].encoded;
  expect_error(*codec::block_form(pages, {}), ErrorCode::checksum_mismatch,
               "page 2: block 1");
}

TEST(HostileBlockForm, IndexMustTellTheTruth) {
  const std::vector<RawBlock> good = intact();
  for (std::size_t i = 0; i < good[kIndex].content.size(); ++i) {
    for (const int change : {1, 2, 0x80}) {
      std::vector<RawBlock> blocks = good;
      blocks[kIndex].content[i] ^= static_cast<std::uint8_t>(change);
      EXPECT_FALSE(decode_all(join(blocks))) << "index byte " << i;
    }
  }
  std::vector<RawBlock> blocks = good;
  blocks[kIndex].content[1] ^= 1;
  expect_corrupt(blocks, "index contradicts the blocks");
  blocks = good;
  blocks[kIndex].content.pop_back();
  expect_corrupt(blocks, "data ends inside");
  blocks = good;
  blocks[kEnd].content[4] ^= 1;
  expect_corrupt(blocks, "does not find the index");
  blocks = good;
  std::rotate(blocks.begin() + kSecondPage, blocks.begin() + kIndex,
              blocks.begin() + kIndex + 1);
  expect_corrupt(blocks, "index block in the wrong place");
}

TEST(HostileBlockForm, MetadataBombsAreDefused) {
  const std::string bomb = "k" + std::string(1, '\0') +
                           std::string(8U << 20, 'v') + std::string(1, '\0');
  std::vector<RawBlock> blocks = intact();
  blocks[kMetadata].content = metadata_list(bomb);
  expect_corrupt(blocks, "at most 1048576");
  blocks[kMetadata].content = metadata_list(bomb, 1000);
  expect_corrupt(blocks, "does not inflate");
  blocks[kMetadata].content = metadata_list(bomb, 1U << 20);
  expect_corrupt(blocks, "does not inflate");
}

TEST(HostileBlockForm, ManyMetadataListsAreLimitedTogether) {
  const std::string megabyte = "k" + std::string(1, '\0') +
                               std::string((1U << 20) - 3, 'v') +
                               std::string(1, '\0');
  const RawBlock page = page_with_metadata(metadata_list(megabyte));
  const std::vector<RawBlock> good = without_index(intact());
  std::vector<RawBlock> blocks{good[kHeader]};
  blocks[0].content[1] = 20;
  for (int i = 0; i < 20; ++i) {
    blocks.push_back(page);
    blocks.push_back(good[kBand]);
    blocks.push_back(good[kBand + 1]);
  }
  expect_error(join(blocks), ErrorCode::corrupt, "metadata");
}

TEST(HostileBlockForm, MetadataMustBeTextUnderDifferentKeys) {
  using namespace std::string_literals;
  const std::string_view not_a_list = "not a list of texts";
  for (const std::string& raw :
       {"a\0b\0a\0c\0"s, "\0b\0"s, "a\0"s, "a\0b"s, "a"s, "a\0\xff\0"s,
        "\xc0\x80\0b\0"s, "\xed\xa0\x80\0b\0"s, "a\0b\0c\0"s}) {
    std::vector<RawBlock> blocks = intact();
    blocks[kMetadata].content = metadata_list(raw);
    expect_corrupt(blocks, not_a_list);
    blocks = intact();
    blocks[kPage] = page_with_metadata(metadata_list(raw));
    expect_corrupt(blocks, not_a_list);
  }
  std::string many;
  for (int i = 0; i < 5000; ++i) many += std::to_string(i) + "\0\0"s;
  std::vector<RawBlock> blocks = intact();
  blocks[kMetadata].content = metadata_list(many);
  expect_corrupt(blocks, not_a_list);
  blocks[kMetadata].content = {0};
  expect_corrupt(blocks, "metadata block without metadata");
  blocks[kMetadata].content = metadata_list("a\0b\0"s);
  blocks[kMetadata].content.push_back(0);
  expect_corrupt(blocks, "too many in a block");
}

TEST(HostileBlockForm, PageNamesMustBeText) {
  for (const Bytes& name :
       {Bytes{1, 0xff}, {1, 0}, {2, 0xc3, 0x28}, {3, 0xe0, 0x80, 0x80}}) {
    std::vector<RawBlock> blocks = intact();
    give_name(blocks[kPage], name);
    expect_corrupt(blocks, "page name is not UTF-8");
  }
  std::vector<RawBlock> blocks = intact();
  give_name(blocks[kPage], {100});
  expect_corrupt(blocks, "data ends inside the page's name");
}

TEST(HostileBlockForm, AbsurdBlockLengthsAreTruncations) {
  Bytes file = intact_file();
  file.resize(6);
  const Bytes length{0xff, 0xff, 0xff, 0xff, 0xff,
                     0xff, 0xff, 0xff, 0xff, 0x01};
  file.insert(file.end(), length.begin(), length.end());
  file.insert(file.end(), 40, 0);
  expect_error(file, ErrorCode::truncated, "data ends inside a block");
}

}  // namespace
}  // namespace unstep
