#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "unstep/step_stream.h"

/// Steps of programs, made and written in the binary form.
namespace unstep {
namespace {

/// Lines of `steps` steps in all directions.
Program lines(int steps) {
  std::string text = "G21 G90\nG0 X0 Y0\nG91\n";
  for (int i = 0; i < 2'000'000 / steps + 2; ++i) {
    const double angle = 2.4 * i;
    text += "G1 X" + std::to_string(steps / 100.0 * std::cos(angle)) + " Y" +
            std::to_string(steps / 100.0 * std::sin(angle)) + " F600\n";
  }
  return *read_gcode(text, {});
}

void write(benchmark::State& state, const Program& program,
           const StepMakeOptions& options) {
  std::uint64_t steps = 0;
  std::uint64_t bytes = 0;
  for (auto _ : state) {
    Result<StepWriter> writer = StepWriter::create(
        StepFormat::binary, step_head(options), [&](std::string_view more) {
          bytes += more.size();
          return Status();
        });
    const Status made = make_steps(program, options, [&](const StepRun& run) {
      steps += run.words.size();
      return writer->add(run);
    });
    if (!made || !writer->finish()) state.SkipWithError("no steps");
  }
  state.counters["steps"] = benchmark::Counter(static_cast<double>(steps),
                                               benchmark::Counter::kIsRate);
  state.counters["bits_per_step"] =
      8.0 * static_cast<double>(bytes) / static_cast<double>(steps);
}

void lines_written(benchmark::State& state) {
  write(state, lines(static_cast<int>(state.range(0))), {});
}
BENCHMARK(lines_written)->Arg(20)->Arg(300)->Arg(5000)->Arg(200000);

/// Turns of a radius of so many steps, and one more for each.
void circles_written(benchmark::State& state) {
  const auto radius = state.range(0);
  std::string text = "G0 X0 Y0\n";
  for (std::int64_t i = 0; i < 400'000 / radius + 1; ++i) {
    text +=
        "G2 I" + std::to_string(static_cast<double>(radius) / 100) + " J0.03\n";
  }
  write(state, *read_gcode(text, {}), {});
}
BENCHMARK(circles_written)->Arg(20)->Arg(300)->Arg(8000);

void timed_lines_written(benchmark::State& state) {
  StepMakeOptions options;
  options.timed = true;
  write(state, lines(static_cast<int>(state.range(0))), options);
}
BENCHMARK(timed_lines_written)->Arg(20)->Arg(300)->Arg(5000);

void lines_of_three_axes_written(benchmark::State& state) {
  StepMakeOptions options;
  options.axes = 3;
  write(state, lines(300), options);
}
BENCHMARK(lines_of_three_axes_written);

void lines_reversed(benchmark::State& state) {
  const StepStream stream =
      *make_steps(lines(static_cast<int>(state.range(0))), StepMakeOptions{});
  std::uint64_t steps = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reverse_steps(stream, {}));
    for (const StepRun& run : stream.runs) steps += run.words.size();
  }
  state.counters["steps"] = benchmark::Counter(static_cast<double>(steps),
                                               benchmark::Counter::kIsRate);
}
BENCHMARK(lines_reversed)->Arg(300)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace unstep

BENCHMARK_MAIN();
