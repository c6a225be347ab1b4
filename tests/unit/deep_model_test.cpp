#include "codec/deep_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "codec/contour_coder.h"
#include "common/wild.h"
#include "entropy/arithmetic_encoder.h"
#include "entropy/deep_mixer.h"
#include "unit/container_testing.h"

namespace unstep::codec {
namespace {

using testing::random_ink;
using testing::wild;
using Bytes = std::vector<std::uint8_t>;
namespace mixing = entropy::deep_mixing;

TEST(DeepMixing, FastFormsEqualTheReference) {
  std::mt19937 random(5);
  constexpr std::size_t kSize = 40;
  for (int round = 0; round < 2000; ++round) {
    alignas(16) std::array<std::int16_t, kSize> x{};
    std::array<std::int32_t, kSize> w{};
    for (std::size_t i = 0; i < kSize; ++i) {
      x[i] = std::clamp<std::int16_t>(wild<std::int16_t>(random), -4095, 4095);
      w[i] = wild<std::int32_t>(random);
    }
    ASSERT_EQ(mixing::dot(x.data(), w.data(), kSize),
              mixing::dot_reference(x.data(), w.data(), kSize));
    auto reference = w;
    const auto error = wild<std::int16_t>(random);
    mixing::train(x.data(), w.data(), kSize, error);
    mixing::train_reference(x.data(), reference.data(), kSize, error);
    ASSERT_EQ(w, reference);
  }
}

using Model = DeepModel<3, 1, 2, 1>;
constexpr Model::Choice kSizes{{4, 1}, {1}, 1};

/// Bytes for bits of which `bit(i)` follows from the first context, of
/// `contexts`, or not.
template <class Bit>
std::size_t cost(std::uint64_t contexts, const Bit& bit) {
  entropy::ArithmeticEncoder coder;
  Model model(12, kSizes);
  for (std::uint64_t i = 0; i < 4000; ++i) {
    model.ask_mixed(0, i * 7919 % contexts);
    model.ask_mixed(1, i % 3);
    model.ask_mixed(2, 0);
    model.code(coder, bit(i * 7919 % contexts, i), {{i % 4, 0}, {0}, 0});
  }
  return coder.finish().size();
}

TEST(DeepModel, LearnsWhatItsContextsSay) {
  const auto odd = [](std::uint64_t context, std::uint64_t) {
    return context * 2654435761U % 8 < 3;
  };
  EXPECT_LT(cost(64, odd), 60U);
  std::mt19937 random(3);
  const auto coin = [&](std::uint64_t, std::uint64_t) {
    return random() % 2 == 0;
  };
  EXPECT_GT(cost(64, coin), 500U);
  EXPECT_LT(cost(64, coin), 530U) << "chance costs a bit and little more";
}

TEST(DeepModel, SeesOutcomesThatTakeTurnsInAContext) {
  std::array<unsigned, 64> seen{};
  const auto every_third = [&](std::uint64_t context, std::uint64_t) {
    return ++seen[context] % 3 == 0;
  };
  // By shares alone a bit would cost 0.92: 460 bytes.
  EXPECT_LT(cost(64, every_third), 160U);
}

TEST(DeepModel, BeginsWithWhatItIsTold) {
  Model model(12, kSizes);
  const std::uint64_t hash = mix(5, 0) * kGolden;
  const Model::Choice choice{{0, 0}, {0}, 0};
  const auto predict = [&] {
    for (std::size_t i = 0; i < 3; ++i) model.ask_mixed(i, 5);
    return model.predict(choice);
  };
  EXPECT_NEAR(predict(), 32768, 2000);
  model.know(0, static_cast<std::uint32_t>(hash >> 36), 0, 60000, 40);
  EXPECT_GT(predict(), 40000);
}

/// The revisions whose turns have deep models.
class DeepContours : public ::testing::TestWithParam<std::uint8_t> {
 protected:
  static Bytes encode(const Bitmap& ink) {
    const Result<Bytes> payload =
        encode_contours(ink, 0, ink.height(), GetParam(), {});
    EXPECT_TRUE(payload);
    return *payload;
  }
  static Status verify(std::span<const std::uint8_t> payload, const Bitmap& ink,
                       const DecodeLimits& limits = {}) {
    return verify_contours(payload, ink, 0, ink.height(), GetParam(), limits,
                           {});
  }
};

TEST_P(DeepContours, ComeBack) {
  for (const std::int32_t side : {1, 2, 63, 64, 65, 130, 300}) {
    for (const unsigned seed : {1U, 2U, 3U}) {
      const Bitmap ink = random_ink(side, side, seed);
      EXPECT_TRUE(verify(encode(ink), ink)) << side;
    }
  }
}

TEST_P(DeepContours, DamagedPayloadsAreRefused) {
  const Bitmap ink = random_ink(90, 70, 4);
  const Bytes payload = encode(ink);
  for (std::size_t i = 0; i < payload.size(); i += 60) {
    Bytes damaged = payload;
    damaged[i] ^= static_cast<std::uint8_t>(1U << i % 8);
    EXPECT_FALSE(verify(damaged, ink));
    EXPECT_FALSE(verify({payload.data(), i}, ink));
  }
}

TEST_P(DeepContours, KeepToTheMemoryLimit) {
  const Bitmap ink = *Bitmap::create(100, 100);
  DecodeLimits limits;
  limits.max_memory = contour_memory(GetParam(), 100, 100) - 1;
  const Status done = verify({}, ink, limits);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::limit_exceeded);
}

INSTANTIATE_TEST_SUITE_P(Revisions, DeepContours,
                         ::testing::Values(kContourSmall, kContourDeep),
                         [](const auto& tested) {
                           return tested.param == kContourSmall ? "Small"
                                                                : "Max";
                         });

}  // namespace
}  // namespace unstep::codec
