#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "formats/colour.h"
#include "formats/opencv_page.h"
#include "formats/page_limits.h"
#include "formats/raster_source.h"

/// BMP. One-bit files are read here, packed; all others by OpenCV.
namespace unstep {
namespace {

struct BmpHeader {
  std::uint32_t data = 0;  ///< where the rows begin
  std::uint32_t info_size = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;  ///< above 0; see top_down
  bool top_down = false;
  std::uint32_t bits = 0;
  std::uint32_t compression = 0;
  std::uint32_t x_per_metre = 0;
  std::uint32_t y_per_metre = 0;
  std::uint32_t colours = 0;  ///< in the palette
  [[nodiscard]] bool is_core() const { return info_size == 12; }
  /// Rows are filled up to four bytes.
  [[nodiscard]] std::uint64_t row_bytes() const {
    return (static_cast<std::uint64_t>(width) * bits + 31) / 32 * 4;
  }
};

class BmpSource final : public RasterSource {
 public:
  BmpSource(SourceBytes bytes, const RasterReadOptions& options)
      : bytes_(std::move(bytes)), options_(options) {}

  Status open() {
    constexpr std::size_t kFileHeader = 14;
    header_.info_size = number(kFileHeader, 4);
    const std::size_t needed = header_.is_core() ? 12 : 40;
    if (bytes_.size() < kFileHeader + needed) {
      return Error{ErrorCode::truncated, "the file ends inside its header"};
    }
    if (header_.info_size < needed) {
      return Error{
          ErrorCode::corrupt,
          "byte 14: header of " + std::to_string(header_.info_size) + " bytes"};
    }
    header_.data = number(10, 4);
    if (header_.is_core()) {
      header_.width = number(18, 2);
      header_.height = number(20, 2);
      header_.bits = number(24, 2);
      header_.colours = 2;
    } else {
      header_.width = static_cast<std::int32_t>(number(18, 4));
      header_.height = static_cast<std::int32_t>(number(22, 4));
      header_.bits = number(28, 2);
      header_.compression = number(30, 4);
      header_.x_per_metre = number(38, 4);
      header_.y_per_metre = number(42, 4);
      header_.colours = number(46, 4) == 0 ? 2 : number(46, 4);
    }
    header_.top_down = header_.height < 0;
    if (header_.top_down) header_.height = -header_.height;
    if (header_.width < 0) {
      return Error{ErrorCode::corrupt, "byte 18: negative width"};
    }
    if (!has_known_coding()) {
      return Error{ErrorCode::corrupt,
                   "byte 28: no such coding: " + std::to_string(header_.bits) +
                       " bits a pixel, compression " +
                       std::to_string(header_.compression)};
    }
    return {};
  }

  [[nodiscard]] std::size_t page_count() const override { return 1; }

  Result<RasterPage> read(std::size_t /*page*/) override {
    const auto width = static_cast<std::uint64_t>(header_.width);
    const auto height = static_cast<std::uint64_t>(header_.height);
    if (Status fits = check_page(options_.limits, width, height, bytes_.size());
        !fits) {
      return fits.error();
    }
    // Uncompressed rows must all be there; OpenCV would make up the rest.
    if (header_.compression == 0 &&
        (header_.data > bytes_.size() ||
         height > (bytes_.size() - header_.data) / header_.row_bytes())) {
      return Error{ErrorCode::truncated, "the file ends at byte " +
                                             std::to_string(bytes_.size()) +
                                             " inside the image"};
    }
    const bool packed = header_.bits == 1 && header_.compression == 0;
    Result<RasterPage> page =
        packed ? read_packed()
               : read_opencv_page(bytes_, width, height, options_);
    if (page && header_.x_per_metre != 0 && header_.y_per_metre != 0 &&
        header_.x_per_metre <= INT32_MAX && header_.y_per_metre <= INT32_MAX) {
      page->info.resolution = {{header_.x_per_metre, 1},
                               {header_.y_per_metre, 1},
                               Resolution::Unit::metre};
    }
    return page;
  }

 private:
  /// Little endian; 0 past the end.
  [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = size; i-- > 0;) {
      value = value << 8 | (at + i < bytes_.size() ? bytes_[at + i] : 0U);
    }
    return value;
  }

  /// Plain rows of 1 to 32 bits, run lengths of 4 and 8, masks of 16 and 32.
  [[nodiscard]] bool has_known_coding() const {
    const std::uint32_t bits = header_.bits;
    switch (header_.compression) {
      case 0:
        return bits == 1 || bits == 4 || bits == 8 || bits == 16 ||
               bits == 24 || bits == 32;
      case 1: return bits == 8;
      case 2: return bits == 4;
      case 3: return bits == 16 || bits == 32;
      default: return false;
    }
  }

  /// Palette entry i: blue, green, red. Entries that are not there are black.
  [[nodiscard]] Colour colour(std::uint32_t i) const {
    if (i >= header_.colours) return kBlack;
    const std::size_t at = std::size_t{14} + header_.info_size +
                           std::size_t{i} * (header_.is_core() ? 3 : 4);
    return make_colour(number(at + 2, 1) * 257, number(at + 1, 1) * 257,
                       number(at, 1) * 257);
  }

  [[nodiscard]] Result<RasterPage> read_packed() const {
    Result<Bitmap> ink = Bitmap::create(header_.width, header_.height);
    if (!ink) return ink.error();
    RasterPage page;
    page.ink = std::move(*ink);
    const Colour zero = colour(0);
    const Colour one = colour(1);
    const bool zero_is_ink = std::pair(weighted_luminance(zero), zero) <=
                             std::pair(weighted_luminance(one), one);
    keep_palette(zero_is_ink ? Palette{zero, one} : Palette{one, zero},
                 page.info.metadata);
    const auto used = (static_cast<std::size_t>(header_.width) + 7) / 8;
    const auto stride = static_cast<std::size_t>(header_.row_bytes());
    const std::int32_t last = page.ink.height() - 1;
    for (std::int32_t y = 0; y <= last; ++y) {
      const std::size_t at =
          header_.data + stride * static_cast<std::size_t>(y);
      page.ink.set_row_bytes(header_.top_down ? y : last - y,
                             std::span(bytes_).subspan(at, used), zero_is_ink);
    }
    return page;
  }

  SourceBytes bytes_;
  RasterReadOptions options_;
  BmpHeader header_;
};

}  // namespace

SourceResult open_bmp(SourceBytes bytes, const RasterReadOptions& options) {
  auto source = std::make_unique<BmpSource>(std::move(bytes), options);
  if (Status opened = source->open(); !opened) return opened.error();
  return std::unique_ptr<RasterSource>(std::move(source));
}

}  // namespace unstep
