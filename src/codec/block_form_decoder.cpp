#include "codec/block_form_decoder.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "codec/byte_reader.h"
#include "codec/checksum.h"
#include "codec/container_fields_decoder.h"
#include "codec/metadata_decoder.h"

namespace unstep::codec {
namespace {

constexpr std::uint64_t kAnyNumber = ~std::uint64_t{0};

/// Reads the blocks in file order and keeps what the later ones must match.
class BlockFormParser {
 public:
  BlockFormParser(std::span<const std::uint8_t> file, std::uint64_t start)
      : file_(file), at_(start) {
    parsed_.info.form = FileInfo::Form::block_form;
    parsed_.info.version = kVersion;
  }

  Result<ParsedFile> parse() {
    while (!ended_) {
      if (Status read = read_block(); !read) return read.error();
    }
    if (at_ != file_.size()) {
      return error_at(
          ErrorCode::corrupt, at_,
          std::to_string(file_.size() - at_) + " bytes after the end block");
    }
    return std::move(parsed_);
  }

 private:
  Status read_block() {
    block_start_ = at_;
    ByteReader in(file_.subspan(static_cast<std::size_t>(at_)), at_,
                  ErrorCode::truncated);
    const std::uint8_t type = in.u8("a block's type");
    const std::uint64_t length = in.varint("a block's length", kAnyNumber);
    const std::uint64_t head_bytes = in.position() - at_;
    const std::uint64_t content_start = in.position();
    const auto content = in.bytes("a block", length);
    const std::uint32_t crc = in.u32("a block's CRC");
    if (!in.ok()) return in.error();
    if (crc_bytes(file_.subspan(
            static_cast<std::size_t>(at_),
            static_cast<std::size_t>(head_bytes) + content.size())) != crc) {
      return error_at(ErrorCode::checksum_mismatch, at_,
                      "block is damaged (CRC)");
    }
    at_ = in.position();
    ByteReader body(content, content_start, ErrorCode::corrupt);
    dispatch(type, body);
    if (!body.ok()) return body.error();
    return {};
  }

  void dispatch(std::uint8_t type, ByteReader& in) {
    if (type != kHeaderBlock && !header_seen_) {
      return out_of_order(in, "file does not begin with a header block");
    }
    switch (type) {
      case kHeaderBlock: read_header(in); break;
      case kMetadataBlock: read_file_metadata(in); break;
      case kPageBlock: read_page(in); break;
      case kPayloadBlock: read_payload(in); break;
      case kIndexBlock: read_index(in); break;
      case kEndBlock: read_end(in); break;
      default:
        if ((type & kOptionalBit) == 0) {
          in.fail(ErrorCode::unsupported_version, block_start_,
                  "block of unknown type " + std::to_string(type) +
                      ", needed to read the file");
        }
        return;
    }
    in.expect_end("a block");
  }

  void out_of_order(ByteReader& in, std::string_view reason) const {
    in.fail(ErrorCode::corrupt, block_start_, reason);
  }

  void read_header(ByteReader& in) {
    if (header_seen_) return out_of_order(in, "second header block");
    header_seen_ = true;
    if (in.u8("the fidelity") != kFidelityExact) {
      in.fail(ErrorCode::unsupported_version, in.position() - 1,
              "unknown fidelity");
    }
    pages_ = in.varint("the number of pages", file_.size());
    if (pages_ == 0) out_of_order(in, "file without pages");
  }

  void read_file_metadata(ByteReader& in) {
    if (metadata_seen_ || !parsed_.info.pages.empty()) {
      return out_of_order(in, "metadata block in the wrong place");
    }
    metadata_seen_ = true;
    parsed_.info.metadata = read_metadata(in, metadata_budget_);
    if (parsed_.info.metadata.empty()) {
      out_of_order(in, "metadata block without metadata");
    }
  }

  void read_page(ByteReader& in) {
    if (!page_complete() || index_seen_) {
      return out_of_order(in, "page block in the wrong place");
    }
    if (parsed_.info.pages.size() == pages_) {
      return out_of_order(in, "more pages than the header says");
    }
    PageEntry page;
    const std::uint64_t start = in.position();
    const std::uint8_t flags = in.u8("the page's flags");
    if ((flags & (kVersionMask | kBlockFormFlag | kUsualFlag)) != 0) {
      in.fail(ErrorCode::corrupt, start, "unknown page flags");
    }
    (void)read_page_head(flags, in, {metadata_budget_}, page);
    blocks_due_ = in.varint("the number of payload blocks", file_.size());
    if (blocks_due_ == 0) out_of_order(in, "page without payload blocks");
    page.checksum = in.u32("the page's checksum");
    parsed_.info.pages.push_back(std::move(page));
    parsed_.proofs.emplace_back();
    page_starts_.push_back(block_start_);
    block_starts_.emplace_back();
    next_row_ = 0;
    joined_ = 0;
  }

  void read_payload(ByteReader& in) {
    if (parsed_.info.pages.empty() || page_complete()) {
      return out_of_order(in, "payload block without a page");
    }
    PageEntry& page = parsed_.info.pages.back();
    PageEntry::Block block;
    read_coder_name(in, block);
    std::uint64_t decoded_bytes = read_counts(in, page.kind, block);
    block.box = kEverywhere;
    if (page.kind == PageKind::ink) {
      read_band(in, page, block);
      block.box = {0, block.first_row,
                   static_cast<std::uint32_t>(page.canvas.width),
                   static_cast<std::uint32_t>(block.rows)};
      decoded_bytes =
          row_bytes(page.canvas.width) * static_cast<std::uint64_t>(block.rows);
    }
    const std::uint32_t checksum = in.u32("the block's checksum");
    block.offset = in.position();
    block.bytes = in.left();
    in.rest();
    if (!in.ok()) return;
    parsed_.proofs.back().push_back({checksum, std::nullopt});
    block_starts_.back().push_back(block_start_);
    page.blocks.push_back(block);
    joined_ = crc_join(joined_, checksum, decoded_bytes);
    --blocks_due_;
    if (page_complete()) finish_page(in, page);
  }

  void read_band(ByteReader& in, const PageEntry& page,
                 PageEntry::Block& block) {
    const std::uint64_t start = in.position();
    block.first_row =
        static_cast<std::int32_t>(in.varint("the first row", kMaxCoord));
    block.rows =
        static_cast<std::int32_t>(in.varint("the number of rows", kMaxCoord));
    if (block.first_row != next_row_ || block.rows == 0 ||
        block.rows > page.canvas.height - next_row_) {
      in.fail(ErrorCode::corrupt, start, "bands do not tile the page");
      return;
    }
    next_row_ += block.rows;
  }

  void finish_page(ByteReader& in, const PageEntry& page) {
    if (page.kind == PageKind::ink && next_row_ != page.canvas.height) {
      return out_of_order(in, "bands do not tile the page");
    }
    if (joined_ != page.checksum) {
      in.fail(ErrorCode::checksum_mismatch, block_start_,
              "checksums of the blocks contradict the page's");
    }
  }

  void read_index(ByteReader& in) {
    if (index_seen_ || !all_pages_complete()) {
      return out_of_order(in, "index block in the wrong place");
    }
    index_seen_ = true;
    index_start_ = block_start_;
    bool true_index =
        in.varint("the index", kAnyNumber) == parsed_.info.pages.size();
    for (std::size_t p = 0; in.ok() && true_index && p < page_starts_.size();
         ++p) {
      true_index =
          in.varint("the index", kAnyNumber) == page_starts_[p] &&
          in.varint("the index", kAnyNumber) == block_starts_[p].size();
      for (std::size_t b = 0;
           in.ok() && true_index && b < block_starts_[p].size(); ++b) {
        true_index = index_entry_matches(in, p, b);
      }
    }
    if (!true_index) {
      in.fail(ErrorCode::corrupt, in.position(),
              "index contradicts the blocks");
    }
  }

  bool index_entry_matches(ByteReader& in, std::size_t p, std::size_t b) {
    PageEntry& page = parsed_.info.pages[p];
    PageEntry::Block& block = page.blocks[b];
    if (in.varint("the index", kAnyNumber) != block_starts_[p][b]) return false;
    const Box box = read_box(in);
    if (page.kind == PageKind::ink) return box == block.box;
    if (page.kind == PageKind::program && box != Box{}) return false;
    parsed_.proofs[p][b].box = box;
    block.box = box;
    return true;
  }

  void read_end(ByteReader& in) {
    if (!all_pages_complete()) {
      return out_of_order(in, "end block before the last page is complete");
    }
    std::uint32_t crc = 0;
    for (const PageEntry& page : parsed_.info.pages) {
      const std::array<std::uint8_t, 4> bytes{
          static_cast<std::uint8_t>(page.checksum),
          static_cast<std::uint8_t>(page.checksum >> 8),
          static_cast<std::uint8_t>(page.checksum >> 16),
          static_cast<std::uint8_t>(page.checksum >> 24)};
      crc = crc_bytes(bytes, crc);
    }
    const std::uint64_t start = in.position();
    if (in.u32("the drawing's checksum") != crc) {
      in.fail(ErrorCode::checksum_mismatch, start,
              "checksums of the pages contradict the drawing's");
    }
    if (in.u64("the offset of the index") != (index_seen_ ? index_start_ : 0)) {
      in.fail(ErrorCode::corrupt, start, "end block does not find the index");
    }
    ended_ = true;
  }

  [[nodiscard]] bool page_complete() const { return blocks_due_ == 0; }
  [[nodiscard]] bool all_pages_complete() const {
    return page_complete() && parsed_.info.pages.size() == pages_;
  }

  std::span<const std::uint8_t> file_;
  std::uint64_t at_;
  std::uint64_t block_start_ = 0;
  ParsedFile parsed_;
  bool header_seen_ = false;
  bool metadata_seen_ = false;
  bool index_seen_ = false;
  bool ended_ = false;
  std::uint64_t metadata_budget_ = kMaxMetadataTotal;
  std::uint64_t pages_ = 0;
  std::uint64_t blocks_due_ = 0;  ///< of the page being read
  std::int32_t next_row_ = 0;
  std::uint32_t joined_ = 0;
  std::uint64_t index_start_ = 0;
  std::vector<std::uint64_t> page_starts_;
  std::vector<std::vector<std::uint64_t>> block_starts_;
};

}  // namespace

Result<ParsedFile> parse_block_form(std::span<const std::uint8_t> file,
                                    std::uint64_t start) {
  return BlockFormParser(file, start).parse();
}

}  // namespace unstep::codec
