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

  /// Looks no farther than `limit`. Mostly the memory knows at once; nothing of
  /// that is written to be read again soon in other pieces, which would take
  /// longer than all the rest.
  /// REQUIRES: from.index < limit, and `from` on the chain.
  Ends ends(const LineVertex& from, std::size_t limit) {
    if (memory_ == nullptr) return after(from, look(from, limit));
    std::size_t index = from.index;
    while (index >= chain_.size()) index -= chain_.size();
    const std::uint64_t word = memory_->word_at(index);
    if (limit - from.index >= memory_->head_steps()) {
      const LookMemory::Head& head = memory_->head(word);
      if (head.is_done()) return after(from, memory_->found(head.ends(), word));
    }
    const LookMemory::Ends* known = memory_->find(word, limit - from.index);
    if (known != nullptr) return after(from, memory_->found(*known, word));
    return after(from, look_and_keep(word, from, limit));
  }

 private:
  static Ends after(const LineVertex& from, const LookMemory::Found& found) {
    return {{from.index + found.farthest_after, moved(from.at, found.farthest)},
            {from.index + found.before_after, moved(from.at, found.before)}};
  }

  [[gnu::noinline]] LookMemory::Found look(const LineVertex& from,
                                           std::size_t limit);
  [[gnu::noinline]] LookMemory::Found look_and_keep(std::uint64_t word,
                                                    const LineVertex& from,
                                                    std::size_t limit);

  void begin(const LineVertex& from, std::size_t limit) {
    from_ = from.index;
    limit_ = limit;
  }
  /// What the last look found.
  [[nodiscard]] LookMemory::Found seen() const {
    return {farthest_index_ - from_, before_index_ - from_, farthest_, before_};
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

  /// A look among the near points. Directions are places in their order.
  struct Near {
    std::int32_t place = NearDirections::kApex;
    std::int32_t farthest = place;
    std::int32_t before = place;
    std::size_t looked = 0;  ///< steps from the apex
    std::size_t farthest_after = 0;
    std::size_t before_after = 0;
    std::int32_t farthest2 = 0;
    std::uint16_t left = 0;
    std::uint16_t right = 0;
  };
  enum class Stopped : std::uint8_t { done, outside, paused };

  Stopped walk_near(const NearDirections& near, Near& state,
                    std::size_t pause) const;
  bool finish_near(Near state);
  bool begin_near(std::uint64_t word, Near& state);
  static LookMemory::Found found_by(const Near& state);

  const ChainWalk& chain_;
  PathTolerance tolerance_;
  std::optional<Cone> cone_;
  const NearDirections* near_;
  LookMemory* memory_ = nullptr;
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

/// Goes on until the look is done, leaves the near points or has seen `pause`
/// steps.
Look::Stopped Look::walk_near(const NearDirections& near, Near& state,
                              std::size_t pause) const {
  // A copy: all that changes stays in registers.
  Near s = state;
  const std::int32_t near2 = near.near2();
  const std::span<const Step> steps = chain_.steps();
  const Step* const first = steps.data();
  const Step* const last = first + steps.size();
  const Step* next = first + (from_ + s.looked) % steps.size();
  const std::size_t limit = limit_ - from_;
  std::size_t stop = std::min(limit, 4 * s.farthest_after + kPatience);
  // Signed: counter-clockwise, by less than half a turn.
  const auto from_to = [](std::uint16_t a, std::uint16_t b) {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(b - a));
  };
  const auto end = [&](Stopped how) {
    state = s;
    return how;
  };
  while (s.looked < pause) {
    const Step step = *next;
    const std::int32_t there = s.place + moves_[step];
    const NearDirections::Entry q = near.at(there);
    if (q.r2 == NearDirections::kOutside) return end(Stopped::outside);
    if (++next == last) next = first;
    s.place = there;
    ++s.looked;
    const bool is_end =
        s.farthest2 <= near2
            ? q.r2 != 0
            : (static_cast<int>(q.r2 + near2 >= s.farthest2) &
               static_cast<int>(from_to(s.right, q.direction) >= 0) &
               static_cast<int>(from_to(q.direction, s.left) >= 0)) != 0;
    s.before = is_end ? s.farthest : s.before;
    s.before_after = is_end ? s.farthest_after : s.before_after;
    s.farthest = is_end ? s.place : s.farthest;
    s.farthest_after = is_end ? s.looked : s.farthest_after;
    stop = is_end ? std::min(limit, 4 * s.looked + kPatience) : stop;
    if (s.looked >= stop) return end(Stopped::done);
    NearDirections::Range sides{q.left, q.right};
    if (q.r2 < s.farthest2) {
      if (s.farthest2 <= near2 || *next == step) continue;
      if (q.r2 <= near2) {
        if (near.holds_all(s.farthest2, q.r2)) continue;
        if (q.r2 == 0) return end(Stopped::done);
      }
      const int quarters = near.quarters(s.farthest2, q.r2);
      if (quarters > 4) return end(Stopped::done);
      sides = near.waiting(s.place, quarters);
    } else {
      const bool bounded = s.farthest2 > near2;
      s.farthest2 = q.r2;
      if (q.r2 <= near2) continue;
      if (!bounded) {
        s.left = sides.left;
        s.right = sides.right;
        continue;
      }
    }
    // As Cone::narrow().
    const bool tighter_left = from_to(sides.left, s.left) >= 0;
    const bool tighter_right = from_to(s.right, sides.right) >= 0;
    const std::int16_t of_left = tighter_left ? from_to(s.right, sides.left)
                                              : from_to(sides.right, s.left);
    const std::int16_t of_right = tighter_right ? from_to(sides.right, s.left)
                                                : from_to(s.right, sides.left);
    if ((of_left | of_right) < 0) return end(Stopped::done);
    s.left = tighter_left ? sides.left : s.left;
    s.right = tighter_right ? sides.right : s.right;
  }
  return end(Stopped::paused);
}

LookMemory::Found Look::found_by(const Near& state) {
  return {state.farthest_after, state.before_after,
          NearDirections::offset_of(state.farthest),
          NearDirections::offset_of(state.before)};
}

/// Goes on among the near points and beyond. True if it stayed there.
bool Look::finish_near(Near state) {
  const Stopped stopped = walk_near(*near_, state, std::size_t{0} - 1);
  const LookMemory::Found found = found_by(state);
  index_ = from_ + state.looked;
  offset_ = NearDirections::offset_of(state.place);
  stop_ = std::min(limit_, from_ + 4 * found.farthest_after + kPatience);
  farthest_ = found.farthest;
  farthest_index_ = from_ + found.farthest_after;
  before_ = found.before;
  before_index_ = from_ + found.before_after;
  if (stopped == Stopped::done) return true;
  // The cone of all points before.
  cone().resume(state.farthest2,
                {near_->vector_of(state.left), near_->vector_of(state.right)});
  look_far();
  return false;
}

LookMemory::Found Look::look(const LineVertex& from, std::size_t limit) {
  begin(from, limit);
  if (near_ != nullptr) {
    finish_near(Near{});
  } else {
    offset_ = farthest_ = before_ = {};
    farthest_index_ = before_index_ = index_ = from.index;
    stop_ = std::min(limit, from.index + kPatience);
    cone().restart();
    look_far();
  }
  return seen();
}

/// Goes the first steps of a word but the last, or remembers what it was like.
/// False if the look is done there.
bool Look::begin_near(std::uint64_t word, Near& state) {
  const LookMemory::Head& head = memory_->head(word);
  const std::size_t steps = memory_->head_steps() - 1;
  if (head.is_known()) {
    const LookMemory::Begun begun = memory_->begun(head, word);
    state = {NearDirections::place_of(begun.at),
             NearDirections::place_of(begun.found.farthest),
             NearDirections::place_of(begun.found.before),
             steps,
             begun.found.farthest_after,
             begun.found.before_after,
             begun.farthest2,
             begun.left,
             begun.right};
    return true;
  }
  if (walk_near(*near_, state, steps) == Stopped::done) {
    memory_->keep_done(word, found_by(state));
    return false;
  }
  memory_->keep_begun(word,
                      {found_by(state), NearDirections::offset_of(state.place),
                       state.farthest2, state.left, state.right});
  return true;
}

/// With the help of the memory, which learns from it. `word`: of the steps from
/// there on.
LookMemory::Found Look::look_and_keep(std::uint64_t word,
                                      const LineVertex& from,
                                      std::size_t limit) {
  begin(from, limit);
  Near state;
  if (limit - from_ >= memory_->head_steps() && !begin_near(word, state))
    return found_by(state);
  const bool near = finish_near(state);
  const std::size_t steps = index_ - from_;
  if (near && steps < LookMemory::kSteps && index_ < limit)
    memory_->keep(word, steps, seen());
  return seen();
}

/// Lays line after line from a vertex to point `last`, until take(end) is false
/// of a line's end. No line stands for more than `reach` steps. Each goes as
/// far as it can, unless the line after it would then be short for its
/// neighbourhood and gets farther from the point before: the farthest point is
/// often on the wrong side of the chain to go on from. That look ahead brings
/// the lines from 1.05-1.14 of the optimum to 1.02-1.07 and costs half a pass.
template <class Take>
void lay_lines(Look& look, LineVertex at, std::size_t last, std::size_t reach,
               const Take& take) {
  const auto look_from = [&](const LineVertex& from) {
    return look.ends(from, std::min(last, from.index + reach));
  };
  if (at.index >= last) return;
  Ends ends = look_from(at);
  for (;;) {
    LineVertex end = ends.farthest;
    if (end.index < last) {
      Ends onward = look_from(end);
      const bool is_short =
          2 * (onward.farthest.index - end.index) <= 3 * (end.index - at.index);
      if (is_short && ends.before.index > at.index &&
          onward.farthest.index < last) {
        const Ends other = look_from(ends.before);
        if (other.farthest.index > onward.farthest.index) {
          end = ends.before;
          onward = other;
        }
      }
      ends = onward;
    }
    at = end;
    if (!take(end) || end.index >= last) return;
  }
}

/// Lines from the last vertex to exactly `last`.
void append_lines(const ChainWalk& chain, std::size_t last, Look& look,
                  LineVertices& vertices) {
  lay_lines(look, vertices.back(), last, chain.size(),
            [&vertices](const LineVertex& end) {
              vertices.push_back(end);
              return true;
            });
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
  bool is_closed = false;
  lay_lines(look, vertices.front(), 4 * lap, lap, [&](const LineVertex& end) {
    vertices.push_back(end);
    while (vertices[before].index + lap < end.index) ++before;
    is_closed = vertices[before].index + lap == end.index;
    return !is_closed && end.index < 2 * lap;
  });
  if (is_closed) {
    vertices.erase(vertices.begin(),
                   vertices.begin() + static_cast<std::ptrdiff_t>(before));
    return vertices;
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
  lay_lines(look, vertices.back(), last, longest,
            [&vertices](const LineVertex& end) {
              vertices.push_back(end);
              return true;
            });
}

}  // namespace unstep::reverse
