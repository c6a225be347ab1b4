#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "unstep/formats.h"

/// What the writer of one foreign raster format offers to RasterWriter.
namespace unstep {

class RasterSink {
 public:
  virtual ~RasterSink() = default;

  /// REQUIRES: ink is not empty. Appends to `notes` what cannot be carried.
  virtual Status add_page(const Bitmap& ink, const PageInfo& info,
                          std::vector<std::string>& notes) = 0;

  /// REQUIRES: a page was added.
  virtual Result<std::vector<std::uint8_t>> finish() = 0;
};

using SinkResult = Result<std::unique_ptr<RasterSink>>;

SinkResult create_pbm_sink();
SinkResult create_png_sink();
SinkResult create_tiff_sink();

}  // namespace unstep
