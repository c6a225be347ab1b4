#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "codec/context.h"
#include "codec/decision_model.h"

namespace unstep::codec {

/// Numbers to one, as a context; negative ones modulo 2^64.
template <class A, class B = int, class C = int>
std::uint64_t join_values(std::uint64_t tag, A a, B b = 0, C c = 0) {
  return mix(mix(mix(tag, static_cast<std::uint64_t>(a)),
                 static_cast<std::uint64_t>(b)),
             static_cast<std::uint64_t>(c));
}
/// A number of few values, for a context.
inline std::uint64_t clip_value(std::int32_t value, std::int32_t limit) {
  return static_cast<std::uint64_t>(std::clamp(value, -limit, limit) + limit);
}

/// How numbers become binary decisions, of which each has a field, which says
/// what it means, and a node. `Model` derives from this and has
///
///     look(field, contexts)       a number comes, under these contexts
///     decide(coder, field, node, bit)
///     note(field, value)          it is known
template <class Model, class Contexts>
class NumberCoding {
 public:
  /// Below 14, so that each field has weights of its own.
  using Field = std::uint8_t;

  template <class Coder>
  bool flag(Coder& coder, Field field, bool value, const Contexts& contexts) {
    model().look(field, contexts);
    value = model().decide(coder, field, 0, value);
    model().note(field, value ? 1 : 0);
    return value;
  }

  /// A number below 2^bits, the highest bit first. REQUIRES: bits <= 8.
  template <class Coder>
  unsigned small(Coder& coder, Field field, unsigned value, int bits,
                 const Contexts& contexts) {
    model().look(field, contexts);
    unsigned node = 1;
    for (int i = bits - 1; i >= 0; --i) {
      const bool bit = (value >> i & 1) != 0;
      node = node * 2 + (model().decide(coder, field, node, bit) ? 1U : 0U);
    }
    model().note(field, node - (1U << bits));
    return node - (1U << bits);
  }

  /// Any number up to 2^31 - 1: how many digits it has, one flag each, then
  /// the digits after the first.
  template <class Coder>
  std::uint32_t number(Coder& coder, Field field, std::uint32_t value,
                       const Contexts& contexts) {
    model().look(field, contexts);
    value = digits(coder, field, kSizes, value);
    model().note(field, value);
    return value;
  }

  /// Any number of +-(2^31 - 1).
  template <class Coder>
  std::int64_t signed_number(Coder& coder, Field field, std::int64_t value,
                             const Contexts& contexts) {
    model().look(field, contexts);
    value = signed_digits(coder, field, value);
    model().note(field, value);
    return value;
  }

 protected:
  static constexpr std::uint32_t kNodes = 72;  ///< that have weights

 private:
  static constexpr std::uint32_t kSizes = 0;  ///< nodes, 32 for either sign
  static constexpr std::uint32_t kSigns = 64;
  static constexpr std::uint32_t kDigits = 256;

  Model& model() { return static_cast<Model&>(*this); }

  template <class Coder>
  std::int64_t signed_digits(Coder& coder, Field field, std::int64_t value) {
    const auto size = static_cast<std::uint32_t>(std::abs(value));
    const bool zero = model().decide(coder, field, kSigns, value == 0);
    if (zero) return 0;
    const bool negative = model().decide(coder, field, kSigns + 1, value < 0);
    const std::uint32_t sizes = negative ? kSizes + 32 : kSizes;
    const std::int64_t read =
        std::int64_t{digits(coder, field, sizes, size - 1)} + 1;
    return negative ? -read : read;
  }

  template <class Coder>
  std::uint32_t digits(Coder& coder, Field field, std::uint32_t sizes,
                       std::uint32_t value) {
    const auto wanted = static_cast<std::uint32_t>(std::bit_width(value));
    std::uint32_t size = 0;
    while (size < 31 &&
           model().decide(coder, field, sizes + size, size < wanted)) {
      ++size;
    }
    if (size == 0) return 0;
    std::uint32_t read = 1;
    for (std::uint32_t i = size - 1; i-- > 0;) {
      const std::uint32_t node =
          kDigits + (sizes << 18) + (size << 12) + std::min(read, 1023U + i);
      const bool bit = (value >> i & 1) != 0;
      read = read * 2 + (model().decide(coder, field, node, bit) ? 1U : 0U);
    }
    return read;
  }
};

/// Codes numbers under contexts made of what came before, like a text. Numbers
/// of different fields share nothing.
class NumberSequence
    : public NumberCoding<NumberSequence, DecisionModel<6>::Values> {
 public:
  static constexpr std::size_t kContexts = 6;
  using Model = DecisionModel<kContexts, 2, false, true>;
  using Contexts = Model::Values;

  explicit NumberSequence(int table_bits)
      : model_(table_bits, std::array<Weights, 1>{initial()}) {}

  void look(Field /*field*/, const Contexts& contexts) {
    model_.set_contexts(contexts);
  }
  void note(Field /*field*/, std::int64_t /*value*/) {}

  template <class Coder>
  bool decide(Coder& coder, Field field, std::uint32_t node, bool bit) {
    const std::uint32_t weights = std::min(node, kNodes - 1);
    return model_.code(coder, bit, std::uint32_t{field} << 27 | node,
                       {field * kNodes + weights, field});
  }

 private:
  using Weights = Model::Weights;
  static constexpr Weights initial() {
    Weights weights{};
    std::fill_n(weights.begin(), 2 * kContexts, 6144 / kContexts);
    return weights;
  }

  Model model_;
};

}  // namespace unstep::codec
