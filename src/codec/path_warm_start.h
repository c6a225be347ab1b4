#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "codec/vector_model.h"

/// The warm start of coder 24: what its models of vectors know before the
/// first bit, learned from other drawings by tests/bench/train_path_coder.cpp,
/// which makes path_warm_start_table.cpp. Part of the format (docs/format.md):
/// a changed table is a new table id. Characters are those of warm_start.h.
namespace unstep::codec::path_warm {

inline constexpr std::uint8_t kTableId = 1;

struct Table {
  /// Counters, for each part and each of its contexts in turn, by growing
  /// index: a character for the indices passed over, one for the counter, the
  /// place of its stretch in kLevels times 4 and that of its age. kSomePassed
  /// has no counter; after kManyPassed a character says how often 64 are passed
  /// over, 0 ends the context.
  std::string_view counters;
  /// Weights: part, set, vector 12 bits, kWeights times 12 bits. Vector 4095:
  /// all of the part.
  std::string_view weights;
};

inline constexpr std::size_t kWeights = 2 * VectorModel::kContexts + 1;
inline constexpr unsigned kSomePassed = 62;
inline constexpr unsigned kManyPassed = 63;
inline constexpr std::array<int, 16> kLevels{
    -1500, -1000, -720, -510, -350, -220, -120, -36,
    36,    120,   220,  350,  510,  720,  1000, 1500};
inline constexpr std::array<std::uint8_t, 4> kCounterAges{3, 7, 14, 28};
inline constexpr unsigned kAllVectors = 4095;
/// What a vector of weights has seen that comes from the table.
inline constexpr std::uint16_t kWeightAge = 768;
/// Weights are stored in steps of 1 / 1024 around 0; mixers have 14 bits.
inline constexpr int kWeightShift = 4;
inline constexpr int kWeightZero = 2048;

/// The table of the format.
extern const Table kTable;

/// REQUIRES: a model that has coded nothing.
void apply(const Table& table, VectorModel& model);

}  // namespace unstep::codec::path_warm
