#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

/// What poppler's pdfimages and pdfinfo say of a PDF file.
namespace unstep {

/// A line of `pdfimages -list`.
struct ListedImage {
  std::size_t page = 0;
  std::size_t in_page = 0;  ///< how many are before it on its page
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::uint64_t components = 1;
  std::uint32_t x_per_inch = 0;
  std::uint32_t y_per_inch = 0;
  bool is_mask = false;     ///< transparency of another image
  bool is_stencil = false;  ///< one bit: paint or not
  [[nodiscard]] std::uint64_t pixels() const { return width * height; }
};

/// What pdfinfo says of a page.
struct PageBox {
  double width = 0;  ///< points of 1/72 inch, before the rotation
  double height = 0;
  int rotation = 0;  ///< clockwise, degrees
};

/// A page that is read.
struct PdfPage {
  std::size_t number = 0;       ///< in the PDF, from 1
  ListedImage image;            ///< the largest
  std::size_t images = 0;       ///< masks not counted
  std::uint64_t all_bytes = 0;  ///< of the samples of all its images
  PageBox box;
};

struct PdfListing {
  std::size_t count = 0;       ///< pages of the PDF
  std::vector<PdfPage> pages;  ///< those with an image, in order
};

/// From what `pdfimages -list` and `pdfinfo -f 1 -l LAST` print. Lines that are
/// not understood are passed over.
[[nodiscard]] PdfListing list_pages(std::string_view images,
                                    std::string_view info);

}  // namespace unstep
