#pragma once

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "unstep/formats.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

namespace unstep::bench {

/// The first page of a bilevel image as lines that cost few bytes, by itself;
/// nothing if it is no image.
inline std::vector<Drawing> cheap_drawings(const std::string& file,
                                           ToleranceOptions options) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
  Result<RasterReader> reader = RasterReader::open(bytes, {});
  if (!reader) return {};
  const Result<RasterPage> page = reader->read(0);
  if (!page) return {};
  Drawing contours;
  contours.canvas = {page->ink.width(), page->ink.height(), YAxis::down};
  const Status traced = trace_contours(page->ink, [&](const Chain& contour) {
    contours.chains.push_back(contour);
    return true;
  });
  options.aim = LineAim::few_bytes;
  Result<Drawing> lines = reverse_tolerance(contours, options);
  if (!traced || !lines) return {};
  return {*std::move(lines)};
}

}  // namespace unstep::bench
