#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "formats/binarise.h"
#include "formats/external_program.h"
#include "formats/orientation.h"
#include "formats/page_limits.h"
#include "formats/pdf_listing.h"
#include "formats/raster_source.h"
#include "formats/resolution.h"

/// Scanned PDF files: the image of each page, taken out by poppler's program
/// pdfimages; size and rotation of pages from its pdfinfo. Poppler is GPL and
/// therefore not linked.
namespace unstep {
namespace {

constexpr const char* kPackage = " (Debian: poppler-utils)";

class PdfSource final : public RasterSource {
 public:
  PdfSource(SourceBytes bytes, const RasterReadOptions& options,
            TemporaryFolder folder)
      : bytes_(std::move(bytes)),
        options_(options),
        folder_(std::move(folder)) {}

  Status open() {
    const std::string pdf = path("in.pdf");
    std::FILE* file = std::fopen(pdf.c_str(), "wb");
    if (file == nullptr) {
      return Error{ErrorCode::io_error, "cannot write to " + pdf};
    }
    const bool written =
        std::fwrite(bytes_.data(), 1, bytes_.size(), file) == bytes_.size();
    if (std::fclose(file) != 0 || !written) {
      return Error{ErrorCode::io_error, "cannot write to " + pdf};
    }
    const Result<std::string> list = run({"pdfimages", "-list", pdf});
    if (!list) return list.error();
    const Result<std::string> info =
        run({"pdfinfo", "-f", "1", "-l", "999999999", pdf});
    if (!info) return info.error();
    PdfListing listing = list_pages(*list, *info);
    count_ = listing.count;
    pages_ = std::move(listing.pages);
    if (!pages_.empty()) return {};
    return Error{ErrorCode::unsupported,
                 "no page of this PDF is an image; lines and text of a PDF are "
                 "not read (pdftocairo -svg makes an SVG of them)"};
  }

  [[nodiscard]] std::size_t page_count() const override {
    return pages_.size();
  }

  Result<RasterPage> read(std::size_t index) override {
    const PdfPage& page = pages_[index];
    Result<SourceBytes> image = extract(page);
    if (!image) return image.error();
    std::string_view format;
    const SourceResult source =
        open_raster_source(*std::move(image), options_, format);
    if (!source) return source.error();
    Result<RasterPage> read = (*source)->read(0);
    if (!read) return read;
    if (page.image.is_stencil) {
      if (Status settled = settle_stencil(page, *read); !settled) {
        return settled.error();
      }
    }
    if (Status placed = place(page, *read); !placed) return placed.error();
    return read;
  }

 private:
  [[nodiscard]] std::string path(const std::string& name) const {
    return folder_.path() + "/" + name;
  }

  [[nodiscard]] Result<std::string> run(
      const std::vector<std::string>& arguments) const {
    RunLimits limits;
    limits.file_bytes = options_.limits.max_memory;
    Result<std::string> output = run_program(arguments, limits);
    if (output || output.error().code != ErrorCode::unsupported) return output;
    Error error = output.error();
    error.message = "PDF: " + error.message + kPackage;
    return error;
  }

  /// The file that pdfimages writes of the page's image: JPEG as it is in the
  /// PDF, everything else as PNG.
  [[nodiscard]] Result<SourceBytes> extract(const PdfPage& page) const {
    if (Status fits = check_page(options_.limits, page.image.width,
                                 page.image.height, bytes_.size());
        !fits) {
      return fits.error();
    }
    if (page.all_bytes > options_.limits.max_memory) {
      return Error{
          ErrorCode::limit_exceeded,
          "the images of the page need more than the memory limit of " +
              std::to_string(options_.limits.max_memory) + " bytes"};
    }
    const Result<TemporaryFolder> images = TemporaryFolder::create();
    if (!images) return images.error();
    const std::string number = std::to_string(page.number);
    const Result<std::string> done =
        run({"pdfimages", "-png", "-j", "-f", number, "-l", number,
             path("in.pdf"), images->path() + "/image"});
    if (!done) return done.error();
    // image-000.png, image-001.jpg, ... image-1000.png
    std::string name = std::to_string(page.image.in_page);
    name.insert(0, 3 - std::min<std::size_t>(name.size(), 3), '0');
    for (const char* ending : {".png", ".jpg"}) {
      const std::string file = images->path() + "/image-" + name + ending;
      if (!std::filesystem::exists(file)) continue;
      return read_file(file, options_.limits.max_memory);
    }
    return Error{ErrorCode::corrupt, "pdfimages gives no image"};
  }

  /// pdfimages gives the bits of a stencil and not which of them paint: a small
  /// picture of the page tells.
  Status settle_stencil(const PdfPage& page, RasterPage& read) const {
    const std::string number = std::to_string(page.number);
    const Result<std::string> picture =
        run({"pdftoppm", "-gray", "-scale-to", "200", "-singlefile", "-f",
             number, "-l", number, path("in.pdf")});
    if (!picture) return picture.error();
    const double dark = darkness(*picture);
    const double share = static_cast<double>(read.ink.ink()) /
                         static_cast<double>(read.ink.pixels());
    const double seen = std::min(cover(page), 1.0);
    if (std::abs(dark - share * seen) > std::abs(dark - (1 - share) * seen)) {
      invert_ink(PixelWork::Invert::yes, read);
      read.work.clear();  // it is how the page looks
      read.info.metadata.clear();
    }
    return {};
  }

  /// The mean of a raw PGM of 255 levels, 0 white to 1 black.
  static double darkness(std::string_view pgm) {
    std::size_t blanks = 0;
    std::size_t at = 0;
    while (at < pgm.size() && blanks < 4) {  // P5, width, height, 255
      if (pgm[at] == ' ' || pgm[at] == '\n') ++blanks;
      ++at;
    }
    const std::string_view samples = pgm.substr(at);
    double sum = 0;
    for (const char sample : samples) {
      sum += 255 - static_cast<unsigned char>(sample);
    }
    return samples.empty() ? 0
                           : sum / 255 / static_cast<double>(samples.size());
  }

  /// The share of the page that its image covers; 1 if it is not known.
  static double cover(const PdfPage& page) {
    const double paper = page.box.width * page.box.height / (72.0 * 72.0);
    const double dots =
        static_cast<double>(page.image.x_per_inch) * page.image.y_per_inch;
    if (paper <= 0 || dots <= 0) return 1;
    return static_cast<double>(page.image.pixels()) / dots / paper;
  }

  /// Resolution, rotation, name, and what is not kept.
  Status place(const PdfPage& page, RasterPage& read) const {
    const ListedImage& image = page.image;
    if (image.x_per_inch > 0 && image.y_per_inch > 0) {
      read.info.resolution = {
          {image.x_per_inch, 1}, {image.y_per_inch, 1}, Resolution::Unit::inch};
    }
    const int quarters = ((page.box.rotation % 360) + 360) % 360 / 90;
    constexpr std::array<int, 4> kOrientations{1, 6, 3, 8};
    const int orientation = kOrientations[static_cast<std::size_t>(quarters)];
    if (orientation != 1) {
      if (Status turned = apply_orientation(orientation, read.ink); !turned) {
        return turned;
      }
      if (is_transposed(orientation)) {
        read.info.resolution = transposed(read.info.resolution);
      }
      read.notes.push_back("page rotation of " +
                           std::to_string(page.box.rotation) +
                           " degrees applied");
    }
    if (count_ > 1) read.info.name = "page " + std::to_string(page.number);
    read.notes.emplace_back(
        "text and lines of the PDF besides the image are not read");
    if (page.images > 1) {
      read.notes.push_back("the largest of " + std::to_string(page.images) +
                           " images; the others not kept");
    }
    note_cover(page, read);
    if (pages_.size() < count_ && page.number == pages_.front().number) {
      read.notes.push_back(std::to_string(count_ - pages_.size()) + " of " +
                           std::to_string(count_) +
                           " pages have no image and are left out");
    }
    return {};
  }

  static void note_cover(const PdfPage& page, RasterPage& read) {
    const double share = 100 * cover(page);
    if (share >= 80) return;
    read.notes.push_back("the image covers " +
                         std::to_string(static_cast<int>(share)) +
                         " % of the page");
  }

  SourceBytes bytes_;
  RasterReadOptions options_;
  TemporaryFolder folder_;
  std::size_t count_ = 0;
  std::vector<PdfPage> pages_;
};

}  // namespace

SourceResult open_pdf(SourceBytes bytes, const RasterReadOptions& options) {
  Result<TemporaryFolder> folder = TemporaryFolder::create();
  if (!folder) return folder.error();
  auto source = std::make_unique<PdfSource>(std::move(bytes), options,
                                            *std::move(folder));
  if (Status opened = source->open(); !opened) return opened.error();
  return std::unique_ptr<RasterSource>(std::move(source));
}

}  // namespace unstep
