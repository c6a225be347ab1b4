#include "codec/page_encoder.h"

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codec/block_coder.h"
#include "codec/checksum.h"
#include "codec/parallel.h"
#include "codec/path_checksum.h"
#include "codec/proof.h"
#include "grid/bit_count.h"

namespace unstep::codec {
namespace {

constexpr DecodeLimits kNoLimits{std::numeric_limits<std::uint64_t>::max(),
                                 std::numeric_limits<std::uint64_t>::max(),
                                 std::numeric_limits<std::uint64_t>::max()};

std::uint64_t passes(const EncodeOptions& options) {
  return options.verify ? 2 : 1;
}

std::int32_t band_count(const Bitmap& ink, int wanted) {
  const std::uint64_t automatic =
      (ink.pixels() + kAutoBandPixels - 1) / kAutoBandPixels;
  const std::uint64_t count =
      wanted == 0 ? automatic : static_cast<std::uint64_t>(wanted);
  return static_cast<std::int32_t>(
      std::min(count, static_cast<std::uint64_t>(ink.height())));
}

/// About what coding a row costs: its words are looked through, a step is taken
/// for each crack between ink and paper, and bends of edges are what is not
/// foreseen. Shares by which the bands of maps and sheets end together.
std::uint64_t row_work(const Bitmap& ink, std::int32_t y) {
  constexpr std::uint64_t kWordsACrack = 4;
  constexpr std::uint64_t kWordsABend = 12;
  const auto row = ink.row(y);
  std::uint64_t cracks = 0;
  std::uint64_t bends = 0;
  std::uint64_t left = 0;  // the pixel before the word, in the highest bit
  std::uint64_t left_above = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::uint64_t above = y > 0 ? ink.row(y - 1)[i] : 0;
    const std::uint64_t sides = row[i] ^ (row[i] >> 1 | left);
    const std::uint64_t sides_above = above ^ (above >> 1 | left_above);
    const std::uint64_t tops = row[i] ^ above;
    // Most words have none.
    if ((sides | tops) != 0) {
      cracks += static_cast<std::uint64_t>(ones(sides) + ones(tops));
    }
    if (sides != sides_above) {
      bends += static_cast<std::uint64_t>(ones(sides ^ sides_above));
    }
    left = row[i] << 63;
    left_above = above << 63;
  }
  return row.size() + kWordsACrack * cracks + kWordsABend * bends;
}

/// Rows whose work is told as one mean, so that the means of a narrow page stay
/// small beside it.
constexpr std::int32_t kRowsAMean = 8;

std::vector<std::uint64_t> mean_works(const Bitmap& ink) {
  std::vector<std::uint64_t> means;
  for (std::int32_t y = 0; y < ink.height(); y += kRowsAMean) {
    const std::int32_t rows = std::min(kRowsAMean, ink.height() - y);
    std::uint64_t sum = 0;
    for (std::int32_t i = 0; i < rows; ++i) sum += row_work(ink, y + i);
    means.push_back(sum / static_cast<std::uint64_t>(rows));
  }
  return means;
}

/// Bands of about equal work, so that threads end together. Those that nobody
/// asked for are of equal height, which bounds the memory of each.
std::vector<BlockParts> cut_bands(const Bitmap& ink, int wanted) {
  const std::int32_t count = band_count(ink, wanted);
  std::vector<std::uint64_t> works;
  if (count > 1 && wanted > 1) works = mean_works(ink);
  const auto work = [&](std::int32_t y) {
    return works.empty() ? 1 : works[static_cast<std::size_t>(y / kRowsAMean)];
  };
  std::uint64_t total = 0;
  for (std::int32_t y = 0; y < ink.height() && count > 1; ++y) total += work(y);
  std::vector<BlockParts> bands(static_cast<std::size_t>(count));
  std::uint64_t done = 0;
  std::int32_t row = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    BlockParts& band = bands[static_cast<std::size_t>(i)];
    band.first_row = row;
    const auto bands_done = static_cast<std::uint64_t>(i) + 1;
    const std::uint64_t end =
        total * bands_done / static_cast<std::uint64_t>(count);
    // A row at least for this band and each that follows.
    const std::int32_t last = ink.height() - (count - 1 - i);
    do {
      done += work(row);
      ++row;
    } while (row < last && (i + 1 == count || done < end));
    band.rows = row - band.first_row;
    band.box = {0, band.first_row, static_cast<std::uint32_t>(ink.width()),
                static_cast<std::uint32_t>(band.rows)};
  }
  return bands;
}

Status prove_band(const Bitmap& ink, const BlockParts& band,
                  const BlockProgress& progress) {
  const Status same =
      verify_ink(band.encoded.name, band.encoded.payload, ink, band.first_row,
                 band.rows, kNoLimits, progress);
  if (!same) return proof_failed(same.error());
  return ProgressSum::complete(progress, static_cast<std::uint64_t>(band.rows));
}

/// What chains and paths differ in. `Item` is one of them, its parts are its
/// steps or elements.
struct Chains {
  using Item = Chain;
  static constexpr std::uint64_t kGroupParts = kGroupSteps;

  static std::span<const Chain> items(const Drawing& d) { return d.chains; }
  static std::size_t parts(const Chain& chain) { return chain.steps.size(); }
  static Status survey(const Drawing& drawing, std::span<const Chain> chains,
                       BlockParts& block) {
    const auto survey = survey_chains(chains, drawing.canvas.y_axis);
    if (!survey) return survey.error();
    block.chains = chains.size();
    block.steps = survey->steps;
    block.box = survey->box;
    block.checksum = crc_chains(chains);
    return {};
  }
  static std::uint64_t bytes(const BlockParts& block) {
    return chain_bytes(block.chains, block.steps);
  }
  static Result<EncodedBlock> encode(const Drawing& drawing,
                                     std::span<const Chain> chains,
                                     const BlockProgress& progress) {
    return encode_chains(chains, drawing.canvas.y_axis, progress);
  }
  static Result<std::vector<Chain>> decode(const Drawing& drawing,
                                           const BlockParts& block,
                                           const BlockProgress& progress) {
    return decode_chains(block.encoded.name, block.encoded.payload,
                         block.chains, block.steps, drawing.canvas.y_axis,
                         progress);
  }
  static bool same(std::span<const Chain> a, std::span<const Chain> b) {
    return std::ranges::equal(a, b);
  }
};

struct Paths {
  using Item = Path;
  static constexpr std::uint64_t kGroupParts = kGroupElements;

  static std::span<const Path> items(const Drawing& d) { return d.paths; }
  static std::size_t parts(const Path& path) { return path.elements.size(); }
  static Status survey(const Drawing& drawing, std::span<const Path> paths,
                       BlockParts& block) {
    const auto survey = survey_paths(
        paths, {drawing.canvas.y_axis, drawing.scale, drawing.paint});
    if (!survey) return survey.error();
    block.paths = paths.size();
    block.elements = survey->elements;
    block.box = survey->box;
    block.checksum = crc_paths(paths);
    return {};
  }
  static std::uint64_t bytes(const BlockParts& block) {
    return path_bytes(block.paths, block.elements);
  }
  static Result<EncodedBlock> encode(const Drawing& /*drawing*/,
                                     std::span<const Path> paths,
                                     const BlockProgress& progress) {
    return encode_paths(paths, progress);
  }
  static Result<std::vector<Path>> decode(const Drawing& /*drawing*/,
                                          const BlockParts& block,
                                          const BlockProgress& progress) {
    return decode_paths(block.encoded.name, block.encoded.payload, block.paths,
                        block.elements, progress);
  }
  static bool same(std::span<const Path> a, std::span<const Path> b) {
    return same_paths(a, b);
  }
};

/// Groups in order, each closed once it has enough; at least one.
template <class Kind>
std::vector<std::span<const typename Kind::Item>> cut_groups(
    const Drawing& drawing) {
  const auto items = Kind::items(drawing);
  std::vector<std::span<const typename Kind::Item>> groups;
  std::size_t first = 0;
  std::uint64_t parts = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    // A head weighs some parts, too: empty items must not gather for ever.
    parts += Kind::parts(items[i]) + 4;
    if (parts < Kind::kGroupParts && i + 1 < items.size()) continue;
    groups.push_back(items.subspan(first, i + 1 - first));
    first = i + 1;
    parts = 0;
  }
  if (groups.empty()) groups.push_back(items);
  return groups;
}

template <class Kind>
Status encode_group(const Drawing& drawing,
                    std::span<const typename Kind::Item> items, bool verify,
                    ProgressSum& sum, BlockParts& block) {
  const BlockProgress progress = sum.block();
  Result<EncodedBlock> encoded = Kind::encode(drawing, items, progress);
  if (!encoded) return encoded.error();
  if (Status more = ProgressSum::complete(progress, items.size()); !more) {
    return more;
  }
  block.encoded = *std::move(encoded);
  if (!verify) return {};
  const BlockProgress again = sum.block();
  const auto decoded = Kind::decode(drawing, block, again);
  if (!decoded) return proof_failed(decoded.error());
  if (!Kind::same(*decoded, items)) {
    return proof_failed({ErrorCode::corrupt, "lines differ"});
  }
  return ProgressSum::complete(again, items.size());
}

template <class Kind>
Status encode_items(const Drawing& drawing, const EncodeOptions& options,
                    PageParts& page) {
  const auto groups = cut_groups<Kind>(drawing);
  page.blocks.resize(groups.size());
  // Before anything is encoded, and over the whole page, so that an error
  // names the item by its number on the page.
  BlockParts whole;
  if (Status valid = Kind::survey(drawing, Kind::items(drawing), whole);
      !valid) {
    return valid;
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    BlockParts& block = page.blocks[i];
    if (Status valid = Kind::survey(drawing, groups[i], block); !valid) {
      return valid;
    }
    page.checksum = crc_join(page.checksum, block.checksum, Kind::bytes(block));
  }
  ProgressSum sum(options.progress,
                  Kind::items(drawing).size() * passes(options));
  return run_parallel(options.jobs, groups.size(), [&](std::size_t i) {
    return encode_group<Kind>(drawing, groups[i], options.verify, sum,
                              page.blocks[i]);
  });
}

}  // namespace

Error proof_failed(const Error& why) {
  if (why.code == ErrorCode::cancelled) return why;
  return Error{
      ErrorCode::internal,
      "the encoded data does not decode to what was given: " + why.message};
}

Status encode_ink_page(const Bitmap& ink, const EncodeOptions& options,
                       PageParts& page) {
  page.blocks = cut_bands(ink, options.bands);
  ProgressSum sum(options.progress,
                  static_cast<std::uint64_t>(ink.height()) * passes(options));
  const auto encode_band = [&](std::size_t i) -> Status {
    BlockParts& band = page.blocks[i];
    const BlockProgress progress = sum.block();
    Result<EncodedBlock> encoded =
        encode_ink(ink, band.first_row, band.rows, options.effort, progress);
    if (!encoded) return encoded.error();
    if (Status more = ProgressSum::complete(
            progress, static_cast<std::uint64_t>(band.rows));
        !more) {
      return more;
    }
    band.encoded = *std::move(encoded);
    band.checksum = crc_rows(ink, band.first_row, band.rows);
    if (!options.verify) return {};
    return prove_band(ink, band, sum.block());
  };
  if (Status done = run_parallel(options.jobs, page.blocks.size(), encode_band);
      !done) {
    return done;
  }
  for (const BlockParts& band : page.blocks) {
    page.checksum = crc_join(
        page.checksum, band.checksum,
        row_bytes(ink.width()) * static_cast<std::uint64_t>(band.rows));
  }
  return {};
}

Status encode_program_page(std::string_view text, const EncodeOptions& options,
                           PageParts& page) {
  page.blocks.resize(1);
  BlockParts& block = page.blocks[0];
  block.lines =
      static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
  block.text_bytes = text.size();
  block.checksum = page.checksum = crc_bytes(
      {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  ProgressSum sum(options.progress, block.lines * passes(options));
  const BlockProgress progress = sum.block();
  Result<EncodedBlock> encoded = encode_program(text, progress);
  if (!encoded) return encoded.error();
  if (Status more = ProgressSum::complete(progress, block.lines); !more) {
    return more;
  }
  block.encoded = *std::move(encoded);
  if (!options.verify) return {};
  const BlockProgress again = sum.block();
  const Result<std::string> decoded =
      decode_program(block.encoded.name, block.encoded.payload, block.lines,
                     block.text_bytes, again);
  if (!decoded) return proof_failed(decoded.error());
  if (*decoded != text) {
    return proof_failed({ErrorCode::corrupt, "the program differs"});
  }
  return ProgressSum::complete(again, block.lines);
}

Status encode_drawing_page(const Drawing& drawing, const EncodeOptions& options,
                           PageParts& page) {
  return page.kind == PageKind::paths
             ? encode_items<Paths>(drawing, options, page)
             : encode_items<Chains>(drawing, options, page);
}

}  // namespace unstep::codec
