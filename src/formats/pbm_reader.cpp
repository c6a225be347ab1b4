#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "formats/colour_rows.h"
#include "formats/page_limits.h"
#include "formats/raster_source.h"

/// PBM and PGM, plain and raw (netpbm's pbm(5) and pgm(5)). Own code: the
/// formats are three numbers and the samples.
namespace unstep {
namespace {

bool is_space(int c) {
  return c == ' ' || (c >= '\t' && c <= '\r');  // isspace of the C locale
}

/// Reads characters and numbers; 256 and nothing past the end.
class Scanner {
 public:
  Scanner(std::span<const std::uint8_t> bytes, std::size_t position)
      : bytes_(bytes), position_(position) {}

  static constexpr int kEnd = 256;
  [[nodiscard]] int peek() const {
    return position_ < bytes_.size() ? bytes_[position_] : kEnd;
  }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - position_; }
  void skip(std::size_t count) { position_ += count; }

  void skip_blanks() {
    for (;; ++position_) {
      if (peek() == '#') {
        while (peek() != '\n' && peek() != '\r' && peek() != kEnd) ++position_;
      }
      if (!is_space(peek())) return;
    }
  }

  /// A decimal number after blanks and comments.
  Result<std::uint32_t> number() {
    skip_blanks();
    if (peek() == kEnd) return truncated();
    std::uint64_t value = 0;
    const std::size_t begin = position_;
    for (; peek() >= '0' && peek() <= '9'; ++position_) {
      value = value * 10 + static_cast<std::uint64_t>(peek() - '0');
      if (value > UINT32_MAX) return corrupt("number too large");
    }
    if (position_ == begin) return corrupt("expected a number");
    return static_cast<std::uint32_t>(value);
  }

  /// A digit 0 or 1 after blanks and comments.
  Result<bool> bit() {
    skip_blanks();
    if (peek() == kEnd) return truncated();
    if (peek() != '0' && peek() != '1') return corrupt("expected 0 or 1");
    return bytes_[position_++] == '1';
  }

  [[nodiscard]] Error corrupt(const std::string& reason) const {
    return {ErrorCode::corrupt,
            "byte " + std::to_string(position_) + ": " + reason};
  }
  [[nodiscard]] Error truncated() const {
    return {ErrorCode::truncated, "the file ends at byte " +
                                      std::to_string(bytes_.size()) +
                                      " inside the image"};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t position_;
};

struct Header {
  char kind = '4';  ///< the digit of the magic
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t maximum = 1;
  std::size_t data = 0;  ///< where the samples begin
  [[nodiscard]] bool is_plain() const { return kind <= '2'; }
  [[nodiscard]] bool is_grey() const { return kind == '2' || kind == '5'; }
  [[nodiscard]] std::uint64_t row_bytes() const {  // raw forms
    if (!is_grey()) return (std::uint64_t{width} + 7) / 8;
    return std::uint64_t{width} * (maximum > 255 ? 2 : 1);
  }
};

Result<Header> read_header(Scanner& scan) {
  Header header;
  if (scan.peek() != 'P') return scan.corrupt("expected the magic of an image");
  if (scan.left() < 2) return scan.truncated();
  scan.skip(1);
  header.kind = static_cast<char>(scan.peek());
  if (header.kind == '3' || header.kind == '6' || header.kind == '7') {
    return Error{ErrorCode::unsupported,
                 std::string("netpbm format P") + header.kind +
                     " (colour) is not read; convert it to PGM or PNG"};
  }
  if (header.kind < '1' || header.kind > '5') {
    return scan.corrupt("expected the magic of an image");
  }
  scan.skip(1);
  for (std::uint32_t* field : {&header.width, &header.height}) {
    const Result<std::uint32_t> number = scan.number();
    if (!number) return number.error();
    *field = *number;
  }
  if (header.is_grey()) {
    const Result<std::uint32_t> number = scan.number();
    if (!number) return number.error();
    header.maximum = *number;
    if (header.maximum < 1 || header.maximum > 65535) {
      return scan.corrupt("greatest value " + std::to_string(header.maximum) +
                          "; it is 1 to 65535");
    }
  }
  if (scan.peek() == Scanner::kEnd) return scan.truncated();
  if (!is_space(scan.peek())) return scan.corrupt("expected white space");
  scan.skip(1);
  header.data = scan.position();
  return header;
}

/// Moves behind the samples. Raw samples are counted, plain ones read.
Status skip_samples(const Header& header, Scanner& scan) {
  if (!header.is_plain()) {
    const std::uint64_t row = header.row_bytes();  // < 2^33
    if (row != 0 && header.height > scan.left() / row) {
      return scan.truncated();
    }
    scan.skip(static_cast<std::size_t>(row * header.height));
    return {};
  }
  // A plain sample takes at least one byte, so this ends with the input.
  const std::uint64_t samples = std::uint64_t{header.width} * header.height;
  for (std::uint64_t i = 0; i < samples; ++i) {
    if (header.is_grey()) {
      if (const auto value = scan.number(); !value) return value.error();
    } else if (const auto bit = scan.bit(); !bit) {
      return bit.error();
    }
  }
  return {};
}

class GreyRows final : public ColourRows {
 public:
  GreyRows(std::span<const std::uint8_t> bytes, const Header& header)
      : bytes_(bytes), header_(header), scan_(bytes, header.data) {}

  Status start() override {
    scan_ = Scanner(bytes_, header_.data);
    return {};
  }

  Status next(std::span<Colour> row) override {
    for (Colour& pixel : row) {
      const Result<std::uint32_t> value = sample();
      if (!value) return value.error();
      if (*value > header_.maximum) {
        return scan_.corrupt("value " + std::to_string(*value) +
                             " above the greatest value " +
                             std::to_string(header_.maximum));
      }
      pixel =
          make_grey((*value * 65535 + header_.maximum / 2) / header_.maximum);
    }
    return {};
  }

 private:
  Result<std::uint32_t> sample() {
    if (header_.is_plain()) return scan_.number();
    const std::size_t size = header_.maximum > 255 ? 2 : 1;
    if (scan_.left() < size) return scan_.truncated();
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value = value << 8 | static_cast<std::uint32_t>(scan_.peek());
      scan_.skip(1);
    }
    return value;
  }

  std::span<const std::uint8_t> bytes_;
  Header header_;
  Scanner scan_;
};

class PbmSource final : public RasterSource {
 public:
  PbmSource(SourceBytes bytes, const RasterReadOptions& options)
      : bytes_(std::move(bytes)), options_(options) {}

  /// Finds the images. Between images, and after the last, white space is
  /// tolerated (editors add it) and nothing else.
  Status index() {
    Scanner scan(bytes_, 0);
    do {
      const Result<Header> header = read_header(scan);
      if (!header) return in_page(header.error());
      if (Status skipped = skip_samples(*header, scan); !skipped) {
        return in_page(skipped.error());
      }
      pages_.push_back(*header);
      while (is_space(scan.peek())) scan.skip(1);
    } while (scan.peek() != Scanner::kEnd);
    return {};
  }

  [[nodiscard]] std::size_t page_count() const override {
    return pages_.size();
  }

  Result<RasterPage> read(std::size_t index) override {
    const Header& header = pages_[index];
    const std::uint64_t row =
        header.is_grey() ? std::uint64_t{header.width} * sizeof(Colour) : 0;
    if (Status fits = check_page(options_.limits, header.width, header.height,
                                 bytes_.size() + row);
        !fits) {
      return fits.error();
    }
    RasterPage page;
    const auto width = static_cast<std::int32_t>(header.width);
    const auto height = static_cast<std::int32_t>(header.height);
    Status done;
    if (header.is_grey()) {
      GreyRows rows(bytes_, header);
      done = read_colours(rows, width, height, options_, bytes_.size() + row,
                          page);
    } else {
      Result<Bitmap> ink = Bitmap::create(width, height);
      if (!ink) return ink.error();
      page.ink = std::move(*ink);
      done = header.is_plain() ? read_plain(header, page.ink)
                               : read_raw(header, page.ink);
    }
    if (!done) return done.error();
    return page;
  }

 private:
  Error in_page(Error error) const {
    error.message =
        "page " + std::to_string(pages_.size() + 1) + ": " + error.message;
    return error;
  }

  Status read_plain(const Header& header, Bitmap& ink) const {
    Scanner scan(bytes_, header.data);
    for (std::int32_t y = 0; y < ink.height(); ++y) {
      for (std::int32_t x = 0; x < ink.width(); ++x) {
        const Result<bool> bit = scan.bit();
        if (!bit) return bit.error();
        if (*bit) ink.set(x, y, true);
      }
    }
    return {};
  }

  Status read_raw(const Header& header, Bitmap& ink) const {
    const auto row_bytes = static_cast<std::size_t>(header.row_bytes());
    std::span<const std::uint8_t> rest = std::span(bytes_).subspan(header.data);
    for (std::int32_t y = 0; y < ink.height(); ++y) {
      ink.set_row_bytes(y, rest.first(row_bytes), false);
      rest = rest.subspan(row_bytes);
    }
    return {};
  }

  SourceBytes bytes_;
  RasterReadOptions options_;
  std::vector<Header> pages_;
};

}  // namespace

SourceResult open_pbm(SourceBytes bytes, const RasterReadOptions& options) {
  auto source = std::make_unique<PbmSource>(std::move(bytes), options);
  if (Status indexed = source->index(); !indexed) return indexed.error();
  return std::unique_ptr<RasterSource>(std::move(source));
}

}  // namespace unstep
