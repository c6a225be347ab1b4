#include "codec/stroke_coder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "codec/path_checksum.h"
#include "codec/stroke_warm_start.h"
#include "codec/word_finder.h"
#include "unit/path_testing.h"

namespace unstep {
namespace {

using codec::decode_strokes;
using codec::EncodedBlock;
using testing::line;
using testing::random_paths;

std::uint64_t elements_of(const std::vector<Path>& paths) {
  std::uint64_t sum = 0;
  for (const Path& path : paths) sum += path.elements.size();
  return sum;
}

/// From both starts; the size from the table.
std::size_t round_trip(const std::vector<Path>& paths) {
  std::size_t size = 0;
  for (const auto& start :
       {codec::stroke_warm::Table{}, codec::stroke_warm::kTable}) {
    const auto block = codec::encode_strokes(paths, start, {});
    EXPECT_TRUE(block) << block.error().message;
    if (!block) return 0;
    const auto decoded = decode_strokes(block->name, block->payload,
                                        paths.size(), elements_of(paths), {});
    EXPECT_TRUE(decoded) << decoded.error().message;
    if (!decoded) return 0;
    EXPECT_EQ(*decoded, paths);
    size = block->payload.size();
  }
  return size;
}

/// Groups of three paths that touch, the same every time, in lines.
std::vector<Path> letters(std::size_t count) {
  std::vector<Path> paths;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<std::int32_t>(100 + 40 * (i % 20));
    const auto y = static_cast<std::int32_t>(100 + 60 * (i / 20));
    Path stem;
    stem.origin = {x, y};
    stem.width = 4;
    stem.elements = {line(0, 20)};
    Path bar = stem;
    bar.elements = {line(8, 0), line(2, 4), line(-2, 6), line(-8, 0)};
    Path leg = stem;
    leg.origin = {x + 4, y + 10};
    leg.elements = {line(i % 3 == 0 ? 6 : 8, 10)};
    paths.insert(paths.end(), {stem, bar, leg});
  }
  return paths;
}

TEST(StrokeCoder, RoundTripsAnyPaths) {
  round_trip({});
  round_trip({Path{}});
  for (unsigned seed = 1; seed <= 6; ++seed) {
    round_trip(random_paths(seed, seed * 4, 9));
  }
  Path far;
  far.origin = {kMaxCoord, -kMaxCoord};
  far.width = kMaxCoord;
  far.elements = {line(-kMaxCoord - kMaxCoord, kMaxCoord), line(1, kMaxCoord)};
  round_trip({far, far, far});
}

TEST(StrokeCoder, RoundTripsEveryUnit) {
  for (const std::int32_t unit : {1, 2, 4, 8, 16}) {
    std::vector<Path> paths = letters(12);
    for (Path& path : paths) {
      path.origin = {path.origin.x * unit + 3, path.origin.y * unit + 1};
      for (Path::Element& element : path.elements) {
        element.segment = {element.segment.dx * unit,
                           element.segment.dy * unit};
      }
    }
    round_trip(paths);
  }
}

TEST(StrokeCoder, TellsGroupsThatRepeatInTwoBytes) {
  const std::size_t few = round_trip(letters(40));
  const std::size_t many = round_trip(letters(240));
  EXPECT_LT(many - few, 200U);
}

TEST(StrokeCoder, TellsPathsThatBeginOnOthersCheaply) {
  std::mt19937 random(5);
  const auto any = [&](unsigned most) {
    return static_cast<std::int32_t>(random() % most);
  };
  std::vector<Path> on;
  std::vector<Path> off;
  Point end{500, 500};
  for (int i = 0; i < 100; ++i) {
    Path path;
    path.width = 3;
    path.origin = end;
    path.elements = {line(any(61) - 30, any(61) - 30 + 100)};
    on.push_back(path);
    path.origin = {any(1000), any(1000)};
    off.push_back(path);
    end = {on.back().origin.x + on.back().elements[0].segment.dx,
           on.back().origin.y + on.back().elements[0].segment.dy};
  }
  EXPECT_LT(round_trip(on) + 150, round_trip(off));
}

TEST(StrokeCoder, FindsGroupsThatRepeat) {
  const std::vector<Path> paths = letters(30);
  const auto groups = codec::find_groups(paths);
  std::uint64_t next = 0;
  for (const codec::PathGroup& group : groups) {
    EXPECT_EQ(group.first, next);
    next += group.count;
  }
  EXPECT_EQ(next, paths.size());
  EXPECT_EQ(groups.size(), 30U);
}

/// Whatever is decoded is as declared and valid.
void decodes_soundly(const codec::CoderName& name,
                     std::span<const std::uint8_t> payload, std::uint64_t count,
                     std::uint64_t elements) {
  const auto decoded = decode_strokes(name, payload, count, elements, {});
  if (!decoded) {
    EXPECT_EQ(decoded.error().code, ErrorCode::corrupt);
    return;
  }
  EXPECT_EQ(decoded->size(), count);
  EXPECT_EQ(elements_of(*decoded), elements);
  EXPECT_TRUE(codec::survey_paths(*decoded, {})) << "decoded is valid";
}

TEST(StrokeCoder, DamagedPayloadsAreRefusedOrSound) {
  const std::vector<Path> paths = letters(5);
  const std::uint64_t elements = elements_of(paths);
  const auto block =
      codec::encode_strokes(paths, codec::stroke_warm::Table{}, {});
  const std::vector<std::uint8_t>& payload = block->payload;
  for (std::size_t size = 0; size < payload.size(); ++size) {
    decodes_soundly(block->name, std::span(payload).first(size), paths.size(),
                    elements);
  }
  for (std::size_t bit = 0; bit < payload.size() * 8; bit += 13) {
    std::vector<std::uint8_t> damaged = payload;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    decodes_soundly(block->name, damaged, paths.size(), elements);
  }
  decodes_soundly(block->name, payload, paths.size() + 1, elements);
  decodes_soundly(block->name, payload, paths.size(), elements + 1);
  EXPECT_FALSE(decode_strokes(block->name, payload, 0, elements, {}));
}

TEST(StrokeCoder, RandomPayloadsAreRefusedOrSound) {
  std::mt19937 random(9);
  for (int i = 0; i < 12; ++i) {
    std::vector<std::uint8_t> payload(random() % 300);
    for (std::uint8_t& byte : payload) {
      byte = static_cast<std::uint8_t>(i % 3 == 0 ? 0xff : random());
    }
    decodes_soundly({codec::kCoderStrokes, 0, 0}, payload, 1 + random() % 500,
                    random() % 2000);
  }
}

TEST(StrokeCoder, RefusesOtherNames) {
  for (const codec::CoderName& name :
       {codec::CoderName{25, 1, 1}, codec::CoderName{25, 0, 2}}) {
    const auto decoded = decode_strokes(name, {}, 0, 0, {});
    ASSERT_FALSE(decoded);
    EXPECT_EQ(decoded.error().code, ErrorCode::unsupported_version);
  }
}

}  // namespace
}  // namespace unstep
