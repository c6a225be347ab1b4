#include "formats/tiff_rows.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace unstep {
namespace {

/// The colour map, 16 bits a sample; old writers used 8 (TIFF 6.0 forbids it).
std::vector<Colour> read_colour_map(TIFF* tiff, unsigned bits) {
  std::uint16_t* red = nullptr;
  std::uint16_t* green = nullptr;
  std::uint16_t* blue = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_COLORMAP, &red, &green, &blue) == 0) return {};
  const std::size_t count = std::size_t{1} << bits;
  bool narrow = true;
  for (std::size_t i = 0; i < count; ++i) {
    narrow = narrow && red[i] < 256 && green[i] < 256 && blue[i] < 256;
  }
  const std::uint32_t factor = narrow ? 257 : 1;
  std::vector<Colour> map(count);
  for (std::size_t i = 0; i < count; ++i) {
    map[i] = make_colour(red[i] * factor, green[i] * factor, blue[i] * factor);
  }
  return map;
}

class PlainColours final : public TiffColours {
 public:
  PlainColours(TIFF* tiff, const TiffShape& shape, const TiffLog& log)
      : rows_(tiff, shape, log), shape_(shape) {
    if (shape.photometric == PHOTOMETRIC_PALETTE) {
      map_ = read_colour_map(tiff, shape.bits);
    }
    std::uint16_t count = 0;
    std::uint16_t* kinds = nullptr;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &count, &kinds);
    if (count > 0) alpha_kind_ = kinds[0];
  }

  [[nodiscard]] std::uint64_t memory() const override { return rows_.memory(); }
  [[nodiscard]] bool saw_alpha() const override { return saw_alpha_; }

  Status start() override {
    rows_.start();
    return {};
  }

  Status next(std::span<Colour> row) override {
    const Result<std::span<const std::uint8_t>> bytes = rows_.next();
    if (!bytes) return bytes.error();
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = pixel(*bytes, x);
    return {};
  }

 private:
  [[nodiscard]] unsigned raw(std::span<const std::uint8_t> bytes,
                             std::size_t i) const {
    if (shape_.bits == 8) return bytes[i];
    if (shape_.bits == 16) {  // libtiff gives them in the machine's order
      std::uint16_t value = 0;
      std::memcpy(&value, bytes.data() + 2 * i, 2);
      return value;
    }
    const std::size_t bit = i * shape_.bits;
    return static_cast<unsigned>(bytes[bit / 8]) >>
               (8 - shape_.bits - bit % 8) &
           ((1U << shape_.bits) - 1);
  }

  /// Sample i of the row, widened to 16 bits (exact: 2^bits - 1 divides
  /// 65535).
  [[nodiscard]] std::uint32_t sample(std::span<const std::uint8_t> bytes,
                                     std::size_t i) const {
    return raw(bytes, i) * (65535U / ((1U << shape_.bits) - 1));
  }

  Colour pixel(std::span<const std::uint8_t> bytes, std::size_t x) {
    const std::size_t n = shape_.samples;
    const std::size_t first = x * n;
    Colour colour = 0;
    std::size_t colours = 1;
    switch (shape_.photometric) {
      case PHOTOMETRIC_PALETTE: {
        const unsigned index = raw(bytes, first);
        colour = index < map_.size() ? map_[index] : kBlack;
        break;
      }
      case PHOTOMETRIC_RGB:
        colours = 3;
        colour = make_colour(sample(bytes, first), sample(bytes, first + 1),
                             sample(bytes, first + 2));
        break;
      case PHOTOMETRIC_MINISWHITE:
        colour = make_grey(65535 - sample(bytes, first));
        break;
      default: colour = make_grey(sample(bytes, first)); break;
    }
    return n > colours ? blend(colour, sample(bytes, first + colours)) : colour;
  }

  Colour blend(Colour colour, std::uint32_t alpha) {
    if (alpha_kind_ == EXTRASAMPLE_UNSPECIFIED) return colour;
    saw_alpha_ = saw_alpha_ || alpha != 65535;
    if (alpha_kind_ == EXTRASAMPLE_UNASSALPHA) return over_white(colour, alpha);
    const auto add = [alpha](std::uint32_t v) {  // premultiplied
      return std::min<std::uint32_t>(65535, v + (65535 - alpha));
    };
    return make_colour(add(red_of(colour)), add(green_of(colour)),
                       add(blue_of(colour)));
  }

  TiffRows rows_;
  TiffShape shape_;
  std::vector<Colour> map_;
  std::uint16_t alpha_kind_ = EXTRASAMPLE_UNSPECIFIED;
  bool saw_alpha_ = false;
};

/// Everything else (YCbCr, CMYK, separate planes, ...) as libtiff shows it.
class RgbaColours final : public TiffColours {
 public:
  RgbaColours(TIFF* tiff, const TiffShape& shape, const TiffLog& log)
      : tiff_(tiff), shape_(shape), log_(log) {}

  [[nodiscard]] std::uint64_t memory() const override {
    return std::uint64_t{shape_.width} * shape_.block_rows * 4;
  }
  [[nodiscard]] bool saw_alpha() const override { return saw_alpha_; }

  Status start() override {
    y_ = 0;
    return {};
  }

  Status next(std::span<Colour> row) override {
    const std::uint32_t in_block = y_ % shape_.block_rows;
    if (in_block == 0) {
      if (Status read = read_block(); !read) return read;
    }
    const auto pixels =
        std::span(block_).subspan(std::size_t{in_block} * row.size());
    for (std::size_t x = 0; x < row.size(); ++x) {
      const std::uint32_t pixel = pixels[x];
      const std::uint32_t alpha = TIFFGetA(pixel);
      saw_alpha_ = saw_alpha_ || alpha != 255;
      // libtiff premultiplies.
      const auto add = [alpha](std::uint32_t v) {
        return widen(std::min<std::uint32_t>(255, v + (255 - alpha)));
      };
      row[x] = make_colour(add(TIFFGetR(pixel)), add(TIFFGetG(pixel)),
                           add(TIFFGetB(pixel)));
    }
    ++y_;
    return {};
  }

 private:
  Status read_block() {
    const std::uint32_t rows = std::min(shape_.block_rows, shape_.height - y_);
    block_.assign(std::size_t{shape_.width} * shape_.block_rows, 0);
    std::array<char, 1024> reason{};
    TIFFRGBAImage image;
    if (TIFFRGBAImageBegin(&image, tiff_, 1, reason.data()) == 0) {
      return Error{ErrorCode::unsupported, reason.data()};
    }
    image.row_offset = static_cast<int>(y_);
    image.req_orientation = image.orientation;  // as stored; turned later
    const int good =
        TIFFRGBAImageGet(&image, block_.data(), shape_.width, rows);
    TIFFRGBAImageEnd(&image);
    if (Status fine = check_tiff_log(log_, true); !fine) return fine;
    if (good == 0) return Error{ErrorCode::corrupt, "libtiff gives no pixels"};
    return {};
  }

  TIFF* tiff_;
  TiffShape shape_;
  const TiffLog& log_;
  std::uint32_t y_ = 0;
  bool saw_alpha_ = false;
  std::vector<std::uint32_t> block_;
};

}  // namespace

TiffShape::TiffShape(TIFF* tiff) {
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &planar);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &compression);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &sample_format);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &orientation);
  if (orientation < 1 || orientation > 8) orientation = ORIENTATION_TOPLEFT;
  has_photometric = TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric) != 0;
  if (!has_photometric && (compression == COMPRESSION_CCITTRLE ||
                           compression == COMPRESSION_CCITTFAX3 ||
                           compression == COMPRESSION_CCITTFAX4)) {
    photometric = PHOTOMETRIC_MINISWHITE;  // what a fax means by 0
  }
  tiled = TIFFIsTiled(tiff) != 0;
  TIFFGetFieldDefaulted(tiff, tiled ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP,
                        &block_rows);
  if (!tiled) block_rows = std::min(block_rows, height);
}

bool TiffShape::is_bilevel() const {
  return bits == 1 && samples == 1 &&
         (photometric == PHOTOMETRIC_MINISWHITE ||
          photometric == PHOTOMETRIC_MINISBLACK ||
          photometric == PHOTOMETRIC_PALETTE);
}

bool TiffShape::is_plain() const {
  const bool known_bits =
      bits == 1 || bits == 2 || bits == 4 || bits == 8 || bits == 16;
  const bool known_colours = photometric == PHOTOMETRIC_MINISWHITE ||
                             photometric == PHOTOMETRIC_MINISBLACK ||
                             photometric == PHOTOMETRIC_PALETTE ||
                             (photometric == PHOTOMETRIC_RGB && samples >= 3);
  return known_bits && known_colours && samples <= 16 &&
         (planar == PLANARCONFIG_CONTIG || samples == 1) &&
         (sample_format == SAMPLEFORMAT_UINT ||
          sample_format == SAMPLEFORMAT_VOID);
}

Status check_tiff_log(const TiffLog& log, bool pixels) {
  if (log.has_error()) return Error{ErrorCode::corrupt, log.error.data()};
  if (!pixels) return {};
  for (std::size_t i = 0; i < log.warning_count; ++i) {
    // Files of before 1990, read as they were meant.
    const bool kept = i < log.warnings.size();
    if (kept &&
        std::strncmp(log.warnings[i].data(), "Old-style LZW", 13) == 0) {
      continue;
    }
    return Error{ErrorCode::corrupt,
                 kept ? log.warnings[i].data() : "libtiff reports damage"};
  }
  return {};
}

std::uint64_t TiffRows::memory() const {
  const std::uint64_t row = TIFFScanlineSize64(tiff_);
  if (!shape_.tiled) return row;
  const std::uint64_t tile = TIFFTileSize64(tiff_);
  const std::uint64_t rows = shape_.block_rows;
  if (rows == 0 || tile == 0 || row > UINT64_MAX / 4 / rows) return UINT64_MAX;
  return tile + row * rows;
}

Result<std::span<const std::uint8_t>> TiffRows::next() {
  row_bytes_ = static_cast<std::size_t>(TIFFScanlineSize64(tiff_));
  const std::size_t rows = shape_.tiled ? shape_.block_rows : 1;
  rows_.resize(row_bytes_ * rows);
  const std::uint32_t y = y_++;
  if (!shape_.tiled) {
    const int good = TIFFReadScanline(tiff_, rows_.data(), y, 0);
    if (Status fine = check_tiff_log(log_, true); !fine) return fine.error();
    if (good != 1) return Error{ErrorCode::corrupt, "libtiff gives no pixels"};
    return std::span<const std::uint8_t>(rows_);
  }
  if (y % rows == 0) {
    --y_;
    if (Status read = read_tiles(); !read) return read.error();
    ++y_;
  }
  return std::span<const std::uint8_t>(rows_).subspan(y % rows * row_bytes_,
                                                      row_bytes_);
}

Status TiffRows::read_tiles() {
  std::uint32_t tile_width = 0;
  TIFFGetField(tiff_, TIFFTAG_TILEWIDTH, &tile_width);
  const std::uint64_t pixel_bits = std::uint64_t{shape_.bits} * shape_.samples;
  if (tile_width == 0 || tile_width * pixel_bits % 8 != 0) {
    return Error{ErrorCode::corrupt, "tiles of " + std::to_string(tile_width) +
                                         " pixels; must be a multiple of 16"};
  }
  tile_.resize(static_cast<std::size_t>(TIFFTileSize64(tiff_)));
  const auto tile_row = static_cast<std::size_t>(TIFFTileRowSize64(tiff_));
  for (std::uint64_t x = 0; x < shape_.width; x += tile_width) {
    const tmsize_t size = TIFFReadTile(tiff_, tile_.data(),
                                       static_cast<std::uint32_t>(x), y_, 0, 0);
    if (Status fine = check_tiff_log(log_, true); !fine) return fine;
    if (size < 0 || static_cast<std::size_t>(size) < tile_.size()) {
      return Error{ErrorCode::corrupt, "libtiff gives no pixels"};
    }
    const auto at = static_cast<std::size_t>(x * pixel_bits / 8);
    const std::size_t count = std::min(tile_row, row_bytes_ - at);
    for (std::size_t row = 0; row < shape_.block_rows; ++row) {
      std::memcpy(rows_.data() + row * row_bytes_ + at,
                  tile_.data() + row * tile_row, count);
    }
  }
  return {};
}

std::unique_ptr<TiffColours> make_tiff_colours(TIFF* tiff,
                                               const TiffShape& shape,
                                               const TiffLog& log) {
  if (shape.is_plain()) {
    return std::make_unique<PlainColours>(tiff, shape, log);
  }
  return std::make_unique<RgbaColours>(tiff, shape, log);
}

std::pair<Colour, Colour> tiff_bilevel_colours(TIFF* tiff,
                                               const TiffShape& shape) {
  if (shape.photometric == PHOTOMETRIC_MINISWHITE) return {kWhite, kBlack};
  if (shape.photometric == PHOTOMETRIC_PALETTE) {
    const std::vector<Colour> map = read_colour_map(tiff, 1);
    if (map.size() == 2) return {map[0], map[1]};
  }
  return {kBlack, kWhite};
}

}  // namespace unstep
