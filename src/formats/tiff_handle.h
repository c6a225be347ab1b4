#pragma once

#include <tiffio.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// libtiff on memory, with its messages kept per handle.
namespace unstep {

/// What libtiff said. Fixed arrays: its callbacks must not throw.
struct TiffLog {
  using Line = std::array<char, 200>;
  Line error{};  ///< the first one
  std::array<Line, 8> warnings{};
  std::size_t warning_count = 0;  ///< may be more than are kept
  [[nodiscard]] bool has_error() const { return error[0] != '\0'; }
  void clear() { *this = TiffLog{}; }
};

struct TiffInput {
  std::span<const std::uint8_t> bytes;
  std::uint64_t position = 0;
};

struct TiffOutput {
  std::vector<std::uint8_t> bytes;
  std::uint64_t position = 0;
};

struct TiffCloser {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffHandle = std::unique_ptr<TIFF, TiffCloser>;

/// Null, with the reason in `log`, if libtiff refuses. `input`, `output` and
/// `log` must outlive the handle. No single allocation of libtiff is above
/// `max_bytes`.
TiffHandle open_tiff_input(TiffInput& input, TiffLog& log,
                           std::uint64_t max_bytes);
TiffHandle open_tiff_output(TiffOutput& output, TiffLog& log);

/// A tag that is text, and its metadata key.
struct TiffTextTag {
  std::uint32_t tag;
  std::string_view key;
};
inline constexpr std::array kTiffTextTags{
    TiffTextTag{TIFFTAG_DOCUMENTNAME, "tiff:DocumentName"},
    TiffTextTag{TIFFTAG_IMAGEDESCRIPTION, "tiff:ImageDescription"},
    TiffTextTag{TIFFTAG_MAKE, "tiff:Make"},
    TiffTextTag{TIFFTAG_MODEL, "tiff:Model"},
    TiffTextTag{TIFFTAG_SOFTWARE, "tiff:Software"},
    TiffTextTag{TIFFTAG_DATETIME, "tiff:DateTime"},
    TiffTextTag{TIFFTAG_ARTIST, "tiff:Artist"},
    TiffTextTag{TIFFTAG_HOSTCOMPUTER, "tiff:HostComputer"},
    TiffTextTag{TIFFTAG_TARGETPRINTER, "tiff:TargetPrinter"},
    TiffTextTag{TIFFTAG_COPYRIGHT, "tiff:Copyright"},
};

}  // namespace unstep
