#include <png.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "formats/colour.h"
#include "formats/png_file.h"
#include "formats/raster_sink.h"
#include "formats/resolution.h"
#include "formats/text.h"

namespace unstep {
namespace {

/// Output that grows by realloc, because libpng's callback must not throw.
struct PngOutput {
  std::uint8_t* data = nullptr;
  std::size_t size = 0;
  std::size_t capacity = 0;
};

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  auto* out = static_cast<PngOutput*>(png_get_io_ptr(png));
  if (count > out->capacity - out->size) {
    const std::size_t capacity = (out->size + count) * 3 / 2 + 4096;
    void* grown = std::realloc(out->data, capacity);
    if (grown == nullptr) png_error(png, "no memory for the file");
    out->data = static_cast<std::uint8_t*>(grown);
    out->capacity = capacity;
  }
  std::memcpy(out->data + out->size, bytes, count);
  out->size += count;
}

void flush_nothing(png_structp /*png*/) {}

/// A text chunk; Latin-1 as tEXt, everything else as iTXt.
struct PngText {
  std::string keyword;
  std::string text;
  bool is_utf8 = false;
};

/// Keywords are 1 to 79 printable Latin-1 characters (PNG, 11.3.4.2); the
/// subset without blanks at the ends and ASCII only is taken.
bool is_keyword(std::string_view key) {
  if (key.empty() || key.size() > 79 || key.front() == ' ' ||
      key.back() == ' ' || key.find("  ") != std::string_view::npos) {
    return false;
  }
  for (const char c : key) {
    if (c < ' ' || c > '~') return false;
  }
  return true;
}

std::vector<PngText> make_texts(const PageInfo& info,
                                std::vector<std::string>& notes) {
  std::vector<PngText> texts;
  const auto add = [&](std::string key, const std::string& value) {
    if (!is_keyword(key) || value.find('\0') != std::string::npos ||
        !is_utf8(value)) {
      notes.push_back("PNG cannot carry the metadata " + key);
      return;
    }
    const auto latin1 = utf8_to_latin1(value);
    texts.push_back({std::move(key), latin1 ? *latin1 : value, !latin1});
  };
  if (!info.name.empty()) add("tiff:PageName", info.name);
  for (const auto& [key, value] : info.metadata) {
    if (key == kPaletteKey) continue;
    add(key.starts_with("png:") ? key.substr(4) : key, value);
  }
  return texts;
}

/// pHYs: whole pixels per metre, or a ratio; x == 0: none.
struct Density {
  png_uint_32 x = 0;
  png_uint_32 y = 0;
  int unit = PNG_RESOLUTION_UNKNOWN;
};

/// Two numbers with the ratio of the resolution; its own ones if they are
/// whole.
std::pair<std::uint64_t, std::uint64_t> make_ratio(const Resolution& from) {
  const std::uint64_t x = std::uint64_t{from.x.numerator} * from.y.denominator;
  const std::uint64_t y = std::uint64_t{from.y.numerator} * from.x.denominator;
  const bool whole = from.x.denominator == 1 && from.y.denominator == 1;
  const std::uint64_t common = whole ? 1 : std::gcd(x, y);
  return {x / common, y / common};
}

Density make_density(const Resolution& from, std::vector<std::string>& notes) {
  if (!from.known()) return {};
  const std::string lost = "PNG cannot carry the resolution " + to_string(from);
  if (!is_usable(from)) {
    notes.push_back(lost);
    return {};
  }
  std::uint64_t x = 0;
  std::uint64_t y = 0;
  bool exact = true;
  if (from.unit == Resolution::Unit::none) {
    std::tie(x, y) = make_ratio(from);
  } else {
    // 1 inch is 127/5000 m.
    const bool inch = from.unit == Resolution::Unit::inch;
    const bool metre = from.unit == Resolution::Unit::metre;
    const std::uint32_t numerator = inch ? 5000 : metre ? 1 : 100;
    const std::uint32_t denominator = inch ? 127 : 1;
    const RoundedRational sx = scale(from.x, numerator, denominator);
    const RoundedRational sy = scale(from.y, numerator, denominator);
    x = round_to_integer(sx.value);
    y = round_to_integer(sy.value);
    exact = sx.exact && sy.exact && sx.value.denominator == 1 &&
            sy.value.denominator == 1;
  }
  if (x == 0 || y == 0 || x > PNG_UINT_31_MAX || y > PNG_UINT_31_MAX) {
    notes.push_back(lost);
    return {};
  }
  if (!exact) {
    notes.push_back("PNG rounds the resolution " + to_string(from) + " to " +
                    std::to_string(x) + " x " + std::to_string(y) +
                    " per metre");
  }
  return {static_cast<png_uint_32>(x), static_cast<png_uint_32>(y),
          from.unit == Resolution::Unit::none ? PNG_RESOLUTION_UNKNOWN
                                              : PNG_RESOLUTION_METER};
}

png_color to_png(Colour colour) {
  return {static_cast<png_byte>(red_of(colour) >> 8),
          static_cast<png_byte>(green_of(colour) >> 8),
          static_cast<png_byte>(blue_of(colour) >> 8)};
}

/// libpng's writer as an owner.
class PngWriter {
 public:
  PngWriter() {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &state_,
                                   png_keep_error, png_keep_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  ~PngWriter() {
    png_destroy_write_struct(&png_, &info_);
    std::free(out_.data);
  }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  Result<std::vector<std::uint8_t>> write(const Bitmap& ink,
                                          const Palette& palette,
                                          const Density& density,
                                          std::vector<png_text> texts) {
    if (png_ == nullptr || info_ == nullptr) {
      return Error{ErrorCode::limit_exceeded, "no memory for libpng"};
    }
    const bool has_palette = palette != Palette{};
    const std::array entries{to_png(palette.ink), to_png(palette.paper)};
    bool good = guard_png(png_, [&] {
      png_set_write_fn(png_, &out_, append_bytes, flush_nothing);
      png_set_user_limits(png_, Bitmap::kMaxSide, Bitmap::kMaxSide);
      png_set_compression_level(png_, 9);
      png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
      png_set_IHDR(png_, info_, static_cast<png_uint_32>(ink.width()),
                   static_cast<png_uint_32>(ink.height()), 1,
                   has_palette ? PNG_COLOR_TYPE_PALETTE : PNG_COLOR_TYPE_GRAY,
                   PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                   PNG_FILTER_TYPE_DEFAULT);
      if (has_palette) png_set_PLTE(png_, info_, entries.data(), 2);
      if (density.x != 0) {
        png_set_pHYs(png_, info_, density.x, density.y, density.unit);
      }
      png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
      png_write_info(png_, info_);
    });
    std::vector<std::uint8_t> row((static_cast<std::size_t>(ink.width()) + 7) /
                                  8);
    for (std::int32_t y = 0; good && y < ink.height(); ++y) {
      // Grey: 0 is black. Palette: entry 0 is the ink.
      ink.get_row_bytes(y, row, true);
      good = guard_png(png_, [&] { png_write_row(png_, row.data()); });
    }
    good = good && guard_png(png_, [&] { png_write_end(png_, info_); });
    if (!good) {
      return Error{ErrorCode::internal,
                   std::string("libpng: ") + state_.error.data()};
    }
    return std::vector<std::uint8_t>(out_.data, out_.data + out_.size);
  }

 private:
  PngCallbackState state_;
  PngOutput out_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

/// 1-bit PNG, grey or with a palette of two.
class PngSink final : public RasterSink {
 public:
  Status add_page(const Bitmap& ink, const PageInfo& info,
                  std::vector<std::string>& notes) override {
    if (!file_.empty()) {
      return Error{ErrorCode::invalid_argument, "PNG holds one page only"};
    }
    const Palette palette = find_palette(info.metadata).value_or(Palette{});
    if (!is_8_bit(palette.ink) || !is_8_bit(palette.paper)) {
      notes.push_back("PNG rounds the colours " + to_string(palette.ink) +
                      " and " + to_string(palette.paper) + " to 8 bits");
    }
    std::vector<PngText> texts = make_texts(info, notes);
    std::vector<png_text> chunks(texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
      chunks[i].compression = texts[i].is_utf8 ? PNG_ITXT_COMPRESSION_NONE
                                               : PNG_TEXT_COMPRESSION_NONE;
      chunks[i].key = texts[i].keyword.data();
      chunks[i].text = texts[i].text.data();
    }
    auto file = PngWriter().write(
        ink, palette, make_density(info.resolution, notes), std::move(chunks));
    if (!file) return file.error();
    file_ = std::move(*file);
    return {};
  }

  Result<std::vector<std::uint8_t>> finish() override {
    return std::move(file_);
  }

 private:
  std::vector<std::uint8_t> file_;
};

}  // namespace

SinkResult create_png_sink() {
  return std::unique_ptr<RasterSink>(std::make_unique<PngSink>());
}

}  // namespace unstep
