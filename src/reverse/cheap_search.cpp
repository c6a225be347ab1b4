#include "reverse/cheap_search.h"

#include <algorithm>
#include <limits>

#include "reverse/tolerance_cheap.h"

namespace unstep::reverse {
namespace {

using vectors::Vec;
__extension__ using Wide = __int128;

/// Vertices lie beside corners of the chain and so many steps from them: along
/// a straight run one is as good as another.
constexpr std::size_t kBesideCorner = 1;
/// Nodes that cost so much more than the cheapest of the next kAhead
/// candidates are given up.
constexpr std::int32_t kMargin = 2 * LinePrice::kBit;
constexpr std::size_t kAhead = 24;
/// Candidates that are looked at in vain before a line is given up.
constexpr int kPatience = 16;
/// No line is cheaper.
constexpr std::int32_t kLeast = LinePrice::kBit / 2;
constexpr std::int32_t kUnreached =
    std::numeric_limits<std::int32_t>::max() / 2;

Point moved(Point at, Point by) { return {at.x + by.x, at.y + by.y}; }

/// At most 13 points of the disc, spread over it, the middle first.
/// Range: as Beam::disc of tolerance_free.cpp.
std::vector<Point> spread(PathTolerance tolerance) {
  const std::int64_t e = tolerance.fixed;
  const std::int64_t units = e >> PathTolerance::kBits;
  const std::int64_t spacing = std::max<std::int64_t>(1, (units + 1) / 2);
  std::vector<Point> places{{0, 0}};
  for (std::int64_t y = -2 * spacing; y <= 2 * spacing; y += spacing) {
    for (std::int64_t x = -2 * spacing; x <= 2 * spacing; x += spacing) {
      const Wide r2 = Wide{x * x + y * y} << (2 * PathTolerance::kBits);
      if (r2 == 0 || r2 > Wide{e} * e) continue;
      places.push_back(
          {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)});
    }
  }
  return places;
}

}  // namespace

CheapSearch::CheapSearch(const ChainWalk& chain, PathTolerance tolerance,
                         const LinePrice& price)
    : chain_(chain),
      price_(price),
      cone_(tolerance),
      places_(spread(tolerance)) {}

void CheapSearch::find_candidates(const LineVertex& first, std::size_t last) {
  candidates_.clear();
  Point at = first.at;
  std::size_t beside = first.index;  // up to here points are beside a corner
  for (std::size_t i = first.index;; ++i) {
    const bool end = i == first.index || i == last;
    const bool corner = !end && !chain_.straight_at(i);
    bool near = end || corner || i <= beside;
    if (corner) beside = i + kBesideCorner;
    for (std::size_t k = 1; !near && k <= kBesideCorner && i + k < last; ++k) {
      near = !chain_.straight_at(i + k);
    }
    if (near) candidates_.push_back({i, at, corner});
    if (i == last) break;
    at = moved(at, chain_.delta(chain_.step(i)));
  }
}

Point CheapSearch::point(std::size_t node) const {
  const std::size_t place = node % places_.size();
  const std::size_t i = node / places_.size();
  return i == 0 ? start_ : moved(candidates_[first_ + i].at, places_[place]);
}

/// All lines from one node, i counted from the window's first candidate.
void CheapSearch::extend(std::size_t i, std::size_t place) {
  const std::size_t id = i * places_.size() + place;
  const Node from = nodes_[id];
  const Point at = point(id);
  const LinePrice::Context context =
      price_.after(i == 0 ? before_ : Vec{from.in.x, from.in.y});
  cone_.restart();
  int vain = 0;
  for (std::size_t k = i + 1; k < count_; ++k) {
    const Candidate& candidate = candidates_[first_ + k];
    const bool last = ends_ && k + 1 == count_;
    const Point offset{candidate.at.x - at.x, candidate.at.y - at.y};
    bool any = false;
    for (std::size_t q = 0; q < (last ? 1 : places_.size()); ++q) {
      Node& to = nodes_[k * places_.size() + q];
      const bool free = last && free_;
      if (from.cost + (free ? 0 : kLeast) >= to.cost) {
        any = true;
        continue;
      }
      const Point line = moved(offset, places_[q]);
      if (!cone_.may_end_at(line.x, line.y)) continue;
      if (!last && !allowed(moved(at, line))) continue;
      any = true;
      const std::int32_t cost =
          from.cost + (free ? 0 : price_(context, line.x, line.y));
      if (cost >= to.cost) continue;
      to = {cost, static_cast<std::int32_t>(id), line};
      least_[k] = std::min(least_[k], cost);
    }
    if (any) {
      vain = 0;
    } else if (++vain > kPatience) {
      return;
    }
    if (candidate.corner && !cone_.add(offset.x, offset.y)) return;
  }
}

/// Where to cut: the cheapest node of the last candidates.
std::size_t CheapSearch::best_end() const {
  const std::size_t places = places_.size();
  for (std::size_t end = count_; end > 1;) {
    const std::size_t begin = end > kAhead + 1 ? end - kAhead : 1;
    const auto best = std::min_element(
        nodes_.begin() + static_cast<std::ptrdiff_t>(begin * places),
        nodes_.begin() + static_cast<std::ptrdiff_t>(end * places),
        [](const Node& a, const Node& b) { return a.cost < b.cost; });
    if (best->cost < kUnreached) {
      return static_cast<std::size_t>(best - nodes_.begin());
    }
    end = begin;
  }
  return 0;
}

std::optional<std::int64_t> CheapSearch::append(const LineVertex& last,
                                                bool free, LineVertices& path) {
  const LineVertex from = path.back();
  if (from.index >= last.index) return 0;
  find_candidates(from, last.index);
  std::int64_t total = 0;
  first_ = 0;
  start_ = from.at;
  before_ = path.size() < 2
                ? Vec{}
                : vectors::between(path[path.size() - 2].at, from.at);
  const std::size_t places = places_.size();
  while (path.back().index < last.index) {
    count_ = std::min(kCheapWindow, candidates_.size() - first_);
    ends_ = first_ + count_ == candidates_.size();
    free_ = free && ends_;
    nodes_.assign(count_ * places, {kUnreached, 0, {}});
    least_.assign(count_, kUnreached);
    nodes_[0].cost = least_[0] = 0;
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      const auto ahead = least_.begin() + static_cast<std::ptrdiff_t>(i);
      const std::int32_t bound =
          kMargin +
          *std::min_element(ahead, ahead + static_cast<std::ptrdiff_t>(
                                               std::min(kAhead, count_ - i)));
      for (std::size_t place = 0; place < places; ++place) {
        const std::int32_t cost = nodes_[i * places + place].cost;
        if (cost < kUnreached && cost <= bound) extend(i, place);
      }
    }
    // The way to the end, or of a cut one the first half.
    std::vector<std::size_t> way;
    const std::size_t end = ends_ ? (count_ - 1) * places : best_end();
    if (nodes_[end].cost >= kUnreached) return std::nullopt;
    for (std::size_t id = end; id >= places;
         id = static_cast<std::size_t>(nodes_[id].from)) {
      way.push_back(id);
    }
    std::size_t taken = 0;
    for (; !way.empty(); way.pop_back()) {
      const std::size_t id = way.back();
      const std::size_t i = id / places;
      if (!ends_ && taken > 0 && i > count_ / 2) break;
      path.push_back({candidates_[first_ + i].index, point(id)});
      taken = id;
    }
    if (taken == 0) return std::nullopt;
    total += nodes_[taken].cost;
    start_ = path.back().at;
    before_ = {nodes_[taken].in.x, nodes_[taken].in.y};
    first_ += taken / places;
  }
  return total;
}

}  // namespace unstep::reverse
