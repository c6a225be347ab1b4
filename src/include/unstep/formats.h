#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// Foreign files: raster images and Freeman chain text.
namespace unstep {

/// How grey and colour pixels become ink. Two-valued files never need it.
struct Threshold {
  enum class Kind : std::uint8_t {
    none,
    fixed,     ///< luminance < level is ink
    otsu,      ///< one level for the page, by Otsu's method
    sauvola,   ///< Sauvola's, of the mean and deviation around
    local,     ///< between the ink and the paper around (docs/rasters.md)
    automatic  ///< local; otsu where a page has too little contrast for it
  };
  Kind kind = Kind::none;
  int level = 128;  ///< fixed: 1..255
};

/// What else is done to the pixels of a page, bilevel ones too, in this order.
struct PixelWork {
  enum class Invert : std::uint8_t { no, yes, automatic };
  Invert invert = Invert::no;    ///< automatic: if more is dark than light
  bool deskew = false;           ///< turns the page straight, within 10 degrees
  std::uint64_t despeckle = 0;   ///< removes 8-connected ink of so many pixels
                                 ///< or fewer
  std::uint64_t fill_holes = 0;  ///< fills 4-connected paper of so many or
                                 ///< fewer that ink encloses
};

struct RasterReadOptions {
  Threshold threshold;
  DecodeLimits limits;
  PixelWork work;
};

/// One page of a raster file, as ink.
struct RasterPage {
  Bitmap ink;
  PageInfo info;
  bool lossless = true;  ///< false: pixels were thresholded or changed
  /// What was done to the pixels, in order: "inverted", ... All together are
  /// in the page's metadata as unstep:pixels and in a note.
  std::vector<std::string> work;
  /// One line each: what of the source is not kept, what was decided.
  std::vector<std::string> notes;
};

/// Reads PBM/PGM, PNG, TIFF, BMP and JPEG from memory, and the page images of
/// a PDF through poppler's program pdfimages. Bilevel data stays packed. Only
/// BMP above 1 bit, local thresholds and PixelWork load OpenCV.
///
///     Result<RasterReader> file = RasterReader::open(std::move(bytes), {});
///     for (std::size_t i = 0; i < file->page_count(); ++i) file->read(i);
class RasterReader {
 public:
  /// Recognises the format by content. bad_magic if none fits.
  static Result<RasterReader> open(std::vector<std::uint8_t> bytes,
                                   RasterReadOptions options);
  ~RasterReader();
  RasterReader(RasterReader&&) noexcept;
  RasterReader& operator=(RasterReader&&) noexcept;

  [[nodiscard]] std::size_t page_count() const;
  [[nodiscard]] std::string_view format() const;  ///< "pbm", "png", ...

  /// invalid_argument, naming --threshold, if the page has more than two
  /// values and no threshold was given.
  Result<RasterPage> read(std::size_t page);

 private:
  struct Impl;
  explicit RasterReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

enum class RasterFormat : std::uint8_t { pbm, png, tiff };

/// Writes pages to one raster file in memory. PBM (P4, several pages are
/// concatenated as netpbm allows), PNG (1 bit, one page), TIFF (G4, several).
class RasterWriter {
 public:
  static Result<RasterWriter> create(RasterFormat format);
  ~RasterWriter();
  RasterWriter(RasterWriter&&) noexcept;
  RasterWriter& operator=(RasterWriter&&) noexcept;

  /// Adds notes (what the format cannot carry) to `notes` if not null.
  /// invalid_argument for a second PNG page.
  Status add_page(const Bitmap& ink, const PageInfo& info,
                  std::vector<std::string>* notes);
  Result<std::vector<std::uint8_t>> finish();

 private:
  struct Impl;
  explicit RasterWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A page of a vector file, or what is written to one.
struct VectorPage {
  Drawing drawing;  ///< chains or paths
  PageInfo info;
  /// One line each: what of the source is not kept, what was decided.
  std::vector<std::string> notes;
};

enum class VectorFormat : std::uint8_t { svg, dxf, hpgl, pdf, json, freeman };

struct VectorReadOptions {
  /// Curves become lines that are never farther than this from them, in units
  /// of the file. 0: a thousandth of the larger side of the drawing's box.
  double curve_tolerance = 0;
  DecodeLimits limits;
};

/// Reads SVG, DXF (ASCII), HPGL, unstep's JSON or Freeman text from memory.
/// Vertices stay what they are in the file: Drawing::scale is the power of ten
/// (of two for binary fractions) that holds them, rounded where it must be,
/// and a note says so. bad_magic if the bytes are not of the format; otherwise
/// errors name the place.
Result<std::vector<VectorPage>> read_vector(std::string_view bytes,
                                            VectorFormat format,
                                            const VectorReadOptions& options);

/// Which vector format these bytes are, by content; nothing if none.
[[nodiscard]] std::optional<VectorFormat> recognise_vector(
    std::string_view bytes);

/// Takes the bytes of a file as they are made, in order.
using ByteSink = std::function<Status(std::string_view bytes)>;

/// Writes vector files path by path, in memory that does not grow with their
/// number (but for PDF's table of pages).
///
///     Result<VectorWriter> svg = VectorWriter::create(VectorFormat::svg,
///     sink); svg->begin_page(canvas, scale, paint, info); for (const Path&
///     path : paths) svg->add(path); svg->end_page(); svg->finish();
class VectorWriter {
 public:
  static Result<VectorWriter> create(VectorFormat format, ByteSink sink);
  ~VectorWriter();
  VectorWriter(VectorWriter&&) noexcept;
  VectorWriter& operator=(VectorWriter&&) noexcept;

  /// invalid_argument for a second page where the format has but one.
  Status begin_page(const Canvas& canvas, std::int32_t scale, Paint paint,
                    const PageInfo& info);
  Status add(const Path& path);
  Status add(const Chain& chain);
  Status end_page();
  Status finish();

  /// begin_page, all chains and paths, end_page.
  Status add_page(const Drawing& drawing, const PageInfo& info);

  /// What the format could not carry so far, one line each.
  [[nodiscard]] const std::vector<std::string>& notes() const;

 private:
  struct Impl;
  explicit VectorWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Recordings of encoders: two channels in quadrature each.
enum class PulseFormat : std::uint8_t {
  csv,     ///< a column a channel, a row a sample
  vcd,     ///< value change dump (IEEE 1364)
  sigrok,  ///< session of sigrok, .sr
  raw2,    ///< 2 bits a sample, 4 a byte, the first in the high bits: A, B
  raw4     ///< 4 bits a sample: A and B of x, A and B of y
};

struct PulseReadOptions {
  /// Channels A and B of x, then of y if there are two encoders: names, or
  /// numbers of columns from 1. Empty: a and b, or xa, xb, ya and yb (any case,
  /// also x_a or x.a), else the only two or four channels there are.
  std::vector<std::string> channels;
  int counts = 4;  ///< of a cycle of both channels: 1, 2 or 4
  /// CSV with analogue values: below `low` is 0, above `high` is 1, between
  /// them is what was before. low < high, or both 0: values are 0 and 1.
  double low = 0;
  double high = 0;
  DecodeLimits limits;  ///< max_steps counts samples too
};

/// One chain from (0, 0), y up: each count of an encoder is a unit step along
/// its axis, counts of the same time are one diagonal step. A before B counts
/// up. Where both channels of an encoder change at once no count is made; notes
/// say how often, and when first. page.info.metadata has what was counted as
/// unstep:pulses. invalid_argument if channels cannot be found.
Result<VectorPage> read_pulses(std::span<const std::uint8_t> bytes,
                               PulseFormat format,
                               const PulseReadOptions& options);

/// VCD or sigrok, by content. CSV and raw streams look like anything.
[[nodiscard]] std::optional<PulseFormat> recognise_pulses(
    std::span<const std::uint8_t> bytes);

/// Freeman chain text (docs/freeman.md): many chains, 4- or 8-connected, open
/// or closed, comments. Errors name line and column.
Result<Drawing> parse_freeman(std::string_view text,
                              const DecodeLimits& limits);
std::string write_freeman(const Drawing& drawing);

/// Whole files. "-" is stdin or stdout. Errors are io_error (with the system's
/// reason), limit_exceeded or output_exists; messages do not repeat the path.
Result<std::vector<std::uint8_t>> read_file(const std::string& path,
                                            std::uint64_t max_bytes);

/// A file written piece by piece under a temporary name in the same folder;
/// commit() syncs it and gives it its own. Destroyed before, it leaves nothing
/// behind. Pipes and other special files are written as the bytes come.
///
///     Result<FileWriter> file = FileWriter::create("a.svg", false);
///     if (file && file->write(bytes)) file->commit();
class FileWriter {
 public:
  /// output_exists for an existing path unless `overwrite`.
  static Result<FileWriter> create(const std::string& path, bool overwrite);
  ~FileWriter();
  FileWriter(FileWriter&&) noexcept;
  FileWriter& operator=(FileWriter&&) noexcept;

  /// After a failure only destruction is allowed.
  Status write(std::span<const std::uint8_t> bytes);
  Status commit();

 private:
  struct Impl;
  explicit FileWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The whole of a file at once, as FileWriter writes it.
Status write_file(const std::string& path, std::span<const std::uint8_t> bytes,
                  bool overwrite);

}  // namespace unstep
