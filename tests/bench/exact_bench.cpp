// Speed of exact reverse interpolation: the fast recogniser beside the per-step
// reference, and drawing its segments beside the plain loop. Verified: both
// recognisers find the same segments, and these draw the steps. The argument is
// the number of steps per segment of the lines the chain is made of; greedy
// segments are a little longer (steps_per_segment).

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

#include "reverse/fast_recogniser.h"
#include "reverse/segment_recogniser.h"
#include "unstep/interpolate.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

using Segments = std::vector<DigitalSegment>;

constexpr std::size_t kSteps = 1 << 20;

void verify(bool good) {
  if (!good) std::abort();
}

/// Lines of random slopes and phases in random octants.
std::vector<Step> chain_of(std::uint32_t length) {
  std::mt19937 random(1995);
  const auto below = [&random](std::uint32_t end) {
    return static_cast<std::uint32_t>(random() % end);
  };
  std::vector<Step> steps;
  while (steps.size() < kSteps) {
    const std::uint32_t n = length / 2 + below(length + 1) + 1;
    const std::uint32_t w = 2 + below(length);
    const auto s0 = static_cast<Step>(below(8));
    const DigitalSegment line{
        s0, static_cast<Step>((s0 + 1) % 8), n, below(w + 1), w, below(w)};
    const std::size_t before = steps.size();
    steps.resize(before + n);
    digital_segment_steps_reference(line, std::span(steps).subspan(before));
  }
  steps.resize(kSteps);
  return steps;
}

Segments by_letters(const std::vector<Step>& steps) {
  Segments segments;
  segments.reserve(steps.size() / 4);
  reverse::SegmentRecogniser open(Connectivity::eight);
  for (const Step step : steps) {
    if (open.push(step)) continue;
    segments.push_back(open.state().segment());
    open = reverse::SegmentRecogniser(Connectivity::eight);
    open.push(step);
  }
  segments.push_back(open.state().segment());
  return segments;
}

Segments by_comparing(const std::vector<Step>& steps) {
  Segments segments;
  segments.reserve(steps.size() / 4);
  const reverse::FastRecogniser fast(Connectivity::eight);
  const std::span<const Step> all(steps);
  for (std::size_t at = 0; at < steps.size(); at += segments.back().n)
    segments.push_back(fast.longest(all.subspan(at)).segment());
  return segments;
}

void count(benchmark::State& state, std::size_t steps, std::size_t segments) {
  state.SetItemsProcessed(static_cast<std::int64_t>(steps) *
                          state.iterations());
  state.counters["steps_per_segment"] =
      static_cast<double>(steps) / static_cast<double>(segments);
}

template <class Find>
void find(benchmark::State& state, Find find_segments) {
  const auto steps = chain_of(static_cast<std::uint32_t>(state.range(0)));
  const Segments expected = by_letters(steps);
  bool same = true;
  for (auto _ : state) {
    const Segments segments = find_segments(steps);
    same = same && segments.size() == expected.size() &&
           segments.back() == expected.back();
    benchmark::ClobberMemory();
  }
  verify(same && find_segments(steps) == expected);
  count(state, steps.size(), expected.size());
}

void reverse_per_step(benchmark::State& state) { find(state, by_letters); }
void reverse_fast(benchmark::State& state) { find(state, by_comparing); }

void reverse_exact_open(benchmark::State& state) {
  find(state, [](const std::vector<Step>& steps) {
    static Chain chain{{}, Connectivity::eight, false, {}};
    chain.steps = steps;
    return std::move(reverse_exact(chain)->segments);
  });
}

template <class Draw>
void draw(benchmark::State& state, Draw draw_segments) {
  const auto steps = chain_of(static_cast<std::uint32_t>(state.range(0)));
  const Segments segments = by_comparing(steps);
  std::vector<Step> out(steps.size());
  for (auto _ : state) {
    draw_segments(segments, out);
    benchmark::ClobberMemory();
  }
  verify(out == steps);
  count(state, steps.size(), segments.size());
}

void forward_plain(benchmark::State& state) {
  draw(state, [](const Segments& segments, std::span<Step> out) {
    for (const DigitalSegment& s : segments)
      out = out.subspan(digital_segment_steps_reference(s, out));
  });
}

void forward_bulk(benchmark::State& state) {
  draw(state, [](const Segments& segments, std::span<Step> out) {
    verify(interpolate(segments, out).operator bool());
  });
}

void lengths(benchmark::internal::Benchmark* bench) {
  for (const int length : {6, 46, 200, 1000, 100'000}) bench->Arg(length);
}
BENCHMARK(reverse_per_step)->Apply(lengths);
BENCHMARK(reverse_fast)->Apply(lengths);
BENCHMARK(reverse_exact_open)->Apply(lengths);
BENCHMARK(forward_plain)->Apply(lengths);
BENCHMARK(forward_bulk)->Apply(lengths);

}  // namespace
}  // namespace unstep

BENCHMARK_MAIN();
