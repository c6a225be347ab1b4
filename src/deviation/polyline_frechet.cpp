#include "deviation/polyline_frechet.h"

#include <algorithm>
#include <cmath>

namespace unstep::deviation {

namespace {

// The difference of two places, its products with another, and how far that
// is off its line times its length; in the plane without cancellation.
Place minus(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }
long double dot(Place a, Place b) { return a.x * b.x + a.y * b.y; }
long double off_line(Place d, Place q) { return d.x * q.y - d.y * q.x; }

Place3 minus(Place3 a, Place3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
long double dot(Place3 a, Place3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
long double off_line(Place3 d, Place3 q) {
  const Place3 across{d.y * q.z - d.z * q.y, d.z * q.x - d.x * q.z,
                      d.x * q.y - d.y * q.x};
  return std::sqrt(dot(across, across));
}

}  // namespace

template <class Point>
bool BasicPolylineFrechet<Point>::near(Point a, Point b) const {
  const Point d = minus(a, b);
  return dot(d, d) <= bound_ * bound_;
}

template <class Point>
auto BasicPolylineFrechet<Point>::cut(Point from, Point to, Point centre) const
    -> Cut {
  const Point d = minus(to, from);
  const Point q = minus(centre, from);
  const long double length2 = dot(d, d);
  if (length2 == 0) return {near(from, centre), 0, 1};
  const long double length = std::sqrt(length2);
  const long double off = off_line(d, q) / length;
  const long double rest = bound_ * bound_ - off * off;
  if (rest < 0) return {};
  const long double middle = dot(d, q) / length2;
  const long double half = std::sqrt(rest) / length;
  const Cut found{true, std::max(middle - half, 0.0L),
                  std::min(middle + half, 1.0L)};
  return found.low <= found.high ? found : Cut{};
}

template <class Point>
bool BasicPolylineFrechet<Point>::within(long double bound) {
  bound_ = bound;
  stuck_ = 0;
  entries_.clear();
  corner_ = near(chain_.front(), path_.front());
  last_ = false;
  if (!corner_) return false;
  if (!near(chain_.back(), path_.back())) {
    stuck_ = chain_.size() - 1;
    return false;
  }
  std::size_t i = 0;
  for (; i + 1 < chain_.size(); ++i) {
    entries_.push_back({i, 0});
    if (!near(chain_[i + 1], path_.front())) break;
  }
  last_ = i + 1 == chain_.size();
  for (std::size_t j = 0; j + 1 < path_.size(); ++j) {
    if (!corner_ && entries_.empty()) return false;
    row(j);
  }
  return last_;
}

template <class Point>
void BasicPolylineFrechet<Point>::row(std::size_t j) {
  const Point a = path_[j];
  const Point b = path_[j + 1];
  const std::size_t edges = chain_.size() - 1;
  std::size_t entry = 0;
  std::size_t i = corner_ ? 0 : entries_.front().edge;
  bool reached = corner_;
  long double low = 0;  // the line is reached from here, if it is
  next_.clear();
  while (reached || entry < entries_.size()) {
    if (!reached) {
      i = entries_[entry].edge;
      low = 0;
    }
    if (i == edges) break;
    const bool enters = entry < entries_.size() && entries_[entry].edge == i;
    const Cut up = cut(chain_[i], chain_[i + 1], b);
    if (up.any && reached) {
      next_.push_back({i, up.low});
    } else if (up.any && enters && entries_[entry].low <= up.high) {
      next_.push_back({i, std::max(entries_[entry].low, up.low)});
    }
    const Cut on = cut(a, b, chain_[i + 1]);
    if (on.any && enters) {
      reached = true;
      low = on.low;
    } else if (on.any && reached && low <= on.high) {
      low = std::max(low, on.low);
    } else {
      reached = false;
    }
    if (enters) ++entry;
    ++i;
  }
  last_ = reached && i == edges;
  stuck_ = i;
  corner_ = corner_ && near(chain_.front(), b);
  entries_.swap(next_);
}

template class BasicPolylineFrechet<Place>;
template class BasicPolylineFrechet<Place3>;

}  // namespace unstep::deviation
