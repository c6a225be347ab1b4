#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "unstep/formats.h"

/// What the reader of one foreign raster format offers to RasterReader, and
/// the readers there are. Each is made from the bytes of a file whose format
/// was recognised; all trust nothing else of them.
namespace unstep {

class RasterSource {
 public:
  virtual ~RasterSource() = default;
  [[nodiscard]] virtual std::size_t page_count() const = 0;

  /// REQUIRES: page < page_count(). Messages do not name the page; the caller
  /// does. May throw std::bad_alloc. Usable again after a failure.
  virtual Result<RasterPage> read(std::size_t page) = 0;
};

using SourceBytes = std::vector<std::uint8_t>;
using SourceResult = Result<std::unique_ptr<RasterSource>>;

SourceResult open_pbm(SourceBytes bytes, const RasterReadOptions& options);
SourceResult open_png(SourceBytes bytes, const RasterReadOptions& options);
SourceResult open_tiff(SourceBytes bytes, const RasterReadOptions& options);
SourceResult open_bmp(SourceBytes bytes, const RasterReadOptions& options);
SourceResult open_jpeg(SourceBytes bytes, const RasterReadOptions& options);
SourceResult open_pdf(SourceBytes bytes, const RasterReadOptions& options);

/// The reader for the bytes, by their content, and the name of the format. May
/// throw std::bad_alloc.
SourceResult open_raster_source(SourceBytes bytes,
                                const RasterReadOptions& options,
                                std::string_view& format);

}  // namespace unstep
