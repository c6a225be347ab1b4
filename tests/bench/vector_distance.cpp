// How far the lines of an SVG file are from the contours of a raster: the
// larger of both Hausdorff distances, in pixels.
//
//     vector_distance PAGE.pbm TRACE.svg
//
// potrace writes y upwards under a transform, which reading resolves.
#include <algorithm>
#include <cstdio>
#include <string_view>

#include "unstep/deviation.h"
#include "unstep/formats.h"
#include "unstep/trace.h"

namespace {

using namespace unstep;

Result<Drawing> contours_of(const char* name) {
  Result<std::vector<std::uint8_t>> bytes = read_file(name, 1U << 30);
  if (!bytes) return bytes.error();
  Result<RasterReader> file = RasterReader::open(*std::move(bytes), {});
  if (!file) return file.error();
  const Result<RasterPage> page = file->read(0);
  if (!page) return page.error();
  Drawing drawing;
  drawing.canvas = {page->ink.width(), page->ink.height(), YAxis::down};
  const Status traced = trace_contours(page->ink, [&](const Chain& contour) {
    drawing.chains.push_back(contour);
    return true;
  });
  if (!traced) return traced.error();
  return drawing;
}

Result<Drawing> paths_of(const char* name) {
  const Result<std::vector<std::uint8_t>> bytes = read_file(name, 1U << 30);
  if (!bytes) return bytes.error();
  VectorReadOptions options;
  options.curve_tolerance = 0.01;
  Result<std::vector<VectorPage>> pages =
      read_vector({reinterpret_cast<const char*>(bytes->data()), bytes->size()},
                  VectorFormat::svg, options);
  if (!pages) return pages.error();
  return std::move(pages->front().drawing);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: vector_distance PAGE.pbm TRACE.svg\n", stderr);
    return 2;
  }
  const Result<Drawing> chains = contours_of(argv[1]);
  const Result<Drawing> paths = paths_of(argv[2]);
  if (!chains || !paths) {
    std::fprintf(stderr, "%s\n",
                 (chains ? paths.error() : chains.error()).message.c_str());
    return 3;
  }
  const Result<Distance> found = measure_distance(*chains, *paths, 0.25);
  if (!found) {
    std::fprintf(stderr, "%s\n", found.error().message.c_str());
    return 3;
  }
  std::printf("%.4f\n",
              std::max(found->of_chains.distance, found->of_paths.distance));
  return 0;
}
