#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "codec/block_coder.h"
#include "codec/checksum.h"
#include "codec/container_decoder.h"
#include "codec/parallel.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

using codec::BlockProgress;
using codec::BlockProof;
using codec::ProgressSum;

Error no_memory() { return Error{ErrorCode::limit_exceeded, "no memory"}; }

Error too_much(std::string_view what, std::uint64_t found,
               std::uint64_t allowed) {
  return Error{ErrorCode::limit_exceeded,
               std::to_string(found) + " " + std::string(what) + ", " +
                   std::to_string(allowed) + " are allowed"};
}

/// Memory of a raster. No overflow: < 2^24 words times < 2^30 rows.
std::uint64_t bitmap_bytes(const Canvas& canvas) {
  return (static_cast<std::uint64_t>(canvas.width) + 63) / 64 * 8 *
         static_cast<std::uint64_t>(canvas.height);
}

codec::CoderName coder_name(const PageEntry::Block& block) {
  return {block.coder, block.revision, block.table};
}

}  // namespace

struct UstpReader::Impl {
  std::span<const std::uint8_t> file;
  DecodeOptions options;
  codec::ParsedFile parsed;

  [[nodiscard]] Result<Page> decode(const PageEntry& entry,
                                    std::span<const BlockProof> proofs) const;
  Status decode_ink(const PageEntry& entry, std::span<const BlockProof> proofs,
                    Page& page) const;
  Status decode_chains(const PageEntry& entry,
                       std::span<const BlockProof> proofs, Page& page) const;
  [[nodiscard]] Status check_chain_limits(const PageEntry& entry) const;
  [[nodiscard]] std::span<const std::uint8_t> payload(
      const PageEntry::Block& block) const {
    return file.subspan(static_cast<std::size_t>(block.offset),
                        static_cast<std::size_t>(block.bytes));
  }
};

namespace {

/// A coder's error with the block's number and place before it.
Error in_block(const PageEntry::Block& block, std::size_t number, Error error) {
  if (error.code == ErrorCode::cancelled) return error;
  error.message = "block " + std::to_string(number + 1) + " (byte " +
                  std::to_string(block.offset) + "): " + error.message;
  return error;
}

Error mismatch(std::string_view what) {
  return Error{ErrorCode::checksum_mismatch,
               std::string(what) + " differs from what was encoded"};
}

}  // namespace

Status UstpReader::Impl::decode_ink(const PageEntry& entry,
                                    std::span<const BlockProof> proofs,
                                    Page& page) const {
  const std::uint64_t pixels = static_cast<std::uint64_t>(entry.canvas.width) *
                               static_cast<std::uint64_t>(entry.canvas.height);
  if (pixels > options.limits.max_pixels) {
    return too_much("pixels", pixels, options.limits.max_pixels);
  }
  const std::uint64_t bytes = bitmap_bytes(entry.canvas);
  if (bytes > options.limits.max_memory) {
    return too_much("bytes of memory", bytes, options.limits.max_memory);
  }
  Result<Bitmap> ink = Bitmap::create(entry.canvas.width, entry.canvas.height);
  if (!ink) return ink.error();
  page.ink = *std::move(ink);

  const auto threads = std::clamp<std::uint64_t>(
      static_cast<std::uint64_t>(std::max(options.jobs, 1)), 1,
      entry.blocks.size());
  DecodeLimits limits = options.limits;
  limits.max_memory = (limits.max_memory - bytes) / threads;
  ProgressSum sum(options.progress,
                  static_cast<std::uint64_t>(entry.canvas.height));
  return codec::run_parallel(
      options.jobs, entry.blocks.size(), [&](std::size_t i) -> Status {
        const PageEntry::Block& block = entry.blocks[i];
        const BlockProgress progress = sum.block();
        if (Status done = codec::decode_ink(coder_name(block), payload(block),
                                            page.ink, block.first_row,
                                            block.rows, limits, progress);
            !done) {
          return in_block(block, i, done.error());
        }
        if (codec::crc_rows(page.ink, block.first_row, block.rows) !=
            proofs[i].checksum) {
          return in_block(block, i, mismatch("decoded ink"));
        }
        return ProgressSum::complete(progress,
                                     static_cast<std::uint64_t>(block.rows));
      });
}

Status UstpReader::Impl::check_chain_limits(const PageEntry& entry) const {
  // Each count is below 2^48 and there are fewer blocks than bytes in memory:
  // the sums are capped before they can overflow.
  constexpr std::uint64_t kCap = std::uint64_t{1} << 56;
  std::uint64_t chains = 0;
  std::uint64_t steps = 0;
  for (const PageEntry::Block& block : entry.blocks) {
    chains = std::min(chains + block.chains, kCap);
    steps = std::min(steps + block.steps, kCap);
  }
  if (steps > options.limits.max_steps) {
    return too_much("steps", steps, options.limits.max_steps);
  }
  const std::uint64_t bytes = chains * sizeof(Chain) + steps;
  if (bytes > options.limits.max_memory) {
    return too_much("bytes of memory", bytes, options.limits.max_memory);
  }
  return {};
}

Status UstpReader::Impl::decode_chains(const PageEntry& entry,
                                       std::span<const BlockProof> proofs,
                                       Page& page) const {
  if (Status fits = check_chain_limits(entry); !fits) return fits;
  std::uint64_t total = 0;
  for (const PageEntry::Block& block : entry.blocks) total += block.chains;
  ProgressSum sum(options.progress, total);
  page.drawing.canvas = entry.canvas;
  for (std::size_t i = 0; i < entry.blocks.size(); ++i) {
    const PageEntry::Block& block = entry.blocks[i];
    const BlockProgress progress = sum.block();
    Result<std::vector<Chain>> chains =
        codec::decode_chains(coder_name(block), payload(block), block.chains,
                             block.steps, entry.canvas.y_axis, progress);
    if (!chains) return in_block(block, i, chains.error());
    const Result<codec::ChainSurvey> survey =
        codec::survey_chains(*chains, entry.canvas.y_axis);
    if (!survey) {
      return in_block(block, i,
                      Error{ErrorCode::corrupt, survey.error().message});
    }
    if (chains->size() != block.chains || survey->steps != block.steps ||
        codec::crc_chains(*chains) != proofs[i].checksum) {
      return in_block(block, i, mismatch("decoded drawing"));
    }
    if (proofs[i].box && *proofs[i].box != survey->box) {
      return in_block(block, i,
                      Error{ErrorCode::corrupt, "wrong box in the index"});
    }
    std::ranges::move(*chains, std::back_inserter(page.drawing.chains));
    if (Status more = ProgressSum::complete(progress, block.chains); !more) {
      return more;
    }
  }
  return {};
}

Result<Page> UstpReader::Impl::decode(
    const PageEntry& entry, std::span<const BlockProof> proofs) const {
  Page page;
  page.kind = entry.kind;
  page.info = entry.info;
  const Status done = entry.kind == PageKind::ink
                          ? decode_ink(entry, proofs, page)
                          : decode_chains(entry, proofs, page);
  if (!done) return done.error();
  return page;
}

UstpReader::UstpReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UstpReader::~UstpReader() = default;
UstpReader::UstpReader(UstpReader&&) noexcept = default;
UstpReader& UstpReader::operator=(UstpReader&&) noexcept = default;

Result<UstpReader> UstpReader::open(std::span<const std::uint8_t> file,
                                    DecodeOptions options) {
  try {
    Result<codec::ParsedFile> parsed = codec::parse_file(file);
    if (!parsed) return parsed.error();
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    impl->options = std::move(options);
    impl->parsed = *std::move(parsed);
    return UstpReader(std::move(impl));
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
}

const FileInfo& UstpReader::info() const { return impl_->parsed.info; }

Result<Page> UstpReader::read_page(std::size_t index) const {
  const std::vector<PageEntry>& pages = impl_->parsed.info.pages;
  if (index >= pages.size()) {
    return Error{ErrorCode::out_of_range, "page " + std::to_string(index + 1) +
                                              " of " +
                                              std::to_string(pages.size())};
  }
  try {
    Result<Page> page =
        impl_->decode(pages[index], impl_->parsed.proofs[index]);
    if (page || page.error().code == ErrorCode::cancelled) return page;
    Error error = page.error();
    error.message = "page " + std::to_string(index + 1) + ": " + error.message;
    return error;
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
}

}  // namespace unstep
