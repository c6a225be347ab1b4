#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "interpolate/digit_by_digit.h"
#include "interpolate/rom.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

using interpolation::kHalfPi;
using interpolation::kPi;
using interpolation::SinCos;

constexpr long double kAngleUnit = 0x1p-60L;

long double radians(std::int64_t phi) {
  return static_cast<long double>(phi) * kAngleUnit;
}

// The larger error of the two words, in units of 2^-n, for radius 1.
long double error_of(SinCos v, std::int64_t phi, int n) {
  const long double one = std::ldexp(1.0L, n);
  return std::max(
      std::abs(static_cast<long double>(v.cos) - std::cos(radians(phi)) * one),
      std::abs(static_cast<long double>(v.sin) - std::sin(radians(phi)) * one));
}

std::vector<std::int64_t> angles(std::int64_t from, std::int64_t to) {
  std::vector<std::int64_t> list{from, to, 0, 1, kHalfPi, kHalfPi / 2};
  std::mt19937_64 random(4);
  std::uniform_int_distribution<std::int64_t> angle(from, to);
  for (int i = 0; i < 1500; ++i) list.push_back(angle(random));
  return list;
}

TEST(DigitByDigit, HoldsItsConstants) {
  // pi 2^60 = 3622009729038561421.2; four equal quarters are 1.2 units short.
  EXPECT_EQ(kPi, 3622009729038561420);
  EXPECT_EQ(interpolation::kScaledAtan[60], std::int64_t{1} << 60);
  for (int i = 0; i < 20; ++i) {
    const long double atan = std::atan(std::ldexp(1.0L, -i));
    EXPECT_NEAR(static_cast<double>(radians(
                    interpolation::kScaledAtan[static_cast<std::size_t>(i)])),
                static_cast<double>(std::ldexp(atan, i)), 1e-15);
  }
  EXPECT_NEAR(1 / static_cast<double>(radians(interpolation::kInverseGain)),
              1.64676, 1e-5);
}

TEST(DigitByDigit, VolderKeepsItsErrorBoundForEveryWordLength) {
  // |phi| <= 1.743, the sum of the constants.
  const auto limit = static_cast<std::int64_t>(1.743 * 0x1p60);
  for (int n = kMinWordLength; n <= kMaxWordLength; ++n)
    for (const std::int64_t phi : angles(-limit, limit))
      ASSERT_LE(
          error_of(interpolation::volder(phi, n, interpolation::unit_start(n)),
                   phi, n),
          2 * n + 4)
          << "n " << n << " phi " << phi;
}

TEST(DigitByDigit, MeggittKeepsItsErrorBoundWithAndWithoutTheSkip) {
  const auto limit = static_cast<std::int64_t>(1.743 * 0x1p60);
  for (int n = kMinWordLength; n <= kMaxWordLength; ++n)
    for (const bool skip : {true, false})
      for (const std::int64_t phi : angles(-limit, limit))
        ASSERT_LE(error_of(interpolation::meggitt(
                               phi, n, interpolation::unit_start(n), skip),
                           phi, n),
                  n / 2.0L + 10)
            << "n " << n << " phi " << phi << " skip " << skip;
}

TEST(DigitByDigit, MeggittIsRightTo1e7At26Digits) {
  for (const std::int64_t phi : angles(-kHalfPi, kHalfPi)) {
    const SinCos v =
        interpolation::meggitt(phi, 26, interpolation::unit_start(26));
    EXPECT_LE(std::ldexp(error_of(v, phi, 26), -26), 1.5e-7L);
  }
}

TEST(DigitByDigit, GivesTheIncrementsOfALineFromItsOneConstant) {
  // dL = 1666 units (10 m/min, 10 ms, 1 um) along (3, 4), words of 40 digits.
  const int n = 40;
  const std::int64_t phi = interpolation::angle_of(3, 4);
  const std::int64_t start = 1666 * interpolation::unit_start(n);
  for (const bool meggitt : {false, true}) {
    const SinCos v = meggitt ? interpolation::meggitt(phi, n, start)
                             : interpolation::volder(phi, n, start);
    EXPECT_NEAR(std::ldexp(static_cast<double>(v.cos), -n), 1666 * 0.6, 1e-6);
    EXPECT_NEAR(std::ldexp(static_cast<double>(v.sin), -n), 1666 * 0.8, 1e-6);
  }
}

TEST(DigitByDigit, FindsTheAngleOfAnyVector) {
  std::mt19937_64 random(8);
  constexpr std::int64_t kLimit = std::int64_t{1} << 33;
  std::uniform_int_distribution<std::int64_t> wide(-kLimit, kLimit);
  std::uniform_int_distribution<std::int64_t> narrow(-3, 3);
  for (int i = 0; i < 4000; ++i) {
    const std::int64_t x = i % 2 == 0 ? wide(random) : narrow(random);
    const std::int64_t y = i % 4 < 2 ? wide(random) : narrow(random);
    if (x == 0 && y == 0) continue;
    const long double want =
        std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    long double off = std::abs(radians(interpolation::angle_of(x, y)) - want);
    off = std::min(off, 2 * std::numbers::pi_v<long double> - off);
    ASSERT_LE(off, 0x1p-53L) << x << ',' << y;
  }
  EXPECT_EQ(interpolation::angle_of(0, 0), 0);
}

TEST(WordLength, ReproducesTheSourcesFigures) {
  // 10 m/min at 10 ms and 1 um: 1666 units. Circles: 10 m and 1 um.
  EXPECT_EQ(word_length_linear(10.0 / 60, 0.01, 1e-6), 11);
  EXPECT_EQ(word_length_circular(10, 1e-6), 24);
  EXPECT_EQ(word_length_linear(1, 1, 1), 1);
  EXPECT_EQ(word_length_circular(1024, 1), 10);
}

TEST(Rom, ReproducesTheSourcesTableSizes) {
  EXPECT_EQ(rom_nodes(10, 1e-6, 12), 3835);
  EXPECT_EQ(rom_bytes(3835, 25, RomForm::values, 12), 23'963);
  const std::int64_t differences =
      rom_bytes(3835, 25, RomForm::differences, 12);
  EXPECT_NEAR(static_cast<double>(differences) / 23'963, 0.5, 0.03);
  EXPECT_NEAR(rom_linear_step(0x1p-23), 0x1p-10, 1e-12);
}

TEST(Rom, KeepsTheErrorBoundOfEveryCorrectionAndStep) {
  const int n = kMaxWordLength;
  for (int s = kMinRomBits; s <= kMaxRomBits; ++s) {
    const long double h = std::ldexp(1.0L, -s);
    for (const RomCorrection correction :
         {RomCorrection::linear, RomCorrection::parabolic,
          RomCorrection::cubic}) {
      const long double bound = correction == RomCorrection::linear ? h * h / 8
                                : correction == RomCorrection::parabolic
                                    ? h * h * h / (9 * std::sqrt(3.0L))
                                    : 3 * h * h * h * h / 128;
      interpolation::Rom rom(s, RomForm::values, correction);
      for (const std::int64_t phi : angles(0, kHalfPi))
        ASSERT_LE(std::ldexp(error_of(rom.at(phi, n), phi, n), -n),
                  bound + std::ldexp(1.0L, -n))
            << "s " << s;
    }
  }
}

TEST(Rom, DifferencesGiveTheSameWordsAsValues) {
  for (const int s : {4, 7, 10}) {
    for (const RomCorrection correction :
         {RomCorrection::linear, RomCorrection::parabolic,
          RomCorrection::cubic}) {
      interpolation::Rom values(s, RomForm::values, correction);
      interpolation::Rom differences(s, RomForm::differences, correction);
      for (const std::int64_t phi : angles(0, kHalfPi)) {
        const SinCos a = values.at(phi, 40);
        const SinCos b = differences.at(phi, 40);
        ASSERT_EQ(a.cos, b.cos);
        ASSERT_EQ(a.sin, b.sin);
      }
    }
  }
}

TEST(Sine, OptionsOutOfRangeAreRefused) {
  InterpolatorOptions options;
  for (const int n : {-1, kMinWordLength - 1, kMaxWordLength + 1}) {
    options.word_length = n;
    EXPECT_FALSE(Interpolator::line(Method::cordic, {5, 5}, options)) << n;
  }
  options = {};
  for (const int s : {-1, kMinRomBits - 1, kMaxRomBits + 1}) {
    options.rom_bits = s;
    EXPECT_FALSE(Interpolator::line(Method::rom, {5, 5}, options)) << s;
  }
}

}  // namespace
}  // namespace unstep
