#include "deviation/thorough.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "deviation/polyline_frechet.h"

namespace unstep::deviation {
namespace {

/// Chords are this near to their arcs, and distances found to as much.
constexpr long double kFine = 1.0L / (1 << 20);
constexpr long double kCoarse = 1.0L / (1 << 12);
/// A closed chain is tried from at most so many of its places.
constexpr std::size_t kMaxStarts = 32;

struct Start {
  std::size_t edge = 0;
  Place place;
  long double distance = 0;
};

Place nearest_on_edge(Place from, Place to, Place p) {
  const long double dx = to.x - from.x;
  const long double dy = to.y - from.y;
  const long double length2 = dx * dx + dy * dy;
  if (length2 == 0) return from;
  const long double t = std::clamp<long double>(
      ((p.x - from.x) * dx + (p.y - from.y) * dy) / length2, 0, 1);
  return {from.x + t * dx, from.y + t * dy};
}

/// Places of the closed chain that are locally nearest to `vertex`.
std::vector<Start> starts_of(const std::vector<Place>& chain, Place vertex) {
  const std::size_t n = chain.size() - 1;
  if (n == 0) return {{0, chain[0], distance(chain[0], vertex)}};
  std::vector<Start> all;
  all.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Place place = nearest_on_edge(chain[i], chain[i + 1], vertex);
    all.push_back({i, place, distance(place, vertex)});
  }
  std::vector<Start> found;
  for (std::size_t i = 0; i < n; ++i) {
    const long double before = all[i == 0 ? n - 1 : i - 1].distance;
    const long double after = all[i + 1 == n ? 0 : i + 1].distance;
    if (all[i].distance <= before && all[i].distance <= after)
      found.push_back(all[i]);
  }
  std::stable_sort(
      found.begin(), found.end(),
      [](const Start& a, const Start& b) { return a.distance < b.distance; });
  if (found.size() > kMaxStarts) found.resize(kMaxStarts);
  return found;
}

std::vector<Place> begun_at(const std::vector<Place>& chain,
                            const Start& start) {
  std::vector<Place> out{start.place};
  out.reserve(chain.size() + 1);
  const auto after =
      chain.begin() + static_cast<std::ptrdiff_t>(start.edge) + 1;
  out.insert(out.end(), after, chain.end());
  if (chain.size() > 1) out.insert(out.end(), chain.begin() + 1, after);
  out.push_back(start.place);
  return out;
}

/// One chain and its path, ready to be asked for several bounds.
class Pair {
 public:
  Pair(const Chain& chain, const Path& path, YAxis axis, std::int32_t scale,
       long double sagitta)
      : chain_(polyline_of(chain, axis)), closed_(chain.closed) {
    const long double unit = 1.0L / scale;
    const Place origin{
        static_cast<long double>(path.origin.x -
                                 std::int64_t{chain.origin.x} * scale) *
            unit,
        static_cast<long double>(path.origin.y -
                                 std::int64_t{chain.origin.y} * scale) *
            unit};
    path_ = polyline_of(path, scale, origin, sagitta);
    long double extent = 1;
    for (const auto* line : {&chain_, &path_})
      for (const Place& p : *line)
        extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
    const bool arcs = path_.size() > path.elements.size() + 1;
    margin_ = std::ldexp(extent, -58) + (arcs ? sagitta : 0);
    // Whole numbers over a power of two: no rounding where all products are 0.
    exact_zero_ = !arcs && (scale & (scale - 1)) == 0;
    if (closed_) starts_ = starts_of(chain_, origin);
  }

  /// Added to a bound that holds for the polylines it holds for the curves.
  [[nodiscard]] long double margin() const { return margin_; }

  [[nodiscard]] bool within(long double bound) {
    if (!closed_) return ask(chain_, bound, 0);
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      if (starts_[i].distance > bound) continue;
      if (!ask(begun_at(chain_, starts_[i]), bound, starts_[i].edge)) continue;
      std::swap(starts_[0], starts_[i]);
      return true;
    }
    return false;
  }

  /// A yes for the bound 0 is exact.
  [[nodiscard]] bool exact_zero() const { return exact_zero_; }

  /// The least bound for which it could hold.
  [[nodiscard]] long double least() const {
    if (!closed_)
      return std::max(distance(chain_.front(), path_.front()),
                      distance(chain_.back(), path_.back()));
    long double best = std::numeric_limits<long double>::max();
    for (const Start& start : starts_) best = std::min(best, start.distance);
    return best;
  }

  /// Where the last no came to its end.
  [[nodiscard]] std::size_t stuck() const { return stuck_; }
  [[nodiscard]] Place place(std::size_t step) const { return chain_[step]; }

 private:
  bool ask(const std::vector<Place>& chain, long double bound,
           std::size_t turned) {
    PolylineFrechet frechet(chain, path_);
    if (frechet.within(bound)) return true;
    const std::size_t n = chain_.size() - 1;
    stuck_ = closed_
                 ? (frechet.stuck_at() + turned) % std::max<std::size_t>(n, 1)
                 : frechet.stuck_at();
    return false;
  }

  std::vector<Place> chain_;
  std::vector<Place> path_;
  bool closed_;
  std::vector<Start> starts_;
  long double margin_ = 0;
  bool exact_zero_ = false;
  std::size_t stuck_ = 0;
};

double rounded_up(long double value) {
  const auto nearest = static_cast<double>(value);
  return nearest < value
             ? std::nextafter(nearest, std::numeric_limits<double>::infinity())
             : nearest;
}

}  // namespace

bool thorough_within(const Chain& chain, const Path& path, YAxis axis,
                     std::int32_t scale, double limit) {
  for (const long double sagitta : {kCoarse, kFine}) {
    Pair pair(chain, path, axis, scale, sagitta);
    const long double bound = limit - pair.margin();
    if (bound < 0) continue;
    if (pair.within(bound)) return true;
    // Not even a little more would do: finer chords cannot help.
    if (!pair.within(limit + pair.margin())) return false;
  }
  return false;
}

Measured thorough_measure(const Chain& chain, const Path& path, YAxis axis,
                          std::int32_t scale, double known) {
  Pair pair(chain, path, axis, scale, kCoarse);
  long double low = std::max(pair.least(), known - pair.margin());
  Measured found;
  if (pair.within(low)) {
    const bool exact = low == 0 && pair.exact_zero();
    found.distance = rounded_up(low + (exact ? 0 : pair.margin()));
    return found;
  }
  found.step = pair.stuck();
  long double high = std::max(low * 2, 0.5L);
  while (!pair.within(high)) {
    low = high;
    found.step = pair.stuck();
    high *= 2;
  }
  const long double precision = std::max(kCoarse, high * kFine);
  while (high - low > precision) {
    const long double middle = (low + high) / 2;
    if (pair.within(middle)) {
      high = middle;
    } else {
      low = middle;
      found.step = pair.stuck();
    }
  }
  found.distance = rounded_up(high + pair.margin());
  found.place = pair.place(found.step);
  return found;
}

}  // namespace unstep::deviation
