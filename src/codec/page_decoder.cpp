#include "codec/page_decoder.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "codec/block_coder.h"
#include "codec/checksum.h"
#include "codec/container_format.h"
#include "codec/crop.h"
#include "codec/parallel.h"
#include "codec/path_checksum.h"

namespace unstep::codec {
namespace {

Error too_much(std::string_view what, std::uint64_t found,
               std::uint64_t allowed) {
  return Error{ErrorCode::limit_exceeded,
               std::to_string(found) + " " + std::string(what) + ", " +
                   std::to_string(allowed) + " are allowed"};
}

CoderName coder_name(const PageEntry::Block& block) {
  return {block.coder, block.revision, block.table};
}

/// A coder's error with the block's number and place before it.
Error in_block(const PageEntry::Block& block, std::size_t number, Error error) {
  if (error.code == ErrorCode::cancelled) return error;
  error.message = "block " + std::to_string(number + 1) + " (byte " +
                  std::to_string(block.offset) + "): " + error.message;
  return error;
}

/// What the coder remembers of each of the last 2^16 lines of a program.
constexpr std::uint64_t kProgramLineBytes = 320;
constexpr std::uint64_t kProgramLines = std::uint64_t{1} << 16;

Error mismatch(std::string_view what) {
  return Error{ErrorCode::checksum_mismatch,
               std::string(what) + " differs from what was encoded"};
}

/// What a page of chains and one of paths differ in. `Item` is a chain or a
/// path, its parts are its steps or elements.
struct Chains {
  using Item = Chain;
  static constexpr std::string_view kParts = "steps";
  static constexpr std::uint64_t kItemBytes = sizeof(Chain);
  static constexpr std::uint64_t kPartBytes = 1;

  static std::uint64_t count(const PageEntry::Block& b) { return b.chains; }
  static std::uint64_t parts(const PageEntry::Block& b) { return b.steps; }
  static Result<std::vector<Chain>> decode(
      const PageEntry& entry, const PageEntry::Block& block,
      std::span<const std::uint8_t> payload, const BlockProgress& progress) {
    return decode_chains(coder_name(block), payload, block.chains, block.steps,
                         entry.canvas.y_axis, progress);
  }
  static Result<std::pair<std::uint64_t, Box>> survey(
      const PageEntry& entry, std::span<const Chain> chains) {
    const auto survey = survey_chains(chains, entry.canvas.y_axis);
    if (!survey) return survey.error();
    return std::pair{survey->steps, survey->box};
  }
  static std::uint32_t crc(std::span<const Chain> chains) {
    return crc_chains(chains);
  }
};

struct Paths {
  using Item = Path;
  static constexpr std::string_view kParts = "elements";
  /// With what the coder remembers of each vertex.
  static constexpr std::uint64_t kItemBytes = 64;
  static constexpr std::uint64_t kPartBytes = 64;
  static_assert(kItemBytes >= sizeof(Path) + 20 &&
                kPartBytes >= sizeof(Path::Element) + 20);

  static std::uint64_t count(const PageEntry::Block& b) { return b.paths; }
  static std::uint64_t parts(const PageEntry::Block& b) { return b.elements; }
  static Result<std::vector<Path>> decode(const PageEntry& /*entry*/,
                                          const PageEntry::Block& block,
                                          std::span<const std::uint8_t> payload,
                                          const BlockProgress& progress) {
    return decode_paths(coder_name(block), payload, block.paths, block.elements,
                        progress);
  }
  static Result<std::pair<std::uint64_t, Box>> survey(
      const PageEntry& entry, std::span<const Path> paths) {
    const auto survey =
        survey_paths(paths, {entry.canvas.y_axis, entry.scale, entry.paint});
    if (!survey) return survey.error();
    return std::pair{survey->elements, survey->box};
  }
  static std::uint32_t crc(std::span<const Path> paths) {
    return crc_paths(paths);
  }
};

/// Whether [a, a + a_size] and [b, b + b_size] meet, by `overlap` at least.
bool meets(std::int32_t a, std::uint32_t a_size, std::int32_t b,
           std::uint32_t b_size, int overlap) {
  const std::int64_t a_end = std::int64_t{a} + a_size;
  const std::int64_t b_end = std::int64_t{b} + b_size;
  return std::min(a_end, b_end) - std::max(a, b) >= overlap;
}

}  // namespace

/// Ink must have a row in common with the box, lines at least a point.
PageDecoder::Chosen PageDecoder::choose(const std::optional<Box>& box) const {
  Chosen chosen;
  const int overlap = entry_.kind == PageKind::ink ? 1 : 0;
  for (std::size_t i = 0; i < entry_.blocks.size(); ++i) {
    const Box& b = entry_.blocks[i].box;
    if (!box || (meets(b.x, b.width, box->x, box->width, overlap) &&
                 meets(b.y, b.height, box->y, box->height, overlap))) {
      chosen.push_back(i);
    }
  }
  return chosen;
}

Status PageDecoder::check_ink_limits(std::uint64_t pixels,
                                     std::uint64_t bytes) const {
  if (pixels > options_.limits.max_pixels) {
    return too_much("pixels", pixels, options_.limits.max_pixels);
  }
  if (bytes > options_.limits.max_memory) {
    return too_much("bytes of memory", bytes, options_.limits.max_memory);
  }
  return {};
}

/// The rows of the chosen bands, which follow each other. `copies`: how many
/// such bitmaps there will be.
Result<Bitmap> PageDecoder::decode_rows(const Chosen& chosen,
                                        std::uint64_t copies) const {
  const std::int32_t first = entry_.blocks[chosen.front()].first_row;
  const PageEntry::Block& last = entry_.blocks[chosen.back()];
  const std::int32_t height = last.first_row + last.rows - first;
  const auto width = static_cast<std::uint64_t>(entry_.canvas.width);
  const auto rows = static_cast<std::uint64_t>(height);
  // No overflow: < 2^27 bytes times < 2^30 rows, twice.
  const std::uint64_t bytes = (width + 63) / 64 * 8 * rows * copies;
  if (Status fits = check_ink_limits(width * rows, bytes); !fits) {
    return fits.error();
  }
  Result<Bitmap> ink = Bitmap::create(entry_.canvas.width, height);
  if (!ink) return ink.error();

  const auto threads = std::clamp<std::uint64_t>(
      static_cast<std::uint64_t>(std::max(options_.jobs, 1)), 1, chosen.size());
  DecodeLimits limits = options_.limits;
  limits.max_memory = (limits.max_memory - bytes) / threads;
  ProgressSum sum(options_.progress, rows);
  const auto decode_band = [&](std::size_t k) -> Status {
    const std::size_t i = chosen[k];
    const PageEntry::Block& block = entry_.blocks[i];
    const BlockProgress progress = sum.block();
    const std::int32_t row = block.first_row - first;
    if (Status done = codec::decode_ink(coder_name(block), payload(block), *ink,
                                        row, block.rows, limits, progress);
        !done) {
      return in_block(block, i, done.error());
    }
    if (crc_rows(*ink, row, block.rows) != proofs_[i].checksum) {
      return in_block(block, i, mismatch("decoded ink"));
    }
    return ProgressSum::complete(progress,
                                 static_cast<std::uint64_t>(block.rows));
  };
  if (Status done = run_parallel(options_.jobs, chosen.size(), decode_band);
      !done) {
    return done.error();
  }
  return ink;
}

Result<Bitmap> PageDecoder::decode_ink(const std::optional<Box>& box) const {
  const Chosen chosen = choose(box);
  if (chosen.empty()) {
    return Error{ErrorCode::out_of_range, "the box misses the page"};
  }
  Result<Bitmap> rows = decode_rows(chosen, box ? 2 : 1);
  if (!rows || !box) return rows;
  const std::int32_t first = entry_.blocks[chosen.front()].first_row;
  return crop(*rows, {box->x, box->y - first, box->width, box->height});
}

template <class Kind>
Status PageDecoder::check_item_limits(const Chosen& chosen) const {
  // Each count is at most 2^48 and there are fewer blocks than bytes in
  // memory: the sums are capped before they can overflow.
  constexpr std::uint64_t kCap = std::uint64_t{1} << 56;
  std::uint64_t count = 0;
  std::uint64_t parts = 0;
  for (const std::size_t i : chosen) {
    count = std::min(count + Kind::count(entry_.blocks[i]), kCap);
    parts = std::min(parts + Kind::parts(entry_.blocks[i]), kCap);
  }
  if (parts > options_.limits.max_steps) {
    return too_much(Kind::kParts, parts, options_.limits.max_steps);
  }
  const std::uint64_t bytes =
      count * Kind::kItemBytes + parts * Kind::kPartBytes;
  if (bytes > options_.limits.max_memory) {
    return too_much("bytes of memory", bytes, options_.limits.max_memory);
  }
  return {};
}

template <class Kind>
Result<std::vector<typename Kind::Item>> PageDecoder::decode_group(
    std::size_t number, const BlockProgress& progress) const {
  const PageEntry::Block& block = entry_.blocks[number];
  auto items = Kind::decode(entry_, block, payload(block), progress);
  if (!items) return in_block(block, number, items.error());
  const auto found = Kind::survey(entry_, *items);
  if (!found) {
    return in_block(block, number, {ErrorCode::corrupt, found.error().message});
  }
  const auto& [parts, box] = *found;
  if (items->size() != Kind::count(block) || parts != Kind::parts(block) ||
      Kind::crc(*items) != proofs_[number].checksum) {
    return in_block(block, number, mismatch("decoded drawing"));
  }
  if (proofs_[number].box && *proofs_[number].box != box) {
    return in_block(block, number,
                    {ErrorCode::corrupt, "wrong box in the index"});
  }
  if (Status more = ProgressSum::complete(progress, Kind::count(block));
      !more) {
    return more.error();
  }
  return items;
}

template <class Kind>
Result<std::vector<typename Kind::Item>> PageDecoder::decode_items(
    const Chosen& chosen) const {
  using Items = std::vector<typename Kind::Item>;
  if (Status fits = check_item_limits<Kind>(chosen); !fits) {
    return fits.error();
  }
  std::uint64_t total = 0;
  for (const std::size_t i : chosen) total += Kind::count(entry_.blocks[i]);
  ProgressSum sum(options_.progress, total);
  std::vector<Items> groups(chosen.size());
  const auto work = [&](std::size_t k) -> Status {
    Result<Items> items = decode_group<Kind>(chosen[k], sum.block());
    if (!items) return items.error();
    groups[k] = *std::move(items);
    return {};
  };
  if (Status done = run_parallel(options_.jobs, chosen.size(), work); !done) {
    return done.error();
  }
  if (groups.size() == 1) return std::move(groups[0]);
  Items all;
  for (Items& group : groups) std::ranges::move(group, std::back_inserter(all));
  return all;
}

/// Whole, whatever the box: a program has no places.
Result<std::string> PageDecoder::decode_program() const {
  std::uint64_t bytes = 0;
  std::uint64_t lines = 0;
  for (const PageEntry::Block& block : entry_.blocks) {
    // Both sums are capped long before they could overflow.
    bytes = std::min(bytes + block.text_bytes, std::uint64_t{1} << 56);
    lines = std::min(lines + block.lines, std::uint64_t{1} << 56);
  }
  if (lines > options_.limits.max_steps) {
    return too_much("lines", lines, options_.limits.max_steps);
  }
  // A string that grows may hold both sizes at once.
  const std::uint64_t memory =
      3 * bytes + kProgramLineBytes * std::min(lines, kProgramLines);
  if (memory > options_.limits.max_memory) {
    return too_much("bytes of memory", memory, options_.limits.max_memory);
  }
  ProgressSum sum(options_.progress, lines);
  std::string text;
  for (std::size_t i = 0; i < entry_.blocks.size(); ++i) {
    const PageEntry::Block& block = entry_.blocks[i];
    const BlockProgress progress = sum.block();
    Result<std::string> part =
        codec::decode_program(coder_name(block), payload(block), block.lines,
                              block.text_bytes, progress);
    if (!part) return in_block(block, i, part.error());
    if (crc_bytes({reinterpret_cast<const std::uint8_t*>(part->data()),
                   part->size()}) != proofs_[i].checksum) {
      return in_block(block, i, mismatch("decoded program"));
    }
    if (Status more = ProgressSum::complete(progress, block.lines); !more) {
      return more.error();
    }
    text += *part;
  }
  return text;
}

Result<Page> PageDecoder::decode(const std::optional<Box>& box) const {
  Page page;
  page.kind = entry_.kind;
  page.info = entry_.info;
  page.fidelity = entry_.fidelity;
  if (entry_.kind == PageKind::ink) {
    Result<Bitmap> ink = decode_ink(box);
    if (!ink) return ink.error();
    page.ink = *std::move(ink);
    return page;
  }
  if (entry_.kind == PageKind::program) {
    Result<std::string> text = decode_program();
    if (!text) return text.error();
    page.program = *std::move(text);
    return page;
  }
  page.drawing.canvas = entry_.canvas;
  page.drawing.scale = entry_.scale;
  page.drawing.paint = entry_.paint;
  if (entry_.kind == PageKind::chains) {
    Result<std::vector<Chain>> chains = decode_items<Chains>(choose(box));
    if (!chains) return chains.error();
    page.drawing.chains = *std::move(chains);
    return page;
  }
  Result<std::vector<Path>> paths = decode_items<Paths>(choose(box));
  if (!paths) return paths.error();
  page.drawing.paths = *std::move(paths);
  return page;
}

}  // namespace unstep::codec
