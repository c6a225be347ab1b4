#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "formats/colour.h"
#include "formats/raster_sink.h"
#include "formats/resolution.h"
#include "formats/tiff_handle.h"
#include "formats/tiff_layout.h"
#include "formats/tiff_photometric.h"

namespace unstep {
namespace {

/// TIFF has no metre.
Resolution in_tiff_units(const Resolution& resolution,
                         std::vector<std::string>& notes) {
  if (resolution.unit != Resolution::Unit::metre) return resolution;
  const RoundedRational x = scale(resolution.x, 1, 100);
  const RoundedRational y = scale(resolution.y, 1, 100);
  const Resolution result{x.value, y.value, Resolution::Unit::centimetre};
  if (!x.exact || !y.exact) {
    notes.push_back("TIFF rounds the resolution " + to_string(resolution) +
                    " to " + to_string(result));
  }
  return result;
}

/// Multi-page TIFF, G4, one strip a page, 0 is white.
class TiffSink final : public RasterSink {
 public:
  Status open() {
    tiff_ = open_tiff_output(output_, log_);
    return tiff_ != nullptr ? Status{} : Status(failure());
  }

  Status add_page(const Bitmap& ink, const PageInfo& info,
                  std::vector<std::string>& notes) override {
    set_shape(ink);
    const bool zero_is_black = set_colours(info);
    Resolution resolution;
    if (info.resolution.known()) {
      if (is_usable(info.resolution)) {
        resolution = in_tiff_units(info.resolution, notes);
        set_resolution(resolution);
      } else {
        notes.push_back("TIFF cannot carry the resolution " +
                        to_string(info.resolution));
      }
    }
    set_text(info, notes);
    if (log_.has_error()) return failure();
    std::vector<std::uint8_t> row((static_cast<std::size_t>(ink.width()) + 7) /
                                  8);
    for (std::int32_t y = 0; y < ink.height(); ++y) {
      ink.get_row_bytes(y, row, zero_is_black);
      if (TIFFWriteScanline(tiff_.get(), row.data(),
                            static_cast<std::uint32_t>(y), 0) != 1) {
        return failure();
      }
    }
    if (TIFFWriteDirectory(tiff_.get()) != 1 || log_.has_error()) {
      return failure();
    }
    resolutions_.push_back(resolution);
    return {};
  }

  Result<std::vector<std::uint8_t>> finish() override {
    tiff_.reset();
    if (log_.has_error()) return failure();
    if (Status patched = patch(); !patched) return patched.error();
    return std::move(output_.bytes);
  }

 private:
  [[nodiscard]] Error failure() const {
    return {ErrorCode::limit_exceeded,
            std::string("libtiff: ") +
                (log_.has_error() ? log_.error.data() : "cannot write")};
  }

  void set_shape(const Bitmap& ink) {
    TIFF* tiff = tiff_.get();
    const auto height = static_cast<std::uint32_t>(ink.height());
    TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_PAGE);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH,
                 static_cast<std::uint32_t>(ink.width()));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_CCITTFAX4);
    TIFFSetField(tiff, TIFFTAG_FILLORDER, FILLORDER_MSB2LSB);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, height);
    TIFFSetField(tiff, TIFFTAG_PAGENUMBER,
                 static_cast<int>(resolutions_.size() & 0xffff), 0);
  }

  /// True if ink is to be written as 0.
  bool set_colours(const PageInfo& info) {
    const auto palette = find_palette(info.metadata);
    if (!palette) {
      const bool zero_is_black = std::any_of(
          info.metadata.begin(), info.metadata.end(), [](const auto& pair) {
            return pair.first == kPhotometricKey && pair.second == kZeroIsBlack;
          });
      TIFFSetField(
          tiff_.get(), TIFFTAG_PHOTOMETRIC,
          zero_is_black ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_MINISWHITE);
      return zero_is_black;
    }
    // Sample 0 stays the paper, whose runs G4 codes best.
    const auto both = [&palette](std::uint32_t (*sample)(Colour)) {
      return std::array{static_cast<std::uint16_t>(sample(palette->paper)),
                        static_cast<std::uint16_t>(sample(palette->ink))};
    };
    const auto red = both(red_of);
    const auto green = both(green_of);
    const auto blue = both(blue_of);
    TIFFSetField(tiff_.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_PALETTE);
    TIFFSetField(tiff_.get(), TIFFTAG_COLORMAP, red.data(), green.data(),
                 blue.data());
    return false;
  }

  /// libtiff takes floats; finish() puts the exact rationals in their place.
  void set_resolution(const Resolution& resolution) {
    const auto value = [](const Rational& r) {
      return static_cast<double>(r.numerator) / r.denominator;
    };
    TIFFSetField(tiff_.get(), TIFFTAG_XRESOLUTION, value(resolution.x));
    TIFFSetField(tiff_.get(), TIFFTAG_YRESOLUTION, value(resolution.y));
    const int unit = resolution.unit == Resolution::Unit::none ? RESUNIT_NONE
                     : resolution.unit == Resolution::Unit::inch
                         ? RESUNIT_INCH
                         : RESUNIT_CENTIMETER;
    TIFFSetField(tiff_.get(), TIFFTAG_RESOLUTIONUNIT, unit);
  }

  void set_text(const PageInfo& info, std::vector<std::string>& notes) {
    const auto set = [&](std::uint32_t tag, const std::string& key,
                         const std::string& text) {
      if (text.find('\0') != std::string::npos) {
        notes.push_back("TIFF cannot carry the metadata " + key);
        return;
      }
      TIFFSetField(tiff_.get(), tag, text.c_str());
    };
    if (!info.name.empty()) set(TIFFTAG_PAGENAME, "page name", info.name);
    for (const auto& [key, text] : info.metadata) {
      if (key == kPaletteKey || key == kPhotometricKey) continue;
      const auto known = std::find_if(
          kTiffTextTags.begin(), kTiffTextTags.end(),
          [&key = key](const TiffTextTag& t) { return t.key == key; });
      if (known == kTiffTextTags.end()) {
        notes.push_back("TIFF cannot carry the metadata " + key);
      } else {
        set(known->tag, key, text);
      }
    }
  }

  /// Exact resolutions, and the number of pages, which the first one cannot
  /// know when it is written.
  Status patch() {
    const auto layout = TiffLayout::parse(output_.bytes);
    std::uint64_t directory = layout ? layout->first_directory() : 0;
    const auto pages = static_cast<std::uint16_t>(
        std::min<std::size_t>(resolutions_.size(), 65535));
    for (const Resolution& resolution : resolutions_) {
      if (directory == 0) {
        return Error{ErrorCode::internal, "libtiff lost a page"};
      }
      const auto number = layout->find(directory, TIFFTAG_PAGENUMBER);
      if (number && number->type == TiffLayout::kShort && number->count == 2) {
        layout->put_second_short(output_.bytes, *number, pages);
      }
      if (resolution.known()) {
        for (const auto& [tag, value] :
             {std::pair{TIFFTAG_XRESOLUTION, resolution.x},
              std::pair{TIFFTAG_YRESOLUTION, resolution.y}}) {
          const auto entry =
              layout->find(directory, static_cast<std::uint16_t>(tag));
          if (!entry || entry->type != TiffLayout::kRational) {
            return Error{ErrorCode::internal, "libtiff lost a resolution"};
          }
          layout->put_rational(output_.bytes, *entry, value);
        }
      }
      directory = layout->next_directory(directory);
    }
    return {};
  }

  TiffOutput output_;
  TiffLog log_;
  std::vector<Resolution> resolutions_;
  TiffHandle tiff_;  // last: closing it writes to the others
};

}  // namespace

SinkResult create_tiff_sink() {
  auto sink = std::make_unique<TiffSink>();
  if (Status opened = sink->open(); !opened) return opened.error();
  return std::unique_ptr<RasterSink>(std::move(sink));
}

}  // namespace unstep
