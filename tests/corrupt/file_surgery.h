#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "codec/byte_reader.h"
#include "codec/byte_writer.h"
#include "codec/checksum.h"
#include "codec/container_format.h"
#include "unstep/codec.h"

/// Takes .ustp files apart and joins them again with right CRCs, so that a
/// test reaches what lies behind the CRC.
namespace unstep::testing {

struct RawBlock {
  std::uint8_t type = 0;
  std::vector<std::uint8_t> content;
};

/// REQUIRES: a valid file in block form.
inline std::vector<RawBlock> take_apart(std::span<const std::uint8_t> file) {
  codec::ByteReader in(file.subspan(5), 5, ErrorCode::truncated);
  std::vector<RawBlock> blocks;
  while (in.left() > 0) {
    RawBlock block;
    block.type = in.u8("type");
    const auto content = in.bytes("content", in.varint("length", 1U << 30));
    block.content.assign(content.begin(), content.end());
    in.u32("crc");
    blocks.push_back(std::move(block));
  }
  return blocks;
}

inline std::vector<std::uint8_t> join(std::span<const RawBlock> blocks) {
  codec::ByteWriter out;
  out.bytes(codec::kSignature);
  out.u8(codec::kVersion | codec::kBlockFormFlag);
  for (const RawBlock& block : blocks) {
    const std::uint64_t start = out.size();
    out.u8(block.type);
    out.varint(block.content.size());
    out.bytes(block.content);
    out.u32(codec::crc_bytes(
        std::span(out.view()).subspan(static_cast<std::size_t>(start))));
  }
  return out.take();
}

/// The blocks without an index, as a file may be.
inline std::vector<RawBlock> without_index(std::vector<RawBlock> blocks) {
  std::erase_if(blocks, [](const RawBlock& block) {
    return block.type == codec::kIndexBlock;
  });
  std::fill(blocks.back().content.begin() + 4, blocks.back().content.end(),
            std::uint8_t{0});
  return blocks;
}

struct Decoded {
  Metadata metadata;
  std::vector<Page> pages;
};

/// Limits that keep a test quick however large a damaged header says it is.
inline DecodeLimits small_limits() { return {1U << 20, 1U << 20, 16U << 20}; }

inline Result<Decoded> decode_all(std::span<const std::uint8_t> file) {
  DecodeOptions options;
  options.limits = small_limits();
  Result<UstpReader> reader = UstpReader::open(file, options);
  if (!reader) return reader.error();
  Decoded decoded;
  decoded.metadata = reader->info().metadata;
  for (std::size_t i = 0; i < reader->info().pages.size(); ++i) {
    Result<Page> page = reader->read_page(i);
    if (!page) return page.error();
    decoded.pages.push_back(*std::move(page));
  }
  return decoded;
}

inline bool same(const Decoded& a, const Decoded& b) {
  if (a.metadata != b.metadata || a.pages.size() != b.pages.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.pages.size(); ++i) {
    const Page& p = a.pages[i];
    const Page& q = b.pages[i];
    if (p.kind != q.kind || p.info != q.info || p.ink != q.ink ||
        p.drawing != q.drawing || p.fidelity != q.fidelity) {
      return false;
    }
  }
  return true;
}

/// The file is refused, the message holding the reason.
inline void expect_error(const std::vector<std::uint8_t>& file, ErrorCode code,
                         std::string_view reason) {
  const auto decoded = decode_all(file);
  ASSERT_FALSE(decoded) << "expected: " << reason;
  EXPECT_EQ(to_string(decoded.error().code), to_string(code))
      << decoded.error().message;
  EXPECT_NE(decoded.error().message.find(reason), std::string::npos)
      << decoded.error().message;
}

}  // namespace unstep::testing
