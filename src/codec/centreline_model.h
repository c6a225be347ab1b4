#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/chain_match.h"
#include "codec/chain_track.h"
#include "codec/dss_state.h"
#include "codec/node_slots.h"
#include "codec/pixel_planes.h"
#include "codec/vertex_rulers.h"
#include "entropy/mixer.h"
#include "entropy/refiner.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// Predicts which pixels around the head of a line are ink. Encoder and decoder
/// run the same object in step; everything is integer.
///
/// Pixels are named by the turn that leads to them, in eighths to the left of
/// the heading: a set of them is a number with bit t for turn t.
class CentrelineModel {
 public:
  static constexpr std::size_t kContexts = 15;
  static constexpr std::size_t kInputs = 32;
  static constexpr std::size_t kSets = 5;
  static constexpr std::size_t kNodes = 8;

  using Weights = std::array<std::int16_t, kInputs>;
  /// What the mixer starts with, 12 fractional bits: a vector for each node,
  /// and again for pixels beside one that was found.
  static const std::array<Weights, 2 * kNodes> kInitialWeights;

  /// In the order in which pixels are asked about.
  static constexpr std::array<std::uint8_t, 8> kOrder{0, 1, 7, 2, 6, 3, 5, 4};

  /// The planes and rulers must outlive the model; 2^table_bits slots per
  /// context.
  CentrelineModel(const PixelPlanes& planes, const VertexRulers& rulers,
                  int table_bits);

  /// Bytes that the constructor allocates, rounded up.
  static std::uint64_t memory(int table_bits);

  /// A piece of ink is met at this pixel; its lines start there.
  void begin_piece(Point start) { start_ = start; }
  /// A line starts at a pixel, heading to `direction`. `turn`: how it left the
  /// line it branched from, or -1 if it left none.
  void begin_line(Point at, Step direction, int turn);

  /// Codes which of the pixels around the head are ink, of those not yet known
  /// (at least one): `unknown` and the result are sets of turns.
  template <class Coder>
  unsigned code(Coder& coder, unsigned unknown, unsigned truth) {
    look_around();
    ask_slots(0);
    learn_last();
    unsigned rest = unknown;
    unsigned first = 0;
    for (const std::uint8_t turn : kOrder) {
      const unsigned bit = 1U << turn;
      if ((rest & bit) == 0) continue;
      rest &= ~bit;
      if (!decide(coder, kNodeOf[turn], (truth & bit) != 0)) continue;
      first = bit;
      break;
    }
    if (first == 0 || rest == 0) return first;
    if (!decide(coder, first == 1 ? kMoreAhead : kMoreAside,
                (truth & rest) != 0)) {
      return first;
    }
    return first | code_more(coder, first, rest, truth);
  }

  /// The line goes on by this turn.
  void advance(unsigned turn);

  [[nodiscard]] Point position() const { return track_.position(); }
  [[nodiscard]] Step direction() const { return track_.direction(); }
  [[nodiscard]] std::uint32_t steps() const { return track_.steps(); }

  /// For the training of kInitialWeights.
  [[nodiscard]] const auto& mixer() const { return mixer_; }

 private:
  using Slots = NodeSlots<kContexts, kNodes>;
  /// A decision about a pixel, or whether there are more pixels of ink after
  /// the first, straight ahead or not.
  enum Node : std::uint8_t {
    kAhead,
    kLeft,
    kRight,
    kFarLeft,
    kFarRight,
    kBehind,
    kMoreAhead,
    kMoreAside
  };
  static constexpr std::array<Node, 8> kNodeOf{
      kAhead, kLeft, kFarLeft, kBehind, kBehind, kBehind, kFarRight, kRight};
  using Selectors = std::array<std::size_t, kSets>;

  /// Pixels of ink after the first: one at least, so the last needs no code.
  template <class Coder>
  unsigned code_more(Coder& coder, unsigned first, unsigned rest,
                     unsigned truth) {
    ask_slots(first);
    learn_last();
    unsigned found = 0;
    for (const std::uint8_t turn : kOrder) {
      const unsigned bit = 1U << turn;
      if ((rest & bit) == 0) continue;
      rest &= ~bit;
      const bool last = rest == 0 && found == 0;
      if (last || decide(coder, kNodeOf[turn], (truth & bit) != 0)) {
        found |= bit;
      }
    }
    return found;
  }

  template <class Coder>
  bool decide(Coder& coder, Node node, bool bit) {
    bit = coder.code(bit, probability(node));
    slots_.note(node, bit);
    for (entropy::Refiner& refiner : refiners_) refiner.learn(bit);
    return bit;
  }

  void look_around();
  void ask_slots(unsigned found);
  void learn_last();
  int probability(Node node);
  [[nodiscard]] std::uint64_t home() const;

  const PixelPlanes& planes_;
  const VertexRulers& rulers_;
  Slots slots_;
  entropy::Mixer<kInputs, kSets, kNodes> mixer_;
  std::array<entropy::Refiner, 2> refiners_;
  ChainMatch match_;

  // The line.
  Point start_;  ///< of the piece of ink
  ChainTrack track_{YAxis::down};
  DssState dss_{8};

  // What is seen, the slots asked for, and the predictions not yet learned.
  std::array<std::uint64_t, kContexts> values_{};
  Selectors sight_{};
  Selectors selectors_{};
};

}  // namespace unstep::codec
