#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "deviation/free_space.h"

namespace unstep::deviation {
namespace {

/// A row of the free space: one line of the path, from A to B = A + d.
///
/// For a chain point Q, p = (Q - A) . d and c = d x (Q - A): the disc about Q
/// cuts from the line, in 1 / (denominator |d|) of path units,
/// denominator p +- sqrt(numerator^2 |d|^2 - denominator^2 c^2).
///
/// Range: |d|^2 <= 2^63 and numerator <= 2^30, so the root's number is below
/// 2^123; it is computed only where it is not negative. Int is int64 when the
/// parts of d and reach + 2 unit are at most 2^28: where a point is near
/// enough to matter |Q - A| <= 2^30, so |p|, |c| < 2^60. Otherwise Int128.
template <class Int>
class LineRow {
 public:
  LineRow(Front& front, Vector64 from, Segment segment)
      : front_(front),
        bound_(front.bound),
        chain_(front.chain),
        a_(from),
        d_{segment.dx, segment.dy},
        b_(from + d_),
        length2_(static_cast<Int>(dot(d_, d_))),
        full_(static_cast<UInt128>(bound_.numerator * bound_.numerator) *
              static_cast<UInt128>(length2_)) {
    widest_ = static_cast<Int>(floor_root(full_) /
                               static_cast<std::uint64_t>(bound_.denominator));
    const auto length =
        static_cast<Int>(floor_root(static_cast<UInt128>(length2_)) + 1);
    near_end_ = length2_ - length * (bound_.reach + 2 * bound_.unit);
    for (std::size_t step = 0; step < 8; ++step) {
      const Vector64 move = chain_.moves()[step];
      p_steps_[step] = static_cast<Int>(dot(d_, move));
      c_steps_[step] = static_cast<Int>(cross(d_, move));
    }
  }

  void run() {
    const std::size_t n = chain_.size();
    stand_at(front_.corner ? 0 : front_.entries.front().edge);
    if (front_.corner) restart();
    while (reached_ || entry_ < front_.entries.size()) {
      if (!reached_ && front_.entries[entry_].edge != at_.index)
        stand_at(front_.entries[entry_].edge);
      if (reached_) hurry();
      if (at_.index == n) break;
      cell();
    }
    front_.last = reached_ && at_.index == n;
    front_.farthest = std::max(front_.farthest, at_.index);
    front_.corner = front_.corner && bound_.within(front_.first, b_);
    front_.entries.swap(front_.next);
    front_.next.clear();
  }

 private:
  struct Place {
    std::size_t index = 0;
    Int p = 0;
    Int c = 0;
  };

  void stand_at(std::size_t index) {
    chain_.seek(index);
    const Vector64 q = chain_.at() - a_;
    at_ = {index, static_cast<Int>(dot(d_, q)), static_cast<Int>(cross(d_, q))};
  }

  void step(Place& place) const {
    const Step code = chain_.steps()[place.index];
    ++place.index;
    place.p += p_steps_[code];
    place.c += c_steps_[code];
  }

  /// The disc about the point cuts something from the line.
  bool cuts(const Place& place) {
    if (place.c > widest_ || place.c < -widest_) return false;
    if (place.p >= 0 && place.p <= length2_) return true;
    chain_.seek(place.index);
    return bound_.within(chain_.at(), place.p < 0 ? a_ : b_);
  }

  /// REQUIRES: cuts(place), so that the root's number is not negative.
  [[nodiscard]] LowEnd low_end(const Place& place) const {
    const Int128 c = Int128{place.c} * bound_.denominator;
    return {Int128{place.p} * bound_.denominator,
            full_ - static_cast<UInt128>(c * c)};
  }

  /// All that the disc about the point here cuts is reached.
  void restart() {
    reached_ = true;
    mark_ = at_;
    low_ = low_end(at_);
    most_ = at_.p;
  }

  /// The usual case: on the line's middle, forward, no entry, no end near.
  void hurry() {
    const std::size_t stop = entry_ < front_.entries.size()
                                 ? front_.entries[entry_].edge
                                 : chain_.size();
    const Step* steps = chain_.steps().data();
    Place place = at_;
    while (place.index < stop && place.p < near_end_) {
      const Step code = steps[place.index];
      const Int p = place.p + p_steps_[code];
      const Int c = place.c + c_steps_[code];
      if (p < most_ || p < 0 || c > widest_ || c < -widest_) break;
      most_ = p;
      place = {place.index + 1, p, c};
    }
    at_ = place;
  }

  /// The cell of the edge from here; goes to its end.
  void cell() {
    const bool enters = entry_ < front_.entries.size() &&
                        front_.entries[entry_].edge == at_.index;
    if (at_.p >= near_end_) leave(enters);
    if (enters) ++entry_;
    Place to = at_;
    step(to);
    const bool open = cuts(to);
    if (open && enters) {
      at_ = to;
      restart();
      return;
    }
    reached_ = open && reached_ && meets_all(to);
    at_ = to;
    if (reached_) most_ = std::max(most_, to.p);
  }

  /// What is reached of the edge from here at the line's end.
  void leave(bool enters) {
    chain_.seek(at_.index);
    const Vector64 move = chain_.move(at_.index);
    const Vector64 unit{move.x / bound_.unit, move.y / bound_.unit};
    const EdgeCut cut = cut_edge(bound_, chain_.at(), unit, b_);
    if (!cut.any) return;
    LowEnd low{cut.p, cut.s};
    if (!reached_) {
      const LowEnd& entered = front_.entries[entry_].low;
      if (!enters || !meets(entered, cut.p, cut.s)) return;
      if (at_most(low, entered)) low = entered;
    }
    front_.next.push_back({at_.index, low});
  }

  /// No low end since the last restart is above what the disc about `to` cuts.
  bool meets_all(const Place& to) {
    if (to.p >= most_) return true;
    const LowEnd here = low_end(to);
    // Not above the farthest point so far, hence no low end: the usual retreat.
    const Int128 back = Int128{most_ - to.p} * bound_.denominator;
    if (back < (Int128{1} << 62) && static_cast<UInt128>(back * back) <= here.s)
      return true;
    while (mark_.index < at_.index) {
      step(mark_);
      const LowEnd low = low_end(mark_);
      if (at_most(low_, low)) low_ = low;
    }
    return meets(low_, here.p, here.s);
  }

  Front& front_;
  const Bound& bound_;
  ChainWalk& chain_;
  Vector64 a_;
  Vector64 d_;
  Vector64 b_;
  Int length2_;
  UInt128 full_;      ///< numerator^2 |d|^2
  Int widest_ = 0;    ///< the largest |c| within the bound
  Int near_end_ = 0;  ///< below this p no disc about B is near the edge
  std::array<Int, 8> p_steps_{};
  std::array<Int, 8> c_steps_{};

  Place at_;
  bool reached_ = false;   ///< something of the line is, at the point here
  std::size_t entry_ = 0;  ///< the next one
  Int most_ = 0;           ///< the largest p since the restart
  Place mark_;  ///< up to here, low_ is the largest low end since then
  LowEnd low_;
};

}  // namespace

void walk_line(Front& front, Vector64 from, Segment segment) {
  if (segment == Segment{}) return;
  constexpr std::int64_t kNarrow = std::int64_t{1} << 28;
  const auto narrow = [](std::int64_t v) {
    return v >= -kNarrow && v <= kNarrow;
  };
  if (narrow(segment.dx) && narrow(segment.dy) &&
      narrow(front.bound.reach + 2 * front.bound.unit)) {
    LineRow<std::int64_t>(front, from, segment).run();
  } else {
    LineRow<Int128>(front, from, segment).run();
  }
}

}  // namespace unstep::deviation
