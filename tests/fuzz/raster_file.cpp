#include <utility>
#include <vector>

#include "fuzz/target.h"
#include "unstep/formats.h"

/// Any bytes as a raster file, greys cut by a level: an error of one line, or
/// pages within the limits. PDF is left to other programs and to its tests.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace unstep;
  constexpr std::string_view kPdf = "%PDF";
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (text.starts_with(kPdf)) return 0;
  RasterReadOptions options;
  options.limits = fuzz::limits();
  options.threshold = {Threshold::Kind::otsu, 128};
  options.work.invert = PixelWork::Invert::automatic;
  Result<RasterReader> file =
      RasterReader::open(std::vector<std::uint8_t>(data, data + size), options);
  if (!file) {
    fuzz::require_sound(file.error());
    return 0;
  }
  for (std::size_t i = 0; i < file->page_count() && i < 4; ++i) {
    const Result<RasterPage> page = file->read(i);
    if (!page) {
      fuzz::require_sound(page.error());
      continue;
    }
    fuzz::require(page->ink.pixels() <= options.limits.max_pixels, "limit");
    for (const std::string& note : page->notes) {
      fuzz::require(note.find('\n') == std::string::npos, "note of lines");
    }
  }
  return 0;
}
