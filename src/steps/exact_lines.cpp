#include "steps/exact_lines.h"

#include <algorithm>
#include <array>

#include "unstep/interpolate.h"
#include "unstep/reverse.h"

namespace unstep::steps {
namespace {

/// How many ends are tried before shorter lines are.
constexpr int kTries = 24;
/// Steps of a line that are compared one by one before all are made.
constexpr std::size_t kEarly = 128;
/// Steps that are always looked at, and what a step of a line brings.
constexpr std::size_t kLook = 64;
constexpr std::size_t kReward = 16;

}  // namespace

/// Steps from `at` on that no line of the method can draw together: they have
/// at most two codes, neighbours.
std::size_t LineSearch::line_bound(std::size_t at, std::size_t most) const {
  const std::size_t end = std::min(codes_.size() - at, most) + at;
  const Step first = codes_[at];
  int other = -1;
  const bool eight = method_ == Method::evaluation8;
  for (std::size_t i = at; i < end; ++i) {
    const Step code = codes_[i];
    if (code == first) continue;
    const int apart = (code - first) & 7;
    const bool near =
        eight ? apart == 1 || apart == 7 : apart == 2 || apart == 6;
    if (!near || (other >= 0 && other != code)) return i - at;
    other = code;
  }
  return end - at;
}

/// Whether the plain line to the end of `count` steps is drawn by them.
bool LineSearch::draws(std::size_t at, std::size_t count, const Segment& line) {
  if (step_count(method_, line) != count) return false;
  // Most lines that do not fit differ early.
  Result<Interpolator> slow = Interpolator::line(method_, line);
  for (std::size_t i = 0; slow && i < std::min(count, kEarly); ++i) {
    const Tick tick = slow->next();
    if (tick.kind != Tick::Kind::step || tick.step != codes_[at + i]) {
      return false;
    }
  }
  if (drawn_.size() < count) drawn_.resize(count);
  const Result<std::size_t> made =
      interpolate(method_, std::array{line}, drawn_);
  return made && *made == count &&
         std::equal(codes_.begin() + static_cast<std::ptrdiff_t>(at),
                    codes_.begin() + static_cast<std::ptrdiff_t>(at + count),
                    drawn_.begin());
}

/// How far it looks is paid from what lines found before have brought, so that
/// short lines of a long straight way do not cost a look at all of it each.
std::size_t LineSearch::longest(std::size_t at, Segment& best) {
  const std::size_t most = std::min(std::max(kLook, credit_), reach_);
  const std::size_t bound = straight_bound(at, most);
  const std::size_t found = longest_within(at, bound, best);
  credit_ -= std::min(credit_, bound);
  credit_ += kReward * found;
  return found;
}

/// A single step always is a line.
std::size_t LineSearch::longest_within(std::size_t at, std::size_t bound,
                                       Segment& best) {
  // Where the longest straight word ends, the vertex is near.
  std::size_t count = bound;
  Segment line = ends_at(at, bound);
  std::size_t skip = 1;
  for (int tries = 0; count > 1; ++tries) {
    if (draws(at, count, line)) break;
    // Further and further back, if the near ends do not do.
    if (tries >= kTries) skip *= 2;
    const std::size_t next = count > skip ? count - skip : 1;
    for (std::size_t i = next; i < count; ++i) {
      const Point d = step_delta(codes_[at + i]);
      line.dx -= d.x;
      line.dy -= d.y;
    }
    count = next;
  }
  best = line;
  return count;
}

Segment LineSearch::ends_at(std::size_t at, std::size_t count) const {
  Segment line;
  for (std::size_t i = 0; i < count; ++i) {
    const Point d = step_delta(codes_[at + i]);
    line.dx += d.x;
    line.dy += d.y;
  }
  return line;
}

/// The longest digital straight segment from there: no plain line is longer.
std::size_t LineSearch::straight_bound(std::size_t at,
                                       std::size_t reach) const {
  const bool eight = method_ == Method::evaluation8;
  ExactReverse exact(eight ? Connectivity::eight : Connectivity::four);
  const std::size_t most = line_bound(at, reach);
  DigitalSegment segment;
  for (std::size_t i = 0; i < most; ++i) {
    if (exact.push(codes_[at + i], segment) != Pushed::open) {
      return std::max<std::size_t>(i, 1);
    }
  }
  return most;
}

}  // namespace unstep::steps
