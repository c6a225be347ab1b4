#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "unstep/codec.h"

/// Numbers of the .ustp container that both sides share. docs/format.md is the
/// normative description; section names below are its own.
namespace unstep::codec {

/// Not ASCII, not UTF-8, and broken by a 7-bit or a text-mode transfer.
inline constexpr std::array<std::uint8_t, 4> kSignature{0xf5, 0x55, 0x0d, 0x0a};

/// The byte after the signature: version in bits 0-1, form in bit 4, the page
/// flags of a short form in the others.
inline constexpr std::uint8_t kVersion = 0;
inline constexpr std::uint8_t kVersionMask = 0x03;
inline constexpr std::uint8_t kBlockFormFlag = 0x10;

/// Page flags. Bits 6 and 7 together say what the page holds; the y axis of
/// paths is in their path head.
inline constexpr std::uint8_t kSquareFlag = 0x04;
/// Short form: the usual coder, which is not named; of paths the usual head
/// too, which is left out.
inline constexpr std::uint8_t kUsualFlag = 0x08;
inline constexpr std::uint8_t kDetailsFlag = 0x20;
inline constexpr std::uint8_t kKindMask = 0xc0;
inline constexpr std::uint8_t kInkKind = 0x00;
inline constexpr std::uint8_t kChainsKind = 0x40;
inline constexpr std::uint8_t kPathsKind = 0x80;
inline constexpr std::uint8_t kChainsUpKind = 0xc0;  ///< chains, y up

/// Details of a page. Bits 0-2 are of the resolution.
inline constexpr std::uint8_t kUnitMask = 0x03;
inline constexpr std::uint8_t kSameBothWaysFlag = 0x04;
inline constexpr std::uint8_t kResolutionFlag = 0x08;
inline constexpr std::uint8_t kTextsFlag = 0x10;         ///< name, metadata
inline constexpr std::uint8_t kFileMetadataFlag = 0x20;  ///< short form

/// Path head.
inline constexpr std::uint8_t kFidelityMask = 0x03;
inline constexpr std::uint8_t kPathsUpFlag = 0x04;
inline constexpr std::uint8_t kStrokeFlag = 0x08;
inline constexpr std::uint8_t kScaleFlag = 0x10;
inline constexpr std::uint8_t kDenominatorFlag = 0x20;
inline constexpr std::uint8_t kProgramFlag = 0x40;  ///< no paths: a program
/// Short form: the usual coder without the usual head.
inline constexpr std::uint8_t kUsualPathCoderFlag = 0x80;
/// The usual path head: these flags and this fidelity.
inline constexpr std::uint8_t kUsualPathHead =
    static_cast<std::uint8_t>(Fidelity::Kind::tolerance);
inline constexpr Fidelity kUsualFidelity{Fidelity::Kind::tolerance, {1, 1}};
/// Short form: what stands for the usual head of strokes, these flags, fidelity
/// and scale, and for their coder.
inline constexpr std::uint8_t kUsualStrokes = 0x03;
inline constexpr std::uint8_t kUsualStrokeHead =
    kUsualPathHead | kStrokeFlag | kScaleFlag;
inline constexpr std::int32_t kUsualStrokeScale = 2;
/// What the head of a short form says of the coder.
enum class HeadCoder : std::uint8_t { named, usual, strokes };
inline constexpr std::uint8_t kPathHeadMask = 0x3f;
inline constexpr std::uint8_t kProgramHeadMask =
    kFidelityMask | kDenominatorFlag | kProgramFlag;

/// Block types. A set optional bit lets a reader that does not know the type
/// skip the block.
inline constexpr std::uint8_t kOptionalBit = 0x80;
inline constexpr std::uint8_t kHeaderBlock = 0x01;
inline constexpr std::uint8_t kPageBlock = 0x02;
inline constexpr std::uint8_t kPayloadBlock = 0x03;
inline constexpr std::uint8_t kEndBlock = 0x04;
inline constexpr std::uint8_t kMetadataBlock = 0x81;
inline constexpr std::uint8_t kIndexBlock = 0x82;

/// The fidelity byte of the header block: every page is bit for bit, step for
/// step what was given to the encoder.
inline constexpr std::uint8_t kFidelityExact = 0;

inline constexpr std::uint64_t kMaxNameBytes = 4096;
inline constexpr std::uint64_t kMaxMetadataBytes = 1U << 20;  ///< one list
inline constexpr std::uint64_t kMaxPackedMetadataBytes = 2U << 20;
inline constexpr std::uint64_t kMaxMetadataPairs = 4096;  ///< one list

/// What all metadata of one file may cost together, metadata_cost of each
/// list. Bounds the memory that opening a small hostile file can take.
inline constexpr std::uint64_t kMaxMetadataTotal = 16U << 20;

/// `bytes` before deflating, in `pairs` of key and value.
[[nodiscard]] constexpr std::uint64_t metadata_cost(std::uint64_t bytes,
                                                    std::uint64_t pairs) {
  return bytes + 64 * pairs;
}

/// Above this many pixels a page is cut into bands unless told otherwise.
inline constexpr std::uint64_t kAutoBandPixels = std::uint64_t{1} << 26;

/// Groups of chains and of paths are closed once they hold so much, so that a
/// part of a large page can be read alone.
inline constexpr std::uint64_t kGroupSteps = std::uint64_t{1} << 20;
inline constexpr std::uint64_t kGroupElements = std::uint64_t{1} << 16;

/// The box of a block of which the file does not say where it is.
inline constexpr Box kEverywhere{-kMaxCoord, -kMaxCoord, 2U * kMaxCoord,
                                 2U * kMaxCoord};

/// Bytes of a row of an ink page in its canonical form (PBM's).
[[nodiscard]] constexpr std::uint64_t row_bytes(std::int32_t width) {
  return (static_cast<std::uint64_t>(width) + 7) / 8;
}

}  // namespace unstep::codec
