// Forward interpolation of digital straight segments.
//
// Why it is fast: the remainder of step i, (a i + r) mod w, decides it, and the
// remainders sixteen steps on differ by 16 a mod w. So sixteen neighbouring
// remainders advance side by side by one addition and one correction each, in
// lanes as narrow as w allows, and nothing waits for the step before. The first
// sixteen come from multiplications by 1 / w while w is small.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "interpolate/lanes.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

using interpolation::kBlock;

/// Bit s1 of [s0]: the two may share a segment.
constexpr auto kPartners = [] {
  std::array<std::uint8_t, 8> partners{};
  for (unsigned s0 = 0; s0 < 8; ++s0) {
    for (unsigned s1 = 0; s1 < 8; ++s1) {
      const unsigned apart = (s0 - s1) & 7;
      const bool four = s0 % 2 == 0 && (apart == 2 || apart == 6);
      if (apart <= 1 || apart == 7 || four)
        partners[s0] = static_cast<std::uint8_t>(partners[s0] | 1U << s1);
    }
  }
  return partners;
}();

bool share_a_segment(Step s0, Step s1) {
  return (s0 | s1) <= 7 && (kPartners[s0 & 7] >> (s1 & 7) & 1) != 0;
}

bool is_valid(const DigitalSegment& s) {
  return share_a_segment(s.s0, s.s1) && s.n >= 1 && s.a <= s.w && s.r < s.w;
}

/// Whole blocks while there is room for them.
template <class Lane>
void draw(const DigitalSegment& s, std::span<Step> out) {
  interpolation::LaneRule<Lane> rule(s);
  interpolation::Lanes<Lane> lanes(s, rule);
  std::size_t at = 0;
  for (; at < s.n && out.size() - at >= kBlock; at += kBlock) {
    lanes.draw(rule, out.data() + at);
    lanes.advance(rule);
  }
  if (at >= s.n) return;
  std::array<Step, kBlock> last;
  lanes.draw(rule, last.data());
  std::memcpy(out.data() + at, last.data(), s.n - at);
}

/// `out` is the rest of the output, at least n steps.
void draw_segment(const DigitalSegment& s, std::span<Step> out) {
  if (s.a == 0 || s.a == s.w) {
    std::memset(out.data(), s.a == 0 ? s.s0 : s.s1, s.n);
  } else if (s.w < 1U << 15) {
    draw<std::int16_t>(s, out);
  } else if (s.w < 1U << 31) {
    draw<std::int32_t>(s, out);
  } else {
    draw<std::int64_t>(s, out);
  }
}

std::string place(std::size_t i) {
  return "segment " + std::to_string(i) + ": ";
}

}  // namespace

Status validate(const DigitalSegment& s) {
  if (is_valid(s)) return {};
  const auto number = [](std::uint32_t v) { return std::to_string(v); };
  const auto bad = [](const std::string& reason) {
    return Error{ErrorCode::invalid_argument, reason};
  };
  if (!share_a_segment(s.s0, s.s1))
    return bad("steps " + number(s.s0) + " and " + number(s.s1) +
               " are not neighbours");
  if (s.n == 0) return bad("has no steps");
  if (s.a > s.w)
    return bad("a = " + number(s.a) + " is above w = " + number(s.w));
  return bad("r = " + number(s.r) + " is not below w = " + number(s.w));
}

Result<std::size_t> interpolate(std::span<const DigitalSegment> segments,
                                std::span<Step> out) {
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!is_valid(segments[i]))
      return Error{ErrorCode::invalid_argument,
                   place(i) + validate(segments[i]).error().message};
    total += segments[i].n;
  }
  if (total > out.size())
    return Error{ErrorCode::limit_exceeded,
                 "the segments make " + std::to_string(total) +
                     " steps, the output has room for " +
                     std::to_string(out.size())};
  for (const DigitalSegment& segment : segments) {
    draw_segment(segment, out);
    out = out.subspan(segment.n);
  }
  return static_cast<std::size_t>(total);
}

std::size_t digital_segment_steps_reference(const DigitalSegment& s,
                                            std::span<Step> out) {
  std::uint64_t remainder = s.r;
  for (std::size_t i = 0; i < s.n; ++i) {
    remainder += s.a;
    const bool one = remainder >= s.w;
    if (one) remainder -= s.w;
    out[i] = one ? s.s1 : s.s0;
  }
  return s.n;
}

}  // namespace unstep
