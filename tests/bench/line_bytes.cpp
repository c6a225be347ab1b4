#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "borders.h"
#include "unstep/codec.h"
#include "unstep/deviation.h"
#include "unstep/formats.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

/// line_bytes FOLDER...: what lines cost, summed over the bilevel images of
/// each folder, whole files, proven by decoding: the border pixels of every
/// contour as 8-connected chains, and the contours as paths within a
/// tolerance.
///
/// line_bytes --rates FOLDER...: the ink exactly and as cheap lines within
/// tolerances from 1 to 4, a row of a table in Markdown for each folder.
namespace unstep::bench {
namespace {

namespace fs = std::filesystem;

struct Sum {
  std::uint64_t bytes = 0;
  std::uint64_t parts = 0;  ///< steps or elements
};

bool add_file(const Drawing& drawing, const Fidelity& fidelity, Sum& sum) {
  UstpWriter writer{EncodeOptions{}};
  const Status added = writer.add_page(drawing, {}, fidelity);
  if (!added) {
    std::fprintf(stderr, "%s\n", added.error().message.c_str());
    return false;
  }
  sum.bytes += writer.finish()->size();
  for (const Chain& chain : drawing.chains) sum.parts += chain.steps.size();
  for (const Path& path : drawing.paths) sum.parts += path.elements.size();
  return true;
}

bool measure(const Bitmap& ink, Sum& borders, std::vector<Sum>& paths) {
  Drawing contours;
  contours.canvas = {ink.width(), ink.height(), YAxis::down};
  Drawing chains = contours;
  const Status traced = trace_contours(ink, [&](const Chain& contour) {
    contours.chains.push_back(contour);
    chains.chains.push_back(border_of(contour));
    return true;
  });
  bool done = bool{traced} && add_file(chains, {}, borders);
  for (std::size_t i = 0; done && i < paths.size(); ++i) {
    ToleranceOptions options;
    options.tolerance = {static_cast<std::uint32_t>(i + 1), 1};
    const Result<Drawing> lines = reverse_tolerance(contours, options);
    done = bool{lines} &&
           add_file(*lines, {Fidelity::Kind::tolerance, options.tolerance},
                    paths[i]);
  }
  return done;
}

/// Calls work with the first page of every image of a folder, by name. False
/// if one of them fails.
template <class Work>
bool for_images(const fs::path& folder, Work work) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in),
                                          {}};
    Result<RasterReader> reader = RasterReader::open(bytes, {});
    if (!reader) continue;  // not an image
    const Result<RasterPage> page = reader->read(0);
    if (!page || !work(page->ink)) return false;
  }
  return true;
}

constexpr std::array<Rational, 5> kRates{
    {{1, 1}, {3, 2}, {2, 1}, {3, 1}, {4, 1}}};

/// The bytes of the ink and of its lines, which are checked.
bool add_rates(const Bitmap& ink, std::uint64_t& exact,
               std::array<Sum, kRates.size()>& rates) {
  UstpWriter writer{EncodeOptions{}};
  if (!writer.add_page(ink, {})) return false;
  exact += writer.finish()->size();
  Drawing contours;
  contours.canvas = {ink.width(), ink.height(), YAxis::down};
  const Status traced = trace_contours(ink, [&](const Chain& contour) {
    contours.chains.push_back(contour);
    return true;
  });
  for (std::size_t i = 0; traced && i < kRates.size(); ++i) {
    ToleranceOptions options;
    options.tolerance = kRates[i];
    options.aim = LineAim::few_bytes;
    options.arcs = false;
    const Result<Drawing> lines = reverse_tolerance(contours, options);
    if (!lines || !check_deviation(contours, *lines, options.tolerance) ||
        !add_file(*lines, {Fidelity::Kind::tolerance, options.tolerance},
                  rates[i])) {
      return false;
    }
  }
  return bool{traced};
}

bool print_rates(const fs::path& folder) {
  std::uint64_t exact = 0;
  std::array<Sum, kRates.size()> rates;
  if (!for_images(folder, [&](const Bitmap& ink) {
        return add_rates(ink, exact, rates);
      })) {
    return false;
  }
  std::printf("| %s | %llu |", folder.filename().c_str(),
              static_cast<unsigned long long>(exact));
  for (const Sum& rate : rates) {
    std::printf(" %llu | %.3f |", static_cast<unsigned long long>(rate.bytes),
                static_cast<double>(rate.bytes) /
                    static_cast<double>(std::max<std::uint64_t>(exact, 1)));
  }
  std::printf("\n");
  return true;
}

bool measure_folder(const fs::path& folder) {
  Sum borders;
  std::vector<Sum> paths(2);
  std::size_t count = 0;
  if (!for_images(folder, [&](const Bitmap& ink) {
        ++count;
        return measure(ink, borders, paths);
      })) {
    return false;
  }
  std::printf(
      "%-12s %4zu files  borders %9llu bytes %7.4f bit/step",
      folder.filename().c_str(), count,
      static_cast<unsigned long long>(borders.bytes),
      8.0 * static_cast<double>(borders.bytes) /
          static_cast<double>(std::max<std::uint64_t>(borders.parts, 1)));
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::printf(
        "  e=%zu %8llu bytes %8llu elements %6.4f", i + 1,
        static_cast<unsigned long long>(paths[i].bytes),
        static_cast<unsigned long long>(paths[i].parts),
        static_cast<double>(paths[i].bytes) /
            static_cast<double>(std::max<std::uint64_t>(paths[i].parts, 1)));
  }
  std::printf("\n");
  return true;
}

}  // namespace
}  // namespace unstep::bench

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: line_bytes [--rates] FOLDER...\n");
    return 2;
  }
  const bool rates = std::strcmp(argv[1], "--rates") == 0;
  for (int i = rates ? 2 : 1; i < argc; ++i) {
    if (!(rates ? unstep::bench::print_rates(argv[i])
                : unstep::bench::measure_folder(argv[i]))) {
      return 1;
    }
  }
}
