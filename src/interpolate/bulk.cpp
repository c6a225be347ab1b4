// Bulk forward interpolation of plain segments.
//
// Why it is fast: a short segment (both deltas <= 32) is one 64-bit word of
// letters, looked up and spread to bytes eight at a time. A longer one goes
// run by run: the rarer letter stands alone, the other comes q or q + 1 times
// after it, so one comparison decides a whole run, and eight bytes of the run
// are stored at once. Nothing is divided inside a line.

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "interpolate/evaluation.h"
#include "interpolate/letters.h"
#include "interpolate/ticks.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

using interpolation::kFreemanLetters;
using interpolation::Letters;
using interpolation::Quadrant;

constexpr std::uint64_t kBytes = 0x0101010101010101;

// Byte i of entry m is 0xFF where bit i of m is set.
constexpr auto kSpread = [] {
  std::array<std::uint64_t, 256> table{};
  for (std::size_t m = 0; m < 256; ++m)
    for (std::size_t i = 0; i < 8; ++i)
      if ((m >> i & 1) != 0) table[m] |= std::uint64_t{0xFF} << (8 * i);
  return table;
}();

constexpr std::size_t kTableSide = 33;
using WordTable = std::array<std::array<std::uint64_t, kTableSide>, kTableSide>;

// [|dx|][|dy|]: bit i is 1 where step i is the second letter: along y, or
// diagonal for evaluation8.
template <Method method>
constexpr WordTable make_words() {
  WordTable table{};
  for (std::int32_t x = 0; x < static_cast<std::int32_t>(kTableSide); ++x) {
    for (std::int32_t y = 0; y < static_cast<std::int32_t>(kTableSide); ++y) {
      std::uint64_t word = 0;
      if constexpr (method == Method::device) {
        DeviceRegisters device;
        device.start(x, y);
        for (int i = 0; device.forward; ++i)
          if (device.clock() == DeviceRegisters::Axis::y)
            word |= std::uint64_t{1} << i;
      } else if constexpr (method == Method::evaluation) {
        std::int64_t f = 0;
        for (int i = 0; i < x + y; ++i) {
          const bool along_y = f < 0 || x == 0;
          if (along_y) word |= std::uint64_t{1} << i;
          f += along_y ? x : -y;
        }
      } else {
        const int n = std::max(x, y);
        int remainder = n / 2;
        for (int i = 0; i < n; ++i) {
          remainder -= std::min(x, y);
          if (remainder >= 0) continue;
          remainder += n;
          word |= std::uint64_t{1} << i;
        }
      }
      table[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)] = word;
    }
  }
  return table;
}

template <Method method>
constexpr WordTable kWords = make_words<method>();

// A line as a word of two letters. g >= 0 asks for the rare letter: g -= M;
// otherwise the common one: g += m. `shrinking`: M and m count down with
// their letters (A1, where they are the remaining distances).
struct Word {
  std::int64_t common;  // M
  std::int64_t rare;    // m
  std::int64_t common_left;
  std::int64_t rare_left;
  std::int64_t g;
  Step common_step;
  Step rare_step;
};

template <bool shrinking>
Step* draw_letters(const Word& w, Step* out) {
  if constexpr (shrinking) {
    // The word of A1 is A1 with x the common letter.
    DeviceRegisters device{w.common, w.rare, w.g,
                           (w.common_left | w.rare_left) != 0};
    while (device.forward)
      *out++ = device.clock() == DeviceRegisters::Axis::x ? w.common_step
                                                          : w.rare_step;
    return out;
  }
  std::int64_t g = w.g;
  const std::int64_t n = w.common_left + w.rare_left;
  for (std::int64_t i = 0; i < n; ++i) {
    const bool common = g < 0;
    g += common ? w.rare : -w.common;
    out[i] = common ? w.common_step : w.rare_step;
  }
  return out + n;
}

Step* fill(Step* out, Step step, std::int64_t n) {
  std::memset(out, step, static_cast<std::size_t>(n));
  return out + n;
}

// INVARIANT at the head of the loop: 0 <= g < m, the rare letter is next.
// After it g < 0 or the ratio has turned; k = ceil(-g / m) common letters
// follow, guessed as q or q + 1 and checked by 0 <= g < m. Locals, not the
// members of `w`, so that all of them stay in registers.
template <bool shrinking>
Step* draw_runs(Word& w, Step* out, const Step* end) {
  const std::uint64_t commons = kBytes * w.common_step;
  const std::uint64_t pattern = (commons & ~std::uint64_t{0xFF}) | w.rare_step;
  std::int64_t common = w.common;
  std::int64_t rare = w.rare;
  std::int64_t common_left = w.common_left;
  std::int64_t rare_left = w.rare_left;
  std::int64_t g = w.g;
  std::int64_t q = common / rare;
  std::int64_t advance = q * rare;
  // Whole words are stored, up to 8 bytes past a run of q + 2 letters.
  while (rare_left > 1 && common_left > 0 && end - out >= q + 16) {
    const std::int64_t next_rare = rare - (shrinking ? 1 : 0);
    if (shrinking) advance -= q;
    const std::int64_t guess = g + (advance - common);
    const std::int64_t more = guess >> 63;
    std::int64_t next_g = guess + (next_rare & more);
    std::int64_t k = q - more;
    if (shrinking && static_cast<std::uint64_t>(next_g) >=
                         static_cast<std::uint64_t>(next_rare)) {
      const std::int64_t behind = common - g;
      k = behind > 0 ? (behind + next_rare - 1) / next_rare : 0;
      q = (common - k) / next_rare;
      if (end - out < k + 16) break;
      next_g = k * next_rare - behind;
      advance = q * next_rare;
    }
    g = next_g;
    rare = next_rare;
    --rare_left;
    common_left -= k;
    if (shrinking) common -= k;
    std::memcpy(out, &pattern, 8);
    for (std::int64_t i = 8; i <= k; i += 8) std::memcpy(out + i, &commons, 8);
    out += k + 1;
  }
  w.common = common;
  w.rare = rare;
  w.common_left = common_left;
  w.rare_left = rare_left;
  w.g = g;
  return out;
}

// Near the end of the output, where draw_runs lacks room to overshoot.
template <bool shrinking>
Step* draw_exact_runs(Word& w, Step* out) {
  while (w.rare_left > 1 && w.common_left > 0 && w.g >= 0) {
    *out++ = w.rare_step;
    --w.rare_left;
    if (shrinking) --w.rare;
    w.g -= w.common;
    const std::int64_t k = w.g < 0 ? (-w.g + w.rare - 1) / w.rare : 0;
    out = fill(out, w.common_step, k);
    w.common_left -= k;
    if (shrinking) w.common -= k;
    w.g += k * w.rare;
  }
  return out;
}

template <bool shrinking>
Step* draw_word(Word w, Step* out, const Step* end) {
  if (w.rare_left == 0) return fill(out, w.common_step, w.common_left);
  if (w.g < 0) {
    const std::int64_t k = (-w.g + w.rare - 1) / w.rare;
    out = fill(out, w.common_step, k);
    w.common_left -= k;
    if (shrinking) w.common -= k;
    w.g += k * w.rare;
  }
  // Runs of two or three letters are no faster than letters.
  if (2 * w.common >= (shrinking ? 5 : 3) * w.rare)
    out = draw_runs<shrinking>(w, out, end);
  if (w.common >= 16 * w.rare) out = draw_exact_runs<shrinking>(w, out);
  if (w.common_left == 0) return fill(out, w.rare_step, w.rare_left);
  if (w.rare_left == 1 && w.g >= 0) {
    *out++ = w.rare_step;
    return fill(out, w.common_step, w.common_left);
  }
  return draw_letters<shrinking>(w, out);
}

// The word of each method; see docs/algorithms.md for the rewriting of its
// rule to g.
template <Method method>
Word make_word(const Quadrant& s, const Letters& letters) {
  const bool x_major = s.xk >= s.yk;
  const Step along_x = letters[s.along_x];
  const Step along_y = letters[s.along_y];
  if constexpr (method == Method::evaluation8) {
    const std::int64_t n = std::max(s.xk, s.yk);
    const std::int64_t m = std::min(s.xk, s.yk);
    const Step straight = x_major ? along_x : along_y;
    const Step diagonal = letters[s.diagonal()];
    if (m <= n - m)
      return {n - m, m, n - m, m, m - 1 - n / 2, straight, diagonal};
    return {m, n - m, m, n - m, n / 2 - m, diagonal, straight};
  } else {
    const std::int64_t f = method == Method::device ? s.yk - s.xk : 0;
    if constexpr (method == Method::device) {
      if (x_major) return {s.xk, s.yk, s.xk, s.yk, f, along_x, along_y};
      return {s.yk, s.xk, s.yk, s.xk, -1 - f, along_y, along_x};
    } else {
      if (x_major) return {s.xk, s.yk, s.xk, s.yk, -1 - f, along_x, along_y};
      return {s.yk, s.xk, s.yk, s.xk, f, along_y, along_x};
    }
  }
}

template <Method method>
std::size_t length_of(const Quadrant& s) {
  return static_cast<std::size_t>(
      method == Method::evaluation8 ? std::max(s.xk, s.yk) : s.xk + s.yk);
}

template <Method method>
Step* draw(Segment segment, Step* out, const Step* end,
           const Letters& letters) {
  const Quadrant s(segment);
  const std::size_t n = length_of<method>(s);
  constexpr auto kSide = static_cast<std::int64_t>(kTableSide);
  if (s.xk >= kSide || s.yk >= kSide)
    return draw_word<method == Method::device>(make_word<method>(s, letters),
                                               out, end);

  std::uint64_t word = kWords<method>[static_cast<std::size_t>(s.xk)]
                                     [static_cast<std::size_t>(s.yk)];
  Step first = letters[s.along_x];
  Step second = letters[s.along_y];
  if constexpr (method == Method::evaluation8) {
    if (s.xk < s.yk) first = second;
    second = letters[s.diagonal()];
  }
  const std::uint64_t base = kBytes * first;
  const std::uint64_t change = base ^ kBytes * second;
  if (static_cast<std::size_t>(end - out) >= n + 8) {
    for (std::size_t i = 0; i < n; i += 8, word >>= 8) {
      const std::uint64_t eight = base ^ (change & kSpread[word & 0xFF]);
      std::memcpy(out + i, &eight, 8);
    }
  } else {
    for (std::size_t i = 0; i < n; ++i, word >>= 1)
      out[i] = (word & 1) != 0 ? second : first;
  }
  return out + n;
}

Error too_short(std::uint64_t need, std::size_t have) {
  return {ErrorCode::limit_exceeded,
          "the segments make " + std::to_string(need) +
              " steps, the output has room for " + std::to_string(have)};
}

template <Method method>
Result<std::size_t> draw_all(std::span<const Segment> segments,
                             std::span<Step> out, const Letters& letters) {
  std::uint64_t total = 0;
  for (const Segment segment : segments)
    total += length_of<method>(Quadrant(segment));
  if (total > out.size()) return too_short(total, out.size());
  Step* at = out.data();
  const Step* end = at + out.size();
  for (const Segment segment : segments)
    at = draw<method>(segment, at, end, letters);
  return static_cast<std::size_t>(at - out.data());
}

Result<std::size_t> draw_by_ticks(Method method,
                                  std::span<const Segment> segments,
                                  std::span<Step> out,
                                  const InterpolatorOptions& options) {
  std::size_t n = 0;
  for (const Segment segment : segments) {
    Result<Interpolator> line = Interpolator::line(method, segment, options);
    if (!line) return line.error();
    for (Tick t = line->next(); t.kind != Tick::Kind::done; t = line->next()) {
      if (t.kind != Tick::Kind::step) continue;
      if (n == out.size()) return too_short(n + 1, n);
      out[n++] = t.step;
    }
  }
  return n;
}

}  // namespace

Result<std::size_t> interpolation::draw_lines(Method method,
                                              std::span<const Segment> segments,
                                              std::span<std::uint8_t> out,
                                              const Letters& letters) {
  switch (method) {
    case Method::device:
      return draw_all<Method::device>(segments, out, letters);
    case Method::evaluation:
      return draw_all<Method::evaluation>(segments, out, letters);
    default: return draw_all<Method::evaluation8>(segments, out, letters);
  }
}

std::uint64_t step_count(Method method, Segment segment) {
  const Quadrant s(segment);
  return static_cast<std::uint64_t>(
      method == Method::evaluation8 ? std::max(s.xk, s.yk) : s.xk + s.yk);
}

Result<std::size_t> interpolate(Method method,
                                std::span<const Segment> segments,
                                std::span<Step> out,
                                const InterpolatorOptions& options) {
  if (interpolation::draws_in_bulk(method))
    return interpolation::draw_lines(method, segments, out, kFreemanLetters);
  const MethodInfo& info = method_info(method);
  if (!info.lines || info.increments)
    return Error{ErrorCode::unsupported, std::string(info.name) +
                                             " does not make the unit steps "
                                             "of a line"};
  return draw_by_ticks(method, segments, out, options);
}

std::size_t device_steps_reference(Segment segment, std::span<Step> out) {
  const Quadrant s(segment);
  DeviceRegisters device;
  device.start(s.xk, s.yk);
  std::size_t n = 0;
  while (device.forward)
    out[n++] =
        device.clock() == DeviceRegisters::Axis::x ? s.along_x : s.along_y;
  return n;
}

}  // namespace unstep
