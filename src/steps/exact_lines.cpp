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

/// A line may run a few steps past the vertex where the one after it begins,
/// which then is drawn by no line: its steps are straight for long, but every
/// line from there is short. Then an end before it is taken.
std::size_t LineSearch::before_next(std::size_t at, std::size_t count,
                                    Segment& line) {
  constexpr std::size_t kShort = 48;
  constexpr std::size_t kEnds = 32;
  const std::size_t end = at + count;
  if (method_ == Method::device || end >= codes_.size()) return count;
  const std::size_t look = std::min(4 * count + kLook, reach_);
  const std::size_t straight = straight_bound(end, look);
  if (straight < kShort) return count;
  Segment next;
  std::size_t best = end + longest_within(end, straight, next);
  if (3 * (best - end) >= straight) return count;
  find_ends(at, count);
  const std::size_t first = ends_.size() - std::min(ends_.size(), kEnds);
  const std::vector<std::size_t> nearest(
      ends_.begin() + static_cast<std::ptrdiff_t>(first), ends_.end());
  std::size_t chosen = count;
  for (std::size_t i = nearest.size(); i-- > 0;) {
    const std::size_t other = nearest[i];
    Segment whole;
    if (other == count || !is_line(at, other, whole)) continue;
    const std::size_t begin = at + other;
    const std::size_t reached =
        begin + longest_within(begin, straight_bound(begin, look), next);
    if (reached <= best) continue;
    best = reached;
    chosen = other;
    line = whole;
    if (best >= end + straight / 4 * 3) break;
  }
  return chosen;
}

/// Every step leaves a range of slopes whose lines have drawn the same so far;
/// the line to an end can only be drawn by them if its slope lies within that.
/// A slope is the share of the second letter: diagonal, or along y. Ranges are
/// somewhat wider than those of the rule, so ends still have to be proven.
void LineSearch::find_ends(std::size_t at, std::size_t bound) {
  ends_.clear();
  const bool eight = method_ == Method::evaluation8;
  double low = 0;
  double high = 1;
  double second = 0;
  for (std::size_t i = 0; i < bound; ++i) {
    const Step code = codes_[at + i];
    const bool is_second = eight ? (code & 1) != 0 : (code & 2) != 0;
    const auto before = static_cast<double>(i);
    const double after = before + 1;
    if (!eight && i > 0) {
      // F >= 0, a step along x, where the line is not above the place.
      double& limit = is_second ? low : high;
      const double share = second / before;
      limit = is_second ? std::max(limit, share) : std::min(limit, share);
    }
    second += is_second ? 1 : 0;
    if (eight) {
      // Half a unit, and as much as half of it over an odd number of steps.
      const double half = 0.5 + 0.5 / after;
      low = std::max(low, (second - half) / after);
      high = std::min(high, (second + half) / after);
    }
    constexpr double kSlack = 1e-15;
    const double share = second / after;
    if (share >= low - kSlack && share <= high + kSlack) {
      ends_.push_back(i + 1);
    }
  }
}

/// A single step always is a line.
std::size_t LineSearch::longest_within(std::size_t at, std::size_t bound,
                                       Segment& best) {
  if (method_ != Method::device) {
    find_ends(at, bound);
    for (int tries = 0; tries < kTries && !ends_.empty(); ++tries) {
      const std::size_t count = ends_.back();
      ends_.pop_back();
      if (is_line(at, count, best)) return count;
    }
  }
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
