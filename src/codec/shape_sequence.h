#pragma once

#include <cstdint>

#include "codec/number_sequence.h"

namespace unstep::codec {

/// Codes what is said of shapes beside their pixels.
class ShapeSequence : public NumberSequence {
 public:
  /// What a number means.
  enum Field : std::uint8_t {
    kMore,
    kNewLine,
    kRefers,
    kClass,
    kRank,
    kSame,
    kWidth,
    kHeight,
    kSide,
    kAlignX,
    kAlignY,
    kGap,
    kRise,
    kFields
  };

  using NumberSequence::NumberSequence;
};

}  // namespace unstep::codec
