#include "codec/mixed_shape_sequence.h"

#include "codec/context.h"
#include "codec/shape_warm_start.h"

namespace unstep::codec {
namespace {

/// log2 of the slots per context.
int table_bits(std::int32_t width, std::int32_t height) {
  return std::int64_t{width} * height < 1'000'000 ? 14 : 16;
}

}  // namespace

MixedShapeSequence::MixedShapeSequence(std::int32_t width, std::int32_t height)
    : ShapeHistory(width),
      mixer_(table_bits(width, height), {kFields * kNodes, kFields * 3},
             shape_warm::kNumbers) {}

std::uint64_t MixedShapeSequence::memory(std::int32_t width,
                                         std::int32_t height) {
  return PixelMixer::memory(table_bits(width, height)) +
         ShapeHistory::memory(width);
}

PixelMixer::Contexts MixedShapeSequence::of_gap(const Contexts& known) const {
  const ShapeFact& a = last(0);
  return {known[1],
          known[2],
          known[4],
          bits_of(from()),
          mix(bits_of(right_to(0)), bits_of(right_to(1))),
          mix(klass(), mix(a.klass, bits_of(a.gap))),
          mix(pen().in_line, bits_of(a.width)),
          mix(bits_of(a.gap), bits_of(a.width))};
}

PixelMixer::Contexts MixedShapeSequence::of_rise(const Contexts& known) const {
  return {known[0],
          known[1],
          known[2],
          known[3],
          known[4],
          known[5],
          bits_of(pen().base),
          mix(klass(), bits_of(gap()))};
}

PixelMixer::Contexts MixedShapeSequence::of_class(const Contexts& known) const {
  return {known[0],
          known[1],
          known[2],
          known[4],
          known[5],
          word(),
          mix(bits_of(right_to(0)), above(0).klass),
          bits_of(last(0).height)};
}

PixelMixer::Contexts MixedShapeSequence::of_others(
    const Contexts& known) const {
  return {known[0],
          known[1],
          known[2],
          known[4],
          known[5],
          mix(mix(klass(), last(0).klass), mix(last(1).klass, last(2).klass)),
          mix(klass(), word()),
          mix(klass(), mix(bits_of(right_to(0)), above(0).klass))};
}

void MixedShapeSequence::look(Field field, const Contexts& contexts) {
  values_ = field == kGap     ? of_gap(contexts)
            : field == kRise  ? of_rise(contexts)
            : field == kClass ? of_class(contexts)
                              : of_others(contexts);
  const std::uint64_t told = kind() * 2 + refers();
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_[i] = mix(values_[i], (std::uint64_t{field} * 8 + i) * 8 + told);
  }
}

}  // namespace unstep::codec
