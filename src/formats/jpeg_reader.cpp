#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "formats/jpeg_rows.h"
#include "formats/orientation.h"
#include "formats/page_limits.h"
#include "formats/raster_source.h"
#include "formats/resolution.h"
#include "formats/tiff_layout.h"

/// JPEG: the pixels come from libjpeg; size, density, orientation and whether
/// the file is whole are read from its markers (ITU-T T.81 annex B, JFIF 1.02)
/// here.
namespace unstep {
namespace {

struct JpegHeader {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  Resolution resolution;
  int orientation = 1;
};

class MarkerReader {
 public:
  explicit MarkerReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// Walks all markers up to the end of the image.
  Result<JpegHeader> read() {
    position_ = 2;  // after SOI
    for (;;) {
      const int marker = next_marker();
      if (marker < 0) break;
      if (marker == kEndOfImage) {
        if (header_.width != 0) return header_;
        return Error{ErrorCode::corrupt,
                     "no image before byte " + std::to_string(position_)};
      }
      if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) continue;
      const std::size_t length = number(position_, 2);
      if (length < 2 || length > bytes_.size() - position_) break;
      segment(marker, bytes_.subspan(position_ + 2, length - 2));
      position_ += length;
    }
    return Error{ErrorCode::truncated, "the file ends at byte " +
                                           std::to_string(bytes_.size()) +
                                           " without the end of the image"};
  }

 private:
  static constexpr int kEndOfImage = 0xd9;

  [[nodiscard]] std::size_t number(std::size_t at, std::size_t size) const {
    std::size_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value = value << 8 | (at + i < bytes_.size() ? bytes_[at + i] : 0U);
    }
    return value;
  }

  /// Skips coded data (in which FF is followed by 00 or a restart marker).
  int next_marker() {
    while (position_ + 1 < bytes_.size()) {
      const auto begin =
          bytes_.begin() + static_cast<std::ptrdiff_t>(position_);
      const auto found = std::find(begin, bytes_.end(), 0xff);
      position_ = static_cast<std::size_t>(found - bytes_.begin());
      if (position_ + 1 >= bytes_.size()) return -1;
      const std::uint8_t code = bytes_[position_ + 1];
      position_ += code == 0xff ? 1 : 2;
      if (code != 0xff && code != 0x00) return code;
    }
    return -1;
  }

  void segment(int marker, std::span<const std::uint8_t> body) {
    const bool is_frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 &&
                          marker != 0xc8 && marker != 0xcc;
    const std::size_t at = position_ + 2;
    if (is_frame && body.size() >= 5) {
      header_.height = number(at + 1, 2);
      header_.width = number(at + 3, 2);
    } else if (marker == 0xe0 && starts_with(body, "JFIF") &&
               body.size() >= 12) {
      read_density(at);
    } else if (marker == 0xe1 && starts_with(body, "Exif") && body.size() > 6) {
      read_exif(body.subspan(6));
    }
  }

  static bool starts_with(std::span<const std::uint8_t> body,
                          const char* name) {
    return body.size() > 4 && std::equal(name, name + 5, body.begin());
  }

  void read_density(std::size_t at) {
    const auto x = static_cast<std::uint32_t>(number(at + 8, 2));
    const auto y = static_cast<std::uint32_t>(number(at + 10, 2));
    const std::size_t unit = number(at + 7, 1);
    const bool means_nothing = unit == 0 && x == y;  // square pixels
    if (x == 0 || y == 0 || means_nothing) return;
    header_.resolution = {{x, 1},
                          {y, 1},
                          unit == 1   ? Resolution::Unit::inch
                          : unit == 2 ? Resolution::Unit::centimetre
                                      : Resolution::Unit::none};
  }

  void read_exif(std::span<const std::uint8_t> tiff) {
    constexpr std::uint16_t kOrientation = 274;
    const auto layout = TiffLayout::parse(tiff);
    if (!layout) return;
    const auto entry = layout->find(layout->first_directory(), kOrientation);
    if (!entry) return;
    const auto value = layout->rational(*entry);
    if (value && value->numerator >= 1 && value->numerator <= 8) {
      header_.orientation = static_cast<int>(value->numerator);
    }
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
  JpegHeader header_;
};

class JpegSource final : public RasterSource {
 public:
  JpegSource(SourceBytes bytes, const RasterReadOptions& options)
      : bytes_(std::move(bytes)), options_(options) {}

  [[nodiscard]] std::size_t page_count() const override { return 1; }

  Result<RasterPage> read(std::size_t /*page*/) override {
    const Result<JpegHeader> header = MarkerReader(bytes_).read();
    if (!header) return header.error();
    RasterPage page;
    if (Status read = read_pixels(page); !read) return read.error();
    page.info.resolution = header->resolution;
    if (header->orientation != 1) {
      if (Status turned = turn(*header, page); !turned) return turned.error();
    }
    return page;
  }

 private:
  Status read_pixels(RasterPage& page) const {
    JpegRows rows(bytes_);
    if (Status opened = rows.open(options_.limits); !opened) return opened;
    page.notes = rows.notes();
    return read_colours(rows, rows.width(), rows.height(), options_,
                        rows.memory(), page);
  }

  Status turn(const JpegHeader& header, RasterPage& page) const {
    if (is_transposed(header.orientation)) {
      const auto width = static_cast<std::uint64_t>(page.ink.width());
      const auto height = static_cast<std::uint64_t>(page.ink.height());
      if (Status fits = check_page(options_.limits, width, height,
                                   bytes_.size() + bitmap_bytes(height, width));
          !fits) {
        return fits;
      }
      page.info.resolution = transposed(header.resolution);
    }
    if (Status turned = apply_orientation(header.orientation, page.ink);
        !turned) {
      return turned;
    }
    page.notes.push_back("EXIF orientation " +
                         std::to_string(header.orientation) + " (" +
                         std::string(orientation_name(header.orientation)) +
                         ") applied; the page is stored top-left");
    return {};
  }

  SourceBytes bytes_;
  RasterReadOptions options_;
};

}  // namespace

SourceResult open_jpeg(SourceBytes bytes, const RasterReadOptions& options) {
  return std::unique_ptr<RasterSource>(
      std::make_unique<JpegSource>(std::move(bytes), options));
}

}  // namespace unstep
