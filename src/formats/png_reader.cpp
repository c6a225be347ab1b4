#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "formats/colour_rows.h"
#include "formats/page_limits.h"
#include "formats/png_file.h"
#include "formats/raster_source.h"
#include "formats/text.h"

namespace unstep {
namespace {

/// IHDR, read once.
struct PngShape {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  int depth = 0;
  int colour_type = 0;
  bool interlaced = false;
  explicit PngShape(const PngFile& file)
      : width(png_get_image_width(file.png(), file.info())),
        height(png_get_image_height(file.png(), file.info())),
        depth(png_get_bit_depth(file.png(), file.info())),
        colour_type(png_get_color_type(file.png(), file.info())),
        interlaced(png_get_interlace_type(file.png(), file.info()) !=
                   PNG_INTERLACE_NONE) {}
  [[nodiscard]] bool is_bilevel() const {
    return depth == 1 && (colour_type == PNG_COLOR_TYPE_GRAY ||
                          colour_type == PNG_COLOR_TYPE_PALETTE);
  }
};

/// The colours of the samples 0 and 1 of a 1-bit image, over white.
std::pair<Colour, Colour> bilevel_colours(const PngFile& file,
                                          bool is_palette) {
  png_bytep alpha = nullptr;
  int alphas = 0;
  png_color_16p grey = nullptr;
  png_get_tRNS(file.png(), file.info(), &alpha, &alphas, &grey);
  if (!is_palette) {
    const bool has_key =
        png_get_valid(file.png(), file.info(), PNG_INFO_tRNS) != 0 &&
        grey != nullptr;
    const auto seen = [&](unsigned sample, Colour colour) {
      return has_key && (grey->gray & 1U) == sample ? kWhite : colour;
    };
    return {seen(0, kBlack), seen(1, kWhite)};
  }
  png_colorp entries = nullptr;
  int count = 0;
  png_get_PLTE(file.png(), file.info(), &entries, &count);
  const auto seen = [&](int i) {
    if (i >= count) return kBlack;
    const Colour colour = make_colour(
        widen(entries[i].red), widen(entries[i].green), widen(entries[i].blue));
    return alpha != nullptr && i < alphas ? over_white(colour, widen(alpha[i]))
                                          : colour;
  };
  return {seen(0), seen(1)};
}

/// 1-bit rows, packed as the file has them. The passes of an interlaced image
/// fill the pixels of their own, so each gets the row as it is so far.
Status read_packed(PngFile& file, const PngShape& shape, bool invert,
                   Bitmap& ink) {
  int passes = 1;
  Status begun = file.call([&] {
    passes = png_set_interlace_handling(file.png());
    png_read_update_info(file.png(), file.info());
  });
  if (!begun) return begun;
  std::vector<std::uint8_t> row((std::size_t{shape.width} + 7) / 8);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::int32_t y = 0; y < ink.height(); ++y) {
      if (pass > 0) ink.get_row_bytes(y, row, invert);
      Status read =
          file.call([&] { png_read_row(file.png(), row.data(), nullptr); });
      if (!read) return read;
      ink.set_row_bytes(y, row, invert);
    }
  }
  return {};
}

/// Rows of any other kind, expanded by libpng to 1..4 samples of 8 or 16 bits.
class PngRows final : public ColourRows {
 public:
  PngRows(std::span<const std::uint8_t> bytes, const DecodeLimits& limits)
      : bytes_(bytes), limits_(limits) {}

  Status start() override {
    y_ = 0;
    file_ = std::make_unique<PngFile>(bytes_);
    if (Status header = file_->read_header(); !header) return header;
    const PngShape shape(*file_);
    const png_structp png = file_->png();
    Status begun = file_->call([&] {
      png_set_expand(png);
      png_set_interlace_handling(png);
      png_read_update_info(png, file_->info());
    });
    if (!begun) return begun;
    channels_ = png_get_channels(png, file_->info());
    samples_are_16_bit_ = png_get_bit_depth(png, file_->info()) == 16;
    row_bytes_ = png_get_rowbytes(png, file_->info());
    return shape.interlaced ? read_whole(shape) : Status{};
  }

  Status next(std::span<Colour> row) override {
    if (!image_.empty()) {
      convert(std::span(image_).subspan(row_bytes_ * y_++, row_bytes_), row);
      return {};
    }
    buffer_.resize(row_bytes_);
    Status read = file_->call(
        [&] { png_read_row(file_->png(), buffer_.data(), nullptr); });
    if (!read) return read;
    convert(buffer_, row);
    return {};
  }

  Status next_luminance(std::span<std::uint8_t> row) override {
    if (channels_ != 1 || samples_are_16_bit_ || !image_.empty()) {
      return ColourRows::next_luminance(row);
    }
    return file_->call(
        [&] { png_read_row(file_->png(), row.data(), nullptr); });
  }

  [[nodiscard]] PngFile& file() { return *file_; }
  [[nodiscard]] bool saw_alpha() const { return saw_alpha_; }

 private:
  /// The passes of an interlaced image need all rows at once.
  Status read_whole(const PngShape& shape) {
    const std::uint64_t size = std::uint64_t{row_bytes_} * shape.height;
    const std::uint64_t row = std::uint64_t{shape.width} * sizeof(Colour);
    if (Status fits = check_page(limits_, shape.width, shape.height,
                                 bytes_.size() + row + size);
        !fits) {
      return fits;
    }
    image_.assign(static_cast<std::size_t>(size), 0);
    std::vector<png_bytep> rows(shape.height);
    for (std::size_t y = 0; y < rows.size(); ++y) {
      rows[y] = image_.data() + y * row_bytes_;
    }
    return file_->call([&] { png_read_image(file_->png(), rows.data()); });
  }

  [[nodiscard]] std::uint32_t sample(std::span<const std::uint8_t> bytes,
                                     std::size_t i) const {
    if (!samples_are_16_bit_) return widen(bytes[i]);
    return std::uint32_t{bytes[2 * i]} << 8 | bytes[2 * i + 1];
  }

  void convert(std::span<const std::uint8_t> bytes, std::span<Colour> row) {
    const std::size_t n = channels_;
    for (std::size_t x = 0; x < row.size(); ++x) {
      Colour pixel =
          n < 3 ? make_grey(sample(bytes, x * n))
                : make_colour(sample(bytes, x * n), sample(bytes, x * n + 1),
                              sample(bytes, x * n + 2));
      if (n % 2 == 0) {
        const std::uint32_t alpha = sample(bytes, x * n + n - 1);
        saw_alpha_ = saw_alpha_ || alpha != 65535;
        pixel = over_white(pixel, alpha);
      }
      row[x] = pixel;
    }
  }

  std::span<const std::uint8_t> bytes_;
  DecodeLimits limits_;
  std::unique_ptr<PngFile> file_;
  std::size_t channels_ = 1;
  std::size_t row_bytes_ = 0;
  std::size_t y_ = 0;
  bool samples_are_16_bit_ = false;
  bool saw_alpha_ = false;
  std::vector<std::uint8_t> buffer_;
  std::vector<std::uint8_t> image_;  // interlaced only
};

Resolution read_resolution(const PngFile& file) {
  png_uint_32 x = 0;
  png_uint_32 y = 0;
  int unit = PNG_RESOLUTION_UNKNOWN;
  png_get_pHYs(file.png(), file.info(), &x, &y, &unit);
  if (x == 0 || y == 0) return {};
  return {{x, 1},
          {y, 1},
          unit == PNG_RESOLUTION_METER ? Resolution::Unit::metre
                                       : Resolution::Unit::none};
}

void read_text(const PngFile& file, PageInfo& info) {
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(file.png(), file.info(), &texts, &count);
  for (int i = 0; i < count; ++i) {
    const bool is_utf8_chunk =
        texts[i].compression >= PNG_ITXT_COMPRESSION_NONE;
    const std::size_t length =
        is_utf8_chunk ? texts[i].itxt_length : texts[i].text_length;
    const std::string_view bytes(texts[i].text, length);
    const std::string value =
        is_utf8_chunk ? to_utf8(bytes) : latin1_to_utf8(bytes);
    const std::string key = latin1_to_utf8(texts[i].key);
    if (key == "tiff:PageName") {
      info.name = value;
    } else {
      // The writer keeps the names of foreign tags; so they come back.
      add_metadata(info.metadata, key.starts_with("tiff:") ? key : "png:" + key,
                   value);
    }
  }
}

/// Resolution, text, and notes of what is not kept. The whole file was read.
void describe(const PngFile& file, RasterPage& page) {
  page.info.resolution = read_resolution(file);
  read_text(file, page.info);
  const auto has = [&file](png_uint_32 chunk) {
    return png_get_valid(file.png(), file.info(), chunk) != 0;
  };
  if (has(PNG_INFO_iCCP)) page.notes.emplace_back("colour profile not kept");
  if (has(PNG_INFO_tIME)) {
    page.notes.emplace_back("modification time not kept");
  }
  if (has(PNG_INFO_eXIf)) page.notes.emplace_back("EXIF data not kept");
  if (!file.warning().empty()) {
    page.notes.push_back("libpng: " + file.warning());
  }
  if (file.bytes_left() != 0) {
    page.notes.push_back(std::to_string(file.bytes_left()) +
                         " bytes after the image not kept");
  }
}

class PngSource final : public RasterSource {
 public:
  PngSource(SourceBytes bytes, const RasterReadOptions& options)
      : bytes_(std::move(bytes)), options_(options) {}

  [[nodiscard]] std::size_t page_count() const override { return 1; }

  Result<RasterPage> read(std::size_t /*page*/) override {
    PngFile file(bytes_);
    if (Status header = file.read_header(); !header) return header.error();
    const PngShape shape(file);
    // libpng holds two rows of at most 8 bytes a pixel.
    const std::uint64_t row =
        std::uint64_t{shape.width} * (shape.is_bilevel() ? 1 : 24);
    if (Status fits = check_page(options_.limits, shape.width, shape.height,
                                 bytes_.size() + row);
        !fits) {
      return fits.error();
    }
    RasterPage page;
    Status read = shape.is_bilevel() ? read_bilevel(file, shape, page)
                                     : read_grey_or_colour(shape, page);
    if (!read) return read.error();
    return page;
  }

 private:
  static Status finish(PngFile& file, RasterPage& page) {
    Status end = file.call([&file] { png_read_end(file.png(), file.info()); });
    if (!end) return end;
    describe(file, page);
    return {};
  }

  static Status read_bilevel(PngFile& file, const PngShape& shape,
                             RasterPage& page) {
    Result<Bitmap> ink = Bitmap::create(shape.width, shape.height);
    if (!ink) return ink.error();
    page.ink = std::move(*ink);
    const auto [zero, one] =
        bilevel_colours(file, shape.colour_type == PNG_COLOR_TYPE_PALETTE);
    // Two equal colours: sample 0 is ink, and the palette restores the look.
    const bool zero_is_ink = std::pair(weighted_luminance(zero), zero) <=
                             std::pair(weighted_luminance(one), one);
    if (Status read = read_packed(file, shape, zero_is_ink, page.ink); !read) {
      return read;
    }
    keep_palette(zero_is_ink ? Palette{zero, one} : Palette{one, zero},
                 page.info.metadata);
    if (png_get_valid(file.png(), file.info(), PNG_INFO_tRNS) != 0) {
      page.notes.emplace_back("transparent pixels shown over white");
    }
    return finish(file, page);
  }

  Status read_grey_or_colour(const PngShape& shape, RasterPage& page) {
    PngRows rows(bytes_, options_.limits);
    if (Status read =
            read_colours(rows, static_cast<std::int32_t>(shape.width),
                         static_cast<std::int32_t>(shape.height), options_,
                         bytes_.size() + std::uint64_t{shape.width} * 24, page);
        !read) {
      return read;
    }
    if (rows.saw_alpha()) {
      page.notes.emplace_back("transparent pixels shown over white");
    }
    return finish(rows.file(), page);
  }

  SourceBytes bytes_;
  RasterReadOptions options_;
};

}  // namespace

SourceResult open_png(SourceBytes bytes, const RasterReadOptions& options) {
  return std::unique_ptr<RasterSource>(
      std::make_unique<PngSource>(std::move(bytes), options));
}

}  // namespace unstep
