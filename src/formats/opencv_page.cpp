#include "formats/opencv_page.h"

#include <utility>

#include "formats/opencv_loader.h"
#include "formats/page_limits.h"

namespace unstep {

Result<RasterPage> read_opencv_page(std::span<const std::uint8_t> bytes,
                                    std::uint64_t width, std::uint64_t height,
                                    const RasterReadOptions& options) {
  // Sides first, so that the product below cannot overflow. OpenCV holds the
  // pixels twice while it turns them.
  Status fits = check_page(options.limits, width, height, 0);
  if (fits) {
    fits =
        check_page(options.limits, width, height,
                   bytes.size() + width * height * 6 + width * sizeof(Colour));
  }
  if (!fits) return fits.error();
  Result<OpencvImage> image = OpencvImage::decode(bytes);
  if (!image) return image.error();
  const auto claimed = static_cast<std::uint64_t>(image->width()) *
                       static_cast<std::uint64_t>(image->height());
  if (claimed != width * height) {
    return Error{ErrorCode::corrupt, "the header's size is not the image's"};
  }
  RasterPage page;
  if (Status read =
          read_colours(*image, image->width(), image->height(), options,
                       bytes.size() + width * height * 6, page);
      !read) {
    return read.error();
  }
  return page;
}

}  // namespace unstep
