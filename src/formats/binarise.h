#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "unstep/formats.h"

/// Grey pages to ink, and what is done to the pixels of pages on the way.
namespace unstep {

/// A page as luminances.
class GreyPage {
 public:
  /// limit_exceeded if the page, its bitmap and `other_bytes` together are
  /// above the memory limit.
  static Result<GreyPage> create(std::int32_t width, std::int32_t height,
                                 const DecodeLimits& limits,
                                 std::uint64_t other_bytes);

  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }
  /// REQUIRES: 0 <= y < height().
  [[nodiscard]] std::span<std::uint8_t> row(std::int32_t y) {
    const auto width = static_cast<std::size_t>(width_);
    return std::span(pixels_).subspan(width * static_cast<std::size_t>(y),
                                      width);
  }
  [[nodiscard]] std::span<std::uint8_t> pixels() { return pixels_; }

 private:
  std::int32_t width_ = 0;
  std::int32_t height_ = 0;
  std::vector<std::uint8_t> pixels_;
};

/// "luminance below 128 is ink", with the method if it was not given.
[[nodiscard]] std::string level_text(Threshold::Kind kind, int level);

/// Sets the bits whose luminance is below the level, clears the others.
void pack_below(std::span<const std::uint8_t> row, std::uint32_t level,
                std::span<std::uint64_t> words);

/// Turns the page straight and inverts it if that is wanted, and makes
/// page.ink of it; page.work says what was done. REQUIRES: threshold.kind is
/// not none.
Status binarise(GreyPage grey, const RasterReadOptions& options,
                std::uint64_t other_bytes, RasterPage& page);

/// Ink and paper change places.
void invert(Bitmap& ink);

/// Ink and paper change places if that is wanted. In a lossless page their
/// colours do too, so that nothing is lost.
void invert_ink(PixelWork::Invert wanted, RasterPage& page);

/// The rest of the work, on ink; all of it unless page.work says that the page
/// was thresholded. Writes what was done to notes and metadata.
Status finish_pixels(const RasterReadOptions& options, RasterPage& page);

}  // namespace unstep
