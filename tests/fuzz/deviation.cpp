#include "unstep/deviation.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/target.h"

/// A chain and a path of any kind: the exact decision and the measured distance
/// agree. 4 bytes of choices, 1 of the number of steps, the steps, then 5 bytes
/// for each element.
namespace unstep::fuzz {
namespace {

constexpr double kFound = 1.0 / 1024;  // twice what a measure is exact to

Path::Element element_of(std::span<const std::uint8_t> bytes) {
  const auto number = [&](std::size_t i) {
    return static_cast<std::int32_t>(static_cast<std::int8_t>(bytes[i])) / 4;
  };
  Path::Element element;
  const Point end{number(1), number(2)};
  const Point centre{number(3), number(4)};
  if (bytes[0] % 2 == 0 || (centre == Point{} && end == Point{})) {
    element.segment = {end.x, end.y};
    return element;
  }
  element.kind = Path::Kind::arc;
  element.arc = {centre, end, (bytes[0] & 2) != 0};
  return element;
}

Point end_of(const Path& path) {
  Point at{};
  for (const Path::Element& element : path.elements) {
    const bool line = element.kind == Path::Kind::segment;
    at.x += line ? element.segment.dx : element.arc.end.x;
    at.y += line ? element.segment.dy : element.arc.end.y;
  }
  return at;
}

Point end_of(const Chain& chain, YAxis axis) {
  Point at{};
  for (const Step step : chain.steps) {
    const Point delta = step_delta(step, axis);
    at = {at.x + delta.x, at.y + delta.y};
  }
  return at;
}

void compare(std::span<const std::uint8_t> input) {
  Drawing chains;
  Drawing paths;
  chains.canvas.y_axis = (input[0] & 1) != 0 ? YAxis::up : YAxis::down;
  const bool closed = (input[0] & 2) != 0;
  paths.scale = 1 + input[1] % 9;
  const Rational tolerance{input[2], 1U + input[3] % 64};
  Chain chain;
  Path path;
  chain.closed = path.closed = closed;
  const std::size_t steps = std::min<std::size_t>(input[4], input.size() - 5);
  for (const std::uint8_t byte : input.subspan(5, steps))
    chain.steps.push_back(byte % 8);
  auto rest = input.subspan(5 + steps);
  for (; rest.size() >= 5 && path.elements.size() < 24; rest = rest.subspan(5))
    path.elements.push_back(element_of(rest.first(5)));
  if (closed) {  // both return
    for (std::size_t i = steps; i-- > 0;)
      chain.steps.push_back(chain.steps[i] ^ 4);
    const Point end = end_of(path);
    path.elements.push_back({Path::Kind::segment, {-end.x, -end.y}, {}});
  }
  require(!closed || end_of(chain, chains.canvas.y_axis) == Point{},
          "there and back is closed");
  chains.chains = {chain};
  paths.paths = {path};

  const auto found = measure_deviation(chains, paths);
  require(static_cast<bool>(found), "any pair can be measured");
  const Status within = check_deviation(chains, paths, tolerance);
  require(within || within.error().code == ErrorCode::corrupt,
          "any pair can be decided");
  const double most = static_cast<double>(tolerance.numerator) /
                      static_cast<double>(tolerance.denominator);
  if (found->distance <= most - kFound)
    require(static_cast<bool>(within), "what is measured within is accepted");
  // Of a closed chain either form may know a better start.
  if (within && !closed)
    require(found->distance <= most + kFound, "what is beyond is refused");
}

}  // namespace
}  // namespace unstep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size < 5 || size > 256) return 0;
  unstep::fuzz::compare(std::span<const std::uint8_t>(data, size));
  return 0;
}
