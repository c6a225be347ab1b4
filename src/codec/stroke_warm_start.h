#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "codec/block_coder.h"

/// The warm start of coder 25: payloads of that coder, made of other drawings
/// by tests/bench/train_strokes.cpp, which both sides decode first, one after
/// the other, so that their models know what each taught them. Part of the
/// format: a changed table is a new table id.
namespace unstep::codec {

struct StrokeModels;

namespace stroke_warm {

inline constexpr std::uint8_t kNoTable = 0;
inline constexpr std::uint8_t kTableId = 1;
/// Drawings of more paths learn better by themselves.
inline constexpr std::size_t kLarge = 3000;

struct Lesson {
  std::uint32_t paths = 0;
  std::uint32_t elements = 0;
  std::string_view payload;  ///< characters of warm_start.h, 6 bits each
};
using Table = std::span<const Lesson>;

/// The table of the format.
extern const Table kTable;

/// Decodes a table; models know nothing before but their own warm start.
void learn(Table table, StrokeModels& models);

}  // namespace stroke_warm

/// For training: encodes from another start.
Result<EncodedBlock> encode_strokes(std::span<const Path> paths,
                                    stroke_warm::Table start,
                                    const BlockProgress& progress);

}  // namespace unstep::codec
