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
  enum class Kind : std::uint8_t { none, fixed, otsu };
  Kind kind = Kind::none;
  int level = 128;  ///< fixed: luminance < level is ink, 1..255
};

struct RasterReadOptions {
  Threshold threshold;
  DecodeLimits limits;
};

/// One page of a raster file, as ink.
struct RasterPage {
  Bitmap ink;
  PageInfo info;
  bool lossless = true;  ///< false: grey or colour pixels were thresholded
  /// One line each: what of the source is not kept, what was decided.
  std::vector<std::string> notes;
};

/// Reads PBM/PGM, PNG, TIFF, BMP and JPEG from memory. Bilevel data stays
/// packed. PBM, PGM, PNG and TIFF never load the OpenCV module.
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
