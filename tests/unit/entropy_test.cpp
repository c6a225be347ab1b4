#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <new>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "common/wild.h"
#include "entropy/arithmetic_decoder.h"
#include "entropy/arithmetic_encoder.h"
#include "entropy/counter.h"
#include "entropy/logistic.h"
#include "entropy/mixer.h"
#include "entropy/refiner.h"
#include "entropy/slots.h"
#include "entropy/table_memory.h"

namespace unstep::entropy {
namespace {

using testing::wild;

struct Coded {
  bool bit;
  int p1;
};

std::vector<std::uint8_t> encode(const std::vector<Coded>& bits) {
  ArithmeticEncoder encoder;
  for (const auto& [bit, p1] : bits) EXPECT_EQ(encoder.code(bit, p1), bit);
  return encoder.finish();
}

void expect_decodes(std::span<const std::uint8_t> bytes,
                    const std::vector<Coded>& bits) {
  ArithmeticDecoder decoder(bytes);
  for (std::size_t i = 0; i < bits.size(); ++i) {
    ASSERT_EQ(decoder.code(false, bits[i].p1), bits[i].bit) << "bit " << i;
  }
  EXPECT_TRUE(decoder.finished());
  EXPECT_FALSE(decoder.overrun());
}

/// Bits drawn with the probabilities they are coded with, or against them.
std::vector<Coded> random_bits(unsigned seed, std::size_t count, bool honest) {
  std::mt19937 random(seed);
  std::vector<Coded> bits;
  for (std::size_t i = 0; i < count; ++i) {
    constexpr std::array<int, 6> kExtremes{1, 65535, 2, 65534, 32768, 32767};
    const int p1 = random() % 3 == 0 ? kExtremes[random() % 6]
                                     : static_cast<int>(1 + random() % 65535);
    const bool drawn = static_cast<int>(random() % 65536) < p1;
    bits.push_back({honest ? drawn : random() % 2 == 0, p1});
  }
  return bits;
}

TEST(ArithmeticCoder, DecodesWhatItEncoded) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Coded> bits = random_bits(seed, seed * 7, seed % 2 == 0);
    expect_decodes(encode(bits), bits);
  }
}

TEST(ArithmeticCoder, DecodesRunsOfExtremes) {
  for (const int p1 : {1, 32768, 65535}) {
    for (const bool bit : {false, true}) {
      const std::vector<Coded> bits(3000, {bit, p1});
      expect_decodes(encode(bits), bits);
    }
  }
}

TEST(ArithmeticCoder, NothingIsNoBytes) {
  EXPECT_TRUE(encode({}).empty());
  expect_decodes({}, {});
}

TEST(ArithmeticCoder, WhatIsCertainCostsNothing) {
  // Ones keep the low end of the interval, where the dropped zeros are.
  EXPECT_TRUE(encode(std::vector<Coded>(40'000, {true, 65535})).empty());
  EXPECT_LE(encode(std::vector<Coded>(40'000, {false, 1})).size(), 1U);
}

TEST(ArithmeticCoder, CostsWhatTheProbabilitiesSay) {
  std::vector<Coded> bits;
  std::mt19937 random(2);
  for (int i = 0; i < 80'000; ++i) bits.push_back({random() % 2 == 0, 32768});
  EXPECT_NEAR(static_cast<double>(encode(bits).size()), 10'000, 10);
}

TEST(ArithmeticCoder, DropsNoMoreZeroBytesThanTheDecoderForgives) {
  // Ones with p = 1/2 halve the interval from above: all bytes are zero.
  const std::vector<Coded> bits(8 * 100, {true, 32768});
  const std::vector<std::uint8_t> bytes = encode(bits);
  EXPECT_GE(bytes.size(), 100U - ArithmeticEncoder::kMaxDropped - 4);
  expect_decodes(bytes, bits);
}

TEST(ArithmeticCoder, NoticesThatBytesAreMissing) {
  const std::vector<Coded> bits = random_bits(3, 5000, true);
  const std::vector<std::uint8_t> bytes = encode(bits);
  const std::span<const std::uint8_t> all = bytes;
  ArithmeticDecoder decoder(all.first(all.size() / 2));
  for (const Coded& coded : bits) decoder.code(false, coded.p1);
  EXPECT_TRUE(decoder.overrun());
  ArithmeticDecoder nothing({});
  EXPECT_FALSE(nothing.overrun());
  EXPECT_TRUE(nothing.finished());
}

TEST(ArithmeticCoder, NoticesBytesLeftOver) {
  const std::vector<Coded> bits = random_bits(4, 500, true);
  std::vector<std::uint8_t> bytes = encode(bits);
  bytes.insert(bytes.end(), 8, 0);
  ArithmeticDecoder decoder(bytes);
  for (const Coded& coded : bits) decoder.code(false, coded.p1);
  EXPECT_FALSE(decoder.finished());
}

TEST(ArithmeticCoder, KnowsItsOwnEndFromEveryOther) {
  const std::vector<Coded> bits = random_bits(5, 300, true);
  const std::vector<std::uint8_t> bytes = encode(bits);
  for (int value = 0; value < 256; ++value) {
    std::vector<std::uint8_t> other = bytes;
    other.back() = static_cast<std::uint8_t>(value);
    if (other == bytes) continue;
    ArithmeticDecoder decoder(other);
    bool same = true;
    for (const auto& [bit, p1] : bits) {
      same = decoder.code(false, p1) == bit && same;
    }
    EXPECT_FALSE(same && decoder.finished()) << value;
  }
}

TEST(Logistic, SquashIsMonotoneSymmetricAndClamped) {
  for (int x = -kStretchMax - 50; x < kStretchMax + 50; ++x) {
    EXPECT_LE(squash(x), squash(x + 1));
    EXPECT_GE(squash(x), 1);
    EXPECT_LE(squash(x), 65535);
    EXPECT_EQ(squash(-x), 65536 - squash(x));
  }
  EXPECT_EQ(squash(1 << 30), squash(kStretchMax));
  EXPECT_EQ(squash(-(1 << 30)), squash(-kStretchMax));
}

TEST(Logistic, StretchIsMonotoneAndSymmetric) {
  for (int p = 0; p < 65535; ++p) {
    ASSERT_LE(stretch(p), stretch(p + 1));
    ASSERT_EQ(stretch(65535 - p), -stretch(p));
  }
}

TEST(Logistic, StretchInvertsSquashWithinAStepOfItsTable) {
  // Stretch knows probabilities to 16 of 65536.
  for (int p = 0; p < 65536; ++p) {
    const int middle = p / 16 * 16 + 8;
    ASSERT_NEAR(squash(stretch(p)), middle, 72) << p;
  }
}

TEST(Logistic, KeepsItsValues) {
  const std::vector<std::pair<int, int>> squashed{
      {0, 32768},    {1, 32832},    {256, 47911},     {512, 57724},
      {1024, 64357}, {2048, 65514}, {3071, 65536 - 1}};
  for (const auto& [x, p] : squashed) EXPECT_EQ(squash(x), p) << x;
  const std::vector<std::pair<int, int>> stretched{
      {32768, 1}, {49152, 282}, {65535, 2292}, {0, -2292}};
  for (const auto& [p, x] : stretched) EXPECT_EQ(stretch(p), x) << p;
}

TEST(Mixing, FastFormsEqualTheReference) {
  std::mt19937 random(5);
  constexpr std::size_t kSize = 40;
  for (int round = 0; round < 2000; ++round) {
    alignas(16) std::array<std::int16_t, kSize> x{};
    std::array<std::int16_t, kSize> w{};
    for (std::size_t i = 0; i < kSize; ++i) {
      x[i] = std::clamp<std::int16_t>(wild<std::int16_t>(random), -4095, 4095);
      w[i] = wild<std::int16_t>(random);
    }
    ASSERT_EQ(mixing::dot<kSize>(x.data(), w.data()),
              mixing::dot_reference(x.data(), w.data(), kSize));
    auto reference = w;
    auto error = wild<std::int16_t>(random);
    mixing::train<kSize>(x.data(), w.data(), error);
    mixing::train_reference(x.data(), reference.data(), kSize, error);
    ASSERT_EQ(w, reference);
  }
}

TEST(Mixer, LearnsWhichInputIsRight) {
  constexpr std::array<std::array<std::int16_t, 8>, 1> kQuarters{
      {{1024, 1024}}};
  Mixer<8, 1> mixer({1}, kQuarters);
  std::mt19937 random(6);
  for (int i = 0; i < 5000; ++i) {
    const bool bit = random() % 2 == 0;
    mixer.inputs()[0] = bit ? 300 : -300;
    mixer.inputs()[1] = random() % 2 == 0 ? 300 : -300;
    const int x = mixer.mix({0});
    if (i > 4000) {
      EXPECT_GT(bit ? squash(x) : 65536 - squash(x), 58000);
    }
    mixer.update(bit);
  }
}

TEST(Mixer, KeepsItsResults) {
  constexpr std::array<std::array<std::int16_t, 8>, 1> kWeights{
      {{1024, 1024, 512}}};
  Mixer<8, 2> mixer({3, 2}, kWeights);
  std::uint32_t state = 1;
  std::uint32_t digest = 0;
  const auto next = [&] {
    state = state * 1664525 + 1013904223;
    return state >> 16;
  };
  for (int i = 0; i < 2000; ++i) {
    for (std::size_t k = 0; k < 8; ++k) {
      mixer.inputs()[k] =
          static_cast<std::int16_t>(static_cast<int>(next() % 4000) - 2000);
    }
    const int x = mixer.mix({next() % 3, next() % 2});
    digest = digest * 31 + static_cast<std::uint32_t>(x);
    mixer.update(next() % 3 == 0);
  }
  EXPECT_EQ(digest, 612358980U);
}

TEST(Mixer, SparesErrorsBelowItsLimit) {
  constexpr std::array<std::array<std::int16_t, 8>, 1> kWeights{{{4096}}};
  Mixer<8, 1, 1, 1000> mixer({1}, kWeights);
  mixer.inputs()[0] = 1100;  // p = 0.9866, an error of 879
  ASSERT_EQ(mixer.mix({0}), 1100);
  mixer.update(true);
  EXPECT_EQ(mixer.mix({0}), 1100);
  EXPECT_EQ(mixer.ages(0)[0], 0);
  mixer.update(false);
  EXPECT_LT(mixer.mix({0}), 1100);
  EXPECT_EQ(mixer.ages(0)[0], 1);
}

TEST(Mixer, GivesVectorsTheirOwnWeights) {
  constexpr std::array<std::array<std::int16_t, 8>, 2> kWeights{
      {{4096}, {-4096}}};
  Mixer<8, 1> mixer({3}, kWeights);
  mixer.inputs()[0] = 500;
  EXPECT_EQ(mixer.mix({0}), 500);
  EXPECT_EQ(mixer.mix({1}), -500);
  EXPECT_EQ(mixer.mix({2}), 500);
}

/// Slots one by one, as docs/format.md describes them.
struct PlainSlots {
  struct Entry {
    std::array<Counter, 2> counters;
    std::uint16_t check = 0;
  };
  std::map<std::pair<std::size_t, std::uint64_t>, Entry> table;

  Entry& find(std::size_t context, int bits, std::uint64_t hash) {
    Entry& entry = table[{context, hash >> (64 - bits)}];
    const std::uint16_t check = ContextSlots<5>::check_of(hash);
    if (entry.check != check) entry = {{}, check};
    return entry;
  }
};

template <std::size_t kContexts>
void expect_slots_one_by_one(const std::array<int, kContexts>& bits) {
  using Slots = ContextSlots<kContexts>;
  constexpr std::size_t kLanes = Slots::kLanes;
  Slots slots(bits);
  PlainSlots plain;
  std::mt19937_64 random(8);
  for (int round = 0; round < 20'000; ++round) {
    std::array<std::uint64_t, kContexts> hashes{};
    for (std::size_t i = 0; i < kContexts; ++i) {
      hashes[i] = random() % 200 * 0x9e3779b97f4a7c15ULL;
      slots.ask(i, hashes[i]);
    }
    slots.learn([](std::size_t, bool) {});
    slots.recall();
    for (std::size_t node = 0; node < 2; ++node) {
      alignas(16) std::array<std::int16_t, Slots::kInputs> inputs{};
      slots.predict(node, inputs.data());
      const bool bit = random() % 3 == 0;
      for (std::size_t i = 0; i < kContexts; ++i) {
        Counter& c = plain.find(i, bits[i], hashes[i]).counters[node];
        ASSERT_EQ(inputs[i], stretch(c.p));
        ASSERT_EQ(inputs[kLanes + i],
                  ((c.p - 32768) * (51 * std::min<int>(c.n, 30))) >> 16);
        c.update(bit);
      }
      for (std::size_t i = kContexts; i < kLanes; ++i) {
        ASSERT_EQ(inputs[i], 0);
        ASSERT_EQ(inputs[kLanes + i], 0);
      }
      slots.note(node, bit);
    }
  }
}

TEST(ContextSlots, WorkAsSlotsOneByOne) {
  static_assert(ContextSlots<5>::kLanes == 8);
  expect_slots_one_by_one<5>({8, 9, 4, 10, 8});
  static_assert(ContextSlots<11>::kLanes == 16);
  expect_slots_one_by_one<11>({8, 9, 4, 10, 8, 7, 8, 9, 5, 10, 8});
}

TEST(Counter, ConvergesToTheShareOfOnes) {
  for (const unsigned percent : {1U, 10U, 50U, 90U, 99U}) {
    std::mt19937 random(percent);
    Counter counter;
    double sum = 0;
    for (int i = 0; i < 20'000; ++i) {
      counter.update(random() % 100 < percent);
      if (i >= 10'000) sum += counter.p;
    }
    EXPECT_NEAR(sum / 10'000 / 65536, percent / 100.0, 0.01);
  }
}

TEST(Counter, TreatsBothBitsAlike) {
  std::mt19937 random(7);
  Counter counter;
  Counter mirror;
  mirror.p = 32767;
  for (int i = 0; i < 5000; ++i) {
    ASSERT_EQ(counter.p, 65535 - mirror.p);
    const bool bit = random() % 5 == 0;
    counter.update(bit);
    mirror.update(!bit);
  }
}

TEST(Counter, ReachesCertaintyAndStaysCodable) {
  for (const bool bit : {false, true}) {
    Counter counter;
    for (int i = 0; i < 100'000; ++i) counter.update(bit);
    EXPECT_EQ(counter.p, bit ? 65535 : 0);
    EXPECT_EQ(counter.n, Counter::kLimit);
    EXPECT_EQ(counter.p1(), bit ? 65520 : 16);
    EXPECT_EQ(counter.p1_fine(), bit ? 65534 : 2);
  }
}

TEST(Refiner, ChangesNothingAtFirst) {
  Refiner refiner(3);
  for (int x = -2047; x < 2048; x += 13) {
    // Between two nodes it is a chord: off by at most f"" / 8 = 0.012.
    EXPECT_NEAR(refiner.refine(x, 2), squash(x), 800) << x;
  }
  EXPECT_EQ(refiner.refine(-3071, 0), squash(-2048));
}

TEST(Refiner, LearnsWhatFollowsInItsContext) {
  Refiner refiner(2);
  const int before = refiner.refine(-512, 1);
  for (int i = 0; i < 400; ++i) {
    refiner.refine(-500, 0);
    refiner.learn(true);
  }
  EXPECT_GT(refiner.refine(-500, 0), 55000);
  EXPECT_EQ(refiner.refine(-512, 1), before);
  EXPECT_EQ(refiner.refine(1500, 0), Refiner(1).refine(1500, 0));
}

}  // namespace
TEST(Table, IsZeroAndWritableToItsEndsFromAFewBytesToHugePages) {
  for (const std::size_t size :
       {std::size_t{1}, std::size_t{1000}, std::size_t{1} << 18,
        (std::size_t{1} << 18) + 1, std::size_t{700'001}}) {
    for (int again = 0; again < 2; ++again) {
      const Table<std::uint64_t> table = make_table<std::uint64_t>(size);
      EXPECT_EQ(std::count(&table[0], &table[0] + size, 0U),
                static_cast<std::ptrdiff_t>(size));
      std::fill(&table[0], &table[0] + size, ~std::uint64_t{0});
    }
  }
}

TEST(Table, TooLargeForTheMachineThrows) {
  EXPECT_THROW((void)make_table<std::uint64_t>(~std::size_t{0} / 4),
               std::bad_alloc);
  EXPECT_THROW((void)make_table<std::uint64_t>(std::size_t{1} << 57),
               std::bad_alloc);
}

}  // namespace unstep::entropy
