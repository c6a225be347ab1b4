#include <cstddef>
#include <utility>
#include <vector>

#include "fuzz/target.h"
#include "unit/frechet_oracle.h"
#include "unstep/deviation.h"
#include "unstep/reverse.h"

/// Lines within a tolerance: 1 byte of tolerance, 1 of options, 3 bits of every
/// other byte a step. The path keeps the bound by the checker that was
/// written apart from it, and one chain alone gives the same path.
namespace unstep::fuzz {
namespace {

/// A closed chain goes back the way it came.
Chain chain_of(std::span<const std::uint8_t> steps, std::uint8_t choice) {
  Chain chain;
  chain.connectivity =
      (choice & 1) != 0 ? Connectivity::four : Connectivity::eight;
  const int codes = (choice & 1) != 0 ? 6 : 7;
  for (const std::uint8_t step : steps) {
    chain.steps.push_back(static_cast<Step>(step & codes));
  }
  if ((choice & 2) != 0) {
    for (std::size_t i = steps.size(); i > 0; --i) {
      chain.steps.push_back(static_cast<Step>((chain.steps[i - 1] + 4) % 8));
    }
    chain.closed = true;
  }
  return chain;
}

void check(const Chain& chain, const ToleranceOptions& options) {
  Drawing drawing;
  drawing.chains.push_back(chain);
  ToleranceReport report;
  const auto lines = reverse_tolerance(drawing, options, &report);
  require(static_cast<bool>(lines), "a valid chain can be reversed");
  require(lines->paths.size() == 1, "one path for each chain");
  const Path& path = lines->paths.front();
  require(path.closed == chain.closed, "closed stays closed");
  require(report.segments + report.arcs == path.elements.size(),
          "the report counts the path's elements");
  // A ring that comes to its start more than once may fall to the checker's
  // thorough form, which refuses what is exactly at the bound.
  const Rational e = options.tolerance;
  require(check_deviation(drawing, *lines, e) ||
              (report.arcs == 0 &&
               testing::path_within(
                   chain, YAxis::down, path, lines->scale,
                   static_cast<long double>(e.numerator) / e.denominator)),
          "the path keeps the bound");
  const auto alone = reverse_tolerance(chain, drawing.canvas.y_axis, options);
  require(alone && *alone == path, "one chain alone gives the same path");
}

}  // namespace
}  // namespace unstep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size < 2 || size > 600) return 0;
  unstep::ToleranceOptions options;
  options.tolerance = {data[0] + 1U, 32};
  options.effort =
      (data[1] & 4) != 0 ? unstep::Effort::max : unstep::Effort::standard;
  options.arcs = (data[1] & 8) != 0;
  const std::span<const std::uint8_t> input(data, size);
  unstep::fuzz::check(unstep::fuzz::chain_of(input.subspan(2), data[1]),
                      options);
  return 0;
}
