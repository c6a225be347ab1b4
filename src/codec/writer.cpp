#include <algorithm>
#include <functional>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "codec/container_decoder.h"
#include "codec/container_encoder.h"
#include "codec/page_encoder.h"
#include "codec/proof.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

using codec::BlockParts;
using codec::PageParts;

Error no_memory() { return Error{ErrorCode::limit_exceeded, "no memory"}; }

bool same_page(const PageParts& given, const PageEntry& found) {
  bool same = found.kind == given.kind && found.canvas == given.canvas &&
              found.info == given.info && found.fidelity == given.fidelity &&
              found.scale == given.scale && found.paint == given.paint &&
              found.checksum == given.checksum &&
              found.blocks.size() == given.blocks.size();
  for (std::size_t i = 0; same && i < given.blocks.size(); ++i) {
    const BlockParts& block = given.blocks[i];
    const PageEntry::Block& entry = found.blocks[i];
    same = entry.bytes == block.encoded.payload.size() &&
           entry.first_row == block.first_row && entry.rows == block.rows &&
           entry.chains == block.chains && entry.steps == block.steps &&
           entry.paths == block.paths && entry.elements == block.elements &&
           entry.lines == block.lines && entry.text_bytes == block.text_bytes &&
           codec::CoderName{entry.coder, entry.revision, entry.table} ==
               block.encoded.name;
  }
  return same;
}

/// The payloads are proven page by page; this proves what is around them.
Status prove_file(std::span<const std::uint8_t> file,
                  std::span<const PageParts> pages, const Metadata& metadata) {
  const Result<codec::ParsedFile> parsed = codec::parse_file(file);
  if (!parsed) return codec::proof_failed(parsed.error());
  if (!std::ranges::equal(pages, parsed->info.pages, same_page) ||
      parsed->info.metadata != metadata) {
    return codec::proof_failed({ErrorCode::corrupt, "headers differ"});
  }
  return {};
}

}  // namespace

struct UstpWriter::Impl {
  EncodeOptions options;
  std::vector<PageParts> pages;
  bool unusable = false;

  /// Takes a page with head but without blocks, which `encode` makes.
  Status add(PageParts page, const std::function<Status(PageParts&)>& encode);
};

Status UstpWriter::Impl::add(PageParts page,
                             const std::function<Status(PageParts&)>& encode) {
  if (unusable) {
    return Error{ErrorCode::invalid_argument,
                 "the writer has failed or finished before"};
  }
  unusable = true;
  if (Status valid = codec::check_page(page); !valid) return valid;
  try {
    if (Status encoded = encode(page); !encoded) return encoded;
    pages.push_back(std::move(page));
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
  unusable = false;
  return {};
}

UstpWriter::UstpWriter(EncodeOptions options)
    : impl_(std::make_unique<Impl>()) {
  impl_->options = std::move(options);
}
UstpWriter::~UstpWriter() = default;
UstpWriter::UstpWriter(UstpWriter&&) noexcept = default;
UstpWriter& UstpWriter::operator=(UstpWriter&&) noexcept = default;

Status UstpWriter::add_page(const Bitmap& ink, const PageInfo& info) {
  if (impl_->options.bands < 0) {
    return Error{ErrorCode::invalid_argument, "a negative number of bands"};
  }
  PageParts page;
  page.kind = PageKind::ink;
  page.canvas = {ink.width(), ink.height(), YAxis::down};
  page.info = info;
  return impl_->add(std::move(page), [&](PageParts& parts) {
    return codec::encode_ink_page(ink, impl_->options, parts);
  });
}

Status UstpWriter::add_page(const Drawing& drawing, const PageInfo& info,
                            const Fidelity& fidelity) {
  const bool exact = fidelity.kind == Fidelity::Kind::exact;
  if (!drawing.chains.empty() && (!drawing.paths.empty() || !exact)) {
    return Error{ErrorCode::invalid_argument,
                 exact ? "a drawing with both chains and paths"
                       : "chains with the fidelity of paths"};
  }
  PageParts page;
  page.canvas = drawing.canvas;
  page.info = info;
  page.kind = PageKind::chains;
  if (!drawing.paths.empty() || !exact) {
    page.kind = PageKind::paths;
    page.fidelity = fidelity;
    if (fidelity.kind != Fidelity::Kind::tolerance) {
      page.fidelity.tolerance = {};
    }
    page.scale = drawing.scale;
    page.paint = drawing.paint;
  }
  return impl_->add(std::move(page), [&](PageParts& parts) {
    return codec::encode_drawing_page(drawing, impl_->options, parts);
  });
}

Status UstpWriter::add_program(std::string_view text, const PageInfo& info,
                               const Fidelity& fidelity) {
  PageParts page;
  page.kind = PageKind::program;
  page.info = info;
  page.fidelity = fidelity;
  if (fidelity.kind != Fidelity::Kind::tolerance) page.fidelity.tolerance = {};
  return impl_->add(std::move(page), [&](PageParts& parts) {
    return codec::encode_program_page(text, impl_->options, parts);
  });
}

Result<std::vector<std::uint8_t>> UstpWriter::finish() {
  if (impl_->unusable || impl_->pages.empty()) {
    return Error{ErrorCode::invalid_argument,
                 impl_->unusable ? "the writer has failed or finished before"
                                 : "a file needs at least one page"};
  }
  impl_->unusable = true;
  const std::vector<PageParts>& pages = impl_->pages;
  const Metadata& metadata = impl_->options.metadata;
  try {
    Result<std::vector<std::uint8_t>> file =
        codec::fits_short_form(pages) ? codec::short_form(pages[0], metadata)
                                      : codec::block_form(pages, metadata);
    if (!file || !impl_->options.verify) return file;
    if (Status proof = prove_file(*file, pages, metadata); !proof) {
      return proof.error();
    }
    return file;
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
}

}  // namespace unstep
