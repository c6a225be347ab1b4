#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/crack_map.h"
#include "codec/curve_fit.h"
#include "codec/dss_state.h"
#include "codec/patch.h"
#include "entropy/counter.h"

namespace unstep::codec {

using trace::kLeft;
using trace::kRight;
using trace::kStraight;
using trace::Turn;
using trace::turned;

/// A contour as it is walked: where the walk is, what it did, and what it sees
/// around it. Models of turns make their contexts of this. `kAll`: a straight
/// segment and curves are fitted to the last places at every step, for dss_ and
/// forecast(); else neither is kept, and gaps are looked for when asked for.
template <bool kAll>
class TurnWalk {
 public:
  /// A gate is one counter that decides whether a bend is so unlikely that it
  /// is coded with this counter alone: 2 of 5 steps of a technical drawing.
  static constexpr int kGateBits = 16;
  static constexpr int kGateAge = 24;    ///< observations before it may
  static constexpr int kGateRare = 512;  ///< of 65536

  /// A contour starts at a point (its address in the planes and in the flipped
  /// plane) and goes east. `ink`: ink is on the right.
  void begin(CrackMap::Address point, CrackMap::Address flipped, bool ink);

  /// The walk has taken a step (the crack is marked) and stands at the next
  /// point: looks at the cracks around it. Returns the turns that lead along
  /// unknown cracks, bit t for turn t.
  unsigned arrive() {
    around_ = patch::at(cracks_, point_, direction_);
    const unsigned ways = patch::ways(around_);
    return ~ways & 7U;
  }

 protected:
  struct Sight {  ///< the nearest parallel crack on one side
    unsigned distance = 0;
    unsigned shape = 0;
  };
  struct Trail {
    std::int32_t x, y;
    std::int64_t area;
  };

  explicit TurnWalk(const CrackMap& cracks)
      : cracks_(cracks), gates_(std::size_t{1} << kGateBits) {}

  /// The gate of the point.
  [[nodiscard]] entropy::Counter& gate();
  [[nodiscard]] static bool decides(const entropy::Counter& gate) {
    return gate.n >= kGateAge && gate.p < kGateRare;
  }

  /// The turn taken at the point, coded or forced, and the step after it.
  void move_on(Turn turn);

  /// The last turns, two bits each, the latest lowest.
  [[nodiscard]] std::uint64_t history(unsigned turns) const {
    return history_ & ((std::uint64_t{1} << (2 * turns)) - 1);
  }
  /// REQUIRED before look(): finds the cracks beside the one just walked,
  /// unless every step does.
  void look_aside() {
    if constexpr (!kAll) {
      gaps_ = gaps(point_ - cracks_.step(direction_),
                   flipped_ - cracks_.flipped_step(direction_), direction_);
    }
  }
  /// `right` or left of the crack just walked.
  [[nodiscard]] Sight look(bool right) const;
  [[nodiscard]] CurveFit::Forecast forecast() const;
  /// The last n steps, n < 128.
  [[nodiscard]] std::uint64_t chord(std::uint32_t n) const;
  [[nodiscard]] unsigned bulge(std::uint32_t n) const;

  const CrackMap& cracks_;
  std::uint64_t around_ = 0;  ///< the patch at the point

  // Where the walk is.
  CrackMap::Address point_ = 0;
  CrackMap::Address flipped_ = 0;
  Quarter direction_ = 0;
  bool ink_ = false;

  // What it did.
  std::uint64_t history_ = 0;  ///< two bits a turn, latest lowest
  std::uint64_t runs_ = 0;  ///< steps since the last eight turns, 8 bits each
  unsigned bends_ = 0;      ///< the last bends, two bits each
  std::uint32_t steps_ = 0;
  DssState dss_;

 private:
  [[nodiscard]] CurveFit::Gaps gaps(CrackMap::Address point,
                                    CrackMap::Address flipped,
                                    Quarter direction) const;
  [[nodiscard]] unsigned shape(CrackMap::Address point) const;
  [[nodiscard]] const Trail& trail(std::uint32_t n) const {
    return trail_[(steps_ - n) % trail_.size()];
  }

  std::vector<entropy::Counter> gates_;
  std::array<Trail, 128> trail_{};  ///< the last positions, by steps_ % 128
  Trail here_{};
  CurveFit curve_;
  CurveFit::Gaps gaps_{};  ///< of the crack just walked
};

extern template class TurnWalk<true>;
extern template class TurnWalk<false>;

}  // namespace unstep::codec
