#include <algorithm>
#include <cstddef>
#include <optional>

#include "deviation/free_space.h"
#include "grid/arc_ring.h"

namespace unstep::deviation {
namespace {

/// A row of the free space: an arc of the path, from A to B.
///
/// The path stands at the point M of the arc while the chain is behind M,
/// which needs |Q - M| <= t, and otherwise at the point on the chain's own
/// radius, which needs R - t <= |Q - C| <= R + t all along the edge. Both are
/// exact. That no other way would do is not shown: a failure is no proof.
///
/// Why M can be compared by the sign of a cross product: Q is within t of M and
/// R >= t + 2 units, so M is less than a quarter turn from Q, and an edge spans
/// less than an eighth. Why the path may run ahead from M to B while the chain
/// stands within t of both: a disc that does not reach C cuts less than half
/// of the circle, in one piece, so it holds the arc from M to B if that is the
/// shorter of the two.
class ArcRow {
 public:
  ArcRow(Front& front, Vector64 from, const Arc& arc)
      : front_(front),
        bound_(front.bound),
        chain_(front.chain),
        ring_(arc, bound_.numerator, bound_.denominator),
        circle_(ring_.circle()),
        a_(from),
        end_{arc.end.x, arc.end.y} {}

  void run() {
    const std::size_t n = chain_.size();
    stand_at(front_.corner ? 0 : front_.entries.front().edge);
    const bool corner = front_.corner;
    if (corner) hold_ = Hold();
    while (hold_ || entry_ < front_.entries.size()) {
      if (!hold_ && front_.entries[entry_].edge != i_)
        stand_at(front_.entries[entry_].edge);
      if (i_ == n) break;
      cell();
    }
    front_.last = hold_ && i_ == n && may_end(*hold_);
    front_.farthest = std::max(front_.farthest, i_);
    front_.corner =
        corner && may_end(Hold()) && bound_.within(front_.first, a_ + end_);
    front_.entries.swap(front_.next);
    front_.next.clear();
  }

 private:
  /// Where the path stands: at A, at B, or on the radius of a chain point.
  struct Hold {
    enum class At : std::uint8_t { start, radius, end };
    At kind = At::start;
    Vector64 at;       ///< the point, relative to A
    Int128 power = 0;  ///< of that point
  };

  void stand_at(std::size_t index) {
    chain_.seek(index);
    i_ = index;
    q_ = chain_.at() - a_;
    power_ = circle_.power(q_);
  }

  [[nodiscard]] bool near_start(Vector64 q) const {
    return bound_.within(q, {});
  }
  [[nodiscard]] bool near_end(Vector64 q) const {
    return bound_.within(q, end_);
  }

  /// Less than half a turn is left from the hold to B.
  [[nodiscard]] bool may_end(const Hold& hold) const {
    if (hold.kind == Hold::At::end) return true;
    if (hold.kind == Hold::At::start && circle_.full()) return false;
    return circle_.ahead(hold.at, end_) >= 0;
  }

  /// Where the path stands once the chain has gone on by `move`.
  [[nodiscard]] std::optional<Hold> advance(const Hold& hold, Vector64 move,
                                            Int128 change) const {
    const Vector64 to = q_ + move;
    if (hold.kind == Hold::At::end)
      return near_end(to) ? std::optional(hold) : std::nullopt;
    if (circle_.ahead(hold.at, to) <= 0) {
      const bool near =
          hold.kind == Hold::At::start
              ? near_start(to)
              : ring_.near_radius(hold.at, hold.power, to, power_ + change);
      return near ? std::optional(hold) : std::nullopt;
    }
    const Int128 power = power_ + change;
    if (!ring_.holds(power) || !ring_.stays_outside(move, power_, change))
      return std::nullopt;
    if (circle_.ahead(hold.at, end_) > 0 && circle_.ahead(end_, to) >= 0) {
      if (!near_end(to)) return std::nullopt;
      return Hold{Hold::At::end, end_, 0};
    }
    return Hold{Hold::At::radius, to, power};
  }

  void cell() {
    const bool enters =
        entry_ < front_.entries.size() && front_.entries[entry_].edge == i_;
    const Vector64 move = chain_.move(i_);
    const Int128 change = circle_.power_change(q_, move);
    leave(enters, move, change);
    std::optional<Hold> next;
    if (enters) next = advance(Hold(), move, change);
    if (!next && hold_) next = advance(*hold_, move, change);
    hold_ = next;
    if (enters) ++entry_;
    ++i_;
    q_ = q_ + move;
    power_ += change;
  }

  /// What is reached of the edge from here at B.
  void leave(bool enters, Vector64 move, Int128 change) {
    const Vector64 unit{move.x / bound_.unit, move.y / bound_.unit};
    const EdgeCut cut = cut_edge(bound_, q_, unit, end_);
    if (!cut.any) return;
    const LowEnd low{cut.p, cut.s};
    if (hold_ && may_end(*hold_) && leads_to_end(*hold_, move, change)) {
      front_.next.push_back({i_, low});
      return;
    }
    if (!enters || !may_end(Hold()) || !leads_to_end(Hold(), move, change))
      return;
    const LowEnd& entered = front_.entries[entry_].low;
    if (!meets(entered, cut.p, cut.s)) return;
    front_.next.push_back({i_, at_most(low, entered) ? entered : low});
  }

  /// From the hold to B while the chain goes to any place of the edge that is
  /// near B: standing near B already, or forward within the ring.
  [[nodiscard]] bool leads_to_end(const Hold& hold, Vector64 move,
                                  Int128 change) const {
    if (hold_ && near_end(q_)) return true;
    return circle_.ahead(hold.at, q_ + move) >= 0 &&
           ring_.stays_outside(move, power_, change);
  }

  Front& front_;
  const Bound& bound_;
  ChainWalk& chain_;
  ArcRing ring_;
  const ArcCircle& circle_;
  Vector64 a_;
  Vector64 end_;  ///< B - A
  std::size_t i_ = 0;
  Vector64 q_;        ///< the chain's point, relative to A
  Int128 power_ = 0;  ///< its power
  std::optional<Hold> hold_;
  std::size_t entry_ = 0;
};

}  // namespace

bool arc_is_decidable(const Bound& bound, const Arc& arc) {
  return ArcRing::decides(arc, bound.numerator, bound.denominator, bound.unit);
}

void walk_arc(Front& front, Vector64 from, const Arc& arc) {
  ArcRow(front, from, arc).run();
}

}  // namespace unstep::deviation
