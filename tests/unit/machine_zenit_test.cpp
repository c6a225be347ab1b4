#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "interpolate/rate_multiplier.h"
#include "machine/controller_word.h"
#include "machine/laser_modulator.h"
#include "machine/motor_control.h"
#include "machine/pulse_former.h"
#include "machine/reversible_counter.h"
#include "machine/zenit.h"

namespace unstep::machine {
namespace {

TEST(ZenitWord, IsFiveBytesMostSignificantFirst) {
  const WordBytes bytes = pack_word({0xa5, 2, 0x2abcdef});
  EXPECT_EQ(bytes, (WordBytes{0x1a, 0x5a, 0xab, 0xcd, 0xef}));
  const auto word = unpack_word(bytes);
  ASSERT_TRUE(word);
  EXPECT_EQ(*word, (ControllerWord{0xa5, 2, 0x2abcdef}));
}

TEST(ZenitWord, EveryFlippedBitOfTheStrobeIsRefused) {
  for (int bit = 4; bit < 8; ++bit) {
    WordBytes bytes = pack_word({1, 1, 1});
    bytes[0] = static_cast<std::uint8_t>(bytes[0] ^ 1 << bit);
    EXPECT_FALSE(unpack_word(bytes));
  }
  EXPECT_FALSE(unpack_word({}));
}

TEST(ZenitWord, ReadIsThreeBytesMostSignificantFirst) {
  EXPECT_EQ(pack_read(0x123456), (ReadBytes{0x12, 0x34, 0x56}));
  EXPECT_EQ(unpack_read({0x12, 0x34, 0x56}), 0x123456U);
}

TEST(ZenitCommands, AreThoseOfTheTable) {
  EXPECT_EQ(command(Operation::eighth_wave, Axis::y).code, 02115);
  EXPECT_EQ(command(Operation::read_counter, Axis::x).code, 06405);
  EXPECT_EQ(command(Operation::load_cr2, Axis::y).code, 02315);
  EXPECT_EQ(command(Operation::laser_on).code, 02445);
  EXPECT_EQ(std::ranges::count(commands(), false, &Command::printed), 2);
}

TEST(ZenitCommands, ClashInTheirCodesButNotInTheirWords) {
  EXPECT_EQ(find_command(Module::motor, Axis::x, 0215)->operation,
            Operation::reset_cr2);
  EXPECT_EQ(find_command(Module::motor, Axis::y, 0215)->operation,
            Operation::positioning);
  EXPECT_EQ(find_command(Module::counter, Axis::y, 0105)->operation,
            Operation::reset_counter);
  std::set<std::uint16_t> codes;
  std::set<WordBytes> words;
  for (const Command& c : commands()) {
    codes.insert(c.code);
    const ControllerWord word = encode_command(c, 0x800001);
    EXPECT_TRUE(words.insert(pack_word(word)).second) << c.name;
    EXPECT_EQ(decode_command(word), &c) << c.name;
    EXPECT_EQ(command_data(word), 0x800001U);
  }
  EXPECT_LT(codes.size(), words.size());
  EXPECT_EQ(decode_command({0xff, 3, 0}), nullptr);
}

/// Follows `x_um` by the signals; returns the count.
class Signals {
 public:
  Signals(Resolution resolution, double hysteresis, double noise)
      : former_(resolution, hysteresis), noise_(-noise, noise) {
    follow(0.02);
  }
  void follow(double x_um) {
    const double phase = 2 * std::numbers::pi * x_um / kFringeUm;
    count += former_.update(std::sin(phase) + noise_(random_),
                            std::cos(phase) + noise_(random_));
  }
  std::int64_t count = 0;
  [[nodiscard]] std::uint64_t lost() const { return former_.lost(); }

 private:
  PulseFormer former_;
  std::uniform_real_distribution<> noise_;
  std::mt19937 random_{1};
};

TEST(PulseFormer, GivesFourPulsesAFringeOrOne) {
  for (const auto& [resolution, pulses] :
       {std::pair{Resolution::eighth_wave, 12}, {Resolution::half_wave, 3}}) {
    Signals signals(resolution, 0.2, 0);
    for (double x = 0; x < 3 * kFringeUm + 0.03; x += 0.01) signals.follow(x);
    EXPECT_EQ(signals.count, pulses);
    for (double x = 3 * kFringeUm; x > 0.03; x -= 0.01) signals.follow(x);
    for (double x = 0.03; x > -0.05; x -= 0.01) signals.follow(x);
    EXPECT_EQ(signals.count, -1);
    EXPECT_EQ(signals.lost(), 0U);
  }
}

TEST(PulseFormer, NoiseWithinTheHysteresisAddsNoPulses) {
  Signals signals(Resolution::eighth_wave, 0.4, 0.19);
  int changes = 0;
  for (double x = 0.02; x < 3.2; x += 1e-4) {
    const std::int64_t before = signals.count;
    signals.follow(x);
    changes += signals.count != before;
  }
  EXPECT_EQ(signals.count, 39);
  EXPECT_EQ(changes, 39);
  Signals chatter(Resolution::eighth_wave, 0.05, 0.19);
  changes = 0;
  for (double x = 0.02; x < 3.2; x += 1e-4) {
    const std::int64_t before = chatter.count;
    chatter.follow(x);
    changes += chatter.count != before;
  }
  EXPECT_GT(changes, 100);
}

TEST(PulseFormer, NoiseBeyondTheAmplitudeLosesEdges) {
  Signals signals(Resolution::eighth_wave, 0.2, 1.5);
  for (double x = 0.02; x < 3.2; x += 1e-4) signals.follow(x);
  EXPECT_GT(signals.lost(), 0U);
}

TEST(FringeCounter, EqualsTheSignalsOnAnyMotion) {
  for (const Resolution resolution :
       {Resolution::eighth_wave, Resolution::half_wave}) {
    std::mt19937 random(7);
    std::normal_distribution<> push(0, 2e-4);
    Signals signals(resolution, 0.3, 0);
    FringeCounter fringes(resolution, 0.3);
    fringes.update(0.02);
    double x = 0.02;
    double speed = 0;
    for (int i = 0; i < 100'000; ++i) {
      speed = std::clamp(speed + push(random), -0.03, 0.03);
      x += speed;
      signals.follow(x);
      fringes.update(x);
      ASSERT_EQ(signals.count, fringes.count()) << x;
    }
  }
}

TEST(ReversibleCounter, CountsInDirectCodeOnEitherSideOfZero) {
  ReversibleCounter counter;
  std::int64_t now = 0;
  const auto count = [&](bool up, int times) {
    for (int i = 0; i < times; ++i) counter.pulse(up, now += kPulseNs);
  };
  count(true, 2);
  EXPECT_EQ(counter.word(), 2U);
  count(false, 5);
  EXPECT_EQ(counter.word(), 0x800003U);
  count(true, 3);
  EXPECT_EQ(counter.word(), 0U);
  counter.load(0x800000);
  EXPECT_EQ(counter.word(), 0U);
}

TEST(ReversibleCounter, OverflowsAtTheEndsOf23Bits) {
  for (const bool up : {true, false}) {
    ReversibleCounter counter;
    counter.load(up ? 0x7ffffe : 0xfffffe);
    EXPECT_TRUE(counter.pulse(up, 1000));
    EXPECT_FALSE(counter.overflowed());
    EXPECT_EQ(counter.word() & 0x7fffff, 0x7fffffU);
    counter.add(up ? 2 : -2, 5000);
    EXPECT_TRUE(counter.overflowed());
    EXPECT_EQ(std::abs(counter.value()), 1);
    counter.reset();
    EXPECT_FALSE(counter.overflowed());
  }
}

TEST(ReversibleCounter, LosesPulsesAbove5MHz) {
  // lambda / 8 at 3 MHz of fringes would be 12 MHz.
  EXPECT_GT(kMaxFringeHz * 4, ReversibleCounter::kMaxPulseHz);
  ReversibleCounter counter;
  for (int i = 0; i < 100; ++i) counter.pulse(true, i * 1000 / 12);
  EXPECT_EQ(counter.value(), 34);
  EXPECT_EQ(counter.lost(), 66U);
}

TEST(ReversibleCounter, ReadWaitsForThePulseAndForItsTurn) {
  ReversibleCounter counter;
  counter.pulse(true, 1000);
  const auto read = counter.read(1050);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->word, 1U);
  EXPECT_EQ(read->ready_ns, 1200);
  EXPECT_FALSE(counter.read(1050 + 99'999));
  EXPECT_TRUE(counter.read(1050 + 100'000));
}

TEST(RatePulses, EqualTheRateMultiplierOfTheDocument) {
  for (const std::uint32_t bits : {1U, 4U, 10U}) {
    for (std::uint32_t rate = 0; rate < 1U << bits;
         rate += bits == 10 ? 37 : 1) {
      std::uint64_t pulses = 0;
      std::uint64_t clock = 0;
      for (int frame = 0; frame < 2; ++frame) {
        interpolation::RateMultiplier multiplier(
            {static_cast<std::int32_t>(rate), 0}, static_cast<int>(bits));
        for (std::uint32_t i = 0; i < 1U << bits; ++i) {
          pulses += multiplier.next().kind == Tick::Kind::step;
          ASSERT_EQ(rate_pulses(rate, bits, ++clock), pulses) << rate;
        }
      }
      EXPECT_EQ(pulses, 2 * rate);
    }
  }
}

TEST(LaserModulator, FlashesWheneverTheWayIsDone) {
  LaserModulator laser;
  laser.set_mode(LaserModulator::Mode::pulse);
  laser.switch_on(true);
  laser.load_dr1(50);
  laser.load_dr2(10);
  std::int64_t now = 0;
  EXPECT_EQ(laser.move(9, now += 2'000'000), 0);
  EXPECT_EQ(laser.move(4, now += 2'000'000), 1);
  EXPECT_EQ(laser.move(-4, now += 2'000'000), 0);
  EXPECT_EQ(laser.move(-9, now += 2'000'000), -9);
  EXPECT_EQ(laser.flashes(), 2U);
  EXPECT_EQ(laser.move(-10, now += 1'999'999), 0);
  EXPECT_EQ(laser.refused(), 1U);
  EXPECT_EQ(laser.width_us(), 50);
  EXPECT_EQ(laser.level_mv(), 0);
  laser.load_dr1(1023);
  EXPECT_EQ(laser.width_us(), 1000);
}

TEST(LaserModulator, HoldsTenBitsOfMillivolts) {
  LaserModulator laser;
  laser.load_dr1(1023);
  EXPECT_EQ(laser.level_mv(), 0);
  laser.switch_on(true);
  EXPECT_EQ(laser.level_mv(), 1023);
  laser.load_dr1(1024);
  EXPECT_EQ(laser.level_mv(), 0);
}

void run(Zenit& zenit, double seconds) {
  const double until = zenit.seconds() + seconds;
  while (zenit.seconds() < until) zenit.tick();
}

TEST(Zenit, PositionsToOnePulse) {
  for (const Operation wave : {Operation::eighth_wave, Operation::half_wave}) {
    const int pulses = wave == Operation::eighth_wave ? 4 : 1;
    for (const int way : {1, -1, 3, 800, -12'500, 100'000}) {
      Zenit zenit(Plant{}, 3);
      zenit.command(wave, Axis::y);
      zenit.command(Operation::load_cr1, Axis::y, to_direct_code(way));
      zenit.command(Operation::positioning, Axis::y);
      zenit.command(Operation::start_motor, Axis::y);
      while (!zenit.motor_done(Axis::y) && zenit.seconds() < 10) zenit.tick();
      ASSERT_TRUE(zenit.motor_done(Axis::y)) << way;
      EXPECT_NEAR(zenit.read_counter(Axis::y).value_or(0), way, 1);
      EXPECT_NEAR(zenit.position_um(Axis::y), way * kFringeUm / pulses,
                  2 * kFringeUm / pulses);
      EXPECT_LT(zenit.top_speed_um(), 1.01 * kMaxSpeedUm);
    }
  }
}

TEST(Zenit, KeepsItsSpeedFrom20UmToOneCentimetreASecond) {
  for (const int rate : {2, -2, 137, -500, 1000}) {
    Zenit zenit(Plant{}, 4);
    zenit.command(Operation::load_cr2, Axis::x, to_direct_code(rate));
    zenit.command(Operation::constant_speed);
    zenit.command(Operation::start_motor);
    run(zenit, 1);
    const double from = zenit.position_um(Axis::x);
    run(zenit, 2);
    const double speed = (zenit.position_um(Axis::x) - from) / 2;
    EXPECT_NEAR(speed, rate * 10, 0.1 + std::abs(rate) * 0.02) << rate;
    zenit.command(Operation::stop_motor);
    run(zenit, 1);
    EXPECT_LT(std::abs(zenit.speed_um(Axis::x)), 3);
  }
}

TEST(Zenit, AnswersX1ToWritesAndX2ToReads) {
  Zenit zenit(Plant{}, 5);
  const auto word = [](Operation operation, std::uint32_t data = 0) {
    return pack_word(encode_command(command(operation), data));
  };
  EXPECT_TRUE(zenit.write(word(Operation::load_counter, 0x800007)));
  EXPECT_FALSE(zenit.read(word(Operation::load_counter, 0)));
  EXPECT_FALSE(zenit.write(word(Operation::read_counter)));
  EXPECT_FALSE(zenit.write({}));
  EXPECT_FALSE(zenit.write(pack_word({0xff, 2, 0})));
  EXPECT_EQ(zenit.read(word(Operation::read_counter)),
            (ReadBytes{0x80, 0x00, 0x07}));
  EXPECT_FALSE(zenit.read(word(Operation::read_counter)));
  zenit.tick();
  EXPECT_TRUE(zenit.read(word(Operation::read_counter)));
  zenit.reset();
  zenit.tick();
  EXPECT_NEAR(zenit.read_counter(Axis::x).value_or(9), 0, 1);
}

}  // namespace
}  // namespace unstep::machine
