#pragma once

#include <cstdint>

#include "codec/number_sequence.h"

namespace unstep::codec {

/// Where the next shape would stand, as far as ShapeLayout knows.
struct ShapePen {
  std::int32_t x = 0;     ///< right side of the last shape
  std::int32_t base = 0;  ///< and the line it stands on
  std::int32_t line_x = 0;
  std::int32_t line_base = 0;  ///< the same of the last line's first shape
  unsigned in_line = 0;        ///< shapes on this line, at most 15
};

/// A shape that has its place.
struct ShapeFact {
  std::uint32_t klass = 0;  ///< and 1
  std::int32_t gap = 0;
  std::int32_t rise = 0;
  std::int32_t x = 0;
  std::int32_t bottom = 0;
  std::int32_t width = 0;
  std::int32_t height = 0;
  bool new_line = false;
};

/// What a number said of shapes means.
struct ShapeFields {
  enum : std::uint8_t {
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
};

/// Codes where the words of coder 25 stand, as ShapeLayout tells it.
class ShapeSequence : public NumberSequence, public ShapeFields {
 public:
  using NumberSequence::NumberSequence;

  /// What other sequences look at.
  void begin(const ShapePen& /*pen*/) {}
};

}  // namespace unstep::codec
