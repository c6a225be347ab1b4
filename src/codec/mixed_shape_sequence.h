#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "codec/number_sequence.h"
#include "codec/pixel_mixer.h"
#include "codec/shape_history.h"

namespace unstep::codec {

/// Codes what is said of shapes for the default effort: under most of the
/// contexts that it is given, the places of columns and lines, and where the
/// shapes above stand.
class MixedShapeSequence
    : public NumberCoding<MixedShapeSequence, NumberSequence::Contexts>,
      public ShapeHistory {
 public:
  using Contexts = NumberSequence::Contexts;

  /// For a band of width x height pixels.
  MixedShapeSequence(std::int32_t width, std::int32_t height);

  static std::uint64_t memory(std::int32_t width, std::int32_t height);

  void look(Field field, const Contexts& contexts);

  template <class Coder>
  bool decide(Coder& coder, Field field, std::uint32_t node, bool bit) {
    PixelMixer::Contexts contexts;
    const std::uint64_t name = (std::uint64_t{node} / 2 + 1) * kGolden;
    for (std::size_t i = 0; i < contexts.size(); ++i) {
      contexts[i] = values_[i] ^ name;
    }
    PixelMixer::Places places;
    mixer_.find(contexts, places);
    return mixer_.code(coder, bit, places, node % 2 != 0,
                       {field * kNodes + std::min(node, kNodes - 1),
                        field * std::size_t{3} + kind()});
  }

  /// For training a warm start.
  [[nodiscard]] const PixelMixer::Mixer& mixer() const {
    return mixer_.mixer();
  }

 private:
  [[nodiscard]] PixelMixer::Contexts of_gap(const Contexts& known) const;
  [[nodiscard]] PixelMixer::Contexts of_rise(const Contexts& known) const;
  [[nodiscard]] PixelMixer::Contexts of_class(const Contexts& known) const;
  [[nodiscard]] PixelMixer::Contexts of_others(const Contexts& known) const;

  PixelMixer mixer_;
  PixelMixer::Contexts values_{};
};

}  // namespace unstep::codec
