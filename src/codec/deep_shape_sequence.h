#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/deep_model.h"
#include "codec/number_sequence.h"
#include "codec/shape_sequence.h"

namespace unstep::codec {

/// Codes what is said of shapes for the max effort: what ShapeSequence sees and
/// twelve contexts more, in a DeepModel. Two matches tell what followed when
/// the same classes came before; columns and lines are known by their places;
/// and the shapes above tell where the next one stands.
class DeepShapeSequence
    : public NumberCoding<DeepShapeSequence, NumberSequence::Contexts>,
      public ShapeFields {
 public:
  static constexpr std::size_t kContexts = 18;
  using Contexts = NumberSequence::Contexts;

  /// For a band of this width.
  explicit DeepShapeSequence(std::int32_t width);

  static std::uint64_t memory(std::int32_t width);

  /// A shape comes: nothing of it is known yet.
  void begin(const ShapePen& pen);
  /// It refers to this shape.
  void refer(std::uint32_t id) { id_ = id; }
  void remember(const ShapeFact& fact);

  void look(Field field, const Contexts& contexts);
  void note(Field field, std::int64_t value);

  template <class Coder>
  bool decide(Coder& coder, Field field, std::uint32_t node, bool bit) {
    ask(std::uint64_t{field} << 27 | node);
    choose(field, node);
    return model_.code(coder, bit, choice_);
  }

 private:
  static constexpr int kTableBits = 18;
  static constexpr std::uint32_t kFacts = 1U << 16;  ///< that are remembered
  static constexpr int kHeadBits = 16;
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

  /// The k-th latest, 0 the last.
  [[nodiscard]] const ShapeFact& last(std::uint32_t k) const {
    return k < count_ ? fact(count_ - k) : none_;
  }
  [[nodiscard]] const ShapeFact& fact(std::uint32_t number) const {
    return number == 0 ? none_ : facts_[number % kFacts];
  }
  void push(Match& match);
  void find_above();
  [[nodiscard]] std::uint64_t foretold(Field field, const Match& match) const;
  [[nodiscard]] More more_of_gap() const;
  [[nodiscard]] More more_of_rise() const;
  [[nodiscard]] More more_of_others(Field field) const;
  void ask(std::uint64_t name);
  void choose(Field field, std::uint32_t node);

  Model model_;
  Model::Choice choice_;
  std::array<std::uint64_t, kContexts> values_{};

  // What was.
  std::vector<ShapeFact> facts_;
  std::uint32_t count_ = 0;
  std::array<Match, 2> matches_;
  std::vector<std::uint32_t> columns_;  ///< the last shape that began there
  std::uint64_t word_ = 0;              ///< classes since the last wide gap
  std::uint64_t last_word_ = 0;
  std::uint32_t line_class_ = 0;  ///< of the first shape on the line

  // The shape that is being told.
  ShapePen pen_;
  std::uint64_t kind_ = 0;  ///< 0 on the line, 1 a new line, 2 not known yet
  std::uint64_t refers_ = 0;
  std::uint64_t klass_ = 0;
  std::uint64_t id_ = 0;
  std::int64_t gap_ = 0;
  std::array<std::uint32_t, 2> above_{};  ///< numbers of facts, 0 none
  ShapeFact none_;
};

}  // namespace unstep::codec
