#include "program/travel_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace unstep::program {
namespace {

/// Improvements look at so many near ends.
constexpr std::size_t kNeighbours = 8;

/// Legs moved in all, for each trip and besides: seconds at most.
constexpr std::uint64_t kWorkPerTrip = 1000;
constexpr std::uint64_t kLeastWork = 1'000'000;

/// Gains below this are rounding.
constexpr double kLeastGain = 1e-6;

/// Only sqrt and products: the same everywhere.
double distance(Point a, Point b) {
  const double dx = double{1} * a.x - b.x;
  const double dy = double{1} * a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

Point entry(const std::vector<Trip>& trips, Leg leg) {
  return leg.turned ? trips[leg.trip].to : trips[leg.trip].from;
}
Point exit(const std::vector<Trip>& trips, Leg leg) {
  return leg.turned ? trips[leg.trip].from : trips[leg.trip].to;
}

/// The ends of trips in square cells; end 2 i is `from` of trip i, 2 i + 1 its
/// `to`.
class EndGrid {
 public:
  explicit EndGrid(const std::vector<Trip>& trips) : trips_(trips) {
    low_ = trips.front().from;
    Point high = low_;
    for (std::uint32_t end = 0; end < 2 * trips.size(); ++end) {
      const Point p = place(end);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double width = double{1} * high.x - low_.x + 1;
    const double height = double{1} * high.y - low_.y + 1;
    const auto ends = static_cast<double>(trips.size());
    side_ = std::max(1.0, std::sqrt(width * height / ends));
    side_ = std::max(side_, std::max(width, height) / 4096);
    columns_ = static_cast<std::int32_t>(width / side_) + 1;
    rows_ = static_cast<std::int32_t>(height / side_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) *
                  static_cast<std::size_t>(rows_));
    for (std::uint32_t end = 0; end < 2 * trips.size(); ++end) {
      cell(column(place(end).x), row(place(end).y)).push_back(end);
    }
  }

  [[nodiscard]] Point place(std::uint32_t end) const {
    const Trip& trip = trips_[end / 2];
    return end % 2 == 0 ? trip.from : trip.to;
  }

  void remove(std::uint32_t trip) {
    for (const std::uint32_t end : {2 * trip, 2 * trip + 1}) {
      std::erase(cell(column(place(end).x), row(place(end).y)), end);
    }
  }

  /// The `count` nearest ends, the nearest first, equal ones by number.
  [[nodiscard]] std::vector<std::uint32_t> nearest(Point at,
                                                   std::size_t count) {
    std::vector<std::pair<double, std::uint32_t>> found;
    const std::int32_t c = column(at.x);
    const std::int32_t r = row(at.y);
    const std::int32_t most = std::max(columns_, rows_);
    for (std::int32_t ring = 0; ring <= most; ++ring) {
      for_each_in_ring(c, r, ring, [&](std::uint32_t end) {
        found.push_back({distance(at, place(end)), end});
      });
      // What is outside of the rings seen is at least this far.
      const double seen = ring * side_;
      std::ranges::sort(found);
      if (found.size() >= count && found[count - 1].first <= seen) break;
    }
    std::vector<std::uint32_t> ends;
    for (std::size_t i = 0; i < std::min(count, found.size()); ++i) {
      ends.push_back(found[i].second);
    }
    return ends;
  }

 private:
  [[nodiscard]] std::int32_t column(std::int32_t x) const {
    const double at = (double{1} * x - low_.x) / side_;
    return static_cast<std::int32_t>(
        std::clamp(at, 0.0, double{1} * columns_ - 1));
  }
  [[nodiscard]] std::int32_t row(std::int32_t y) const {
    const double at = (double{1} * y - low_.y) / side_;
    return static_cast<std::int32_t>(
        std::clamp(at, 0.0, double{1} * rows_ - 1));
  }
  std::vector<std::uint32_t>& cell(std::int32_t c, std::int32_t r) {
    return cells_[static_cast<std::size_t>(r) *
                      static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(c)];
  }

  template <class Use>
  void for_each_in_ring(std::int32_t c, std::int32_t r, std::int32_t ring,
                        Use use) {
    for (std::int32_t y = std::max(r - ring, 0);
         y <= std::min(r + ring, rows_ - 1); ++y) {
      const bool whole = y == r - ring || y == r + ring;
      const std::int32_t stride = whole || ring == 0 ? 1 : 2 * ring;
      for (std::int32_t x = c - ring; x <= c + ring; x += stride) {
        if (x < 0 || x >= columns_) continue;
        for (const std::uint32_t end : cell(x, y)) use(end);
      }
    }
  }

  const std::vector<Trip>& trips_;
  Point low_;
  double side_ = 1;
  std::int32_t columns_ = 1;
  std::int32_t rows_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

std::vector<Leg> nearest_first(const std::vector<Trip>& trips, Point start) {
  EndGrid grid(trips);
  std::vector<Leg> order;
  Point at = start;
  while (order.size() < trips.size()) {
    const std::uint32_t end = grid.nearest(at, 1).front();
    order.push_back({end / 2, end % 2 == 1});
    grid.remove(end / 2);
    at = exit(trips, order.back());
  }
  return order;
}

/// Makes an order shorter until nothing helps or the work is done.
class Improver {
 public:
  Improver(const std::vector<Trip>& trips, std::vector<Leg>& order, Point start)
      : trips_(trips),
        order_(order),
        start_(start),
        place_(order.size()),
        work_(kLeastWork + kWorkPerTrip * order.size()) {
    for (std::size_t i = 0; i < order.size(); ++i) place_[order[i].trip] = i;
    EndGrid grid(trips);
    near_.reserve(2 * trips.size());
    for (std::uint32_t end = 0; end < 2 * trips.size(); ++end) {
      near_.push_back(grid.nearest(grid.place(end), kNeighbours));
    }
  }

  void run() {
    for (bool better = true; better && work_ > 0;) {
      better = false;
      for (std::size_t i = 0; i < order_.size() && work_ > 0; ++i) {
        better = improve_after(i) || better;
      }
    }
  }

 private:
  [[nodiscard]] Point before(std::size_t i) const {
    return i == 0 ? start_ : exit(trips_, order_[i - 1]);
  }
  /// The way from leg i to the next one; 0 after the last.
  [[nodiscard]] double gap(Point from, std::size_t i) const {
    return i < order_.size() ? distance(from, entry(trips_, order_[i])) : 0;
  }

  /// Tries to make the way after leg i lead to one of the near ends.
  bool improve_after(std::size_t i) {
    const Leg leg = order_[i];
    const std::uint32_t end = 2 * leg.trip + (leg.turned ? 0 : 1);
    for (const std::uint32_t to : near_[end]) {
      if (to / 2 == leg.trip) continue;
      const std::size_t j = place_[to / 2];
      const bool its_exit = (to % 2 == 1) != order_[j].turned;
      if (turn(i, j, its_exit) || move(i, j, to % 2 == 1)) return true;
    }
    return false;
  }

  /// 2-opt: turns i + 1 .. j around, so that i is followed by the exit of j; or
  /// for an entry j before i, j .. i, so that what is before j is followed by
  /// the exit of i.
  bool turn(std::size_t i, std::size_t j, bool its_exit) {
    std::size_t first = i + 1;
    std::size_t last = j;
    if (j < i && !its_exit) {
      first = j;
      last = i;
    } else if (j <= i || !its_exit) {
      return false;
    }
    const Point ahead = before(first);
    const Point out = exit(trips_, order_[last]);
    const Point in = entry(trips_, order_[first]);
    const double gain = distance(ahead, in) + gap(out, last + 1) -
                        distance(ahead, out) - gap(in, last + 1);
    if (gain < kLeastGain) return false;
    const std::uint64_t cost = last - first + 1;
    if (cost > work_) return false;
    work_ -= cost;
    std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(first),
                 order_.begin() + static_cast<std::ptrdiff_t>(last + 1));
    for (std::size_t k = first; k <= last; ++k) {
      order_[k].turned = !order_[k].turned;
      place_[order_[k].trip] = k;
    }
    return true;
  }

  /// Or-opt: takes leg j out and puts it after i, entered at its end `to`.
  bool move(std::size_t i, std::size_t j, bool turned) {
    if (j == i || j == i + 1) return false;
    const Leg moved{order_[j].trip, turned};
    const Point at = exit(trips_, order_[i]);
    const double out = distance(before(j), entry(trips_, order_[j])) +
                       gap(exit(trips_, order_[j]), j + 1) -
                       gap(before(j), j + 1);
    const double in = distance(at, entry(trips_, moved)) +
                      gap(exit(trips_, moved), i + 1) - gap(at, i + 1);
    if (out - in < kLeastGain) return false;
    const std::uint64_t cost = i < j ? j - i : i - j;
    if (cost > work_) return false;
    work_ -= cost;
    const auto leg = [&](std::size_t k) {
      return order_.begin() + static_cast<std::ptrdiff_t>(k);
    };
    order_[j] = moved;
    if (i < j) {
      std::rotate(leg(i + 1), leg(j), leg(j + 1));
    } else {
      std::rotate(leg(j), leg(j + 1), leg(i + 1));
    }
    for (std::size_t k = std::min(i, j); k <= std::max(i, j); ++k) {
      place_[order_[k].trip] = k;
    }
    return true;
  }

  const std::vector<Trip>& trips_;
  std::vector<Leg>& order_;
  Point start_;
  std::vector<std::size_t> place_;                ///< of each trip in the order
  std::vector<std::vector<std::uint32_t>> near_;  ///< of each end
  std::uint64_t work_;
};

}  // namespace

double travel_of(const std::vector<Trip>& trips, const std::vector<Leg>& order,
                 Point start) {
  double sum = 0;
  Point at = start;
  for (const Leg leg : order) {
    sum += distance(at, entry(trips, leg));
    at = exit(trips, leg);
  }
  return sum;
}

std::vector<Leg> short_order(const std::vector<Trip>& trips, Point start) {
  if (trips.empty()) return {};
  std::vector<Leg> given;
  for (std::uint32_t i = 0; i < trips.size(); ++i) given.push_back({i, false});
  std::vector<Leg> order = nearest_first(trips, start);
  Improver(trips, order, start).run();
  return travel_of(trips, order, start) < travel_of(trips, given, start)
             ? order
             : given;
}

}  // namespace unstep::program
