// Lines within a tolerance over a folder of images: speed, steps per line and
// the ratio to the fewest lines with vertices on the chain.
//
//     tolerance_bench [--tolerance N/D] FOLDER...
//
// A row per folder. Contours of every image, one drawing each; every result
// passes check_deviation. Processor time, the best of five rounds; `lines only`
// is the one-pass fit alone, `drawing` has the search for crossings too. The
// fewest lines are sought for rings of up to 2048 steps, and the ratio counts
// these alone. The heap keeps what it has: memory that is given back after each
// drawing and taken again would cost more than some of the work.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "reverse/tolerance_optimum.h"
#include "unstep/deviation.h"
#include "unstep/formats.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

namespace {

namespace fs = std::filesystem;
using namespace unstep;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::vector<Drawing> load(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Drawing> drawings;
  for (const fs::path& file : files) {
    auto bytes = read_file(file.string(), std::uint64_t{1} << 30);
    if (!bytes) continue;
    auto reader = RasterReader::open(*std::move(bytes), {});
    if (!reader) continue;
    const auto page = reader->read(0);
    if (!page) continue;
    Drawing drawing;
    (void)trace_contours(page->ink, [&](const Chain& contour) {
      drawing.chains.push_back(contour);
      return true;
    });
    drawings.push_back(std::move(drawing));
  }
  return drawings;
}

template <class Work>
double best_of_five(const Work& work) {
  double best = 1e9;
  for (int round = 0; round < 5; ++round) {
    const double start = seconds();
    work();
    best = std::min(best, seconds() - start);
  }
  return best;
}

bool measure(const fs::path& folder, const ToleranceOptions& options) {
  const std::vector<Drawing> drawings = load(folder);
  double steps = 0;
  ToleranceReport total;
  double fitted = 0;
  double fewest = 0;
  const reverse::PathTolerance fixed{
      (std::int64_t{options.tolerance.numerator} << 12) /
      options.tolerance.denominator};
  for (const Drawing& drawing : drawings) {
    ToleranceReport report;
    const auto lines = reverse_tolerance(drawing, options, &report);
    if (!lines) return false;
    if (const Status s = check_deviation(drawing, *lines, options.tolerance);
        !s) {
      std::fprintf(stderr, "%s\n", s.error().message.c_str());
      return false;
    }
    total.segments += report.segments;
    total.refined += report.refined;
    for (const Chain& chain : drawing.chains) {
      steps += static_cast<double>(chain.steps.size());
      if (chain.steps.size() > reverse::kSearchWindow) continue;
      const reverse::ChainWalk walk(chain, YAxis::down, 1);
      fitted += static_cast<double>(reverse::fit_lines(walk, fixed).size() - 1);
      fewest += static_cast<double>(
          reverse::fit_fewest_lines(walk, fixed).size() - 1);
    }
  }
  const auto near =
      fixed.fixed > reverse::NearDirections::kMaxTolerance
          ? nullptr
          : std::make_unique<const reverse::NearDirections>(fixed);
  const double one_pass = best_of_five([&] {
    reverse::LookMemory memory(static_cast<std::size_t>(steps));
    for (const Drawing& drawing : drawings) {
      for (const Chain& chain : drawing.chains) {
        (void)reverse::fit_lines({chain, YAxis::down, 1}, fixed, near.get(),
                                 &memory);
      }
    }
  });
  const double whole = best_of_five([&] {
    for (const Drawing& drawing : drawings) {
      (void)reverse_tolerance(drawing, options);
    }
  });
  std::printf("| %s | %.0f | %.2f | %.3f | %.1f | %.1f | %llu |\n",
              folder.filename().c_str(), steps,
              steps / static_cast<double>(total.segments), fitted / fewest,
              steps / one_pass / 1e6, steps / whole / 1e6,
              static_cast<unsigned long long>(total.refined));
  return true;
}

}  // namespace

int main(int argc, char** argv) {
#ifdef __GLIBC__
  (void)mallopt(M_MMAP_THRESHOLD, 1 << 30);
  (void)mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
  ToleranceOptions options;
  options.arcs = false;
  int first = 1;
  if (argc > 2 && std::string(argv[1]) == "--tolerance") {
    unsigned n = 1;
    unsigned d = 1;
    if (std::sscanf(argv[2], "%u/%u", &n, &d) < 1 || d == 0 || n < d) {
      std::fprintf(stderr, "a tolerance of at least 1, N or N/D\n");
      return 2;
    }
    options.tolerance = {n, d};
    first = 3;
  }
  std::printf(
      "| set | steps | steps per line | lines / fewest | Msteps/s, lines only "
      "| Msteps/s, drawing | refined |\n|---|---|---|---|---|---|---|\n");
  for (int i = first; i < argc; ++i) {
    if (!measure(argv[i], options)) return 1;
  }
  return 0;
}
