#include "cli/source.h"

#include <zlib.h>

#include <utility>

#include "cli/output_format.h"
#include "cli/program.h"
#include "cli/reshape.h"

namespace unstep::cli {
namespace {

std::string_view text_of(const std::vector<std::uint8_t>& file) {
  return {reinterpret_cast<const char*>(file.data()), file.size()};
}

std::string_view name_of(VectorFormat format) {
  switch (format) {
    case VectorFormat::svg: return "svg";
    case VectorFormat::dxf: return "dxf";
    case VectorFormat::hpgl: return "hpgl";
    case VectorFormat::pdf: return "pdf";
    case VectorFormat::json: return "json";
    case VectorFormat::freeman: return "freeman";
  }
  return "";
}

std::string_view name_of(PulseFormat format) {
  switch (format) {
    case PulseFormat::csv: return "csv";
    case PulseFormat::vcd: return "vcd";
    case PulseFormat::sigrok: return "sr";
    case PulseFormat::raw2: return "raw2";
    case PulseFormat::raw4: return "raw4";
  }
  return "";
}

std::optional<PulseFormat> promised_pulses(const std::string& path) {
  if (has_suffix(path, ".csv")) return PulseFormat::csv;
  if (has_suffix(path, ".vcd")) return PulseFormat::vcd;
  if (has_suffix(path, ".sr")) return PulseFormat::sigrok;
  return std::nullopt;
}

/// What the ending of a name promises, where the content need not show it.
std::optional<VectorFormat> promised(const std::string& path) {
  if (has_suffix(path, ".fc")) return VectorFormat::freeman;
  const std::optional<OutputFormat> format = format_of_name(path);
  if (format == OutputFormat::pdf) return std::nullopt;  // its page images
  return format ? vector_format(*format) : std::nullopt;
}

std::uint32_t file_crc32(const std::vector<std::uint8_t>& file) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), file.data(), file.size()));
}

}  // namespace

Result<Source> Source::open(const std::string& path,
                            const InputOptions& options) {
  Result<std::vector<std::uint8_t>> file =
      read_file(path, options.limits.max_memory);
  if (!file) return file.error();
  const std::uint64_t bytes = file->size();
  const std::uint32_t crc = options.checksum ? file_crc32(*file) : 0;
  Result<Source> source = recognise(path, std::move(*file), options);
  if (!source) return source;
  source->bytes_ = bytes;
  source->crc32_ = crc;
  return source;
}

Result<Source> Source::recognise(const std::string& path,
                                 std::vector<std::uint8_t> file,
                                 const InputOptions& options) {
  using Kind = InputOptions::Kind;
  if (options.kind == Kind::raster) {
    return open_raster(std::move(file), options);
  }
  if (options.kind == Kind::vector) {
    return open_vector(file, options.vector, options);
  }
  if (options.kind == Kind::pulses) {
    return open_pulses(file, options.pulses, options);
  }
  if (const auto format = promised(path)) {
    return open_vector(file, *format, options);
  }
  if (names_program(path)) {
    Source source;
    source.format_ = "gcode";
    source.program_.emplace(text_of(file));
    source.grid_ = options.grid;
    source.max_steps_ = options.limits.max_steps;
    return source;
  }
  if (const auto format = promised_pulses(path)) {
    return open_pulses(file, *format, options);
  }
  // An empty text is a drawing without chains; an empty image is none.
  if (file.empty()) return Error{ErrorCode::truncated, "the file is empty"};
  auto kept = std::make_unique<std::vector<std::uint8_t>>(std::move(file));
  Result<UstpReader> ustp =
      UstpReader::open(*kept, {options.limits, options.jobs, {}});
  if (ustp) {
    Source source;
    source.format_ = "ustp";
    source.ustp_bytes_ = std::move(kept);
    source.ustp_.emplace(std::move(*ustp));
    return source;
  }
  if (ustp.error().code != ErrorCode::bad_magic || has_suffix(path, ".ustp")) {
    return ustp.error();
  }
  if (const auto pulses = recognise_pulses(*kept)) {
    return open_pulses(*kept, *pulses, options);
  }
  const auto format = recognise_vector(text_of(*kept));
  if (!format || *format == VectorFormat::pdf) {
    return open_raster(std::move(*kept), options);
  }
  Result<Source> vector = open_vector(*kept, *format, options);
  if (vector || *format != VectorFormat::freeman) return vector;
  return Error{vector.error().code,
               "neither a drawing nor Freeman text: " + vector.error().message};
}

Result<Source> Source::open_raster(std::vector<std::uint8_t> file,
                                   const InputOptions& options) {
  Result<RasterReader> raster = RasterReader::open(
      std::move(file), {options.threshold, options.limits, options.work});
  if (!raster) return raster.error();
  Source source;
  source.format_ = raster->format();
  source.raster_.emplace(std::move(*raster));
  return source;
}

Result<Source> Source::open_vector(const std::vector<std::uint8_t>& file,
                                   VectorFormat format,
                                   const InputOptions& options) {
  Result<std::vector<VectorPage>> pages = read_vector(
      text_of(file), format, {options.curve_tolerance, options.limits});
  if (!pages) return pages.error();
  Source source;
  source.format_ = name_of(format);
  source.vectors_ = *std::move(pages);
  source.grid_ = options.grid;
  source.max_steps_ = options.limits.max_steps;
  return source;
}

Result<Source> Source::open_pulses(const std::vector<std::uint8_t>& file,
                                   PulseFormat format,
                                   const InputOptions& options) {
  PulseReadOptions decoding = options.decoding;
  decoding.limits = options.limits;
  Result<VectorPage> page = read_pulses(file, format, decoding);
  if (!page) return page.error();
  Source source;
  source.format_ = name_of(format);
  source.vectors_.push_back(*std::move(page));
  return source;
}

std::size_t Source::page_count() const {
  if (raster_) return raster_->page_count();
  if (program_) return 1;
  return ustp_ ? ustp_->info().pages.size() : vectors_.size();
}

Result<SourcePage> Source::read(std::size_t index) {
  SourcePage out;
  if (ustp_) {
    Result<Page> page = ustp_->read_page(index);
    if (!page) return page.error();
    out.page = std::move(*page);
  } else if (program_) {
    out.page.kind = PageKind::program;
    out.page.program = *program_;
  } else if (!raster_) {
    VectorPage& vector = vectors_[index];
    out.page.kind =
        vector.drawing.paths.empty() ? PageKind::chains : PageKind::paths;
    out.page.drawing = std::move(vector.drawing);
    out.page.info = std::move(vector.info);
    out.notes = std::move(vector.notes);
  } else {
    Result<RasterPage> page = raster_->read(index);
    if (!page) return page.error();
    out.page.info = std::move(page->info);
    out.page.ink = std::move(page->ink);
    out.lossless = page->lossless;
    out.notes = std::move(page->notes);
    out.work = std::move(page->work);
  }
  if (grid_ && out.page.kind == PageKind::program) {
    Result<Page> drawn = draw_program_page(out.page, out.notes);
    if (!drawn) return drawn.error();
    out.page = *std::move(drawn);
  }
  if (grid_ && out.page.kind == PageKind::paths) {
    Result<Page> steps = to_steps(std::move(out.page), *grid_, max_steps_);
    if (!steps) return steps.error();
    out.page = *std::move(steps);
  }
  return out;
}

}  // namespace unstep::cli
