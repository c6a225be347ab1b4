#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "unstep/formats.h"
#include "unstep/trace.h"

/// convert IN OUT: a raster's contours, or the paths of a vector file, as a
/// vector file of the kind that OUT ends with; or, for a raster and .pbm, the
/// ink of its first page. What tests/clients hands to
/// programs that we did not write.
namespace {

using namespace unstep;

int fail(const std::string& message) {
  std::cerr << message << "\n";
  return 1;
}

Result<VectorFormat> format_of(std::string_view path) {
  constexpr std::pair<std::string_view, VectorFormat> kEndings[] = {
      {".svg", VectorFormat::svg},   {".dxf", VectorFormat::dxf},
      {".hpgl", VectorFormat::hpgl}, {".pdf", VectorFormat::pdf},
      {".json", VectorFormat::json}, {".fc", VectorFormat::freeman}};
  for (const auto& [ending, format] : kEndings) {
    if (path.ends_with(ending)) return format;
  }
  return Error{ErrorCode::invalid_argument, "unknown ending"};
}

Status convert_raster(RasterReader& reader, VectorWriter& writer) {
  for (std::size_t i = 0; i < reader.page_count(); ++i) {
    const Result<RasterPage> page = reader.read(i);
    if (!page) return page.error();
    const Canvas canvas{page->ink.width(), page->ink.height(), YAxis::down};
    Status done = writer.begin_page(canvas, 1, Paint::fill, page->info);
    if (!done) return done;
    Status added;
    Status traced = trace_contours(page->ink, [&](const Chain& contour) {
      added = writer.add(contour);
      return static_cast<bool>(added);
    });
    if (!added) return added;
    if (!traced) return traced;
    done = writer.end_page();
    if (!done) return done;
  }
  return writer.finish();
}

Status convert_vector(std::string_view bytes, VectorFormat from,
                      VectorWriter& writer) {
  const Result<std::vector<VectorPage>> pages = read_vector(bytes, from, {});
  if (!pages) return pages.error();
  for (const VectorPage& page : *pages) {
    for (const std::string& note : page.notes) std::cerr << note << "\n";
    Status added = writer.add_page(page.drawing, page.info);
    if (!added) return added;
  }
  return writer.finish();
}

/// The ink itself, to compare with.
Status write_raster(RasterReader& reader, std::ostream& file) {
  Result<RasterWriter> writer = RasterWriter::create(RasterFormat::pbm);
  if (!writer) return writer.error();
  const Result<RasterPage> page = reader.read(0);
  if (!page) return page.error();
  if (Status added = writer->add_page(page->ink, {}, nullptr); !added) {
    return added;
  }
  const Result<std::vector<std::uint8_t>> bytes = writer->finish();
  if (!bytes) return bytes.error();
  file.write(reinterpret_cast<const char*>(bytes->data()),
             static_cast<std::streamsize>(bytes->size()));
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fail("usage: convert IN OUT");
  const std::string in = argv[1];
  const std::string out = argv[2];
  Result<std::vector<std::uint8_t>> bytes = read_file(in, 1U << 30);
  if (!bytes) return fail(bytes.error().message);
  std::ofstream file(out, std::ios::binary);
  const Result<VectorFormat> from = format_of(in);
  const std::string text =
      from ? std::string(bytes->begin(), bytes->end()) : "";
  Result<RasterReader> raster = RasterReader::open(std::move(*bytes), {});
  if (!from && !raster) return fail(raster.error().message);
  if (out.ends_with(".pbm")) {
    const Status done = write_raster(*raster, file);
    return done ? 0 : fail(done.error().message);
  }
  const Result<VectorFormat> to = format_of(out);
  if (!to) return fail(to.error().message);
  Result<VectorWriter> writer =
      VectorWriter::create(*to, [&file](std::string_view part) -> Status {
        file.write(part.data(), static_cast<std::streamsize>(part.size()));
        if (file) return {};
        return Error{ErrorCode::io_error, "cannot write"};
      });
  if (!writer) return fail(writer.error().message);
  const Status done = from ? convert_vector(text, *from, *writer)
                           : convert_raster(*raster, *writer);
  if (!done) return fail(done.error().message);
  for (const std::string& note : writer->notes()) std::cerr << note << "\n";
  return 0;
}
