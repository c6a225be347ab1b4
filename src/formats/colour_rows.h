#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "formats/colour.h"
#include "unstep/formats.h"

/// Grey and colour pixels to ink, one row in memory at a time.
namespace unstep {

/// The rows of one image, first row first, as often as wanted.
class ColourRows {
 public:
  virtual ~ColourRows() = default;
  /// Goes (back) to the first row.
  virtual Status start() = 0;
  /// REQUIRES: start() was called, rows are left, row.size() is the width.
  virtual Status next(std::span<Colour> row) = 0;
  /// The same row as luminances, 0..255. Rows of one image are taken in one of
  /// the two ways between start() and start().
  virtual Status next_luminance(std::span<std::uint8_t> row);

 private:
  std::vector<Colour> colours_;  ///< a row, if luminances come from colours
};

/// Fills page.ink from the rows. At most two values: the darker one is ink,
/// page.lossless stays true and the colours go to the metadata. More: the
/// threshold decides, page.lossless is false and page.work says how;
/// invalid_argument if there is none. A single value is ink if its luminance
/// is below 128. The limits of the bitmap were checked by the caller, who also
/// holds `other_bytes`.
Status read_colours(ColourRows& rows, std::int32_t width, std::int32_t height,
                    const RasterReadOptions& options, std::uint64_t other_bytes,
                    RasterPage& page);

}  // namespace unstep
