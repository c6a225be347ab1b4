#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "formats/colour_rows.h"
#include "formats/tiff_handle.h"
#include "unstep/result.h"

/// The pixels of the current directory of a TIFF file.
namespace unstep {

/// The tags that say how pixels are stored.
struct TiffShape {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t bits = 1;     ///< per sample
  std::uint16_t samples = 1;  ///< per pixel
  std::uint16_t planar = PLANARCONFIG_CONTIG;
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  bool has_photometric = false;
  std::uint16_t sample_format = SAMPLEFORMAT_UINT;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  bool tiled = false;
  std::uint32_t block_rows = 0;  ///< of a strip or tile

  explicit TiffShape(TIFF* tiff);
  [[nodiscard]] bool is_bilevel() const;
  /// True if TiffColours can unpack the samples itself.
  [[nodiscard]] bool is_plain() const;
};

/// The first thing that went wrong since the log was cleared, or success.
/// While pixels are decoded a warning is damage too (a code word that fits no
/// code, a fax line of the wrong length): libtiff would go on with guesses.
Status check_tiff_log(const TiffLog& log, bool pixels);

/// Packed rows as stored, from strips or tiles. Holds one row, or one row of
/// tiles.
class TiffRows {
 public:
  TiffRows(TIFF* tiff, const TiffShape& shape, const TiffLog& log)
      : tiff_(tiff), shape_(shape), log_(log) {}

  /// The bytes that the object will hold.
  [[nodiscard]] std::uint64_t memory() const;
  void start() { y_ = 0; }
  /// The next row. REQUIRES: rows are left.
  Result<std::span<const std::uint8_t>> next();

 private:
  Status read_tiles();

  TIFF* tiff_;
  TiffShape shape_;
  const TiffLog& log_;
  std::uint32_t y_ = 0;
  std::vector<std::uint8_t> rows_;  ///< one row or one row of tiles
  std::vector<std::uint8_t> tile_;
  std::size_t row_bytes_ = 0;
};

/// Rows of grey and colour pixels: unpacked here where that is simple, else by
/// libtiff to 8-bit RGBA (one strip or row of tiles at a time).
class TiffColours : public ColourRows {
 public:
  /// The bytes that the object will hold.
  [[nodiscard]] virtual std::uint64_t memory() const = 0;
  [[nodiscard]] virtual bool saw_alpha() const = 0;
};
std::unique_ptr<TiffColours> make_tiff_colours(TIFF* tiff,
                                               const TiffShape& shape,
                                               const TiffLog& log);

/// The colours of the samples 0 and 1 of a bilevel page.
std::pair<Colour, Colour> tiff_bilevel_colours(TIFF* tiff,
                                               const TiffShape& shape);

}  // namespace unstep
