#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "codec/byte_writer.h"
#include "codec/checksum.h"
#include "codec/container_format.h"
#include "corrupt/file_surgery.h"
#include "unit/container_testing.h"

/// Short forms written by hand, field by field.
namespace unstep {
namespace {

using codec::ByteWriter;
using testing::Bytes;
using testing::decode_all;
using testing::expect_error;
using testing::random_ink;

/// A short form with a right checksum over `head` (flags to counts) and the
/// decoded bytes of `checksum`.
Bytes forge(const Bytes& head, std::uint32_t decoded_crc,
            std::uint64_t decoded_bytes, const Bytes& payload) {
  ByteWriter out;
  out.bytes(codec::kSignature);
  out.bytes(head);
  out.u32(codec::crc_join(codec::crc_bytes(head), decoded_crc, decoded_bytes));
  out.bytes(payload);
  return out.take();
}

/// Only the head matters: the file fails before its payload is looked at.
void expect_bad_head(const Bytes& head, ErrorCode code,
                     std::string_view reason) {
  Bytes file(codec::kSignature.begin(), codec::kSignature.end());
  file.insert(file.end(), head.begin(), head.end());
  file.insert(file.end(), 24, 0);
  expect_error(file, code, reason);
}

Bytes stored_payload(const Bitmap& ink) {
  return *codec::encode_stored(ink, 0, ink.height());
}

TEST(HostileShortForm, ForgedIntactFileIsReadable) {
  const Bitmap ink = random_ink(8, 6, 1);
  const Bytes file = forge({0, 8, 6, 0}, ink.crc32(), 6, stored_payload(ink));
  const auto decoded = decode_all(file);
  ASSERT_TRUE(decoded) << decoded.error().message;
  EXPECT_EQ(decoded->pages[0].ink, ink);
}

TEST(HostileShortForm, ForeignFilesAreNamedAsSuch) {
  expect_error({}, ErrorCode::bad_magic, "not a .ustp file");
  expect_error({0x89, 'P', 'N', 'G', '\r', '\n'}, ErrorCode::bad_magic,
               "not a .ustp file");
  expect_error({0xf5, 0x55}, ErrorCode::truncated, "the signature");
  expect_error({0xf5, 0x55, 0x0d, 0x0a}, ErrorCode::truncated, "the version");
}

TEST(HostileShortForm, NewerVersionsAreNamed) {
  for (int version = 1; version <= 3; ++version) {
    expect_bad_head({static_cast<std::uint8_t>(version), 8, 6, 0},
                    ErrorCode::unsupported_version,
                    "format version " + std::to_string(version));
  }
}

TEST(HostileShortForm, ImpossibleNumbersAreErrors) {
  const ErrorCode corrupt = ErrorCode::corrupt;
  expect_bad_head({0, 0x88, 0x00, 8, 0}, corrupt, "superfluous bytes");
  expect_bad_head({0, 0x80, 0x80, 0x80, 0x80, 0x04, 8, 0}, corrupt,
                  "at most 1073741823");
  expect_bad_head(
      {0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x02, 8, 0},
      corrupt, "exceeds 64 bits");
  expect_bad_head({0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff,
                   0xff, 0x01, 8, 0},
                  corrupt, "exceeds 64 bits");
  expect_bad_head({0, 0, 8, 0}, corrupt, "side of 0");
  expect_bad_head({0, 8, 0, 0}, corrupt, "side of 0");
  expect_bad_head({codec::kSquareFlag, 0, 0}, corrupt, "side of 0");
  expect_bad_head({0, 8, 8, 0}, corrupt, "equal sides are given twice");
  expect_bad_head({codec::kChainsKind, 0, 8, 16, 0, 0}, corrupt, "side of 0");
  expect_bad_head({codec::kPathsKind, 8, 0, 0, 24, 0, 0}, corrupt, "side of 0");
}

TEST(HostileShortForm, ImpossiblePathHeadsAreErrors) {
  const std::uint8_t kind = codec::kPathsKind | codec::kSquareFlag;
  const ErrorCode corrupt = ErrorCode::corrupt;
  expect_bad_head({kind, 8, 0x0b, 24, 0, 0}, ErrorCode::unsupported_version,
                  "unknown fidelity");
  // What the byte 3 says shorter.
  expect_bad_head({kind, 8, 0x19, 1, 2, 0x99, 0, 0}, corrupt,
                  "the usual coder is named");
  expect_bad_head({kind, 8, 0x40, 24, 0, 0}, corrupt, "unknown flags");
  expect_bad_head({kind, 8, 0x44, 28, 0, 0}, corrupt, "unknown flags");
  expect_bad_head({kind, 8, 0x81, 1, 0, 0}, corrupt, "usual head");
  expect_bad_head({kind, 8, 0x20, 1, 2, 24, 0, 0}, corrupt, "unknown flags");
  expect_bad_head({kind, 8, 0x21, 1, 0, 24, 0, 0}, corrupt,
                  "denominator 0 or 1");
  expect_bad_head({kind, 8, 0x21, 1, 1, 24, 0, 0}, corrupt,
                  "denominator 0 or 1");
  expect_bad_head({kind, 8, 0x10, 1, 24, 0, 0}, corrupt, "scale below 2");
  expect_bad_head({kind, 8, 0x10, 0x81, 0x80, 0x40, 24, 0, 0}, corrupt,
                  "at most 1048576");
}

TEST(HostileShortForm, ImpossibleResolutionsAreErrors) {
  const std::uint8_t flag = codec::kDetailsFlag | codec::kSquareFlag;
  const std::uint8_t one = codec::kResolutionFlag | 1;
  const std::uint8_t same = one | codec::kSameBothWaysFlag;
  const ErrorCode corrupt = ErrorCode::corrupt;
  expect_bad_head({flag, 8, same, 1, 0, 0}, corrupt, "denominator 0");
  expect_bad_head({flag, 8, one, 2, 1, 2, 0, 0}, corrupt, "denominator 0");
  expect_bad_head({flag, 8, one, 2, 1, 2, 1, 0}, corrupt, "given twice");
  expect_bad_head({flag, 8, codec::kResolutionFlag | 4, 0, 1, 0}, corrupt,
                  "says nothing");
  expect_bad_head({flag, 8, same, 0x80, 0x80, 0x80, 0x80, 0x10, 1, 0}, corrupt,
                  "at most 4294967295");
}

TEST(HostileShortForm, ImpossibleDetailsAreErrors) {
  const std::uint8_t flag = codec::kDetailsFlag | codec::kSquareFlag;
  const ErrorCode corrupt = ErrorCode::corrupt;
  for (const int details : {0, 1, 4, 0x11, 0x40, 0x80, 0xc8}) {
    expect_bad_head({flag, 8, static_cast<std::uint8_t>(details), 1, 1, 1, 1},
                    corrupt, "unknown details");
  }
  const std::uint8_t texts = codec::kTextsFlag;
  expect_bad_head({flag, 8, texts, 0, 0, 0}, corrupt, "page that has none");
  expect_bad_head({flag, 8, texts, 1, 0xff, 0, 0}, corrupt, "not UTF-8");
  expect_bad_head({flag, 8, texts, 1, 'a', 5, 2, 0x07, 0x00, 0}, corrupt,
                  "metadata does not inflate");
  expect_bad_head({flag, 8, texts, 0, 5, 0xff, 0xff, 0xff, 0xff, 0x7f}, corrupt,
                  "packed size");
  expect_bad_head({flag, 8, codec::kFileMetadataFlag, 0, 0}, corrupt,
                  "file that has none");
}

TEST(HostileShortForm, TheUsualCoderIsNotNamed) {
  expect_bad_head({0, 8, 6, 0xa1}, ErrorCode::corrupt, "usual coder");
  expect_bad_head({codec::kChainsKind, 8, 6, 16, 0, 0}, ErrorCode::corrupt,
                  "usual coder");
  expect_bad_head({codec::kPathsKind, 8, 6, 0, 0x98, 0, 0}, ErrorCode::corrupt,
                  "usual coder");
}

TEST(HostileShortForm, UnknownCodersAreErrors) {
  const Bitmap ink = random_ink(8, 6, 2);
  const Bytes payload = stored_payload(ink);
  for (const Bytes& name : {Bytes{31}, Bytes{0x80}, Bytes{0x20},
                            Bytes{0x60, 9, 0}, Bytes{0x60, 0, 200}}) {
    Bytes head{0, 8, 6};
    head.insert(head.end(), name.begin(), name.end());
    expect_error(forge(head, ink.crc32(), 6, payload),
                 ErrorCode::unsupported_version, "is unknown");
  }
  expect_bad_head({0, 8, 6, 0xe0, 3, 0}, ErrorCode::corrupt, "bit 7");
  expect_bad_head({0, 8, 6, 0x60, 2, 1}, ErrorCode::corrupt,
                  "long coder name for a short one");
}

TEST(HostileShortForm, HugeDimensionsAreRefusedBeforeAllocation) {
  // 2^30 - 1 squared: 2^57 bytes if anybody believed it.
  const Bytes head{codec::kSquareFlag, 0xff, 0xff, 0xff, 0xff, 0x03, 0};
  expect_error(forge(head, 0, 0, {1, 2, 3}), ErrorCode::limit_exceeded,
               "pixels");
  DecodeOptions options;
  options.limits.max_pixels = std::numeric_limits<std::uint64_t>::max();
  const Bytes file = forge(head, 0, 0, {1, 2, 3});
  const auto reader = UstpReader::open(file, options);
  ASSERT_TRUE(reader);
  const auto page = reader->read_page(0);
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().code, ErrorCode::limit_exceeded);
  EXPECT_NE(page.error().message.find("memory"), std::string::npos);
}

TEST(HostileShortForm, ManyChainsAndStepsAreRefusedBeforeAllocation) {
  // 2^48 chains; then 2^48 steps; then more than the format can count.
  const std::uint8_t flag =
      codec::kChainsKind | codec::kSquareFlag | codec::kUsualFlag;
  const Bytes big{0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x40};
  Bytes chains{flag, 8};
  chains.insert(chains.end(), big.begin(), big.end());
  chains.push_back(0);
  expect_error(forge(chains, 0, 0, {}), ErrorCode::limit_exceeded, "memory");
  Bytes steps{flag, 8, 1};
  steps.insert(steps.end(), big.begin(), big.end());
  expect_error(forge(steps, 0, 0, {}), ErrorCode::limit_exceeded, "steps");
  steps.back() = 0x41;
  expect_bad_head(steps, ErrorCode::corrupt, "at most");
}

TEST(HostileShortForm, ManyPathsAndElementsAreRefusedBeforeAllocation) {
  const std::uint8_t flag =
      codec::kPathsKind | codec::kSquareFlag | codec::kUsualFlag;
  const Bytes big{0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x40};
  Bytes paths{flag, 8};
  paths.insert(paths.end(), big.begin(), big.end());
  paths.push_back(0);
  expect_error(forge(paths, 0, 0, {}), ErrorCode::limit_exceeded, "memory");
  Bytes elements{flag, 8, 1};
  elements.insert(elements.end(), big.begin(), big.end());
  expect_error(forge(elements, 0, 0, {}), ErrorCode::limit_exceeded,
               "elements");
  // Few enough, but of more bytes than there may be: 2^19 of 32 bytes.
  expect_error(forge({flag, 8, 1, 0x80, 0x80, 0x20}, 0, 0, {}),
               ErrorCode::limit_exceeded, "memory");
  elements.back() = 0x41;
  expect_bad_head(elements, ErrorCode::corrupt, "at most");
}

TEST(HostileShortForm, WrongChecksumIsAnError) {
  const Bitmap ink = random_ink(12, 9, 3);
  expect_error(forge({0, 12, 9, 0}, ink.crc32() ^ 1, 18, stored_payload(ink)),
               ErrorCode::checksum_mismatch, "differs from what was encoded");
  const Bitmap other = random_ink(12, 9, 4);
  expect_error(forge({0, 12, 9, 0}, ink.crc32(), 18, stored_payload(other)),
               ErrorCode::checksum_mismatch, "differs from what was encoded");
}

TEST(HostileStoredCoder, StreamThatDoesNotFitTheRowsIsAnError) {
  const Bitmap ink = random_ink(12, 9, 5);
  const Bytes payload = stored_payload(ink);
  const auto with = [&](const Bytes& bytes) {
    return forge({0, 12, 9, 0}, ink.crc32(), 18, bytes);
  };
  expect_error(with({}), ErrorCode::corrupt, "damaged at row 0");
  Bytes longer = payload;
  longer.push_back(0);
  expect_error(with(longer), ErrorCode::corrupt, "end with the last row");
  expect_error(with(stored_payload(random_ink(12, 8, 5))), ErrorCode::corrupt,
               "damaged at row 8");
  expect_error(with(stored_payload(random_ink(12, 10, 5))), ErrorCode::corrupt,
               "end with the last row");
  Bytes no_check_value(payload.begin(), payload.end() - 4);
  expect_error(with(no_check_value), ErrorCode::corrupt,
               "end with the last row");
}

}  // namespace
}  // namespace unstep
