#include "formats/jpeg_rows.h"

#include <array>
#include <csetjmp>
#include <cstdio>
// After cstdio, which it needs.
#include <jerror.h>
#include <jpeglib.h>

#include "formats/page_limits.h"

namespace unstep {
namespace {

/// libjpeg's way to report: errors jump back, warnings are errors unless they
/// are known to be harmless.
struct Report {
  jpeg_error_mgr manager{};  ///< first, so that libjpeg's pointer is ours
  std::jmp_buf back{};
  std::array<char, JMSG_LENGTH_MAX> message{};
  bool has_odd_marker = false;  ///< of Adobe or JFIF
};

Report& report_of(j_common_ptr common) {
  return *reinterpret_cast<Report*>(common->err);
}

[[noreturn]] void fail(j_common_ptr common) {
  Report& report = report_of(common);
  common->err->format_message(common, report.message.data());
  std::longjmp(report.back, 1);
}

void hear(j_common_ptr common, int level) {
  if (level >= 0) return;  // not a warning
  const int code = common->err->msg_code;
  if (code == JWRN_ADOBE_XFORM || code == JWRN_JFIF_MAJOR) {
    report_of(common).has_odd_marker = true;
    return;
  }
  fail(common);
}

void keep_silent(j_common_ptr) {}

/// Progressive files may hold any number of scans, each of which costs as much
/// as the image.
void watch_scans(j_common_ptr common) {
  constexpr int kMostScans = 500;
  auto* const jpeg = reinterpret_cast<j_decompress_ptr>(common);
  if (jpeg->input_scan_number <= kMostScans) return;
  Report& report = report_of(common);
  std::snprintf(report.message.data(), report.message.size(),
                "more than %d scans", kMostScans);
  std::longjmp(report.back, 1);
}

std::uint8_t times(unsigned value, unsigned share) {
  return static_cast<std::uint8_t>((value * share + 127) / 255);
}

}  // namespace

struct JpegRows::Impl {
  explicit Impl(std::span<const std::uint8_t> file) : bytes(file) {}
  ~Impl() { close(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void close() {
    if (is_open) jpeg_destroy_decompress(&jpeg);
    is_open = false;
  }

  /// Calls libjpeg. The work must hold nothing that needs a destructor: it is
  /// left by longjmp.
  template <class Work>
  Status call(const Work& work) {
    if (setjmp(report.back) != 0) {  // NOLINT
      return Error{ErrorCode::corrupt,
                   "libjpeg: " + std::string(report.message.data())};
    }
    work();
    return {};
  }

  Status read_header() {
    close();
    jpeg.err = jpeg_std_error(&report.manager);
    report.manager.error_exit = fail;
    report.manager.emit_message = hear;
    report.manager.output_message = keep_silent;
    return call([this] {
      jpeg_create_decompress(&jpeg);
      is_open = true;
      jpeg_mem_src(&jpeg, bytes.data(), bytes.size());
      jpeg_read_header(&jpeg, TRUE);
      progress.progress_monitor = watch_scans;
      jpeg.progress = &progress;
    });
  }

  [[nodiscard]] bool is_ink() const {
    return jpeg.jpeg_color_space == JCS_CMYK ||
           jpeg.jpeg_color_space == JCS_YCCK;
  }

  /// Begins to give rows in a colour space.
  Status begin(J_COLOR_SPACE space) {
    if (Status read = read_header(); !read) return read;
    return call([this, space] {
      jpeg.out_color_space = space;
      jpeg.dct_method = JDCT_ISLOW;  // the same on every machine
      jpeg_start_decompress(&jpeg);
    });
  }

  Status read_row(std::uint8_t* to) {
    return call([this, to] {
      JSAMPROW target = to;
      jpeg_read_scanlines(&jpeg, &target, 1);
      // Damage may follow the last row: the end must be there too.
      if (jpeg.output_scanline == jpeg.output_height) {
        jpeg_finish_decompress(&jpeg);
      }
    });
  }

  std::span<const std::uint8_t> bytes;
  Report report;
  jpeg_decompress_struct jpeg{};
  jpeg_progress_mgr progress{};
  bool is_open = false;
  bool as_luminance = false;
  bool begun = false;
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::uint64_t memory = 0;
  std::vector<std::uint8_t> row;
  std::vector<std::string> notes;
};

JpegRows::JpegRows(std::span<const std::uint8_t> bytes)
    : impl_(std::make_unique<Impl>(bytes)) {}
JpegRows::~JpegRows() = default;

std::int32_t JpegRows::width() const { return impl_->width; }
std::int32_t JpegRows::height() const { return impl_->height; }
std::uint64_t JpegRows::memory() const { return impl_->memory; }
const std::vector<std::string>& JpegRows::notes() const { return impl_->notes; }

/// A progressive or arithmetic-coded image is held as coefficients, two bytes
/// each, sides rounded up to two blocks of 8.
Status JpegRows::open(const DecodeLimits& limits) {
  if (Status read = impl_->read_header(); !read) return read;
  const jpeg_decompress_struct& jpeg = impl_->jpeg;
  const std::uint64_t width = jpeg.image_width;
  const std::uint64_t height = jpeg.image_height;
  const auto components = static_cast<std::uint64_t>(jpeg.num_components);
  const std::uint64_t rows = (width + 64) * components * 2 * 16 * 4;
  const bool whole = jpeg_has_multiple_scans(&impl_->jpeg) != FALSE;
  const std::uint64_t coefficients =
      whole ? (width + 64) * (height + 64) * components * 2 : 0;
  impl_->memory =
      impl_->bytes.size() + rows + coefficients + width * sizeof(Colour);
  if (Status fits = check_page(limits, width, height, impl_->memory); !fits) {
    return fits;
  }
  impl_->width = static_cast<std::int32_t>(width);
  impl_->height = static_cast<std::int32_t>(height);
  const bool is_known = jpeg.jpeg_color_space != JCS_UNKNOWN;
  if (!is_known) {
    return Error{ErrorCode::unsupported, "JPEG of " +
                                             std::to_string(components) +
                                             " components of no known colours"};
  }
  if (impl_->is_ink()) {
    impl_->notes.emplace_back(
        "CMYK shown as red, green and blue without a colour profile");
  }
  if (impl_->report.has_odd_marker) {
    impl_->notes.emplace_back("unknown version in a JFIF or Adobe marker");
  }
  return {};
}

Status JpegRows::start() {
  impl_->begun = false;
  return {};
}

Status JpegRows::next(std::span<Colour> row) {
  const bool is_ink = impl_->is_ink();
  const std::size_t channels = is_ink ? 4 : 3;
  if (!impl_->begun) {
    if (Status begun = impl_->begin(is_ink ? JCS_CMYK : JCS_RGB); !begun) {
      return begun;
    }
    impl_->begun = true;
    impl_->row.resize(row.size() * channels);
  }
  if (Status read = impl_->read_row(impl_->row.data()); !read) return read;
  // Adobe's programs, which write nearly all such files, store 255 - ink.
  const bool inverted = impl_->jpeg.saw_Adobe_marker != FALSE;
  for (std::size_t x = 0; x < row.size(); ++x) {
    const std::uint8_t* from = impl_->row.data() + x * channels;
    std::array<std::uint8_t, 3> rgb{from[0], from[1], from[2]};
    if (is_ink) {
      const auto light = [inverted](std::uint8_t sample) {
        return static_cast<unsigned>(inverted ? sample : 255 - sample);
      };
      const unsigned black = light(from[3]);
      for (std::size_t i = 0; i < 3; ++i) rgb[i] = times(light(from[i]), black);
    }
    row[x] = make_colour(rgb[0] * 257U, rgb[1] * 257U, rgb[2] * 257U);
  }
  return {};
}

Status JpegRows::next_luminance(std::span<std::uint8_t> row) {
  const J_COLOR_SPACE stored = impl_->jpeg.jpeg_color_space;
  if (stored != JCS_GRAYSCALE && stored != JCS_YCbCr) {
    return ColourRows::next_luminance(row);
  }
  if (!impl_->begun) {
    if (Status begun = impl_->begin(JCS_GRAYSCALE); !begun) return begun;
    impl_->begun = true;
  }
  return impl_->read_row(row.data());
}

}  // namespace unstep
