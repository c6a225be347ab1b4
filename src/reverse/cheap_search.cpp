#include "reverse/cheap_search.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

#include "reverse/tolerance_cheap.h"

namespace unstep::reverse {
namespace {

using vectors::Vec;
__extension__ using Wide = __int128;

/// Vertices lie beside corners of the chain and so many steps from them: along
/// a straight run one is as good as another. From this tolerance on, those of
/// corners are enough.
constexpr std::size_t kBesideCorner = 1;
constexpr std::int64_t kCornersAlone = 3;
/// Nodes that cost so much more than the cheapest of the next kAhead
/// candidates are given up; with a choice of many vertices, from kManyPlaces
/// on, fewer bits will do.
constexpr std::int32_t kMargin = 3 * LinePrice::kBit;
constexpr std::int32_t kSmallMargin = 3 * LinePrice::kBit / 2;
constexpr std::size_t kManyPlaces = 13;
constexpr std::size_t kAhead = 24;
/// Candidates before and after one that may have its vertices instead.
constexpr std::size_t kShared = 4;
/// Steps that a line may stand for, where a chain winds in one place.
constexpr std::size_t kLongest = 4 * kCheapLine;
constexpr std::int32_t kUnreached =
    std::numeric_limits<std::int32_t>::max() / 2;

std::int64_t squared(const Vec& v) { return v.x * v.x + v.y * v.y; }

/// At most 13 points of the disc, spread over it, the middle first.
/// Range: as Beam::disc of tolerance_free.cpp.
std::vector<Point> spread(PathTolerance tolerance) {
  const std::int64_t e = tolerance.fixed;
  const std::int64_t units = e >> PathTolerance::kBits;
  const std::int64_t spacing = std::max<std::int64_t>(1, (units + 1) / 3);
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

CheapSearch::CheapSearch(PathTolerance tolerance)
    : cone_(tolerance),
      places_(spread(tolerance)),
      margin_(places_.size() < kManyPlaces ? kMargin : kSmallMargin),
      beside_(tolerance.fixed >> PathTolerance::kBits < kCornersAlone
                  ? kBesideCorner
                  : 0) {
  cone_.keep_roots();
  for (const Point& place : places_) reach_ = std::max(reach_, place.x);
}

void CheapSearch::begin(const ChainWalk& chain, const LinePrice& price) {
  chain_ = &chain;
  price_ = &price;
  has_top_ = false;
}

void CheapSearch::find_candidates(const LineVertex& first, std::size_t last) {
  candidates_.clear();
  Point at = first.at;
  std::size_t beside = first.index;  // up to here points are beside a corner
  for (std::size_t i = first.index;; ++i) {
    const bool end = i == first.index || i == last;
    const bool corner = !end && !chain_->straight_at(i);
    bool near = end || corner || i <= beside;
    if (corner) beside = i + beside_;
    for (std::size_t k = 1; !near && k <= beside_ && i + k < last; ++k) {
      near = !chain_->straight_at(i + k);
    }
    if (near) candidates_.push_back({i, at, corner, 1, 0});
    if (i == last) break;
    at = moved(at, chain_->delta(chain_->step(i)));
  }
}

/// Of vertices at the same point, beside several candidates, only that beside
/// the nearest one is kept: the others would be the same vertex again.
void CheapSearch::share_places() {
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    Candidate& candidate = candidates_[k];
    candidate.places = 0;
    for (std::size_t q = 0; q < places_.size(); ++q) {
      if (is_nearest(k, places_[q])) candidate.places |= std::uint32_t{1} << q;
    }
  }
}

bool CheapSearch::is_nearest(std::size_t k, Point place) const {
  const Point at = moved(candidates_[k].at, place);
  const std::int64_t distance = squared({place.x, place.y});
  // Of equally near ones all or, if there is much to choose from, the first.
  const int tie = places_.size() < kManyPlaces ? 0 : 1;
  const std::size_t end = std::min(candidates_.size(), k + kShared + 1);
  for (std::size_t j = k > kShared ? k - kShared : 0; j < end; ++j) {
    const Vec away = vectors::between(candidates_[j].at, at);
    // Farther than any place, and squares of the others are below 2^43.
    if (vectors::size_of(away) > 2 * reach_) continue;
    if (squared(away) < distance + (j < k ? tie : 0)) return false;
  }
  return true;
}

Point CheapSearch::point(std::size_t node) const {
  const std::size_t place = node % places_.size();
  const std::size_t i = node / places_.size();
  return i == 0 ? start_ : moved(candidates_[first_ + i].at, places_[place]);
}

/// All lines from one node, i counted from the window's first candidate.
void CheapSearch::extend(std::size_t i, std::size_t place) {
  const std::size_t id = i * places_.size() + place;
  const Node& node = nodes_[id];
  const Source from{
      static_cast<std::int32_t>(id), node.cost, point(id),
      price_->after(i == 0 ? before_ : Vec{node.in.x, node.in.y})};
  // So near, lines to one candidate differ too much for LinePrice::least.
  const std::int32_t near = 4 * reach_;
  const std::size_t farthest = candidates_[first_ + i].index + kLongest;
  cone_.restart();
  for (std::size_t k = i + 1; k < count_; ++k) {
    const Candidate& candidate = candidates_[first_ + k];
    if (candidate.index > farthest) return;
    const Point offset{candidate.at.x - from.at.x, candidate.at.y - from.at.y};
    if (ends_ && k + 1 == count_) {
      end_at(from, k, 0, from.cost);
    } else if (candidate.places != 0) {
      const bool is_near =
          std::abs(offset.x) <= near && std::abs(offset.y) <= near;
      const std::int32_t least =
          from.cost + (is_near
                           ? from.context.least
                           : price_->least(from.context, offset.x, offset.y));
      for (std::uint32_t left = least <= candidate.bound ? candidate.places : 0;
           left != 0; left &= left - 1) {
        end_at(from, k, static_cast<std::size_t>(std::countr_zero(left)),
               least);
      }
    }
    if (candidate.corner && !cone_.add(offset.x, offset.y)) return;
  }
}

/// A line to a place of candidate k, if it is the cheapest way there so far;
/// its way costs no less than `least`.
void CheapSearch::end_at(const Source& from, std::size_t k, std::size_t place,
                         std::int32_t least) {
  const Candidate& candidate = candidates_[first_ + k];
  Node& to = nodes_[k * places_.size() + place];
  if (least >= to.cost) return;
  const Point end = moved(candidate.at, places_[place]);
  const Point line{end.x - from.at.x, end.y - from.at.y};
  if (line.x == 0 && line.y == 0) return;
  const bool last = ends_ && k + 1 == count_;
  const std::int32_t cost =
      from.cost + (last && free_ ? 0 : (*price_)(from.context, line.x, line.y));
  if (cost >= to.cost || cost > candidate.bound ||
      !cone_.may_end_at(line.x, line.y) || (!last && !allowed(end))) {
    return;
  }
  to = {cost, from.node, line};
  if (cost + margin_ >= candidate.bound) return;
  for (std::size_t j = k + 1; j-- > 0 && j + kAhead > k;) {
    std::int32_t& bound = candidates_[first_ + j].bound;
    bound = std::min(bound, cost + margin_);
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
  share_places();
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
    for (std::size_t i = 0; i < count_; ++i) {
      candidates_[first_ + i].bound = kUnreached;
    }
    nodes_[0].cost = 0;
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      const std::int32_t bound = candidates_[first_ + i].bound;
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
