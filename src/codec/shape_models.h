#pragma once

#include <cstdint>

#include "codec/deep_shape_pixels.h"
#include "codec/deep_shape_sequence.h"
#include "codec/shape_pixels.h"
#include "codec/shape_sequence.h"

namespace unstep::codec {

/// The models of ShapeScan: of the default effort.
struct MixedShapeModels {
  using Pixels = ShapePixels;
  using Sequence = ShapeSequence;

  static Sequence make_sequence(std::int32_t /*width*/) {
    return Sequence(kSequenceBits);
  }
  static constexpr std::uint64_t sequence_memory(std::int32_t /*width*/) {
    return std::uint64_t{ShapeSequence::kContexts * 4} << kSequenceBits;
  }

 private:
  static constexpr int kSequenceBits = 16;
};

/// Of the max effort.
struct DeepShapeModels {
  using Pixels = ShapePixelOrder<DeepShapePixels>;
  using Sequence = DeepShapeSequence;

  static Sequence make_sequence(std::int32_t width) { return Sequence(width); }
  static std::uint64_t sequence_memory(std::int32_t width) {
    return Sequence::memory(width);
  }
};

}  // namespace unstep::codec
