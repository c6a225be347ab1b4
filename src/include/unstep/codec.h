#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// The .ustp file: pages of bilevel ink or of unit-step chains, stored
/// lossless. docs/format.md is the normative description.
///
///     UstpWriter writer({});
///     Status added = writer.add_page(bitmap, {});
///     Result<std::vector<std::uint8_t>> file = writer.finish();
///
///     Result<UstpReader> reader = UstpReader::open(*file, {});
///     Result<Page> page = reader->read_page(0);
namespace unstep {

/// Pixels (grid units) per unit of length, exactly as the source said it.
/// Unit none means that only the ratio x : y is known.
struct Resolution {
  enum class Unit : std::uint8_t {
    none = 0,
    inch = 1,
    centimetre = 2,
    metre = 3
  };
  Rational x;  ///< numerator 0: unknown
  Rational y;
  Unit unit = Unit::none;
  [[nodiscard]] bool known() const { return x.numerator != 0; }
  friend bool operator==(const Resolution&, const Resolution&) = default;
};

/// UTF-8 key and value; keys are unique within one list.
using Metadata = std::vector<std::pair<std::string, std::string>>;

struct PageInfo {
  std::string name;  ///< UTF-8, may be empty
  Resolution resolution;
  Metadata metadata;  ///< of this page ("tiff:Artist", ...)
  friend bool operator==(const PageInfo&, const PageInfo&) = default;
};

/// Hard limits of a decoder, checked before anything is allocated. Of a page
/// that is read in part, what is read counts.
struct DecodeLimits {
  std::uint64_t max_pixels = std::uint64_t{1} << 32;  ///< per page
  std::uint64_t max_steps = std::uint64_t{1} << 32;   ///< per page;
                                                      ///< elements of paths
  std::uint64_t max_memory = std::uint64_t{2} << 30;  ///< bytes, whole call
};

struct EncodeOptions {
  bool verify = true;  ///< decode every block and compare before success
  int bands = 0;       ///< per raster page; 0: one, more above 64 Mpx
  int jobs = 1;        ///< threads; the bytes never depend on it
  Metadata metadata;   ///< of the file
  Progress progress;
  /// Of ink pages. fast: a few direct models; max: more models and memory.
  Effort effort = Effort::standard;
};

struct DecodeOptions {
  DecodeLimits limits;
  int jobs = 1;
  Progress progress;
};

enum class PageKind : std::uint8_t {
  ink = 0,
  chains = 1,
  paths = 2,
  program = 3
};

/// How a page of paths stands to the chains that it was made from.
struct Fidelity {
  enum class Kind : std::uint8_t {
    exact = 0,      ///< the page is what was given
    tolerance = 1,  ///< within `tolerance` of the chains, Frechet distance
    device = 2,     ///< segments of DeviceReverse: drawn by Method::device they
                    ///< are within 1 unit per axis at the same step
  };
  Kind kind = Kind::exact;
  /// When kind == tolerance: grid units; of a program mm.
  Rational tolerance{0, 1};
  friend bool operator==(const Fidelity&, const Fidelity&) = default;
};

/// A part of the canvas, in grid units.
struct Box {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  friend bool operator==(const Box&, const Box&) = default;
};

/// What the file says of a page, known without decoding its payload.
struct PageEntry {
  PageKind kind = PageKind::ink;
  Canvas canvas;              ///< pixels of an ink page
  Fidelity fidelity;          ///< paths and programs
  std::int32_t scale = 1;     ///< paths: Drawing::scale
  Paint paint = Paint::fill;  ///< paths: Drawing::paint
  PageInfo info;
  std::uint32_t checksum = 0;  ///< CRC-32 of the decoded page (format.md)
  struct Block {
    std::uint64_t offset = 0;    ///< of the payload, from the file's start
    std::uint64_t bytes = 0;     ///< of the payload
    std::int32_t first_row = 0;  ///< ink: the band's rows
    std::int32_t rows = 0;
    std::uint64_t chains = 0;      ///< chains: how many
    std::uint64_t steps = 0;       ///< chains
    std::uint64_t paths = 0;       ///< paths: how many
    std::uint64_t elements = 0;    ///< paths: segments and arcs
    std::uint64_t lines = 0;       ///< program: of its text
    std::uint64_t text_bytes = 0;  ///< program
    Box box;                       ///< what it draws lies inside
    std::uint8_t coder = 0;        ///< coder id, format.md
    std::uint8_t revision = 0;     ///< model revision
    std::uint8_t table = 0;        ///< warm-start table, 0 = none
  };
  std::vector<Block> blocks;
};

struct FileInfo {
  enum class Form : std::uint8_t { short_form, block_form };
  Form form = Form::short_form;
  std::uint8_t version = 0;  ///< 0: pre-release format
  Metadata metadata;
  std::vector<PageEntry> pages;
};

/// A decoded page: `ink` for PageKind::ink, `drawing.chains` for
/// PageKind::chains, `drawing.paths` for PageKind::paths, `program` for
/// PageKind::program.
struct Page {
  PageKind kind = PageKind::ink;
  PageInfo info;
  Fidelity fidelity;
  Bitmap ink;
  Drawing drawing;
  std::string program;  ///< text of G-code, each line with its end
};

/// Collects pages and makes the file. After a failed call only destruction is
/// allowed. Not for use from two threads at once; several writers are.
class UstpWriter {
 public:
  explicit UstpWriter(EncodeOptions options);
  ~UstpWriter();
  UstpWriter(UstpWriter&&) noexcept;
  UstpWriter& operator=(UstpWriter&&) noexcept;

  /// Encodes a raster page (and proves it, if options.verify).
  /// internal if the proof failed: the file must not be used.
  Status add_page(const Bitmap& ink, const PageInfo& info);

  /// Encodes the chains of a drawing, step for step, or its paths, element
  /// for element, in their order; `fidelity` is kept with paths.
  /// invalid_argument if the drawing has both or an invalid one.
  Status add_page(const Drawing& drawing, const PageInfo& info,
                  const Fidelity& fidelity = {});

  /// Encodes the text of a program of a machine; it is stored best in the form
  /// that write_gcode (program.h) gives it. The tolerance of `fidelity` is in
  /// mm. invalid_argument if its last line has no end or it has a resolution.
  Status add_program(std::string_view text, const PageInfo& info,
                     const Fidelity& fidelity = {});

  /// The whole file. invalid_argument if there is no page.
  Result<std::vector<std::uint8_t>> finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads a file held in memory. Nothing of the bytes is trusted.
class UstpReader {
 public:
  /// Parses structure and checks block CRCs; decodes no payload. `file` must
  /// outlive the reader.
  static Result<UstpReader> open(std::span<const std::uint8_t> file,
                                 DecodeOptions options);
  ~UstpReader();
  UstpReader(UstpReader&&) noexcept;
  UstpReader& operator=(UstpReader&&) noexcept;

  [[nodiscard]] const FileInfo& info() const;

  /// Decodes a page and checks it against its checksum. out_of_range if there
  /// is no such page. The reader stays usable after a failure.
  Result<Page> read_page(std::size_t index) const;

  /// Decodes only the blocks whose boxes meet `box`, each against its own
  /// checksum, and gives what lies in them: ink as the box itself cut out of
  /// the page (`box` clipped to the page, then its upper left corner is pixel
  /// (0, 0)), chains and paths whole, unclipped, where their blocks have them.
  /// out_of_range if there is no such page or the box misses an ink page.
  Result<Page> read_page(std::size_t index, const Box& box) const;

 private:
  struct Impl;
  explicit UstpReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace unstep
