// Speed of programs: reading, compaction, writing, in lines of the input per
// second. Files given by UNSTEP_PROGRAMS (a list with ":" between) are timed
// beside the generated ones. Every timed result is verified first.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "unstep/program.h"

namespace unstep {
namespace {

constexpr int kLines = 100'000;
constexpr double kTolerance = 0.005;

void verify(bool good) {
  if (!good) std::abort();
}

/// Smooth curves in pieces of about `step` mm, four decimals: what CAM writes.
std::string curves(double step) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::string text = "G21 G90\nG0 X0 Y0 Z0\nF600\n";
  double x = 0;
  double y = 0;
  double heading = 0;
  double bend = 0;
  for (int i = 0; i < kLines; ++i) {
    if (i % 50 == 0) bend = unit(random) * 0.2;
    heading += bend * step;
    x += step * std::cos(heading);
    y += step * std::sin(heading);
    char line[64];
    std::snprintf(line, sizeof line, "G1 X%.4f Y%.4f\n", x, y);
    text += line;
  }
  return text;
}

void set_lines(benchmark::State& state, const std::string& text) {
  state.SetItemsProcessed(std::count(text.begin(), text.end(), '\n') *
                          state.iterations());
}

void read(benchmark::State& state, const std::string& text) {
  verify(static_cast<bool>(read_gcode(text, {})));
  for (auto _ : state) benchmark::DoNotOptimize(read_gcode(text, {}));
  set_lines(state, text);
}

void read_and_compact(benchmark::State& state, const std::string& text) {
  CompactOptions options;
  options.tolerance_mm = kTolerance;
  CompactReport report;
  verify(static_cast<bool>(compact(*read_gcode(text, {}), options, &report)));
  verify(report.lines_after <= report.lines_before);
  for (auto _ : state) {
    const Result<Program> program = read_gcode(text, {});
    benchmark::DoNotOptimize(compact(*program, options));
  }
  state.counters["left"] = static_cast<double>(report.lines_after) /
                           static_cast<double>(report.lines_before);
  set_lines(state, text);
}

void write(benchmark::State& state, const std::string& text) {
  const Result<Program> program = read_gcode(text, {});
  verify(static_cast<bool>(program));
  for (auto _ : state) benchmark::DoNotOptimize(write_gcode(*program, {}));
  set_lines(state, text);
}

void add(const std::string& name, const std::string& text) {
  benchmark::RegisterBenchmark(("read/" + name).c_str(), read, text);
  benchmark::RegisterBenchmark(("read_and_compact/" + name).c_str(),
                               read_and_compact, text);
  benchmark::RegisterBenchmark(("write/" + name).c_str(), write, text);
}

void add_files() {
  const char* list = std::getenv("UNSTEP_PROGRAMS");
  std::string rest = list == nullptr ? "" : list;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string path = rest.substr(0, end);
    rest.erase(0, end + 1);
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)),
                           std::istreambuf_iterator<char>());
    verify(!text.empty());
    add(path.substr(path.rfind('/') + 1), text);
  }
}

}  // namespace
}  // namespace unstep

int main(int count, char** arguments) {
  unstep::add("curves_0.05mm", unstep::curves(0.05));
  unstep::add("curves_0.5mm", unstep::curves(0.5));
  unstep::add_files();
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
