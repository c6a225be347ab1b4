#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "codec/block_coder.h"
#include "codec/path_checksum.h"
#include "unit/path_testing.h"
#include "unstep/grid.h"

namespace unstep {
namespace {

using codec::decode_paths;
using codec::encode_paths;
using codec::EncodedBlock;
using testing::arc;
using testing::elements_of;
using testing::line;
using testing::random_paths;

/// Encodes, decodes, compares; returns the payload.
std::vector<std::uint8_t> round_trip(const std::vector<Path>& paths) {
  const Result<EncodedBlock> block = encode_paths(paths, {});
  EXPECT_TRUE(block) << block.error().message;
  if (!block) return {};
  const auto decoded = decode_paths(block->name, block->payload, paths.size(),
                                    elements_of(paths), {});
  EXPECT_TRUE(decoded) << decoded.error().message;
  EXPECT_TRUE(decoded && *decoded == paths) << "other paths came back";
  return block->payload;
}

TEST(PathCoder, KeepsNoPathsAndPathsWithoutElements) {
  EXPECT_TRUE(round_trip({}).empty());
  for (const bool closed : {false, true}) {
    round_trip({{{3, -4}, closed, 0, {}}});
    round_trip({{{3, -4}, closed, 5, {}}, {{}, !closed, 0, {}}});
  }
}

TEST(PathCoder, KeepsEachSmallLineAndPairOfLines) {
  std::vector<Path> paths;
  for (std::int32_t x = -3; x <= 3; ++x) {
    for (std::int32_t y = -3; y <= 3; ++y) {
      paths.push_back({{7, 9}, false, 0, {line(x, y)}});
      paths.push_back({{7, 9}, true, 0, {line(x, y), line(-x, -y)}});
      for (std::int32_t z = -2; z <= 2; ++z) {
        paths.push_back({{x, y}, false, 0, {line(x, y), line(z, 2)}});
        paths.push_back({{x, y}, false, 0, {line(y, 2), line(x, z)}});
      }
      round_trip({paths.back()});
    }
  }
  round_trip(paths);
}

TEST(PathCoder, KeepsArcs) {
  for (const bool clockwise : {false, true}) {
    const Path circle{{5, 5}, true, 3, {arc({10, 0}, {}, clockwise)}};
    round_trip({circle});
    const Path rounded{{0, 0},
                       true,
                       0,
                       {line(20, 0), arc({0, 5}, {5, 5}, clockwise),
                        line(0, 20), arc({-5, 0}, {-5, 5}, clockwise),
                        line(-20, 0), arc({0, -5}, {-5, -5}, clockwise),
                        line(0, -20), arc({5, 0}, {5, -5}, clockwise)}};
    round_trip({rounded, circle, rounded});
    // Ends off the circle, full turns that are not at the end.
    round_trip({{{}, false, 0, {arc({1, 1}, {9, 0}), arc({3, 0}, {})}}});
  }
}

TEST(PathCoder, KeepsRandomPaths) {
  for (unsigned seed = 0; seed < 36; ++seed) {
    SCOPED_TRACE(seed);
    round_trip(random_paths(seed, 1 + seed % 9, 1U << seed % 9, seed % 2 == 0));
  }
}

TEST(PathCoder, KeepsManyPaths) { round_trip(random_paths(100, 2'000, 4)); }

TEST(PathCoder, KeepsExtremeCoordinates) {
  constexpr std::int32_t kFar = 2 * kMaxCoord;
  std::vector<Path> paths;
  for (const std::int32_t x : {-kMaxCoord, kMaxCoord}) {
    for (const std::int32_t y : {-kMaxCoord, kMaxCoord}) {
      const std::int32_t dx = x < 0 ? kFar : -kFar;
      const std::int32_t dy = y < 0 ? kFar : -kFar;
      paths.push_back({{x, y},
                       true,
                       kMaxCoord,
                       {line(dx, 0), line(0, dy), line(-dx, -dy), line(dx, dy),
                        arc({-dx, -dy}, {-dx, 0}), line(0, -dy)}});
      paths.push_back(
          {{x, y}, false, 0, {line(dx, dy), line(-dx, 1 - dy / 2)}});
    }
  }
  round_trip(paths);
}

TEST(PathCoder, RefusesInvalidPaths) {
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  Path::Element odd;
  odd.kind = static_cast<Path::Kind>(2);
  const std::vector<Path> invalid{
      {{}, true, 0, {line(1, 0)}},
      {{}, false, -1, {}},
      {{kMaxCoord + 1, 0}, false, 0, {}},
      {{kMaxCoord, 0}, false, 0, {line(1, 0)}},
      {{}, false, 0, {line(kLeast, kLeast)}},
      {{}, false, 0, {arc({0, 0}, {1, 1})}},
      {{}, false, 0, {arc({0, kLeast}, {1, 1})}},
      {{kMaxCoord, 0}, false, 0, {arc({1, 0}, {-1, 1})}},
      {{}, false, 0, {odd}}};
  for (std::size_t i = 0; i < invalid.size(); ++i) {
    const auto block = encode_paths(std::span(&invalid[i], 1), {});
    ASSERT_FALSE(block) << i;
    EXPECT_EQ(block.error().code, ErrorCode::invalid_argument);
    EXPECT_EQ(block.error().message.rfind("path 1: ", 0), 0U)
        << block.error().message;
  }
}

TEST(PathCoder, StopsWhenTheCallerWantsTo) {
  const std::vector<Path> paths = random_paths(103, 300, 5);
  const auto stop = [](std::uint64_t) { return false; };
  const Result<EncodedBlock> none = encode_paths(paths, stop);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::cancelled);
  const Result<EncodedBlock> block = encode_paths(paths, {});
  const auto decoded = decode_paths(block->name, block->payload, paths.size(),
                                    elements_of(paths), stop);
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error().code, ErrorCode::cancelled);
}

TEST(PathCoder, RefusesOtherNames) {
  for (const codec::CoderName& name :
       {codec::CoderName{26, 0, 0}, codec::CoderName{24, 7, 0},
        codec::CoderName{24, 0, 9}, codec::CoderName{16, 0, 0}}) {
    const auto decoded = decode_paths(name, {}, 0, 0, {});
    ASSERT_FALSE(decoded);
    EXPECT_EQ(decoded.error().code, ErrorCode::unsupported_version);
  }
}

TEST(PathCoder, SpendsLittleOnRepetition) {
  Path shape = random_paths(102, 1, 400, false)[0];
  shape.closed = true;
  const std::size_t once = round_trip({shape}).size();
  std::vector<Path> stamps;
  for (int i = 0; i < 10; ++i) {
    stamps.push_back(shape);
    shape.origin.x += 3000;
  }
  EXPECT_LT(round_trip(stamps).size(), once * 5 / 2);
}

codec::CoderName known_name() { return encode_paths({}, {})->name; }

/// Whatever is decoded is as declared and valid; returns whether anything was.
bool decodes_soundly(std::span<const std::uint8_t> payload, std::uint64_t count,
                     std::uint64_t elements) {
  const auto decoded = decode_paths(known_name(), payload, count, elements, {});
  if (!decoded) {
    EXPECT_EQ(decoded.error().code, ErrorCode::corrupt);
    return false;
  }
  EXPECT_EQ(decoded->size(), count);
  EXPECT_EQ(elements_of(*decoded), elements);
  EXPECT_TRUE(codec::survey_paths(*decoded, {})) << "decoded is valid";
  return true;
}

TEST(PathCoder, DamagedPayloadsAreRefusedOrSound) {
  const std::vector<Path> paths = random_paths(104, 8, 12);
  const std::uint64_t elements = elements_of(paths);
  const std::vector<std::uint8_t> payload = encode_paths(paths, {})->payload;
  for (std::size_t size = 0; size < payload.size(); ++size) {
    decodes_soundly(std::span(payload).first(size), paths.size(), elements);
  }
  for (std::size_t bit = 0; bit < payload.size() * 8; bit += 7) {
    std::vector<std::uint8_t> damaged = payload;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    decodes_soundly(damaged, paths.size(), elements);
    const auto decoded =
        decode_paths(known_name(), damaged, paths.size(), elements, {});
    EXPECT_FALSE(decoded && *decoded == paths) << "bit " << bit;
  }
  std::vector<std::uint8_t> longer = payload;
  longer.insert(longer.end(), 20, 1);
  EXPECT_FALSE(decodes_soundly(longer, paths.size(), elements));
}

TEST(PathCoder, RandomPayloadsAreRefusedOrSound) {
  std::mt19937 random(105);
  for (int i = 0; i < 200; ++i) {
    std::vector<std::uint8_t> payload(random() % 40);
    for (std::uint8_t& byte : payload) {
      byte = static_cast<std::uint8_t>(random());
    }
    decodes_soundly(payload, random() % 6, random() % 60);
  }
}

TEST(PathCoder, WrongCountsAreRefusedEarly) {
  const std::uint64_t huge = std::uint64_t{1} << 48;
  EXPECT_FALSE(decodes_soundly({}, 0, 1));
  EXPECT_FALSE(decodes_soundly({}, huge, huge));
  EXPECT_FALSE(decodes_soundly({}, 1, huge));
  EXPECT_FALSE(decodes_soundly({}, huge, 0));
  const std::vector<std::uint8_t> ones(30, 0xff);
  EXPECT_FALSE(decodes_soundly(ones, huge, huge));
  EXPECT_FALSE(decodes_soundly(ones, 1, huge));
}

}  // namespace
}  // namespace unstep
