#include "cli/source.h"

#include <zlib.h>

#include <algorithm>
#include <span>
#include <utility>

namespace unstep::cli {
namespace {

/// Text that is no netpbm file, whose signatures are text too.
bool may_be_freeman(std::span<const std::uint8_t> file) {
  if (file.size() >= 2 && file[0] == 'P' && file[1] >= '1' && file[1] <= '7') {
    return false;
  }
  const auto head = file.first(std::min<std::size_t>(file.size(), 512));
  return std::all_of(head.begin(), head.end(), [](std::uint8_t byte) {
    return byte == '\t' || byte == '\n' || byte == '\r' ||
           (byte >= 0x20 && byte != 0x7f);
  });
}

}  // namespace

std::uint32_t file_crc32(const std::vector<std::uint8_t>& file) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), file.data(), file.size()));
}

Result<Source> Source::open(const std::string& path,
                            const InputOptions& options) {
  Result<std::vector<std::uint8_t>> file =
      read_file(path, options.limits.max_memory);
  if (!file) return file.error();
  const std::uint64_t bytes = file->size();
  const std::uint32_t crc = file_crc32(*file);
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
  if (options.kind == Kind::freeman || has_suffix(path, ".fc")) {
    return open_freeman(file, options);
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
  if (!may_be_freeman(*kept)) return open_raster(std::move(*kept), options);
  Result<Source> freeman = open_freeman(*kept, options);
  if (freeman) return freeman;
  return Error{
      freeman.error().code,
      "neither a raster image nor Freeman text: " + freeman.error().message};
}

Result<Source> Source::open_raster(std::vector<std::uint8_t> file,
                                   const InputOptions& options) {
  Result<RasterReader> raster =
      RasterReader::open(std::move(file), {options.threshold, options.limits});
  if (!raster) return raster.error();
  Source source;
  source.format_ = raster->format();
  source.raster_.emplace(std::move(*raster));
  return source;
}

Result<Source> Source::open_freeman(const std::vector<std::uint8_t>& file,
                                    const InputOptions& options) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()),
                              file.size());
  Result<Drawing> drawing = parse_freeman(text, options.limits);
  if (!drawing) return drawing.error();
  Source source;
  source.format_ = "freeman";
  source.drawing_ = std::move(*drawing);
  return source;
}

std::size_t Source::page_count() const {
  if (raster_) return raster_->page_count();
  return ustp_ ? ustp_->info().pages.size() : 1;
}

Result<SourcePage> Source::read(std::size_t index) {
  SourcePage out;
  if (ustp_) {
    Result<Page> page = ustp_->read_page(index);
    if (!page) return page.error();
    out.page = std::move(*page);
  } else if (drawing_) {
    out.page.kind = PageKind::chains;
    out.page.drawing = std::move(*drawing_);
  } else {
    Result<RasterPage> page = raster_->read(index);
    if (!page) return page.error();
    out.page.info = std::move(page->info);
    out.page.ink = std::move(page->ink);
    out.lossless = page->lossless;
    out.notes = std::move(page->notes);
  }
  return out;
}

}  // namespace unstep::cli
