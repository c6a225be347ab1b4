#include "deviation/polyline_frechet.h"

#include <algorithm>
#include <cmath>

namespace unstep::deviation {

bool PolylineFrechet::near(Place a, Place b) const {
  const long double x = a.x - b.x;
  const long double y = a.y - b.y;
  return x * x + y * y <= bound_ * bound_;
}

PolylineFrechet::Cut PolylineFrechet::cut(Place from, Place to,
                                          Place centre) const {
  const long double dx = to.x - from.x;
  const long double dy = to.y - from.y;
  const long double qx = centre.x - from.x;
  const long double qy = centre.y - from.y;
  const long double length2 = dx * dx + dy * dy;
  if (length2 == 0) return {near(from, centre), 0, 1};
  const long double length = std::sqrt(length2);
  const long double off = (dx * qy - dy * qx) / length;
  const long double rest = bound_ * bound_ - off * off;
  if (rest < 0) return {};
  const long double middle = (dx * qx + dy * qy) / length2;
  const long double half = std::sqrt(rest) / length;
  const Cut found{true, std::max(middle - half, 0.0L),
                  std::min(middle + half, 1.0L)};
  return found.low <= found.high ? found : Cut{};
}

bool PolylineFrechet::within(long double bound) {
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

void PolylineFrechet::row(std::size_t j) {
  const Place a = path_[j];
  const Place b = path_[j + 1];
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

}  // namespace unstep::deviation
