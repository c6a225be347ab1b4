#include <cstddef>
#include <string>
#include <vector>

#include "fuzz/target.h"
#include "reverse/fast_recogniser.h"
#include "reverse/segment_recogniser.h"
#include "unstep/interpolate.h"
#include "unstep/reverse.h"

/// Both recognisers agree step for step, and their segments draw the steps. 1
/// byte of choices, then groups of bytes: one that says what follows, then a
/// line (s0 and s1, n, a, w, r in a byte each) or a step for each byte.
namespace unstep::fuzz {
namespace {

std::vector<Step> chain_of(std::span<const std::uint8_t> input, unsigned unit) {
  const auto code = [unit](unsigned v) {
    return static_cast<Step>(v * unit % 8);
  };
  std::vector<Step> steps;
  while (!input.empty()) {
    const std::uint8_t what = input[0];
    input = input.subspan(1);
    if (what >= 128 && input.size() >= 4) {
      const std::uint32_t n = input[0] + 1U + 16U * (what & 31);
      const std::uint32_t w = input[1] + 1U;
      const DigitalSegment line{
          code(what), code(what + 1U + 6U * (what >> 6 & 1)),
          n,          input[2] % (w + 1),
          w,          input[3] % w};
      const std::size_t before = steps.size();
      steps.resize(before + n);
      digital_segment_steps_reference(line, std::span(steps).subspan(before));
      input = input.subspan(4);
      continue;
    }
    steps.push_back(code(what));
  }
  return steps;
}

std::vector<DigitalSegment> compare(const std::vector<Step>& steps,
                                    Connectivity connectivity) {
  std::vector<DigitalSegment> segments;
  const reverse::FastRecogniser fast(connectivity);
  const std::span<const Step> all(steps);
  for (std::size_t at = 0; at < steps.size(); at += segments.back().n) {
    reverse::SegmentRecogniser open(connectivity);
    for (std::size_t i = at; i < steps.size() && open.push(steps[i]);) ++i;
    require(fast.longest(all.subspan(at)) == open.state(),
            "both recognisers end in the same state");
    segments.push_back(open.state().segment());
  }
  return segments;
}

void round_trip(const std::vector<Step>& steps, Connectivity connectivity,
                bool closed) {
  const auto segments = compare(steps, connectivity);
  std::vector<Step> drawn(steps.size());
  for (const DigitalSegment& segment : segments)
    require(static_cast<bool>(validate(segment)), "segments are valid");
  const auto count = interpolate(segments, drawn);
  require(count && *count == steps.size() && drawn == steps,
          "segments draw their steps");
  const auto whole = reverse_exact({{}, connectivity, closed, steps});
  require(static_cast<bool>(whole), "any chain has segments");
  require(whole->segments.size() <= segments.size(),
          "the start of a closed chain is no worse than the first step");
  require(closed || whole->segments == segments, "open chains are greedy");
  const auto again = interpolate(whole->segments, drawn);
  require(again && *again == steps.size(), "a lap is a lap");
  for (std::size_t i = 0; i < steps.size(); ++i)
    require(drawn[i] == steps[(whole->start + i) % steps.size()],
            "the lap begins at its start");
}

/// Values from anywhere are refused or drawn as the plain loop does.
void draw_any(std::span<const std::uint8_t> input) {
  DigitalSegment s;
  const auto number = [&] {
    std::uint32_t v = 0;
    for (int i = 0; i < 4; ++i) v = v << 8 | input[static_cast<std::size_t>(i)];
    input = input.subspan(4);
    return v;
  };
  s = {input[0], input[1], input[2], 0, 0, 0};
  input = input.subspan(3);
  s.a = number();
  s.w = number();
  s.r = number();
  std::vector<Step> out(255);
  const auto count = interpolate(std::span(&s, 1), out);
  require(count.operator bool() == validate(s).operator bool(),
          "what is valid is drawn");
  if (!count) return require_sound(count.error());
  std::vector<Step> plain(255);
  digital_segment_steps_reference(s, plain);
  for (std::size_t i = 0; i < s.n; ++i)
    require(out[i] == plain[i], "steps of the plain loop");
}

}  // namespace
}  // namespace unstep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace unstep;
  if (size < 1 || size > 4096) return 0;
  const std::span<const std::uint8_t> input(data, size);
  const bool four = (input[0] & 1) != 0;
  fuzz::round_trip(fuzz::chain_of(input.subspan(1), four ? 2 : 1),
                   four ? Connectivity::four : Connectivity::eight,
                   (input[0] & 2) != 0);
  if (size >= 16) fuzz::draw_any(input.last(15));
  return 0;
}
