#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/shape_sequence.h"

namespace unstep::codec {

/// A number as a part of a context: negative ones modulo 2^64.
[[nodiscard]] constexpr std::uint64_t bits_of(std::int64_t value) {
  return static_cast<std::uint64_t>(value);
}

/// What was told of shapes, for models of what is told next: the shapes of
/// before, those above, and as much of the next shape as is known.
class ShapeHistory : public ShapeFields {
 public:
  /// For a band of this width.
  explicit ShapeHistory(std::int32_t width);

  static std::uint64_t memory(std::int32_t width);

  /// A shape comes: nothing of it is known yet.
  void begin(const ShapePen& pen);
  /// It refers to this shape.
  void refer(std::uint32_t id) { id_ = id; }
  /// A number that was told of it.
  void note(std::uint8_t field, std::int64_t value);
  /// It has its place.
  void remember(const ShapeFact& fact);

  /// The k-th latest, 0 the last.
  [[nodiscard]] const ShapeFact& last(std::uint32_t k) const {
    return k < count_ ? fact(count_ - k) : none_;
  }
  /// The k-th that stands above, and how far right of the pen and how far below
  /// its base; kNoShape if there is none.
  [[nodiscard]] const ShapeFact& above(std::size_t k) const {
    return fact(above_[k]);
  }
  [[nodiscard]] std::int32_t right_to(std::size_t k) const {
    return above_[k] == 0 ? kNoShape : above(k).x - from();
  }
  [[nodiscard]] std::int32_t up_to(std::size_t k) const {
    return above_[k] == 0 ? kNoShape : above(k).bottom - base();
  }
  [[nodiscard]] const ShapePen& pen() const { return pen_; }
  /// Where the shape would stand if its gap and its rise were 0.
  [[nodiscard]] std::int32_t from() const {
    return kind_ == 1 ? pen_.line_x : pen_.x;
  }
  [[nodiscard]] std::int32_t base() const {
    return kind_ == 1 ? pen_.line_base : pen_.base;
  }
  /// 0 on the line, 1 on a new line, 2 not known yet.
  [[nodiscard]] std::uint64_t kind() const { return kind_; }
  [[nodiscard]] std::uint64_t refers() const { return refers_; }
  [[nodiscard]] std::uint64_t klass() const { return klass_; }
  [[nodiscard]] std::uint64_t id() const { return id_; }
  [[nodiscard]] std::int64_t gap() const { return gap_; }
  /// Classes since the last wide gap, and those before it.
  [[nodiscard]] std::uint64_t word() const { return word_; }
  [[nodiscard]] std::uint64_t last_word() const { return last_word_; }
  /// The class of the first shape on the line.
  [[nodiscard]] std::uint32_t line_class() const { return line_class_; }

  static constexpr std::int32_t kNoShape = -999;

 protected:
  static constexpr std::uint32_t kFacts = 1U << 14;  ///< that are remembered

  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// By its number from 1 on; 0 is none.
  [[nodiscard]] const ShapeFact& fact(std::uint32_t number) const {
    return number == 0 ? none_ : facts_[number % kFacts];
  }

 private:
  void find_above();

  std::vector<ShapeFact> facts_;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> columns_;  ///< the last shape that began there
  std::uint64_t word_ = 0;
  std::uint64_t last_word_ = 0;
  std::uint32_t line_class_ = 0;
  ShapeFact none_;

  // The shape that is being told.
  ShapePen pen_;
  std::uint64_t kind_ = 0;
  std::uint64_t refers_ = 0;
  std::uint64_t klass_ = 0;
  std::uint64_t id_ = 0;
  std::int64_t gap_ = 0;
  std::array<std::uint32_t, 2> above_{};  ///< numbers of facts, 0 none
};

}  // namespace unstep::codec
