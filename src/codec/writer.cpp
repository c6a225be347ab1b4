#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "codec/block_coder.h"
#include "codec/checksum.h"
#include "codec/container_decoder.h"
#include "codec/container_encoder.h"
#include "codec/parallel.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

using codec::BlockParts;
using codec::BlockProgress;
using codec::EncodedBlock;
using codec::PageParts;
using codec::ProgressSum;

constexpr DecodeLimits kNoLimits{std::numeric_limits<std::uint64_t>::max(),
                                 std::numeric_limits<std::uint64_t>::max(),
                                 std::numeric_limits<std::uint64_t>::max()};

Error no_memory() { return Error{ErrorCode::limit_exceeded, "no memory"}; }

std::int32_t band_count(const Bitmap& ink, int wanted) {
  const std::uint64_t automatic =
      (ink.pixels() + codec::kAutoBandPixels - 1) / codec::kAutoBandPixels;
  const std::uint64_t count =
      wanted == 0 ? automatic : static_cast<std::uint64_t>(wanted);
  return static_cast<std::int32_t>(
      std::min(count, static_cast<std::uint64_t>(ink.height())));
}

/// Bands of equal height, but for a row.
std::vector<BlockParts> cut_bands(const Bitmap& ink, int wanted) {
  const std::int32_t count = band_count(ink, wanted);
  std::vector<BlockParts> bands(static_cast<std::size_t>(count));
  std::int32_t row = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    BlockParts& band = bands[static_cast<std::size_t>(i)];
    band.first_row = row;
    band.rows = (ink.height() - row) / (count - i);
    band.box = {0, row, static_cast<std::uint32_t>(ink.width()),
                static_cast<std::uint32_t>(band.rows)};
    row += band.rows;
  }
  return bands;
}

Error proof_failed(const std::string& reason) {
  return Error{ErrorCode::internal,
               "the encoded data does not decode to what was given: " + reason};
}

Status prove_band(const Bitmap& ink, const BlockParts& band,
                  const BlockProgress& progress) {
  const Status same =
      codec::verify_ink(band.encoded.name, band.encoded.payload, ink,
                        band.first_row, band.rows, kNoLimits, progress);
  if (!same) {
    if (same.error().code == ErrorCode::cancelled) return same;
    return proof_failed(same.error().message);
  }
  return ProgressSum::complete(progress, static_cast<std::uint64_t>(band.rows));
}

Status prove_chains(const Drawing& drawing, const BlockParts& block,
                    const BlockProgress& progress) {
  const Result<std::vector<Chain>> decoded = codec::decode_chains(
      block.encoded.name, block.encoded.payload, block.chains, block.steps,
      drawing.canvas.y_axis, progress);
  if (!decoded) {
    if (decoded.error().code == ErrorCode::cancelled) return decoded.error();
    return proof_failed(decoded.error().message);
  }
  if (*decoded != drawing.chains) return proof_failed("chains differ");
  return ProgressSum::complete(progress, block.chains);
}

bool same_page(const PageParts& given, const PageEntry& found) {
  bool same = found.kind == given.kind && found.canvas == given.canvas &&
              found.info == given.info && found.checksum == given.checksum &&
              found.blocks.size() == given.blocks.size();
  for (std::size_t i = 0; same && i < given.blocks.size(); ++i) {
    const BlockParts& block = given.blocks[i];
    const PageEntry::Block& entry = found.blocks[i];
    same = entry.bytes == block.encoded.payload.size() &&
           entry.first_row == block.first_row && entry.rows == block.rows &&
           entry.chains == block.chains && entry.steps == block.steps &&
           codec::CoderName{entry.coder, entry.revision, entry.table} ==
               block.encoded.name;
  }
  return same;
}

/// The payloads are proven page by page; this proves what is around them.
Status prove_file(std::span<const std::uint8_t> file,
                  std::span<const PageParts> pages, const Metadata& metadata) {
  const Result<codec::ParsedFile> parsed = codec::parse_file(file);
  if (!parsed) return proof_failed(parsed.error().message);
  if (!std::ranges::equal(pages, parsed->info.pages, same_page) ||
      parsed->info.metadata != metadata) {
    return proof_failed("headers differ");
  }
  return {};
}

}  // namespace

struct UstpWriter::Impl {
  EncodeOptions options;
  std::vector<PageParts> pages;
  bool unusable = false;

  Status add(PageKind kind, const Canvas& canvas, const PageInfo& info,
             const std::function<Status(PageParts&)>& encode);
  Status encode_ink(const Bitmap& ink, PageParts& page) const;
  Status encode_chains(const Drawing& drawing, PageParts& page) const;
  [[nodiscard]] std::uint64_t passes() const { return options.verify ? 2 : 1; }
};

Status UstpWriter::Impl::add(PageKind kind, const Canvas& canvas,
                             const PageInfo& info,
                             const std::function<Status(PageParts&)>& encode) {
  if (unusable) {
    return Error{ErrorCode::invalid_argument,
                 "the writer has failed or finished before"};
  }
  unusable = true;
  if (Status valid = codec::check_page(kind, canvas, info); !valid) {
    return valid;
  }
  try {
    PageParts page;
    page.kind = kind;
    page.canvas = canvas;
    page.info = info;
    if (Status encoded = encode(page); !encoded) return encoded;
    pages.push_back(std::move(page));
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
  unusable = false;
  return {};
}

Status UstpWriter::Impl::encode_ink(const Bitmap& ink, PageParts& page) const {
  page.blocks = cut_bands(ink, options.bands);
  ProgressSum sum(options.progress,
                  static_cast<std::uint64_t>(ink.height()) * passes());
  const auto encode_band = [&](std::size_t i) -> Status {
    BlockParts& band = page.blocks[i];
    const BlockProgress progress = sum.block();
    Result<EncodedBlock> encoded =
        codec::encode_ink(ink, band.first_row, band.rows, progress);
    if (!encoded) return encoded.error();
    if (Status more = ProgressSum::complete(
            progress, static_cast<std::uint64_t>(band.rows));
        !more) {
      return more;
    }
    band.encoded = *std::move(encoded);
    band.checksum = codec::crc_rows(ink, band.first_row, band.rows);
    if (!options.verify) return {};
    return prove_band(ink, band, sum.block());
  };
  if (Status done =
          codec::run_parallel(options.jobs, page.blocks.size(), encode_band);
      !done) {
    return done;
  }
  for (const BlockParts& band : page.blocks) {
    page.checksum = codec::crc_join(
        page.checksum, band.checksum,
        codec::row_bytes(ink.width()) * static_cast<std::uint64_t>(band.rows));
  }
  return {};
}

Status UstpWriter::Impl::encode_chains(const Drawing& drawing,
                                       PageParts& page) const {
  const Result<codec::ChainSurvey> survey =
      codec::survey_chains(drawing.chains, drawing.canvas.y_axis);
  if (!survey) return survey.error();
  ProgressSum sum(options.progress, drawing.chains.size() * passes());
  const BlockProgress progress = sum.block();
  Result<EncodedBlock> encoded =
      codec::encode_chains(drawing.chains, drawing.canvas.y_axis, progress);
  if (!encoded) return encoded.error();
  if (Status more = ProgressSum::complete(progress, drawing.chains.size());
      !more) {
    return more;
  }
  page.blocks.resize(1);
  BlockParts& block = page.blocks[0];
  block.encoded = *std::move(encoded);
  block.chains = drawing.chains.size();
  block.steps = survey->steps;
  block.box = survey->box;
  block.checksum = codec::crc_chains(drawing.chains);
  page.checksum = block.checksum;
  if (!options.verify) return {};
  return prove_chains(drawing, block, sum.block());
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
  return impl_->add(
      PageKind::ink, Canvas{ink.width(), ink.height(), YAxis::down}, info,
      [&](PageParts& page) { return impl_->encode_ink(ink, page); });
}

Status UstpWriter::add_page(const Drawing& drawing, const PageInfo& info,
                            const Fidelity& /*fidelity*/) {
  if (!drawing.paths.empty()) {
    return Error{ErrorCode::invalid_argument,
                 "a drawing with paths; only chains can be stored"};
  }
  return impl_->add(
      PageKind::chains, drawing.canvas, info,
      [&](PageParts& page) { return impl_->encode_chains(drawing, page); });
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
        codec::fits_short_form(pages, metadata)
            ? codec::short_form(pages[0])
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
