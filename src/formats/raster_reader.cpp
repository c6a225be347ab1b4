#include <algorithm>
#include <array>
#include <new>
#include <string>
#include <utility>

#include "formats/binarise.h"
#include "formats/raster_source.h"

namespace unstep {
namespace {

bool starts_with(std::span<const std::uint8_t> bytes, std::string_view magic) {
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](char a, std::uint8_t b) {
                      return static_cast<std::uint8_t>(a) == b;
                    });
}

struct Format {
  std::string_view magic;
  std::string_view name;
  SourceResult (*open)(SourceBytes, const RasterReadOptions&);
};

using namespace std::string_view_literals;
constexpr std::array kFormats{
    Format{"P1"sv, "pbm"sv, open_pbm},
    Format{"P4"sv, "pbm"sv, open_pbm},
    Format{"P2"sv, "pgm"sv, open_pbm},
    Format{"P5"sv, "pgm"sv, open_pbm},
    Format{"P3"sv, "ppm"sv, open_pbm},
    Format{"P6"sv, "ppm"sv, open_pbm},
    Format{"P7"sv, "pam"sv, open_pbm},
    Format{"\x89PNG\r\n\x1a\n"sv, "png"sv, open_png},
    Format{"II*\0"sv, "tiff"sv, open_tiff},
    Format{"MM\0*"sv, "tiff"sv, open_tiff},
    Format{"II+\0"sv, "tiff"sv, open_tiff},  // BigTIFF
    Format{"MM\0+"sv, "tiff"sv, open_tiff},
    Format{"BM"sv, "bmp"sv, open_bmp},
    Format{"\xff\xd8\xff"sv, "jpeg"sv, open_jpeg},
    Format{"%PDF-"sv, "pdf"sv, open_pdf},
};

Error no_memory() {
  return {ErrorCode::limit_exceeded, "no memory for the image"};
}

}  // namespace

struct RasterReader::Impl {
  std::unique_ptr<RasterSource> source;
  std::string_view format;
  RasterReadOptions options;
};

RasterReader::RasterReader(std::unique_ptr<Impl> impl)
    : impl_(std::move(impl)) {}
RasterReader::~RasterReader() = default;
RasterReader::RasterReader(RasterReader&&) noexcept = default;
RasterReader& RasterReader::operator=(RasterReader&&) noexcept = default;

Result<RasterReader> RasterReader::open(std::vector<std::uint8_t> bytes,
                                        RasterReadOptions options) {
  const Threshold& threshold = options.threshold;
  if (threshold.kind == Threshold::Kind::fixed &&
      (threshold.level < 1 || threshold.level > 255)) {
    return Error{
        ErrorCode::out_of_range,
        "threshold " + std::to_string(threshold.level) + "; it is 1 to 255"};
  }
  try {
    std::string_view format;
    SourceResult source = open_raster_source(std::move(bytes), options, format);
    if (!source) return source.error();
    return RasterReader(
        std::make_unique<Impl>(Impl{*std::move(source), format, options}));
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
}

SourceResult open_raster_source(SourceBytes bytes,
                                const RasterReadOptions& options,
                                std::string_view& format) {
  for (const Format& known : kFormats) {
    if (!starts_with(bytes, known.magic)) continue;
    format = known.name;
    return known.open(std::move(bytes), options);
  }
  return Error{ErrorCode::bad_magic,
               "not a PBM, PGM, PNG, TIFF, BMP, JPEG or PDF file"};
}

std::size_t RasterReader::page_count() const {
  return impl_->source->page_count();
}

std::string_view RasterReader::format() const { return impl_->format; }

Result<RasterPage> RasterReader::read(std::size_t page) {
  if (page >= page_count()) {
    return Error{ErrorCode::out_of_range,
                 "no page " + std::to_string(page + 1) + "; the file has " +
                     std::to_string(page_count())};
  }
  try {
    Result<RasterPage> read = impl_->source->read(page);
    if (read) {
      const Status finished = finish_pixels(impl_->options, *read);
      if (finished) return read;
      read = finished.error();
    }
    Error error = read.error();
    error.message = "page " + std::to_string(page + 1) + ": " + error.message;
    return error;
  } catch (const std::bad_alloc&) {
    return no_memory();
  }
}

}  // namespace unstep
