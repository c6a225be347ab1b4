#include "codec/container_encoder.h"

#include <string>
#include <utility>

#include "codec/byte_writer.h"
#include "codec/checksum.h"
#include "codec/metadata_encoder.h"
#include "codec/path_checksum.h"
#include "codec/text_rules.h"

namespace unstep::codec {
namespace {

std::uint8_t kind_flags(const PageParts& page) {
  if (page.kind == PageKind::ink) return kInkKind;
  if (page.kind == PageKind::paths || page.kind == PageKind::program) {
    return kPathsKind;
  }
  return page.canvas.y_axis == YAxis::up ? kChainsUpKind : kChainsKind;
}

std::uint8_t path_flags(const PageParts& page) {
  auto flags = static_cast<std::uint8_t>(page.fidelity.kind);
  if (page.kind == PageKind::program) flags |= kProgramFlag;
  if (page.canvas.y_axis == YAxis::up) flags |= kPathsUpFlag;
  if (page.paint == Paint::stroke) flags |= kStrokeFlag;
  if (page.scale != 1) flags |= kScaleFlag;
  if (page.fidelity.kind == Fidelity::Kind::tolerance &&
      page.fidelity.tolerance.denominator != 1) {
    flags |= kDenominatorFlag;
  }
  return flags;
}

/// `other_flags`: bit 7.
void put_path_head(const PageParts& page, std::uint8_t other_flags,
                   ByteWriter& out) {
  const bool tolerance = page.fidelity.kind == Fidelity::Kind::tolerance;
  const Rational& e = page.fidelity.tolerance;
  out.u8(path_flags(page) | other_flags);
  if (tolerance) out.varint(e.numerator);
  if (tolerance && e.denominator != 1) out.varint(e.denominator);
  if (page.scale != 1) out.varint(static_cast<std::uint64_t>(page.scale));
}

/// What of the page a block holds, and how many canonical bytes that is.
std::uint64_t put_counts(const PageParts& page, const BlockParts& block,
                         ByteWriter& out) {
  if (page.kind == PageKind::ink) {
    return row_bytes(page.canvas.width) *
           static_cast<std::uint64_t>(block.rows);
  }
  if (page.kind == PageKind::program) {
    out.varint(block.lines);
    out.varint(block.text_bytes);
    return block.text_bytes;
  }
  const bool chains = page.kind == PageKind::chains;
  out.varint(chains ? block.chains : block.paths);
  out.varint(chains ? block.steps : block.elements);
  return chains ? chain_bytes(block.chains, block.steps)
                : path_bytes(block.paths, block.elements);
}

void put_coder_name(const CoderName& name, ByteWriter& out) {
  if (name.revision <= 2 && name.table <= 1) {
    out.u8(static_cast<std::uint8_t>(name.coder | name.revision << 5 |
                                     name.table << 7));
  } else {
    out.u8(static_cast<std::uint8_t>(name.coder | 3U << 5));
    out.u8(name.revision);
    out.u8(name.table);
  }
}

void put_resolution(const Resolution& resolution, ByteWriter& out) {
  out.varint(resolution.x.numerator);
  out.varint(resolution.x.denominator);
  if (resolution.x == resolution.y) return;
  out.varint(resolution.y.numerator);
  out.varint(resolution.y.denominator);
}

/// `of_file`: the file's metadata, if the page head has to hold them.
std::uint8_t details_of(const PageInfo& info, const Metadata& of_file) {
  std::uint8_t details = 0;
  const Resolution& resolution = info.resolution;
  if (resolution != Resolution{}) {
    details |= kResolutionFlag | static_cast<std::uint8_t>(resolution.unit);
    if (resolution.x == resolution.y) details |= kSameBothWaysFlag;
  }
  if (!info.name.empty() || !info.metadata.empty()) details |= kTextsFlag;
  if (!of_file.empty()) details |= kFileMetadataFlag;
  return details;
}

Status put_details(std::uint8_t details, const PageInfo& info,
                   const Metadata& of_file, ByteWriter& out) {
  out.u8(details);
  if ((details & kResolutionFlag) != 0) put_resolution(info.resolution, out);
  if ((details & kTextsFlag) != 0) {
    out.varint(info.name.size());
    out.bytes({reinterpret_cast<const std::uint8_t*>(info.name.data()),
               info.name.size()});
    if (Status put = write_metadata(info.metadata, out); !put) return put;
  }
  if ((details & kFileMetadataFlag) == 0) return {};
  return write_metadata(of_file, out);
}

/// What a short form's head can say of the coder.
HeadCoder head_coder_of(const PageParts& page, const CoderName& name) {
  if (name == usual_coder(page.kind)) return HeadCoder::usual;
  const bool strokes =
      kind_flags(page) == kPathsKind && name == kUsualStrokeCoder &&
      path_flags(page) == kUsualStrokeHead && page.fidelity == kUsualFidelity &&
      page.scale == kUsualStrokeScale;
  return strokes ? HeadCoder::strokes : HeadCoder::named;
}

/// Page flags, canvas, details, path head. `other_flags` fill bits 0, 1 and 4.
Status put_page_head(const PageParts& page, std::uint8_t other_flags,
                     HeadCoder coder, const Metadata& of_file,
                     ByteWriter& out) {
  const bool usual = coder == HeadCoder::usual;
  const bool paths = kind_flags(page) == kPathsKind;
  const bool no_path_head = usual && path_flags(page) == kUsualPathHead &&
                            page.fidelity == kUsualFidelity;
  const std::uint8_t details = details_of(page.info, of_file);
  const bool square = page.canvas.width == page.canvas.height;
  std::uint8_t flags = other_flags;
  if (usual && (!paths || no_path_head)) flags |= kUsualFlag;
  if (square) flags |= kSquareFlag;
  if (details != 0) flags |= kDetailsFlag;
  flags |= kind_flags(page);
  out.u8(flags);
  out.varint(static_cast<std::uint64_t>(page.canvas.width));
  if (!square) out.varint(static_cast<std::uint64_t>(page.canvas.height));
  if (details != 0) {
    if (Status put = put_details(details, page.info, of_file, out); !put) {
      return put;
    }
  }
  if (coder == HeadCoder::strokes) {
    out.u8(kUsualStrokes);
  } else if (paths && !no_path_head) {
    put_path_head(page, usual ? kUsualPathCoderFlag : std::uint8_t{0}, out);
  }
  return {};
}

/// Type, length, content, CRC of all three.
void put_block(std::uint8_t type, const ByteWriter& content, ByteWriter& out) {
  ByteWriter head;
  head.u8(type);
  head.varint(content.size());
  out.bytes(head.view());
  out.bytes(content.view());
  out.u32(crc_bytes(content.view(), crc_bytes(head.view())));
}

Status put_page(const PageParts& page, ByteWriter& out) {
  ByteWriter content;
  if (Status put = put_page_head(page, 0, HeadCoder::named, {}, content);
      !put) {
    return put;
  }
  content.varint(page.blocks.size());
  content.u32(page.checksum);
  put_block(kPageBlock, content, out);
  return {};
}

void put_payload(const PageParts& page, const BlockParts& block,
                 ByteWriter& out) {
  ByteWriter content;
  put_coder_name(block.encoded.name, content);
  put_counts(page, block, content);
  if (page.kind == PageKind::ink) {
    content.varint(static_cast<std::uint64_t>(block.first_row));
    content.varint(static_cast<std::uint64_t>(block.rows));
  }
  content.u32(block.checksum);
  content.bytes(block.encoded.payload);
  put_block(kPayloadBlock, content, out);
}

void put_box(const Box& box, ByteWriter& out) {
  out.coordinate(box.x);
  out.coordinate(box.y);
  out.varint(box.width);
  out.varint(box.height);
}

Status check_canvas(PageKind kind, const Canvas& canvas) {
  const bool unbounded = canvas.width == 0 && canvas.height == 0;
  const bool in_range = canvas.width >= 1 && canvas.width <= kMaxCoord &&
                        canvas.height >= 1 && canvas.height <= kMaxCoord;
  if (!in_range && !(unbounded && kind != PageKind::ink)) {
    return Error{ErrorCode::out_of_range,
                 "canvas of " + std::to_string(canvas.width) + " x " +
                     std::to_string(canvas.height) + "; sides are 1 to " +
                     std::to_string(kMaxCoord)};
  }
  return {};
}

Status check_path_head(const PageParts& page) {
  if (page.kind == PageKind::program &&
      (page.canvas != Canvas{} || page.info.resolution != Resolution{} ||
       page.fidelity.kind == Fidelity::Kind::device)) {
    return Error{ErrorCode::invalid_argument,
                 "a program has no canvas, no resolution and no device"};
  }
  if (page.fidelity.kind > Fidelity::Kind::device ||
      page.fidelity.tolerance.denominator == 0) {
    return Error{ErrorCode::invalid_argument,
                 "fidelity of an unknown kind or with a zero denominator"};
  }
  if (page.scale < 1 || page.scale > Drawing::kMaxScale) {
    return Error{ErrorCode::out_of_range,
                 "scale of " + std::to_string(page.scale) + "; it is 1 to " +
                     std::to_string(Drawing::kMaxScale)};
  }
  if (page.paint > Paint::stroke) {
    return Error{ErrorCode::invalid_argument, "unknown kind of paint"};
  }
  return {};
}

Status check_metadata_total(std::span<const PageParts> pages,
                            const Metadata& metadata) {
  std::uint64_t cost = metadata_cost(metadata_bytes(metadata), metadata.size());
  for (const PageParts& page : pages) {
    const Metadata& list = page.info.metadata;
    cost += metadata_cost(metadata_bytes(list), list.size());
  }
  if (cost > kMaxMetadataTotal) {
    return Error{ErrorCode::limit_exceeded, "too much metadata for one file"};
  }
  return {};
}

}  // namespace

Status check_page(const PageParts& page) {
  const PageInfo& info = page.info;
  if (Status valid = check_canvas(page.kind, page.canvas); !valid) return valid;
  if (Status valid = check_path_head(page); !valid) return valid;
  if (info.name.size() > kMaxNameBytes) {
    return Error{ErrorCode::limit_exceeded,
                 "page name of " + std::to_string(info.name.size()) +
                     " bytes, at most " + std::to_string(kMaxNameBytes) +
                     " are possible"};
  }
  if (!is_text(info.name)) {
    return Error{ErrorCode::invalid_argument, "page name is not UTF-8 text"};
  }
  if (info.resolution.x.denominator == 0 ||
      info.resolution.y.denominator == 0 ||
      info.resolution.unit > Resolution::Unit::metre) {
    return Error{ErrorCode::invalid_argument,
                 "resolution has a zero denominator or an unknown unit"};
  }
  ByteWriter unused;
  return write_metadata(info.metadata, unused);
}

bool fits_short_form(std::span<const PageParts> pages) {
  return pages.size() == 1 && pages[0].blocks.size() == 1;
}

Result<std::vector<std::uint8_t>> short_form(const PageParts& page,
                                             const Metadata& metadata) {
  if (Status fits = check_metadata_total({&page, 1}, metadata); !fits) {
    return fits.error();
  }
  const BlockParts& block = page.blocks[0];
  const HeadCoder coder = head_coder_of(page, block.encoded.name);
  ByteWriter head;
  if (Status put = put_page_head(page, kVersion, coder, metadata, head); !put) {
    return put.error();
  }
  if (coder == HeadCoder::named) put_coder_name(block.encoded.name, head);
  const std::uint64_t decoded_bytes = put_counts(page, block, head);
  ByteWriter out;
  out.bytes(kSignature);
  out.bytes(head.view());
  out.u32(crc_join(crc_bytes(head.view()), page.checksum, decoded_bytes));
  out.bytes(block.encoded.payload);
  return out.take();
}

Result<std::vector<std::uint8_t>> block_form(std::span<const PageParts> pages,
                                             const Metadata& metadata) {
  if (Status fits = check_metadata_total(pages, metadata); !fits) {
    return fits.error();
  }
  ByteWriter out;
  out.bytes(kSignature);
  out.u8(kVersion | kBlockFormFlag);

  ByteWriter header;
  header.u8(kFidelityExact);
  header.varint(pages.size());
  put_block(kHeaderBlock, header, out);
  if (!metadata.empty()) {
    ByteWriter content;
    if (Status put = write_metadata(metadata, content); !put) {
      return put.error();
    }
    put_block(kMetadataBlock, content, out);
  }

  ByteWriter index;
  ByteWriter checksums;
  index.varint(pages.size());
  for (const PageParts& page : pages) {
    index.varint(out.size());
    index.varint(page.blocks.size());
    checksums.u32(page.checksum);
    if (Status put = put_page(page, out); !put) return put.error();
    for (const BlockParts& block : page.blocks) {
      index.varint(out.size());
      put_box(block.box, index);
      put_payload(page, block, out);
    }
  }

  ByteWriter end;
  end.u32(crc_bytes(checksums.view()));
  end.u64(out.size());
  put_block(kIndexBlock, index, out);
  put_block(kEndBlock, end, out);
  return out.take();
}

}  // namespace unstep::codec
