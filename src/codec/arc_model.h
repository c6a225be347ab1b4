#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/number_model.h"
#include "codec/vector_classes.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// Predicts the centre and the sense of an arc whose end is known. The centre
/// lies near the bisector of the chord, so that one of its components follows
/// from the other; that one is coded as the difference to a guess, which the
/// encoder chooses: the centre of the arc that continues the element before
/// without a corner, or of one with the radius of an earlier arc.
class ArcModel {
 public:
  static constexpr std::size_t kGuesses = 5;

  /// Codes the centre; REQUIRES for true arcs: the end is coded. False if it
  /// cannot be: its components are not below 2^32.
  template <class Coder>
  bool code(Coder& coder, const Vec& end, const Vec& tangent, Vec& centre,
            bool& clockwise) {
    clockwise = NumberModel::decide(coder, sense_[sense_context(end, tangent)],
                                    clockwise);
    const bool coded = end.zero()
                           ? code_circle(coder, centre)
                           : code_arc(coder, end, tangent, clockwise, centre);
    if (coded) remember(centre, clockwise);
    return coded;
  }

 private:
  static constexpr std::int64_t kLimit = std::int64_t{1} << 32;

  static bool small(const Vec& v) {
    return v.x > -kLimit && v.x < kLimit && v.y > -kLimit && v.y < kLimit;
  }

  template <class Coder>
  bool code_circle(Coder& coder, Vec& centre) {
    const Vec same = circle_;
    centre.x = same.x + circle_x_.code(coder, centre.x - same.x);
    centre.y = same.y + circle_y_.code(coder, centre.y - same.y);
    if (!small(centre)) return false;
    circle_ = centre;
    return true;
  }

  template <class Coder>
  bool code_arc(Coder& coder, const Vec& end, const Vec& tangent,
                bool clockwise, Vec& centre) {
    const bool y_first = std::abs(end.x) >= std::abs(end.y);
    const std::int64_t true_first = y_first ? centre.y : centre.x;
    const std::int64_t true_second = y_first ? centre.x : centre.y;
    const std::array<std::int64_t, kGuesses> guesses =
        guess_all(end, tangent, clockwise, y_first);
    std::size_t choice = best_guess(guesses, true_first);
    std::size_t k = 0;
    while (k + 1 < kGuesses &&
           NumberModel::decide(coder, choices_[choice_before_ * kGuesses + k],
                               choice > k)) {
      ++k;
    }
    choice = choice_before_ = k;
    const std::int64_t first =
        guesses[choice] +
        first_[choice].code(coder, true_first - guesses[choice]);
    if (first <= -kLimit || first >= kLimit) return false;
    const std::int64_t expected = on_bisector(end, y_first, first);
    const std::int64_t second =
        expected + second_.code(coder, true_second - expected);
    centre = y_first ? Vec{second, first} : Vec{first, second};
    return small(centre);
  }

  static std::size_t best_guess(
      const std::array<std::int64_t, kGuesses>& guesses, std::int64_t value) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < kGuesses; ++i) {
      if (std::abs(value - guesses[i]) < std::abs(value - guesses[best])) {
        best = i;
      }
    }
    return best;
  }

  [[nodiscard]] std::size_t sense_context(const Vec& end,
                                          const Vec& tangent) const;
  [[nodiscard]] std::array<std::int64_t, kGuesses> guess_all(
      const Vec& end, const Vec& tangent, bool clockwise, bool y_first) const;
  [[nodiscard]] static std::int64_t on_bisector(const Vec& end, bool y_first,
                                                std::int64_t first);
  void remember(const Vec& centre, bool clockwise);

  std::array<entropy::Counter, 8> sense_;
  std::array<entropy::Counter, kGuesses * kGuesses> choices_;
  std::array<SignedNumberModel, kGuesses> first_;
  SignedNumberModel second_;
  SignedNumberModel circle_x_;
  SignedNumberModel circle_y_;
  std::size_t choice_before_ = 0;
  bool clockwise_before_ = true;
  Vec circle_;
  std::array<std::int64_t, 2> squared_radii_{};  ///< of the last two sizes
};

}  // namespace unstep::codec
