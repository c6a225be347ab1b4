#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "formats/orientation.h"
#include "formats/page_limits.h"
#include "formats/raster_source.h"
#include "formats/resolution.h"
#include "formats/text.h"
#include "formats/tiff_handle.h"
#include "formats/tiff_layout.h"
#include "formats/tiff_photometric.h"
#include "formats/tiff_rows.h"

namespace unstep {
namespace {

/// The strips or tiles must be inside the file before one is decoded: libtiff
/// has several ways to go on without them.
Status check_blocks(TIFF* tiff, const TiffShape& shape, std::size_t file) {
  const std::uint32_t count =
      shape.tiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint64_t offset = TIFFGetStrileOffset(tiff, i);
    const std::uint64_t size = TIFFGetStrileByteCount(tiff, i);
    const std::string block = (shape.tiled ? "tile " : "strip ") +
                              std::to_string(i + 1) + " of " +
                              std::to_string(count);
    if (offset == 0 || size == 0) {
      return Error{ErrorCode::corrupt, block + " has no data"};
    }
    if (offset > file || size > file - offset) {
      return Error{ErrorCode::truncated,
                   block + " ends at byte " + std::to_string(offset) + " + " +
                       std::to_string(size) + ", the file at byte " +
                       std::to_string(file)};
    }
  }
  return {};
}

Resolution::Unit read_unit(TIFF* tiff) {
  std::uint16_t unit = RESUNIT_INCH;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
  if (unit == RESUNIT_INCH) return Resolution::Unit::inch;
  if (unit == RESUNIT_CENTIMETER) return Resolution::Unit::centimetre;
  return Resolution::Unit::none;
}

class TiffSource final : public RasterSource {
 public:
  TiffSource(SourceBytes bytes, const RasterReadOptions& options)
      : bytes_(std::move(bytes)), options_(options), input_{bytes_, 0} {}

  Status open() {
    const auto layout = TiffLayout::parse(bytes_);
    if (!layout) {
      return Error{ErrorCode::truncated, "the file ends inside its header"};
    }
    layout_ = *layout;
    tiff_ = open_tiff_input(input_, log_, options_.limits.max_memory);
    if (tiff_ == nullptr) {
      return Error{
          ErrorCode::corrupt,
          "page 1: " + std::string(log_.has_error() ? log_.error.data()
                                                    : "no TIFF directory")};
    }
    page_count_ = TIFFNumberOfDirectories(tiff_.get());
    if (Status fine = check_tiff_log(log_, false); !fine) {
      Error error = fine.error();
      error.message =
          "page " + std::to_string(page_count_ + 1) + ": " + error.message;
      return error;
    }
    return {};
  }

  [[nodiscard]] std::size_t page_count() const override { return page_count_; }

  Result<RasterPage> read(std::size_t index) override {
    if (Status there = go_to(index); !there) return there.error();
    const TiffShape shape(tiff_.get());
    if (Status fits = check(shape, 0, false); !fits) return fits.error();
    if (Status known = check_guesses(); !known) return known.error();
    RasterPage page;
    describe(shape, page);
    log_.clear();
    if (Status inside = check_blocks(tiff_.get(), shape, bytes_.size());
        !inside) {
      return inside.error();
    }
    if (Status fine = check_tiff_log(log_, false); !fine) return fine.error();
    Status read = shape.is_bilevel() ? read_bilevel(shape, page)
                                     : read_colour(shape, page);
    if (!read) return read.error();
    if (shape.orientation != ORIENTATION_TOPLEFT) {
      if (Status turned = turn(shape, page); !turned) return turned.error();
    }
    return page;
  }

 private:
  /// Makes the page current; its directory's messages are in log_.
  Status go_to(std::size_t index) {
    log_.clear();
    const std::size_t current = TIFFCurrentDirectory(tiff_.get());
    int good = 1;
    if (is_current_good_ && index == current) {
      log_ = directory_log_;
    } else if (is_current_good_ && index == current + 1) {
      good = TIFFReadDirectory(tiff_.get());
    } else {
      good = TIFFSetDirectory(tiff_.get(), static_cast<tdir_t>(index));
    }
    directory_log_ = log_;
    Status fine = check_tiff_log(log_, false);
    is_current_good_ = good == 1 && fine;
    if (!fine) return fine;
    if (good != 1) return Error{ErrorCode::corrupt, "no TIFF directory"};
    return {};
  }

  /// Where the sizes of strips contradict the image, libtiff takes the bytes
  /// that happen to follow for pixels.
  [[nodiscard]] Status check_guesses() const {
    const std::size_t kept =
        std::min(directory_log_.warning_count, directory_log_.warnings.size());
    for (std::size_t i = 0; i < kept; ++i) {
      const std::string_view line = directory_log_.warnings[i].data();
      if (line.find("Bogus") != std::string_view::npos) {
        return Error{ErrorCode::corrupt, std::string(line)};
      }
    }
    if (kept < directory_log_.warning_count) {
      return Error{ErrorCode::corrupt, "more than " + std::to_string(kept) +
                                           " faults in the directory; the "
                                           "first: " +
                                           directory_log_.warnings[0].data()};
    }
    return {};
  }

  Status read_bilevel(const TiffShape& shape, RasterPage& page) {
    TiffRows rows(tiff_.get(), shape, log_);
    const bool twice = is_transposed(shape.orientation);
    if (Status fits = check(shape, rows.memory(), twice); !fits) return fits;
    Result<Bitmap> ink = Bitmap::create(shape.width, shape.height);
    if (!ink) return ink.error();
    page.ink = std::move(*ink);
    const auto [zero, one] = tiff_bilevel_colours(tiff_.get(), shape);
    const bool zero_is_ink = std::pair(weighted_luminance(zero), zero) <=
                             std::pair(weighted_luminance(one), one);
    keep_palette(zero_is_ink ? Palette{zero, one} : Palette{one, zero},
                 page.info.metadata);
    if (page_count_ > 1 && shape.photometric == PHOTOMETRIC_MINISBLACK) {
      page.info.metadata.emplace_back(kPhotometricKey, kZeroIsBlack);
    }
    const auto used = (static_cast<std::size_t>(shape.width) + 7) / 8;
    for (std::int32_t y = 0; y < page.ink.height(); ++y) {
      const Result<std::span<const std::uint8_t>> row = rows.next();
      if (!row) return row.error();
      if (row->size() < used) {
        return Error{ErrorCode::corrupt, "rows shorter than the image"};
      }
      page.ink.set_row_bytes(y, row->first(used), zero_is_ink);
    }
    return {};
  }

  Status read_colour(const TiffShape& shape, RasterPage& page) {
    const auto rows = make_tiff_colours(tiff_.get(), shape, log_);
    const std::uint64_t row = std::uint64_t{shape.width} * sizeof(Colour);
    if (Status fits = check(shape, rows->memory() + row,
                            is_transposed(shape.orientation));
        !fits) {
      return fits;
    }
    Status read =
        read_colours(*rows, static_cast<std::int32_t>(shape.width),
                     static_cast<std::int32_t>(shape.height), options_,
                     bytes_.size() + rows->memory() + row, page);
    if (!read) return read;
    if (rows->saw_alpha()) {
      page.notes.emplace_back("transparent pixels shown over white");
    }
    if (!shape.is_plain() && shape.bits > 8) {
      page.lossless = false;
      page.notes.emplace_back("samples reduced to 8 bits, not lossless");
    }
    return {};
  }

  [[nodiscard]] Status check(const TiffShape& shape, std::uint64_t memory,
                             bool twice) const {
    std::uint64_t other = bytes_.size();
    for (const std::uint64_t part :
         {memory, twice ? bitmap_bytes(shape.height, shape.width) : 0}) {
      other = part > UINT64_MAX - other ? UINT64_MAX : other + part;
    }
    return check_page(options_.limits, shape.width, shape.height, other);
  }

  static Status turn(const TiffShape& shape, RasterPage& page) {
    if (Status turned = apply_orientation(shape.orientation, page.ink);
        !turned) {
      return turned;
    }
    if (is_transposed(shape.orientation)) {
      page.info.resolution = transposed(page.info.resolution);
    }
    page.notes.push_back("orientation " + std::to_string(shape.orientation) +
                         " (" +
                         std::string(orientation_name(shape.orientation)) +
                         ") applied; the page is stored top-left");
    return {};
  }

  void describe(const TiffShape& shape, RasterPage& page) {
    read_resolution(page);
    read_text(page);
    if (!shape.has_photometric) {
      page.notes.emplace_back(
          shape.photometric == PHOTOMETRIC_MINISWHITE
              ? "photometric interpretation missing; 0 taken as white"
              : "photometric interpretation missing; 0 taken as black");
    }
    note_lost_tags(page);
    for (std::size_t i = 0; i < std::min(directory_log_.warning_count,
                                         directory_log_.warnings.size());
         ++i) {
      page.notes.push_back(std::string("libtiff: ") +
                           directory_log_.warnings[i].data());
    }
  }

  void read_resolution(RasterPage& page) const {
    const std::uint64_t directory = TIFFCurrentDirOffset(tiff_.get());
    const auto read = [&](std::uint16_t tag) -> std::optional<Rational> {
      const auto entry = layout_.find(directory, tag);
      return entry ? layout_.rational(*entry) : std::nullopt;
    };
    const std::optional<Rational> x = read(TIFFTAG_XRESOLUTION);
    const std::optional<Rational> y = read(TIFFTAG_YRESOLUTION);
    if (!x && !y) {
      if (layout_.find(directory, TIFFTAG_XRESOLUTION)) {
        page.notes.emplace_back("resolution of an unusual type not kept");
      }
      return;
    }
    Resolution resolution{x ? *x : *y, y ? *y : *x, read_unit(tiff_.get())};
    if (!x || !y) {
      page.notes.emplace_back("resolution given for one axis; used for both");
    }
    if (is_usable(resolution)) {
      page.info.resolution = resolution;
    } else {
      page.notes.push_back("resolution " + to_string(resolution) +
                           " is not a number above 0; not kept");
    }
  }

  void read_text(RasterPage& page) {
    const auto read = [this](std::uint32_t tag) -> std::string {
      const char* text = nullptr;
      if (TIFFGetField(tiff_.get(), tag, &text) == 0 || text == nullptr) {
        return {};
      }
      return to_utf8(text);
    };
    page.info.name = read(TIFFTAG_PAGENAME);
    for (const auto& [tag, key] : kTiffTextTags) {
      std::string text = read(tag);
      if (text.empty()) continue;
      page.info.metadata.emplace_back(key, std::move(text));
    }
  }

  void note_lost_tags(RasterPage& page) {
    const auto note = [&page](const std::string& tag) {
      page.notes.push_back("TIFF tag " + tag + " not kept");
    };
    float position = 0;
    if (TIFFGetField(tiff_.get(), TIFFTAG_XPOSITION, &position) != 0 ||
        TIFFGetField(tiff_.get(), TIFFTAG_YPOSITION, &position) != 0) {
      note("XPosition/YPosition");
    }
    std::uint32_t kind = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_SUBFILETYPE, &kind);
    if ((kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) != 0) {
      page.notes.emplace_back(
          "the page is a preview or a mask of another one; stored as a page");
    }
    std::uint16_t count = 0;
    void* offsets = nullptr;
    if (TIFFGetField(tiff_.get(), TIFFTAG_SUBIFD, &count, &offsets) != 0) {
      page.notes.emplace_back("images inside the page (SubIFDs) not kept");
    }
    const int tags = TIFFGetTagListCount(tiff_.get());
    for (int i = 0; i < tags; ++i) {
      const std::uint32_t tag = TIFFGetTagListEntry(tiff_.get(), i);
      const bool kept =
          tag == TIFFTAG_PAGENAME ||
          std::any_of(kTiffTextTags.begin(), kTiffTextTags.end(),
                      [tag](const TiffTextTag& t) { return t.tag == tag; });
      if (kept) continue;
      const TIFFField* field = TIFFFieldWithTag(tiff_.get(), tag);
      note(field != nullptr ? TIFFFieldName(field) : std::to_string(tag));
    }
  }

  SourceBytes bytes_;
  RasterReadOptions options_;
  TiffInput input_;
  TiffLog log_;
  TiffLog directory_log_;
  TiffLayout layout_;
  TiffHandle tiff_;
  std::size_t page_count_ = 0;
  bool is_current_good_ = false;
};

}  // namespace

SourceResult open_tiff(SourceBytes bytes, const RasterReadOptions& options) {
  auto source = std::make_unique<TiffSource>(std::move(bytes), options);
  if (Status opened = source->open(); !opened) return opened.error();
  return std::unique_ptr<RasterSource>(std::move(source));
}

}  // namespace unstep
