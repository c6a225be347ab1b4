#pragma once

#include "codec/path_model.h"
#include "codec/path_warm_start.h"
#include "codec/shape_sequence.h"
#include "codec/stroke_anchor.h"
#include "codec/stroke_head.h"

namespace unstep::codec {

/// What learns in coder 25; nothing of a payload itself.
struct StrokeModels {
  static constexpr int kTableBits = 16;

  StrokeModels() { path_warm::apply(path_warm::kTable, paths.vectors()); }

  /// Forgets all paths, but nothing that was learned.
  void restart() {
    anchors.restart();
    heads.restart();
    paths.restart();
  }

  NumberSequence items{kTableBits};   ///< StrokeWords and the frame
  NumberSequence starts{kTableBits};  ///< StrokeStart
  ShapeSequence layout{kTableBits};
  StrokeAnchor anchors{kTableBits};
  StrokeHeadModel heads{kTableBits};
  PathModel paths;
};

}  // namespace unstep::codec
