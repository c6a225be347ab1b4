#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/deep_model.h"
#include "codec/number_sequence.h"
#include "codec/shape_history.h"

namespace unstep::codec {

/// Codes what is said of shapes for the max effort, in a DeepModel: under the
/// contexts that it is given and twelve more. Two matches tell what followed
/// when the same classes came before; columns and lines are known by their
/// places; and the shapes above tell where the next one stands.
class DeepShapeSequence
    : public NumberCoding<DeepShapeSequence, NumberSequence::Contexts>,
      public ShapeHistory {
 public:
  static constexpr std::size_t kContexts = 18;
  using Contexts = NumberSequence::Contexts;

  /// For a band of width x height pixels.
  DeepShapeSequence(std::int32_t width, std::int32_t height);

  static std::uint64_t memory(std::int32_t width, std::int32_t height);

  void look(Field field, const Contexts& contexts);
  void remember(const ShapeFact& fact);

  template <class Coder>
  bool decide(Coder& coder, Field field, std::uint32_t node, bool bit) {
    ask(std::uint64_t{field} << 27 | node);
    choose(field, node);
    return model_.code(coder, bit, choice_);
  }

 private:
  static constexpr int kTableBits = 18;
  static constexpr int kHeadBits = 14;
  using Model = DeepModel<kContexts, 0, 6, 2>;
  using More = std::array<std::uint64_t, 10>;
  static const Model::Choice kSizes;

  /// What followed the last place where the same classes came in a row.
  struct Match {
    std::uint32_t minimum;
    std::vector<std::uint32_t> heads;
    std::uint32_t at = 0;
    std::uint32_t length = 0;
  };

  void push(Match& match);
  [[nodiscard]] std::uint64_t foretold(Field field, const Match& match) const;
  [[nodiscard]] More more_of_gap() const;
  [[nodiscard]] More more_of_rise() const;
  [[nodiscard]] More more_of_others(Field field) const;
  void ask(std::uint64_t name);
  void choose(Field field, std::uint32_t node);

  Model model_;
  Model::Choice choice_;
  std::array<std::uint64_t, kContexts> values_{};
  std::array<Match, 2> matches_;
};

}  // namespace unstep::codec
