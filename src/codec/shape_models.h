#pragma once

#include "codec/deep_shape_pixels.h"
#include "codec/deep_shape_sequence.h"
#include "codec/mixed_shape_sequence.h"
#include "codec/shape_pixels.h"

namespace unstep::codec {

/// The models of ShapeScan: of the default effort.
struct MixedShapeModels {
  using Pixels = ShapePixels;
  using Sequence = MixedShapeSequence;
};

/// Of the max effort.
struct DeepShapeModels {
  using Pixels = ShapePixelOrder<DeepShapePixels>;
  using Sequence = DeepShapeSequence;
};

}  // namespace unstep::codec
