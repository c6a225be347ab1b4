#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "codec/chain_match.h"
#include "codec/chain_track.h"
#include "codec/context.h"
#include "codec/dss_state.h"
#include "codec/pixel_planes.h"
#include "codec/vertex_rulers.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// Follows the lines of thin ink: what was done and is seen at the head of a
/// line, and in which order the pixels around it are asked about. Encoder and
/// decoder run the same object in step; everything is integer.
///
/// Pixels are named by the turn that leads to them, in eighths to the left of
/// the heading: a set of them is a number with bit t for turn t.
///
/// `Model` derives from this and has
///
///     look(sight)               a head is reached
///     ask(found)                pixels come: the first ones (0), or those
///     after
///                               the one found
///     decide(coder, node, bit)
template <class Model>
class LineFollower {
 public:
  static constexpr std::size_t kNodes = 8;

  /// In the order in which pixels are asked about.
  static constexpr std::array<std::uint8_t, 8> kOrder{0, 1, 7, 2, 6, 3, 5, 4};

  /// A piece of ink is met at this pixel; its lines start there.
  void begin_piece(Point start) { start_ = start; }
  /// A line starts at a pixel, heading to `direction`. `turn`: how it left the
  /// line it branched from, or -1 if it left none.
  void begin_line(Point at, Step direction, int turn) {
    dss_.reset();
    if (turn < 0) return track_.begin(at, direction);
    const Point move = step_delta(direction, YAxis::down);
    track_.begin({at.x - move.x, at.y - move.y},
                 static_cast<Step>((direction - turn) & 7));
    advance(static_cast<unsigned>(turn));
  }

  /// Codes which of the pixels around the head are ink, of those not yet known
  /// (at least one): `unknown` and the result are sets of turns.
  template <class Coder>
  unsigned code(Coder& coder, unsigned unknown, unsigned truth) {
    model().look(see());
    model().ask(0);
    unsigned rest = unknown;
    unsigned first = 0;
    for (const std::uint8_t turn : kOrder) {
      const unsigned bit = 1U << turn;
      if ((rest & bit) == 0) continue;
      rest &= ~bit;
      if (!model().decide(coder, kNodeOf[turn], (truth & bit) != 0)) continue;
      first = bit;
      break;
    }
    if (first == 0 || rest == 0) return first;
    if (!model().decide(coder, first == 1 ? kMoreAhead : kMoreAside,
                        (truth & rest) != 0)) {
      return first;
    }
    return first | code_more(coder, first, rest, truth);
  }

  /// The line goes on by this turn.
  void advance(unsigned turn) {
    match_.push(turn);
    track_.advance(turn);
    dss_.push(track_.direction());
  }

  [[nodiscard]] Point position() const { return track_.position(); }
  [[nodiscard]] Step direction() const { return track_.direction(); }
  [[nodiscard]] std::uint32_t steps() const { return track_.steps(); }

 protected:
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

  /// What is seen at the head.
  struct Sight {
    std::uint64_t base = 0;  ///< diagonal or not, the first steps of a line
    PixelPatch patch;
    std::uint64_t near = 0;     ///< what is known of 3 x 3 pixels
    std::uint64_t all = 0;      ///< and of 5 x 5
    std::uint64_t grid = 0;     ///< the rulers here
    std::uint64_t verdict = 0;  ///< of the straight segment
    unsigned level = 0;         ///< of the match
    unsigned guess = 0;
    std::uint64_t home = 0;  ///< the way to the start of the piece, if near
  };

  static constexpr std::size_t kContexts = 8;
  using Values = std::array<std::uint64_t, kContexts>;
  /// Of sets of weights: how many vectors, for the first pixels.
  using Selectors = std::array<std::size_t, 4>;
  static constexpr Selectors kVectors{512, 1024, 256, 256};

  /// As many follow for pixels beside one that was found.
  static constexpr Selectors twice(Selectors vectors) {
    for (std::size_t& n : vectors) n *= 2;
    return vectors;
  }

  /// The planes and rulers must outlive the model.
  LineFollower(const PixelPlanes& planes, const VertexRulers& rulers)
      : planes_(planes), rulers_(rulers) {}

  [[nodiscard]] Values contexts(const Sight& sight) const {
    const auto& [base, patch, near, all, grid, verdict, level, guess,
                 way_home] = sight;
    const auto history = [this](unsigned turns) {
      return track_.history(turns);
    };
    return {mix(near, mix(history(2), base)),
            mix(near, mix(history(6), base)),
            mix(all, mix(history(1), base)),
            mix(verdict, mix(history(4), base)),
            way_home != 0 ? mix(way_home, mix(history(1), track_.direction()))
                          : mix(history(3) << 3 | track_.direction(), 99),
            mix(grid, mix(near, track_.direction())),
            mix(grid, mix(history(2), base)),
            mix(level << 3 | guess, base)};
  }
  [[nodiscard]] Selectors selectors(const Sight& sight) const {
    return {static_cast<std::size_t>(track_.history(2)) * kNodes,
            (sight.level * 8 + sight.guess) * kNodes +
                ((sight.patch.ink & pixel_patch::kOuter) != 0 ? 512U : 0U),
            static_cast<std::size_t>(sight.verdict >> 5 & 31) * kNodes,
            (std::min(track_.steps(), 15U) * 2 + (sight.home != 0 ? 1U : 0U)) *
                kNodes};
  }

  ChainTrack track_{YAxis::down};
  DssState dss_{8};

 private:
  Model& model() { return static_cast<Model&>(*this); }

  /// Pixels of ink after the first: one at least, so the last needs no code.
  template <class Coder>
  unsigned code_more(Coder& coder, unsigned first, unsigned rest,
                     unsigned truth) {
    model().ask(first);
    unsigned found = 0;
    for (const std::uint8_t turn : kOrder) {
      const unsigned bit = 1U << turn;
      if ((rest & bit) == 0) continue;
      rest &= ~bit;
      const bool last = rest == 0 && found == 0;
      if (last || model().decide(coder, kNodeOf[turn], (truth & bit) != 0)) {
        found |= bit;
      }
    }
    return found;
  }

  [[nodiscard]] Sight see() const {
    const Point at = track_.position();
    Sight sight;
    sight.base = (track_.direction() & 1U) |
                 std::uint64_t{std::min(track_.steps(), 3U)} << 1;
    sight.patch = pixel_patch::at(planes_, planes_.at(at.x, at.y),
                                  track_.direction() / 2U);
    sight.near = pixel_patch::near(sight.patch);
    sight.all = pixel_patch::all(sight.patch);
    sight.grid = rulers_.column(at.x) << 6 | rulers_.row(at.y);
    sight.verdict = dss_.verdict(track_.direction());
    sight.level = match_.confidence();
    sight.guess = sight.level > 0 ? match_.prediction() : 0;
    sight.home = home();
    return sight;
  }

  [[nodiscard]] std::uint64_t home() const {
    constexpr std::int32_t kNear = 20;
    const std::int32_t dx = start_.x - track_.position().x;
    const std::int32_t dy = start_.y - track_.position().y;
    if (std::abs(dx) > kNear || std::abs(dy) > kNear) return 0;
    return static_cast<std::uint64_t>((dx + 32) << 7 | (dy + 32));
  }

  const PixelPlanes& planes_;
  const VertexRulers& rulers_;
  ChainMatch match_;
  Point start_;  ///< of the piece of ink
};

}  // namespace unstep::codec
