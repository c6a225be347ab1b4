#include "codec/chain_coder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <span>
#include <vector>

#include "codec/block_coder.h"
#include "unstep/codec.h"
#include "unstep/grid.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

using codec::decode_chains;
using codec::encode_chains;
using codec::EncodedBlock;

std::uint64_t steps_of(const std::vector<Chain>& chains) {
  std::uint64_t steps = 0;
  for (const Chain& chain : chains) steps += chain.steps.size();
  return steps;
}

/// Encodes, decodes, compares; returns the payload.
std::vector<std::uint8_t> round_trip(const std::vector<Chain>& chains,
                                     YAxis axis = YAxis::down) {
  const Result<EncodedBlock> block = encode_chains(chains, axis, {});
  EXPECT_TRUE(block) << block.error().message;
  if (!block) return {};
  const auto decoded = decode_chains(block->name, block->payload, chains.size(),
                                     steps_of(chains), axis, {});
  EXPECT_TRUE(decoded) << decoded.error().message;
  EXPECT_TRUE(decoded && *decoded == chains) << "other chains came back";
  return block->payload;
}

/// A walk that turns seldom; a closed one goes straight home at the end.
Chain random_walk(std::mt19937& random, std::size_t steps, bool four,
                  bool closed) {
  Chain chain;
  chain.connectivity = four ? Connectivity::four : Connectivity::eight;
  chain.closed = closed;
  chain.origin = {static_cast<std::int32_t>(random() % 2000) - 1000,
                  static_cast<std::int32_t>(random() % 2000) - 1000};
  unsigned direction = random() % 8;
  Point at;
  const auto go = [&](unsigned step) {
    chain.steps.push_back(static_cast<Step>(step));
    const Point move = step_delta(static_cast<Step>(step));
    at = {at.x + move.x, at.y + move.y};
  };
  for (std::size_t i = 0; i < steps; ++i) {
    if (random() % 3 == 0) direction = (direction + 7 + random() % 3) % 8;
    if (random() % 50 == 0) direction = random() % 8;
    go(four ? direction & 6 : direction);
  }
  while (closed && at.x != 0) go(at.x > 0 ? 4 : 0);
  while (closed && at.y != 0) go(at.y > 0 ? 6 : 2);
  return chain;
}

std::vector<Chain> random_drawing(unsigned seed, std::size_t chains,
                                  std::size_t longest) {
  std::mt19937 random(seed);
  std::vector<Chain> drawing;
  for (std::size_t i = 0; i < chains; ++i) {
    const std::size_t steps = random() % (longest + 1);
    const bool four = random() % 2 == 0;
    const bool closed = random() % 2 == 0;
    drawing.push_back(random_walk(random, steps, four, closed));
  }
  return drawing;
}

TEST(ChainCoder, KeepsNoChainsAndChainsWithoutSteps) {
  EXPECT_TRUE(round_trip({}).empty());
  for (const bool closed : {false, true}) {
    for (const auto connectivity : {Connectivity::four, Connectivity::eight}) {
      round_trip({{{3, -4}, connectivity, closed, {}}});
      round_trip({{{3, -4}, connectivity, closed, {}},
                  {{}, connectivity, !closed, {}},
                  {{-1, 0}, connectivity, closed, {}}});
    }
  }
}

TEST(ChainCoder, KeepsEachSingleStepAndPairOfSteps) {
  for (Step a = 0; a < 8; ++a) {
    for (const YAxis axis : {YAxis::up, YAxis::down}) {
      round_trip({{{7, 9}, Connectivity::eight, false, {a}}}, axis);
    }
    for (Step b = 0; b < 8; ++b) {
      round_trip({{{}, Connectivity::eight, false, {a, b}}});
      if (a % 2 == 0 && b % 2 == 0) {
        round_trip({{{}, Connectivity::four, false, {a, b}}});
      }
    }
    round_trip(
        {{{}, Connectivity::eight, true, {a, static_cast<Step>((a + 4) % 8)}}});
  }
}

TEST(ChainCoder, KeepsRetracingChains) {
  Chain there_and_back{{}, Connectivity::eight, true, {}};
  for (int i = 0; i < 100; ++i) {
    there_and_back.steps.push_back(static_cast<Step>(i % 5 == 0 ? 1 : 0));
  }
  for (std::size_t i = 100; i-- > 0;) {
    there_and_back.steps.push_back(
        static_cast<Step>(there_and_back.steps[i] ^ 4));
  }
  round_trip({there_and_back});
  Chain to_and_fro{{}, Connectivity::four, false, {}};
  for (int i = 0; i < 1000; ++i) {
    to_and_fro.steps.push_back(static_cast<Step>(i % 2 * 4));
  }
  round_trip({to_and_fro});
}

TEST(ChainCoder, KeepsRandomWalks) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Chain> chains =
        random_drawing(seed, 1 + seed % 7, 1U << (seed % 12));
    round_trip(chains, seed % 2 == 0 ? YAxis::up : YAxis::down);
  }
}

TEST(ChainCoder, KeepsManyChains) {
  round_trip(random_drawing(100, 20'000, 4));
}

TEST(ChainCoder, KeepsAVeryLongChain) {
  std::mt19937 random(101);
  round_trip({random_walk(random, 600'000, false, true)});
}

TEST(ChainCoder, KeepsExtremeCoordinates) {
  std::vector<Chain> corners;
  for (const std::int32_t x : {-kMaxCoord, kMaxCoord}) {
    for (const std::int32_t y : {-kMaxCoord, kMaxCoord}) {
      const Step inward = x < 0 ? 0 : 4;
      corners.push_back(
          {{x, y}, Connectivity::four, false, {inward, inward, inward}});
    }
  }
  round_trip(corners, YAxis::up);
  round_trip(corners, YAxis::down);
}

TEST(ChainCoder, SpendsLittleOnStraightLinesAndOnRepetition) {
  const Chain ruled{
      {5, 5}, Connectivity::eight, false, std::vector<Step>(100'000, 3)};
  EXPECT_LT(round_trip({ruled}).size(), 60U);
  std::mt19937 random(102);
  Chain shape = random_walk(random, 500, false, true);
  const std::size_t once = round_trip({shape}).size();
  std::vector<Chain> stamps;
  for (int i = 0; i < 10; ++i) {
    stamps.push_back(shape);
    shape.origin.x += 3000;
  }
  EXPECT_LT(round_trip(stamps).size(), once * 2);
}

/// Steps of a straight line, 8- or 4-connected.
void draw_line(std::vector<Step>& steps, Segment line, bool four) {
  const Method method = four ? Method::evaluation : Method::evaluation8;
  std::vector<Step> drawn(static_cast<std::size_t>(std::abs(line.dx)) +
                          static_cast<std::size_t>(std::abs(line.dy)));
  const auto count = interpolate(method, {&line, 1}, drawn);
  ASSERT_TRUE(count);
  steps.insert(steps.end(), drawn.begin(),
               drawn.begin() + static_cast<std::ptrdiff_t>(*count));
}

/// A ring of straight lines up to `reach` along each axis, through its origin
/// once on the way.
Chain ring_of_lines(std::mt19937& random, bool four, std::int32_t reach) {
  const auto way = [&] {
    return static_cast<std::int32_t>(
               random() % static_cast<std::uint32_t>(2 * reach + 1)) -
           reach;
  };
  Chain chain{
      {-5, 7}, four ? Connectivity::four : Connectivity::eight, true, {}};
  for (int lap = 0; lap < 2; ++lap) {
    Segment home;
    for (int i = 0; i < 4; ++i) {
      const Segment line{way(), way()};
      draw_line(chain.steps, line, four);
      home = {home.dx - line.dx, home.dy - line.dy};
    }
    draw_line(chain.steps, home, four);
  }
  return chain;
}

TEST(ChainCoder, KeepsLongLinesInFewBytes) {
  std::mt19937 random(107);
  for (const bool four : {false, true}) {
    std::vector<Chain> chains;
    for (int i = 0; i < 6; ++i) {
      chains.push_back(ring_of_lines(random, four, 2000));
      Chain open = chains.back();
      open.closed = false;
      open.steps.resize(open.steps.size() / 2);
      chains.push_back(std::move(open));
    }
    chains.push_back(random_walk(random, 3000, four, true));
    round_trip(chains, YAxis::up);
    chains.pop_back();
    // About 45 bits a line of some 2000 steps.
    EXPECT_LT(round_trip(chains).size(), 6U * 15 * 8);
  }
}

TEST(ChainCoder, KeepsAMillionStepsOfALineInAFewBytes) {
  Chain line{{}, Connectivity::eight, false, {}};
  draw_line(line.steps, {1'000'003, 414'214}, false);
  EXPECT_LT(round_trip({line}).size(), 20U);
}

TEST(ChainCoder, RefusesInvalidChains) {
  const std::vector<Chain> invalid{
      {{}, Connectivity::eight, true, {0, 1}},
      {{}, Connectivity::four, false, {0, 1}},
      {{}, Connectivity::eight, false, {8}},
      {{kMaxCoord, 0}, Connectivity::eight, false, {0}},
      {{0, kMaxCoord + 1}, Connectivity::eight, false, {}}};
  for (const Chain& chain : invalid) {
    EXPECT_FALSE(encode_chains(std::span(&chain, 1), YAxis::up, {}));
  }
}

TEST(ChainCoder, StopsWhenTheCallerWantsTo) {
  const std::vector<Chain> chains = random_drawing(103, 300, 5);
  const auto stop = [](std::uint64_t) { return false; };
  const Result<EncodedBlock> none = encode_chains(chains, YAxis::up, stop);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::cancelled);
  const Result<EncodedBlock> block = encode_chains(chains, YAxis::up, {});
  const auto decoded = decode_chains(block->name, block->payload, chains.size(),
                                     steps_of(chains), YAxis::up, stop);
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error().code, ErrorCode::cancelled);
}

TEST(ChainCoder, RefusesOtherNames) {
  for (const codec::CoderName& name :
       {codec::CoderName{17, 0, 0}, codec::CoderName{16, 2, 0},
        codec::CoderName{16, 0, 1}}) {
    const auto decoded = decode_chains(name, {}, 0, 0, YAxis::up, {});
    ASSERT_FALSE(decoded);
    EXPECT_EQ(decoded.error().code, ErrorCode::unsupported_version);
  }
}

TEST(ChainCoder, ADrawingComesBackFromAFile) {
  for (const YAxis axis : {YAxis::up, YAxis::down}) {
    Drawing drawing{{300, 200, axis}, random_drawing(106, 40, 100), {}};
    UstpWriter writer{EncodeOptions{}};
    const Status added = writer.add_page(drawing, {});
    ASSERT_TRUE(added) << added.error().message;
    const auto file = writer.finish();
    ASSERT_TRUE(file);
    const auto reader = UstpReader::open(*file, {});
    ASSERT_TRUE(reader);
    const auto page = reader->read_page(0);
    ASSERT_TRUE(page) << page.error().message;
    EXPECT_TRUE(page->drawing == drawing);
    std::vector<std::uint8_t> damaged = *file;
    damaged[damaged.size() / 2] ^= 0x10;
    const auto other = UstpReader::open(damaged, {});
    EXPECT_FALSE(other && other->read_page(0)) << "the checksum sees it";
  }
}

/// Whatever is decoded is as declared and valid; returns whether anything was.
bool decodes_soundly(std::span<const std::uint8_t> payload, std::uint64_t count,
                     std::uint64_t steps) {
  const auto decoded =
      decode_chains({codec::kCoderChains, codec::kChainRevision, 0}, payload,
                    count, steps, YAxis::up, {});
  if (!decoded) {
    EXPECT_EQ(decoded.error().code, ErrorCode::corrupt);
    return false;
  }
  EXPECT_EQ(decoded->size(), count);
  EXPECT_EQ(steps_of(*decoded), steps);
  EXPECT_TRUE(encode_chains(*decoded, YAxis::up, {})) << "decoded is valid";
  return true;
}

/// Truncated anywhere, and with every `stride`-th bit the other way.
void expect_damage_is_seen(const std::vector<Chain>& chains,
                           std::size_t stride) {
  const std::uint64_t steps = steps_of(chains);
  const std::vector<std::uint8_t> payload =
      encode_chains(chains, YAxis::up, {})->payload;
  for (std::size_t size = 0; size < payload.size(); ++size) {
    decodes_soundly(std::span(payload).first(size), chains.size(), steps);
  }
  for (std::size_t bit = 0; bit < payload.size() * 8; bit += stride) {
    std::vector<std::uint8_t> damaged = payload;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    decodes_soundly(damaged, chains.size(), steps);
    const auto decoded =
        decode_chains({codec::kCoderChains, codec::kChainRevision, 0}, damaged,
                      chains.size(), steps, YAxis::up, {});
    EXPECT_FALSE(decoded && *decoded == chains) << "bit " << bit;
  }
  std::vector<std::uint8_t> longer = payload;
  longer.insert(longer.end(), 20, 1);
  EXPECT_FALSE(decodes_soundly(longer, chains.size(), steps));
}

TEST(ChainCoder, DamagedPayloadsAreRefusedOrSound) {
  expect_damage_is_seen(random_drawing(104, 12, 60), 1);
}

TEST(ChainCoder, DamagedSegmentsAreRefusedOrSound) {
  std::mt19937 random(108);
  const Chain ring = ring_of_lines(random, false, 300);
  Chain line{{9, 9}, Connectivity::four, false, {}};
  draw_line(line.steps, {1500, -700}, true);
  expect_damage_is_seen({ring, line}, 3);
}

TEST(ChainCoder, RandomPayloadsAreRefusedOrSound) {
  std::mt19937 random(105);
  for (int i = 0; i < 300; ++i) {
    std::vector<std::uint8_t> payload(random() % 40);
    for (std::uint8_t& byte : payload) {
      byte = static_cast<std::uint8_t>(random());
    }
    decodes_soundly(payload, random() % 6, random() % 200);
  }
}

TEST(ChainCoder, WrongCountsAreRefusedEarly) {
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
