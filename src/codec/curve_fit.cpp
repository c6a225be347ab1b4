#include "codec/curve_fit.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "entropy/mixer.h"

namespace unstep::codec {
namespace {

/// How many values a fit takes: the most of these that there are.
constexpr std::array<unsigned, 6> kLengths{4, 6, 9, 14, 21, 32};
constexpr int kLongestLine = 3;

using Filter = std::array<std::int16_t, 32>;
using Filters = std::array<Filter, kLengths.size()>;

/// The weights, times 4096, of the differences d_i = v_i - v_(i+1) (latest
/// first) in the forecast of the next value less v_0, by the least squares
/// polynomial of degree 1 or 2 through k values. With w_j the weight of v_j,
/// d_i has -(w_(i+1) + .. + w_(k-1)).
constexpr Filters make_filters(int degree) {
  Filters filters{};
  for (std::size_t f = 0; f < filters.size(); ++f) {
    const auto k = static_cast<std::int64_t>(kLengths[f]);
    const std::int64_t whole = 2 * k * (k - 1) * (k - 2);
    std::int64_t rest = 0;
    for (std::int64_t j = k - 1; j > 0; --j) {
      // All over `whole`: the line, and what the parabola adds to it.
      const std::int64_t middle = 2 * j - k + 1;
      rest += (4 * k - 6 * j - 4) * 2 * (k - 2);
      if (degree == 2) rest += 5 * (3 * middle * middle - (k * k - 1));
      // Rounded to the nearest; + 64 makes the division one of positives.
      const std::int64_t scaled =
          (2 * 4096 * -rest + whole * (1 + 2 * 4096 * 64)) / (2 * whole) -
          4096 * 64;
      filters[f][static_cast<std::size_t>(j - 1)] =
          static_cast<std::int16_t>(scaled);
    }
  }
  return filters;
}

constexpr Filters kLine = make_filters(1);
constexpr Filters kParabola = make_filters(2);

/// Which of kLengths; -1 if there are too few values.
int length_class(unsigned count) {
  return count < 4    ? -1
         : count < 6  ? 0
         : count < 9  ? 1
         : count < 14 ? 2
         : count < 21 ? 3
         : count < 32 ? 4
                      : 5;
}

/// In 1/64 unit, relative to the last value.
int expect(const Filters& filters, int length,
           const std::array<std::int16_t, 32>& steps) {
  return entropy::mixing::dot<32>(
             filters[static_cast<std::size_t>(length)].data(), steps.data()) >>
         6;
}

}  // namespace

void CurveFit::Series::push(std::int32_t value, std::int32_t jump) {
  const std::int32_t step = value - last;
  last = value;
  if (count == 0 || step > jump || step < -jump) {
    count = 1;
    return;
  }
  std::memmove(steps.data() + 1, steps.data(),
               (kSamples - 1) * sizeof(steps[0]));
  steps[0] = static_cast<std::int16_t>(step);
  count = std::min<unsigned>(count + 1, kSamples);
}

void CurveFit::step(Quarter direction, std::int32_t x, std::int32_t y,
                    const Gaps& gaps) {
  Axis& axis = axes_[direction & 1];
  const int sign = direction < 2 ? 1 : -1;
  if (sign != axis.sign) {
    axis.sign = sign;
    axis.error = 64;
    axis.places.count = 0;
    for (Series& gap : axis.gaps) gap.count = 0;
  }
  const std::int32_t place = (direction & 1) == 0 ? y : x;
  Series& places = axis.places;
  const int length = std::min(length_class(places.count), kLongestLine);
  if (length >= 0) {
    const std::int32_t moved =
        std::clamp(place - places.last, -kJump - 1, kJump + 1) * 64;
    const int miss =
        std::min(std::abs(moved - expect(kLine, length, places.steps)), 255);
    axis.error += (miss * 4 - axis.error) / 8;
  }
  places.push(place, kJump);
  for (std::size_t side = 0; side < 2; ++side) {
    Series& gap = axis.gaps[side];
    if (gaps[side] == 0) {
      gap.count = 0;
    } else {
      gap.push(gaps[side], kGapJump);
    }
  }
}

CurveFit::Forecast CurveFit::forecast(std::size_t axis, Quarter direction,
                                      std::int32_t x, std::int32_t y,
                                      const Gaps& gaps) const {
  const Axis& a = axes_[axis];
  const bool along = (direction & 1) == axis;
  // A walk along the axis may bend right, one across it has so far to go on.
  int sign = direction < 2 ? 1 : -1;
  if (along) sign = axis == 0 ? a.sign : -a.sign;
  const std::uint64_t turn =
      !along && heading(axis) == ((direction + 1) & 3) ? 1U : 0U;
  const std::uint64_t frame = turn << 1 | (along ? 1U : 0U);
  // In eighths of a unit.
  const auto level = [&](int ahead) {
    const int d = std::clamp(ahead * sign + 32, -127, 191) + 128;
    return (static_cast<std::uint64_t>(d >> 3) << 2 | frame) + 8;
  };

  Forecast out;
  const int length = length_class(a.places.count);
  std::uint64_t curve = frame & 1;
  std::uint64_t trust = 0;
  if (length >= 0) {
    const std::int32_t here = axis == 0 ? y : x;
    const std::int32_t since =
        std::clamp(here - a.places.last, -kJump, kJump) * 64;
    curve = level(expect(kParabola, length, a.places.steps) - since);
    trust = length < 2 ? 1 : length < 4 ? 2 : 3;
  }
  const std::uint64_t quality = a.error < 40    ? 0
                                : a.error < 70  ? 1
                                : a.error < 120 ? 2
                                                : 3;
  out.curve = curve << 8 | trust << 2 | quality;

  std::array<std::uint64_t, 2> sides{};
  for (std::size_t side = 0; side < 2; ++side) {
    const Series& past = a.gaps[side];
    sides[side] = (along ? 2U : 0U) | (gaps[side] > 0 ? 1U : 0U);
    if (gaps[side] == 0 || past.count == 0) continue;
    const int fit = std::min(length_class(past.count), kLongestLine);
    const int wanted =
        past.last * 64 + (fit >= 0 ? expect(kLine, fit, past.steps) : 0);
    const int ahead = gaps[side] * 64 - wanted;
    if (std::abs(ahead) >= 200) continue;
    sides[side] = level(side == 0 ? ahead : -ahead) << 8 |
                  static_cast<std::uint64_t>(fit + 1) << 4;
  }
  const bool greater_is_right = (axis == 0) == (a.sign > 0);
  out.right = sides[greater_is_right ? 0 : 1];
  out.left = sides[greater_is_right ? 1 : 0];
  return out;
}

}  // namespace unstep::codec
