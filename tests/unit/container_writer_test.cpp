#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "codec/container_format.h"
#include "unit/container_testing.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

using testing::Bytes;
using testing::random_ink;
using testing::write_pages;

ErrorCode code_of(const Status& status) {
  EXPECT_FALSE(status);
  return status ? ErrorCode::internal : status.error().code;
}

ErrorCode add_code(const PageInfo& info, EncodeOptions options = {}) {
  UstpWriter writer(std::move(options));
  return code_of(writer.add_page(random_ink(5, 5, 1), info));
}

ErrorCode add_code(const Drawing& drawing) {
  UstpWriter writer({});
  return code_of(writer.add_page(drawing, {}));
}

TEST(UstpWriter, NeedsAPage) {
  UstpWriter writer({});
  const Result<Bytes> file = writer.finish();
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::invalid_argument);
}

TEST(UstpWriter, IsUsedUpByFinishAndByFailure) {
  UstpWriter writer({});
  ASSERT_TRUE(writer.add_page(random_ink(5, 5, 1), {}));
  ASSERT_TRUE(writer.finish());
  EXPECT_FALSE(writer.finish());
  EXPECT_FALSE(writer.add_page(random_ink(5, 5, 1), {}));

  UstpWriter failed({});
  ASSERT_FALSE(failed.add_page(Bitmap(), {}));
  EXPECT_FALSE(failed.add_page(random_ink(5, 5, 1), {}));
  EXPECT_FALSE(failed.finish());
}

TEST(UstpWriter, RefusesWhatTheFormatCannotHold) {
  PageInfo info;
  info.name = "\xff";
  EXPECT_EQ(add_code(info), ErrorCode::invalid_argument);
  info.name = std::string("a\0b", 3);
  EXPECT_EQ(add_code(info), ErrorCode::invalid_argument);
  info.name = std::string(codec::kMaxNameBytes + 1, 'a');
  EXPECT_EQ(add_code(info), ErrorCode::limit_exceeded);
  info = {};
  info.resolution.y.denominator = 0;
  EXPECT_EQ(add_code(info), ErrorCode::invalid_argument);
  EncodeOptions options;
  options.bands = -1;
  EXPECT_EQ(add_code({}, options), ErrorCode::invalid_argument);
  UstpWriter writer({});
  EXPECT_EQ(code_of(writer.add_page(Bitmap(), {})), ErrorCode::out_of_range);
}

TEST(UstpWriter, RefusesBadMetadata) {
  for (const auto& [metadata, code] :
       {std::pair{Metadata{{"a", "1"}, {"a", "2"}},
                  ErrorCode::invalid_argument},
        {Metadata{{"", "1"}}, ErrorCode::invalid_argument},
        {Metadata{{"a", "\x80"}}, ErrorCode::invalid_argument},
        {Metadata{{"\xc3", "a"}}, ErrorCode::invalid_argument},
        {Metadata{{"a", std::string(codec::kMaxMetadataBytes, 'v')}},
         ErrorCode::limit_exceeded}}) {
    PageInfo info;
    info.metadata = metadata;
    EXPECT_EQ(add_code(info), code);
    EncodeOptions options;
    options.metadata = metadata;
    UstpWriter writer(options);
    ASSERT_TRUE(writer.add_page(random_ink(5, 5, 1), {}));
    const Result<Bytes> file = writer.finish();
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, code);
  }
}

TEST(UstpWriter, NeverWritesMoreMetadataThanTheReaderTakes) {
  PageInfo info;
  info.metadata = {{"a", std::string(codec::kMaxMetadataBytes - 3, 'v')}};
  for (const std::size_t pages : {15U, 16U}) {
    UstpWriter writer({});
    for (std::size_t i = 0; i < pages; ++i) {
      ASSERT_TRUE(writer.add_page(random_ink(5, 5, 1), info));
    }
    const Result<Bytes> file = writer.finish();
    if (pages == 16) {
      ASSERT_FALSE(file);
      EXPECT_EQ(file.error().code, ErrorCode::limit_exceeded);
    } else {
      ASSERT_TRUE(file) << file.error().message;
    }
  }
}

TEST(UstpWriter, RefusesInvalidDrawings) {
  const auto drawing = [](Chain chain) {
    return Drawing{{}, {std::move(chain)}, {}};
  };
  const ErrorCode invalid = ErrorCode::invalid_argument;
  EXPECT_EQ(add_code(Drawing{{}, {Chain{}}, {Path{}}, 1, Paint::fill}),
            invalid);
  EXPECT_EQ(add_code(drawing({{0, 0}, Connectivity::four, false, {0, 1}})),
            invalid);
  EXPECT_EQ(add_code(drawing({{0, 0}, Connectivity::eight, false, {8}})),
            invalid);
  EXPECT_EQ(add_code(drawing({{0, 0}, Connectivity::eight, true, {0, 2}})),
            invalid);
  EXPECT_EQ(add_code(drawing(
                {{kMaxCoord, 0}, Connectivity::eight, false, {4, 0, 0}})),
            invalid);
  EXPECT_EQ(
      add_code(drawing({{kMaxCoord + 1, 0}, Connectivity::four, false, {}})),
      invalid);
  EXPECT_EQ(add_code(drawing({{std::numeric_limits<std::int32_t>::min(), 0},
                              Connectivity::four,
                              false,
                              {}})),
            invalid);
  EXPECT_EQ(add_code(Drawing{{5, 0, YAxis::up}, {}, {}}),
            ErrorCode::out_of_range);
  EXPECT_EQ(add_code(Drawing{{-1, -1, YAxis::up}, {}, {}}),
            ErrorCode::out_of_range);
}

TEST(UstpWriter, VerificationDoesNotChangeTheBytes) {
  EncodeOptions with;
  with.bands = 3;
  EncodeOptions without = with;
  without.verify = false;
  const std::vector pages{random_ink(50, 40, 1), random_ink(3, 3, 2)};
  EXPECT_EQ(write_pages(pages, with), write_pages(pages, without));
}

/// A listener that proves it is never called twice at once and only forwards.
class Listener {
 public:
  explicit Listener(int calls) : calls_left_(calls) {}

  Progress progress() {
    return [this](std::uint64_t done, std::uint64_t total) {
      EXPECT_FALSE(inside_.exchange(true));
      EXPECT_GE(done, last_);
      EXPECT_LE(done, total);
      last_ = done;
      total_ = total;
      inside_ = false;
      return calls_left_-- > 0;
    };
  }
  [[nodiscard]] bool complete() const { return total_ > 0 && last_ == total_; }

 private:
  int calls_left_;
  std::atomic<bool> inside_{false};
  std::uint64_t last_ = 0;
  std::uint64_t total_ = 0;
};

TEST(ContainerProgress, ReachesTheTotalWhileEncodingAndDecoding) {
  for (const int jobs : {1, 4}) {
    const Bitmap ink = random_ink(100, 90, 3);
    Listener encoding(1 << 30);
    EncodeOptions options;
    options.bands = 6;
    options.jobs = jobs;
    options.progress = encoding.progress();
    const Bytes file = write_pages(std::vector{ink}, options);
    EXPECT_TRUE(encoding.complete());

    Listener decoding(1 << 30);
    DecodeOptions decode;
    decode.jobs = jobs;
    decode.progress = decoding.progress();
    ASSERT_TRUE(UstpReader::open(file, decode)->read_page(0));
    EXPECT_TRUE(decoding.complete());
  }
}

TEST(ContainerProgress, CancelsEncodingAndDecoding) {
  const Bitmap ink = random_ink(100, 90, 3);
  EncodeOptions plain;
  plain.bands = 4;
  const Bytes file = write_pages(std::vector{ink}, plain);
  for (const int calls : {0, 1, 3}) {
    Listener encoding(calls);
    EncodeOptions options = plain;
    options.jobs = 2;
    options.progress = encoding.progress();
    UstpWriter writer(options);
    EXPECT_EQ(code_of(writer.add_page(ink, {})), ErrorCode::cancelled);

    Listener decoding(calls);
    DecodeOptions decode;
    decode.jobs = 2;
    decode.progress = decoding.progress();
    const Result<UstpReader> reader = UstpReader::open(file, decode);
    ASSERT_TRUE(reader);
    const Result<Page> page = reader->read_page(0);
    ASSERT_FALSE(page);
    EXPECT_EQ(page.error().code, ErrorCode::cancelled);
  }
}

}  // namespace
}  // namespace unstep
