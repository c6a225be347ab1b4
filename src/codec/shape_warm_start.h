#pragma once

#include "codec/pixel_mixer.h"

/// The warm start of coder 2: weights that the mixers of the default effort
/// begin with, learned from other pages by tests/bench/train_shapes.cpp, which
/// makes shape_warm_start_table.cpp. Part of the format (docs/format.md): a
/// changed table is a new table id.
namespace unstep::codec::shape_warm {

extern const PixelMixer::Start kPixels;
extern const PixelMixer::Start kNumbers;

}  // namespace unstep::codec::shape_warm
