#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/decision_model.h"
#include "codec/vector_classes.h"
#include "codec/vector_match.h"
#include "codec/vertex_memory.h"

namespace unstep::codec {

/// Where on its path a vector stands.
struct VectorPlace {
  std::int32_t vertex = 0;  ///< it leads from there, in the VertexMemory
  bool arc = false;         ///< it is the chord of an arc
  bool closed = false;
  std::uint64_t index = 0;  ///< elements before it
  std::uint64_t left = 0;   ///< elements of the path, it included, to come
  Vec home;                 ///< to the path's origin
  Vec tangent;              ///< of the element before at its end, may be zero
};

/// Predicts the vectors of paths: a turn among 28 classes of direction, then
/// the length (larger component), then the smaller component within the class.
/// Each binary decision has kContexts contexts, most of them about where an
/// expected vector lies: the one before, the bend continued, the other side of
/// a stroke, what followed here before, the way home.
class VectorModel {
 public:
  static constexpr std::size_t kContexts = 18;
  static constexpr std::size_t kSets = 3;  ///< of weights
  using Decisions = DecisionModel<kContexts, kSets, true>;

  VectorModel(int table_bits, const VertexMemory& vertices);

  /// A path starts.
  void begin();

  /// Codes a vector; `v` is what was coded afterwards, its components below
  /// 2^32. False if no vector has the class and length that were coded.
  template <class Coder>
  bool code(Coder& coder, const VectorPlace& place, Vec& v) {
    look_around(place);
    set_turn_contexts(place);
    if (code_zero(coder, v.zero())) {
      v = {};
      return true;
    }
    const int base = before_direction() % kDirections;
    int turn = (direction_of(v) - base + kDirections) % kDirections;
    turn = code_turn(coder, turn);
    direction_ = (base + turn) % kDirections;
    Vec r = turned_back(v, direction_ / 7);  // meaningless in a decoder
    find_parallel(place);
    set_length_contexts(place, turn);
    length_ = code_length(coder, std::max(r.x, r.y));
    const Range range = vectors::minor_range(direction_ % 7, length_);
    if (range.low > range.high) return false;
    const std::int64_t minor =
        code_minor(coder, place, turn, range, std::min(r.x, r.y));
    const int slope = direction_ % 7;
    r = slope <= 3 ? Vec{length_, minor} : Vec{minor, length_};
    v = turned_back(r, (4 - direction_ / 7) % 4);
    advance(v, turn);
    return true;
  }

  /// For a warm start and its training: of turns, lengths, smaller components.
  [[nodiscard]] std::array<Decisions, 3>& decisions() { return decisions_; }

 private:
  using Range = vectors::MinorRange;
  enum Part : std::uint8_t { kTurn, kLength, kMinor };
  /// Nodes of the turn; the others follow.
  static constexpr std::uint32_t kBends = 0, kRight = 1, kZero = 40;

  template <class Coder>
  bool decide(Coder& coder, Part part, bool bit, std::uint32_t node,
              std::uint32_t first, std::uint32_t second) {
    return decisions_[part].code(coder, bit, node + (arc_ ? 0x10000U : 0U),
                                 {first, second, stage_});
  }

  template <class Coder>
  bool code_zero(Coder& coder, bool zero) {
    return decide(coder, kTurn, zero, kZero, kZero, kZero);
  }

  template <class Coder>
  int code_turn(Coder& coder, int turn) {
    const auto decision = [&](bool bit, std::uint32_t node) {
      return decide(coder, kTurn, bit, node, node,
                    64 + turn_selector_ + (node > 2 ? 256U : 0U));
    };
    if (!decision(turn != 0, kBends)) return 0;
    const bool right = decision(turn > kDirections / 2, kRight);
    const int size = right ? kDirections - turn : turn;
    const int most = right ? 13 : 14;
    int coded = 1;
    while (coded < most &&
           decision(size > coded,
                    static_cast<std::uint32_t>(coded + (right ? 20 : 1)))) {
      ++coded;
    }
    return right ? kDirections - coded : coded;
  }

  /// The number of binary digits, then the digits below the first.
  template <class Coder>
  std::int64_t code_length(Coder& coder, std::int64_t length) {
    const auto decision = [&](bool bit, std::uint32_t node, unsigned width,
                              std::int64_t threshold, std::int64_t weight) {
      const std::uint32_t far =
          distance_class(expected_length_, threshold, weight);
      return decide(coder, kLength, bit, node, 64 + width,
                    512 + far + 16 * std::min(width, 10U) + length_selector_);
    };
    const auto true_width = static_cast<unsigned>(
        std::bit_width(static_cast<std::uint64_t>(length)));
    unsigned width = 1;
    while (width < 32) {
      const std::int64_t power = std::int64_t{1} << width;
      if (!decision(true_width > width, width, width, power, power)) break;
      ++width;
    }
    std::int64_t coded = 1;
    for (unsigned i = width - 1; i-- > 0;) {
      const bool bit = (length >> i & 1) != 0;
      const unsigned depth = width - 2 - i;
      bool one = false;
      if (depth < 6) {
        const std::uint32_t prefix =
            depth < 5 ? static_cast<std::uint32_t>(coded) : 63U;
        const std::int64_t power = std::int64_t{1} << i;
        one = decision(bit, (64 + 64 * width + prefix) * 4 + 1, width,
                       (2 * coded + 1) * power, power);
      } else {
        one = coder.code(bit, 32768);
      }
      coded = 2 * coded + (one ? 1 : 0);
    }
    return coded;
  }

  /// The smaller component by halving what the class of direction leaves.
  template <class Coder>
  std::int64_t code_minor(Coder& coder, const VectorPlace& place, int turn,
                          Range range, std::int64_t minor) {
    auto [low, high] = range;
    set_minor_expectations(place);
    std::uint32_t prefix = 1;
    for (int depth = 0; low < high; ++depth) {
      const std::int64_t middle = low + (high - low) / 2;
      const int width = std::min(
          static_cast<int>(
              std::bit_width(static_cast<std::uint64_t>(high - low + 1))),
          7);
      set_minor_contexts(place, turn, middle, width, prefix);
      const auto node =
          static_cast<std::uint32_t>(width * 8 + std::min(depth, 3));
      const bool upper =
          decide(coder, kMinor, minor > middle, 700 + node,
                 320 + node + (parallel_.kind > 0 ? 64U : 0U), minor_selector_);
      prefix = std::min(2 * prefix + (upper ? 1U : 0U), 255U);
      (upper ? low : high) = upper ? middle + 1 : middle;
    }
    return low;
  }

  struct Parallel {
    Vec move;
    int kind = 0;  ///< 0 none, 1 against its path's order, 2 along it
  };
  /// Where an expected vector would put the smaller component, times 8.
  struct Expected {
    std::int64_t value = 0;
    bool known = false;
  };

  [[nodiscard]] int before_direction() const {
    return before_[0].zero() ? 0 : direction_of(before_[0]);
  }
  [[nodiscard]] int relative(const Vec& v) const;
  [[nodiscard]] int relative_fine(const Vec& v) const;
  [[nodiscard]] Expected expected_minor(const Vec& v) const;
  void look_around(const VectorPlace& place);
  void find_parallel(const VectorPlace& place);
  void set_turn_contexts(const VectorPlace& place);
  void set_length_contexts(const VectorPlace& place, int turn);
  void set_minor_expectations(const VectorPlace& place);
  void set_minor_contexts(const VectorPlace& place, int turn,
                          std::int64_t middle, int width, std::uint32_t prefix);
  void advance(const Vec& v, int turn);

  const VertexMemory& vertices_;
  std::array<Decisions, 3> decisions_;
  VectorMatch match_;

  // What the path did: the vectors before, the latest first, and the turns
  // to them.
  std::array<Vec, 3> before_;
  std::array<int, 3> turns_{};

  // What is around the vector to be coded.
  bool arc_ = false;
  Vec bend_;      ///< the turn before made again
  Vec backward_;  ///< from the nearest vertex against its path's order
  Vec forward_;   ///< along it
  Vec offset_;    ///< to the nearest vertex
  int near_ = 0;  ///< 0 none, 1.. how near
  Parallel parallel_;
  std::uint32_t stage_ = 0;  ///< how far the path is
  std::uint32_t turn_selector_ = 0;
  std::uint32_t length_selector_ = 0;
  std::uint32_t minor_selector_ = 0;
  std::int64_t expected_length_ = 0;
  enum Guess : std::uint8_t {
    kStraight,
    kBend,
    kParallel,
    kMatch,
    kHome,
    kBackward,
    kSecond,
    kGuesses
  };
  std::array<Expected, kGuesses> guesses_;

  // What is known of it.
  int direction_ = 0;
  std::int64_t length_ = 0;
};

}  // namespace unstep::codec
