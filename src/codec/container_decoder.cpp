#include "codec/container_decoder.h"

#include <algorithm>
#include <string>
#include <utility>

#include "codec/block_form_decoder.h"
#include "codec/byte_reader.h"
#include "codec/checksum.h"
#include "codec/container_fields_decoder.h"

namespace unstep::codec {
namespace {

/// After the signature and `flags`: one page, one block, no frame.
Result<ParsedFile> parse_short_form(std::uint8_t flags, ByteReader& in,
                                    std::span<const std::uint8_t> file) {
  const std::uint64_t head_start = in.position() - 1;
  PageEntry page;
  PageEntry::Block block;
  std::uint64_t budget = kMaxMetadataTotal;
  Metadata of_file;
  const HeadCoder coder = read_page_head(flags, in, {budget, &of_file}, page);
  read_short_coder_name(coder, in, page, block);
  std::uint64_t decoded_bytes = read_counts(in, page.kind, block);
  block.box = kEverywhere;
  if (page.kind == PageKind::ink) {
    block.box = {0, 0, static_cast<std::uint32_t>(page.canvas.width),
                 static_cast<std::uint32_t>(page.canvas.height)};
    block.rows = page.canvas.height;
    decoded_bytes = row_bytes(page.canvas.width) *
                    static_cast<std::uint64_t>(page.canvas.height);
  }
  const auto head = file.subspan(static_cast<std::size_t>(head_start),
                                 in.position() - head_start);
  const std::uint32_t joined = in.u32("the checksum");
  block.offset = in.position();
  block.bytes = in.left();
  if (!in.ok()) return in.error();
  page.checksum = crc_split(joined, crc_bytes(head), decoded_bytes);

  ParsedFile parsed;
  parsed.info.form = FileInfo::Form::short_form;
  parsed.info.version = kVersion;
  parsed.info.metadata = std::move(of_file);
  parsed.proofs.push_back({BlockProof{page.checksum, std::nullopt}});
  page.blocks.push_back(block);
  parsed.info.pages.push_back(std::move(page));
  return parsed;
}

}  // namespace

Result<ParsedFile> parse_file(std::span<const std::uint8_t> file) {
  const std::size_t known = std::min(file.size(), kSignature.size());
  if (known == 0 ||
      !std::equal(file.begin(),
                  file.begin() + static_cast<std::ptrdiff_t>(known),
                  kSignature.begin())) {
    return error_at(ErrorCode::bad_magic, 0, "not a .ustp file");
  }
  ByteReader in(file, 0, ErrorCode::truncated);
  in.bytes("the signature", kSignature.size());
  const std::uint8_t flags = in.u8("the version");
  if (!in.ok()) return in.error();
  if ((flags & kVersionMask) != kVersion) {
    return error_at(ErrorCode::unsupported_version, 4,
                    "format version " + std::to_string(flags & kVersionMask) +
                        " is unknown; this program reads version 0");
  }
  if ((flags & kBlockFormFlag) == 0) return parse_short_form(flags, in, file);
  if (flags != (kVersion | kBlockFormFlag)) {
    return error_at(ErrorCode::corrupt, 4, "page flags in a block form");
  }
  return parse_block_form(file, in.position());
}

}  // namespace unstep::codec
