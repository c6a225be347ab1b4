#include "reverse/tolerance_lines.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <span>

namespace unstep::reverse {
namespace {

/// Steps that are looked at in vain before the farthest point is taken: in
/// proportion to the line found, so that the time stays linear.
constexpr std::size_t kPatience = 64;

/// Room for the lines of most chains, so that they need not grow.
std::size_t usual_lines(std::size_t steps) {
  return std::min<std::size_t>(steps / 4 + 8, 1024);
}

/// The last two points to which one line may go; `before` is the line's start
/// if there is but one.
struct Ends {
  LineVertex farthest;
  LineVertex before;
};

/// A look from a vertex along the chain.
class Look {
 public:
  Look(const ChainWalk& chain, PathTolerance tolerance,
       const NearDirections* near, LookMemory* memory)
      : chain_(chain), tolerance_(tolerance), near_(near) {
    for (std::size_t code = 0; code < moves_.size(); ++code) {
      const Point delta = chain.delta(static_cast<Step>(code));
      moves_[code] = delta.y * NearDirections::kRow + delta.x;
      // A longer step could pass the border of the near points.
      if (std::abs(delta.x) > 1 || std::abs(delta.y) > 1) near_ = nullptr;
    }
    if (near_ != nullptr && memory != nullptr) memory->begin(chain);
    if (near_ != nullptr && memory != nullptr && memory->in_use())
      memory_ = memory;
  }

  /// Looks no farther than `limit`.
  /// REQUIRES: from.index < limit, and `from` on the chain.
  Ends ends(const LineVertex& from, std::size_t limit) {
    if (memory_ == nullptr) {
      look(from, limit);
      return after(from, seen());
    }
    std::size_t index = from.index;
    while (index >= chain_.size()) index -= chain_.size();
    const std::uint64_t word = memory_->word_at(index);
    std::optional<LookMemory::Found> found =
        memory_->find(word, limit - from.index);
    if (!found) {
      look(from, limit);
      found = seen();
      const std::size_t steps = index_ - from.index;
      if (near_done_ && steps < LookMemory::kSteps && index_ < limit)
        memory_->keep(word, steps, *found);
    }
    return after(from, *found);
  }

 private:
  /// What the last look found.
  [[nodiscard]] LookMemory::Found seen() const {
    return {farthest_index_ - from_, before_index_ - from_, farthest_, before_};
  }
  static Ends after(const LineVertex& from, const LookMemory::Found& found) {
    return {{from.index + found.farthest_after, moved(from.at, found.farthest)},
            {from.index + found.before_after, moved(from.at, found.before)}};
  }

  void look(const LineVertex& from, std::size_t limit) {
    from_ = from.index;
    limit_ = limit;
    index_ = from.index;
    offset_ = farthest_ = before_ = {};
    farthest_index_ = before_index_ = from.index;
    stop_ = std::min(limit, from.index + kPatience);
    near_done_ = near_ != nullptr && is_done_near(*near_);
    if (near_ == nullptr) cone().restart();
    if (!near_done_) look_far();
  }

  void found(Point offset) {
    before_ = farthest_;
    before_index_ = farthest_index_;
    farthest_ = offset;
    farthest_index_ = index_;
    stop_ = std::min(limit_, from_ + 4 * (index_ - from_) + kPatience);
  }

  /// Most chains need none.
  Cone& cone() {
    if (!cone_) cone_.emplace(tolerance_);
    return *cone_;
  }

  void look_far() {
    if (index_ >= stop_) return;
    Cone& cone = *cone_;
    Step step = chain_.step(index_);
    while (index_ < stop_) {
      offset_ = moved(offset_, chain_.delta(step));
      ++index_;
      if (cone.may_end_at(offset_.x, offset_.y)) found(offset_);
      if (index_ == limit_) break;
      const Step next = chain_.step(index_);
      if (next != step && !cone.add(offset_.x, offset_.y)) break;
      step = next;
    }
  }

  /// The same among the near points. False if it leaves them: the cone is then
  /// that of all points before.
  bool is_done_near(const NearDirections& near);

  const ChainWalk& chain_;
  PathTolerance tolerance_;
  std::optional<Cone> cone_;
  const NearDirections* near_;
  LookMemory* memory_ = nullptr;
  bool near_done_ = false;  ///< the last look went no farther
  std::array<std::int32_t, 8> moves_;
  std::size_t from_ = 0;
  std::size_t limit_ = 0;
  std::size_t stop_ = 0;
  std::size_t index_ = 0;  ///< of the point at offset_
  Point offset_;
  std::size_t farthest_index_ = 0;
  Point farthest_;
  std::size_t before_index_ = 0;
  Point before_;
};

bool Look::is_done_near(const NearDirections& near) {
  // Locals: all that changes stays in registers.
  const std::int32_t near2 = near.near2();
  const std::span<const Step> steps = chain_.steps();
  const Step* const first = steps.data();
  const Step* const last = first + steps.size();
  const Step* next = first + index_ % steps.size();
  std::int32_t place = NearDirections::kApex;
  std::int32_t farthest = place;
  std::int32_t before = place;
  std::size_t looked = 0;  // steps from the apex
  std::size_t farthest_after = 0;
  std::size_t before_after = 0;
  const std::size_t limit = limit_ - from_;
  std::size_t stop = stop_ - from_;
  std::int32_t farthest2 = 0;
  std::uint16_t left = 0;
  std::uint16_t right = 0;
  // Signed: counter-clockwise, by less than half a turn.
  const auto from_to = [](std::uint16_t a, std::uint16_t b) {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(b - a));
  };
  const auto end = [&](bool done) {
    index_ = from_ + looked;
    offset_ = NearDirections::offset_of(place);
    stop_ = from_ + stop;
    farthest_ = NearDirections::offset_of(farthest);
    farthest_index_ = from_ + farthest_after;
    before_ = NearDirections::offset_of(before);
    before_index_ = from_ + before_after;
    return done;
  };
  for (;;) {
    const Step step = *next;
    const std::int32_t there = place + moves_[step];
    const NearDirections::Entry q = near.at(there);
    if (q.r2 == NearDirections::kOutside) {
      cone().resume(farthest2, {near.vector_of(left), near.vector_of(right)});
      return end(false);
    }
    if (++next == last) next = first;
    place = there;
    ++looked;
    const bool is_end =
        farthest2 <= near2
            ? q.r2 != 0
            : (static_cast<int>(q.r2 + near2 >= farthest2) &
               static_cast<int>(from_to(right, q.direction) >= 0) &
               static_cast<int>(from_to(q.direction, left) >= 0)) != 0;
    before = is_end ? farthest : before;
    before_after = is_end ? farthest_after : before_after;
    farthest = is_end ? place : farthest;
    farthest_after = is_end ? looked : farthest_after;
    stop = is_end ? std::min(limit, 4 * looked + kPatience) : stop;
    if (looked >= stop) return end(true);
    NearDirections::Range sides{q.left, q.right};
    if (q.r2 < farthest2) {
      if (farthest2 <= near2 || *next == step) continue;
      if (q.r2 <= near2) {
        if (near.holds_all(farthest2, q.r2)) continue;
        if (q.r2 == 0) return end(true);
      }
      const int quarters = near.quarters(farthest2, q.r2);
      if (quarters > 4) return end(true);
      sides = near.waiting(place, quarters);
    } else {
      const bool bounded = farthest2 > near2;
      farthest2 = q.r2;
      if (q.r2 <= near2) continue;
      if (!bounded) {
        left = sides.left;
        right = sides.right;
        continue;
      }
    }
    // As Cone::narrow().
    const bool tighter_left = from_to(sides.left, left) >= 0;
    const bool tighter_right = from_to(right, sides.right) >= 0;
    const std::int16_t of_left =
        tighter_left ? from_to(right, sides.left) : from_to(sides.right, left);
    const std::int16_t of_right =
        tighter_right ? from_to(sides.right, left) : from_to(right, sides.left);
    if ((of_left | of_right) < 0) return end(true);
    left = tighter_left ? sides.left : left;
    right = tighter_right ? sides.right : right;
  }
}

/// Lays line after line. Each goes as far as it can, unless the line after it
/// would then be short for its neighbourhood and gets farther from the point
/// before: the farthest point is often on the wrong side of the chain to go
/// on from. That look ahead brings the lines from 1.05-1.14 of the optimum to
/// 1.02-1.07 and costs half a pass.
class OnePass {
 public:
  /// `reach`: the most steps that a line may stand for.
  OnePass(Look& look, std::size_t reach) : look_(look), reach_(reach) {}

  void begin(const LineVertex& from, std::size_t last) {
    at_ = from;
    last_ = last;
    ends_ = look_from(from);
  }

  /// The end of the next line. REQUIRES: the last one was before `last`.
  LineVertex next() {
    LineVertex end = ends_.farthest;
    if (end.index < last_) {
      Ends onward = look_from(end);
      const bool is_short = 2 * (onward.farthest.index - end.index) <=
                            3 * (end.index - at_.index);
      if (is_short && ends_.before.index > at_.index &&
          onward.farthest.index < last_) {
        const Ends other = look_from(ends_.before);
        if (other.farthest.index > onward.farthest.index) {
          end = ends_.before;
          onward = other;
        }
      }
      ends_ = onward;
    }
    at_ = end;
    return end;
  }

 private:
  [[nodiscard]] Ends look_from(const LineVertex& from) const {
    return look_.ends(from, std::min(last_, from.index + reach_));
  }

  Look& look_;
  std::size_t reach_;
  std::size_t last_ = 0;
  LineVertex at_;
  Ends ends_;
};

/// Lines from the last vertex to exactly `last`.
void append_lines(const ChainWalk& chain, std::size_t last, Look& look,
                  LineVertices& vertices) {
  if (vertices.back().index >= last) return;
  OnePass lines(look, chain.size());
  lines.begin(vertices.back(), last);
  while (vertices.back().index < last) vertices.push_back(lines.next());
}

/// Closed chain: lines go on round the ring until they come to a vertex that
/// they made a lap before. From there on they close by themselves, without the
/// short line that ends at a start chosen blindly. If that has not happened
/// after two laps, the ring starts at the end of the first line.
LineVertices fit_ring(const ChainWalk& chain, Look& look) {
  const std::size_t lap = chain.size();
  LineVertices vertices;
  vertices.reserve(usual_lines(lap));
  vertices.push_back({0, chain.origin()});
  std::size_t before = 0;  // the first vertex not passed again
  OnePass lines(look, lap);
  lines.begin(vertices.front(), 4 * lap);
  while (vertices.back().index < 2 * lap) {
    vertices.push_back(lines.next());
    const std::size_t now = vertices.back().index;
    while (vertices[before].index + lap < now) ++before;
    if (vertices[before].index + lap == now) {
      vertices.erase(vertices.begin(),
                     vertices.begin() + static_cast<std::ptrdiff_t>(before));
      return vertices;
    }
  }
  LineVertices forced{vertices[1]};
  append_lines(chain, forced.front().index + lap, look, forced);
  return forced;
}

/// The point between two vertices that is farthest from their line; the first
/// vertex if all are on it. Products: differences are below 2^31, so a cross
/// product fits int64.
LineVertex farthest_from_line(const ChainWalk& chain, const LineVertex& from,
                              const LineVertex& to) {
  const std::int64_t dx = std::int64_t{to.at.x} - from.at.x;
  const std::int64_t dy = std::int64_t{to.at.y} - from.at.y;
  LineVertex best = from;
  std::int64_t distance = 0;
  Point at = from.at;
  for (std::size_t i = from.index; i + 1 < to.index; ++i) {
    at = moved(at, chain.delta(chain.step(i)));
    const std::int64_t cross =
        dx * (at.y - from.at.y) - dy * (at.x - from.at.x);
    if (std::abs(cross) > distance) {
      distance = std::abs(cross);
      best = {i + 1, at};
    }
  }
  return best;
}

/// A ring of two lines encloses nothing. If its chain does, each of the two
/// gets a vertex where the chain is farthest from it.
LineVertices unfolded(const ChainWalk& chain, const LineVertices& ring,
                      Look& look) {
  LineVertices result{ring.front()};
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const LineVertex middle = farthest_from_line(chain, ring[i - 1], ring[i]);
    if (middle.index > ring[i - 1].index) {
      append_lines(chain, middle.index, look, result);
    }
    append_lines(chain, ring[i].index, look, result);
  }
  return result;
}

/// Every corner of a closed chain, the least change there is.
LineVertices corners(const ChainWalk& chain) {
  LineVertices result;
  result.reserve(chain.size() + 1);
  Point at = chain.origin();
  for (std::size_t i = 1; i < 2 * chain.size(); ++i) {
    at = moved(at, chain.delta(chain.step(i - 1)));
    if (chain.straight_at(i)) continue;
    result.push_back({i, at});
    if (i == result.front().index + chain.size()) break;
  }
  return result;
}

/// Indices of the first vertex within the first lap.
void normalise(const ChainWalk& chain, LineVertices& ring) {
  const std::size_t laps = ring.front().index / chain.size() * chain.size();
  for (LineVertex& vertex : ring) vertex.index -= laps;
}

}  // namespace

LineVertices fit_lines(const ChainWalk& chain, PathTolerance tolerance,
                       const NearDirections* near, LookMemory* memory) {
  if (chain.size() == 0) return {{0, chain.origin()}};
  if (chain.closed() && chain.size() <= kSpeckSteps) return corners(chain);
  Look look(chain, tolerance, near, memory);
  if (!chain.closed()) {
    LineVertices vertices;
    vertices.reserve(usual_lines(chain.size()));
    vertices.push_back({0, chain.origin()});
    append_lines(chain, chain.size(), look, vertices);
    return vertices;
  }
  LineVertices vertices = fit_ring(chain, look);
  if (vertices.size() == 3) vertices = unfolded(chain, vertices, look);
  normalise(chain, vertices);
  return vertices;
}

void fit_lines_between(const ChainWalk& chain, PathTolerance tolerance,
                       std::size_t last, std::size_t longest,
                       LineVertices& vertices) {
  Look look(chain, tolerance, nullptr, nullptr);
  if (vertices.back().index >= last) return;
  OnePass lines(look, longest);
  lines.begin(vertices.back(), last);
  while (vertices.back().index < last) vertices.push_back(lines.next());
}

}  // namespace unstep::reverse
