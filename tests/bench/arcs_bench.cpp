#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "unstep/deviation.h"
#include "unstep/formats.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

/// arcs_bench IMAGE...: lines, lines and arcs, and the check of both over
/// the contours of the images at a tolerance of 1. Speeds are the best of
/// three. Exit code 1 if a bound is broken.
namespace {

using namespace unstep;

template <class Call>
double best_of_three(const Call& call) {
  double best = 1e30;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    const std::chrono::duration<double> spent =
        std::chrono::steady_clock::now() - start;
    best = std::min(best, spent.count());
  }
  return best;
}

Result<Drawing> contours_of(const std::string& name) {
  auto bytes = read_file(name, std::uint64_t{1} << 30);
  if (!bytes) return bytes.error();
  RasterReadOptions options;
  options.threshold = {Threshold::Kind::fixed, 128};
  Result<RasterReader> file = RasterReader::open(*std::move(bytes), options);
  if (!file) return file.error();
  Result<RasterPage> page = file->read(0);
  if (!page) return page.error();
  Drawing drawing;
  drawing.canvas = {page->ink.width(), page->ink.height(), YAxis::down};
  const Status traced = trace_contours(page->ink, [&](const Chain& chain) {
    drawing.chains.push_back(chain);
    return true;
  });
  if (!traced) return traced.error();
  return drawing;
}

struct Sums {
  std::uint64_t steps = 0;
  std::uint64_t lines = 0;
  std::uint64_t parts = 0;
  std::uint64_t arcs = 0;
  double line_time = 0;
  double arc_time = 0;
  double check_time = 0;
  bool sound = true;
};

void measure(const Drawing& drawing, Sums& sums) {
  for (const Chain& chain : drawing.chains) sums.steps += chain.steps.size();
  ToleranceOptions options;
  ToleranceReport report;
  options.arcs = false;
  sums.line_time += best_of_three([&] {
    sums.sound &=
        static_cast<bool>(reverse_tolerance(drawing, options, &report));
  });
  sums.lines += report.segments;
  options.arcs = true;
  Result<Drawing> made = Drawing();
  sums.arc_time += best_of_three(
      [&] { made = reverse_tolerance(drawing, options, &report); });
  sums.sound &= static_cast<bool>(made);
  if (!made) return;
  sums.parts += report.segments + report.arcs;
  sums.arcs += report.arcs;
  sums.check_time += best_of_three([&] {
    const Status status = check_deviation(drawing, *made, options.tolerance);
    if (!status) std::fprintf(stderr, "%s\n", status.error().message.c_str());
    sums.sound &= static_cast<bool>(status);
  });
}

}  // namespace

int main(int argc, char** argv) {
  Sums sums;
  const std::vector<std::string> names(argv + 1, argv + argc);
  for (const std::string& name : names) {
    const Result<Drawing> drawing = contours_of(name);
    if (!drawing) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(),
                   drawing.error().message.c_str());
      continue;
    }
    measure(*drawing, sums);
  }
  const auto speed = [&](double time) {
    return static_cast<double>(sums.steps) / time / 1e6;
  };
  std::printf(
      "| steps | lines | lines and arcs | arcs | ratio | lines, "
      "Msteps/s | with arcs | check |\n|---|---|---|---|---|---|---|---|\n");
  std::printf("| %llu | %llu | %llu | %llu | %.3f | %.1f | %.1f | %.1f |\n",
              static_cast<unsigned long long>(sums.steps),
              static_cast<unsigned long long>(sums.lines),
              static_cast<unsigned long long>(sums.parts),
              static_cast<unsigned long long>(sums.arcs),
              static_cast<double>(sums.parts) / static_cast<double>(sums.lines),
              speed(sums.line_time), speed(sums.arc_time),
              speed(sums.check_time));
  return sums.sound ? 0 : 1;
}
