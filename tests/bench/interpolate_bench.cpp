// Speed of interpolation: the bulk form beside the plain per-step loop and
// beside cv::LineIterator, device reverse beside a loop that only reads the
// steps, and the worst single push. Every timed result is verified first.
// Built with -O2 or more; see docs/algorithms.md for the figures.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "unstep/interpolate.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

// Segments of a smooth chain, `length` steps each on average.
std::vector<Segment> chain_of(std::int32_t length, std::size_t steps) {
  std::mt19937 random(10);
  std::vector<Segment> segments;
  for (std::size_t total = 0; total < steps;) {
    const auto n = static_cast<std::int32_t>(
        length / 2 + static_cast<std::int32_t>(
                         random() % static_cast<unsigned>(length + 1)));
    const auto x =
        static_cast<std::int32_t>(random() % static_cast<unsigned>(n + 1));
    const Segment s{random() % 2 == 0 ? x : -x,
                    random() % 2 == 0 ? n - x : x - n};
    segments.push_back(s);
    total += static_cast<std::size_t>(n);
  }
  return segments;
}

std::size_t total_steps(Method method, const std::vector<Segment>& segments) {
  std::size_t total = 0;
  for (const Segment s : segments)
    total += static_cast<std::size_t>(step_count(method, s));
  return total;
}

std::size_t plain(const std::vector<Segment>& segments, std::span<Step> out) {
  std::size_t n = 0;
  for (const Segment s : segments)
    n += device_steps_reference(s, out.subspan(n));
  return n;
}

void verify(bool good) {
  if (!good) std::abort();
}

constexpr std::size_t kSteps = 1 << 20;

void set_steps(benchmark::State& state, std::size_t steps) {
  state.SetItemsProcessed(static_cast<std::int64_t>(steps) *
                          state.iterations());
}

void forward_plain_loop(benchmark::State& state) {
  const auto segments =
      chain_of(static_cast<std::int32_t>(state.range(0)), kSteps);
  std::vector<Step> out(total_steps(Method::device, segments));
  for (auto _ : state) {
    benchmark::DoNotOptimize(plain(segments, out));
    benchmark::ClobberMemory();
  }
  set_steps(state, out.size());
}
BENCHMARK(forward_plain_loop)->Arg(10)->Arg(100)->Arg(100'000);

void forward_bulk(benchmark::State& state, Method method) {
  const auto segments =
      chain_of(static_cast<std::int32_t>(state.range(0)), kSteps);
  std::vector<Step> out(total_steps(method, segments));
  if (method == Method::device) {
    std::vector<Step> expected(out.size());
    verify(plain(segments, expected) == out.size());
    verify(interpolate(method, segments, out) && out == expected);
  }
  for (auto _ : state) {
    auto n = interpolate(method, segments, out);
    benchmark::DoNotOptimize(n);
    benchmark::ClobberMemory();
  }
  set_steps(state, out.size());
}
BENCHMARK_CAPTURE(forward_bulk, device, Method::device)
    ->Arg(10)
    ->Arg(100)
    ->Arg(100'000);
BENCHMARK_CAPTURE(forward_bulk, evaluation, Method::evaluation)
    ->Arg(10)
    ->Arg(100'000);
BENCHMARK_CAPTURE(forward_bulk, evaluation8, Method::evaluation8)
    ->Arg(10)
    ->Arg(100'000);

// The same long lines through OpenCV, in memory order of nothing: pointer mode
// off, positions only.
void line_iterator(benchmark::State& state, int connectivity) {
  const auto segments =
      chain_of(static_cast<std::int32_t>(state.range(0)), kSteps);
  std::size_t steps = 0;
  for (auto _ : state) {
    steps = 0;
    for (const Segment s : segments) {
      cv::LineIterator line(cv::Point(0, 0), cv::Point(s.dx, s.dy),
                            connectivity);
      const int n = line.count - 1;
      cv::Point sum;
      for (int i = 0; i < n; ++i, ++line) sum += line.pos();
      benchmark::DoNotOptimize(sum);
      steps += static_cast<std::size_t>(n);
    }
  }
  set_steps(state, steps);
}
BENCHMARK_CAPTURE(line_iterator, four, 4)->Arg(100'000);
BENCHMARK_CAPTURE(line_iterator, eight, 8)->Arg(100'000);

// The pixel pointers of a raster, as a drawing routine uses the iterator.
void line_iterator_pointers(benchmark::State& state, int connectivity) {
  const cv::Mat raster = cv::Mat::zeros(4096, 4096, CV_8UC1);
  std::mt19937 random(2);
  std::vector<std::pair<cv::Point, cv::Point>> lines;
  for (int i = 0; i < 64; ++i) {
    const auto at = [&random] { return static_cast<int>(random() % 4096); };
    lines.emplace_back(cv::Point(at(), at()), cv::Point(at(), at()));
  }
  std::size_t steps = 0;
  for (auto _ : state) {
    steps = 0;
    for (const auto& [from, to] : lines) {
      cv::LineIterator line(raster, from, to, connectivity);
      const int n = line.count - 1;
      std::uintptr_t sum = 0;
      for (int i = 0; i < n; ++i, ++line)
        sum += reinterpret_cast<std::uintptr_t>(*line);
      benchmark::DoNotOptimize(sum);
      steps += static_cast<std::size_t>(n);
    }
  }
  set_steps(state, steps);
}
BENCHMARK_CAPTURE(line_iterator_pointers, four, 4);
BENCHMARK_CAPTURE(line_iterator_pointers, eight, 8);

std::vector<Step> smooth_chain() {
  std::vector<Step> steps(kSteps + 64);
  const auto segments = chain_of(40, kSteps);
  steps.resize(total_steps(Method::evaluation, segments));
  verify(interpolate(Method::evaluation, segments, steps).operator bool());
  return steps;
}

void read_steps_only(benchmark::State& state) {
  const auto steps = smooth_chain();
  for (auto _ : state) {
    std::uint64_t sum = 0;
    for (const Step step : steps) {
      sum += step;
      benchmark::DoNotOptimize(sum);
    }
  }
  set_steps(state, steps.size());
}
BENCHMARK(read_steps_only);

void device_reverse(benchmark::State& state) {
  const auto steps = smooth_chain();
  std::size_t segments = 0;
  for (auto _ : state) {
    DeviceReverse device;
    Segment closed;
    segments = 0;
    for (const Step step : steps)
      segments += device.push(step, closed) == Pushed::segment;
    segments += device.finish(closed);
    benchmark::DoNotOptimize(segments);
  }
  const auto expected = reverse_device(steps);
  verify(expected && expected->size() == segments);
  set_steps(state, steps.size());
  state.counters["steps_per_segment"] =
      static_cast<double>(steps.size()) / static_cast<double>(segments);
}
BENCHMARK(device_reverse);

// Ten million pushes timed one by one; the clock's own cost is in every one.
void worst_single_push(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t kPushes = 10'000'000;
  const auto steps = smooth_chain();
  std::vector<std::uint32_t> nanoseconds(kPushes);
  for (auto _ : state) {
    DeviceReverse device;
    Segment closed;
    for (std::size_t i = 0; i < kPushes; ++i) {
      const Step step = steps[i % steps.size()];
      const auto before = Clock::now();
      benchmark::DoNotOptimize(device.push(step, closed));
      const auto after = Clock::now();
      nanoseconds[i] = static_cast<std::uint32_t>(
          std::chrono::nanoseconds(after - before).count());
    }
  }
  std::sort(nanoseconds.begin(), nanoseconds.end());
  const auto at = [&nanoseconds](double part) {
    return static_cast<double>(
        nanoseconds[static_cast<std::size_t>(part * (kPushes - 1))]);
  };
  state.counters["p50_ns"] = at(0.5);
  state.counters["p99.999_ns"] = at(0.99999);
  state.counters["max_ns"] = at(1);
  set_steps(state, kPushes);
}
BENCHMARK(worst_single_push)->Iterations(1);

}  // namespace
}  // namespace unstep

BENCHMARK_MAIN();
