#include "trace/stroke_shape.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "trace/neighbourhood.h"

namespace unstep::trace {
namespace {

/// A width is measured to this part of a pixel.
constexpr double kProbe = 0.25;

/// Widths of a pen may be off by this much, in pixels, before it is changed.
constexpr double kWidthSlack = 2.0;

/// A tip is taken back as far as a spot's ink reaches, by this share: 0.707
/// for the corner of a square end, less because noise bends it.
constexpr double kTipShare = 0.65;

/// How far the ink goes from a place, at most `most`; nothing if farther.
std::optional<double> way_out(const Bitmap& ink, Vector2 from, Vector2 along,
                              double most) {
  for (int i = 1;; ++i) {
    const double far = kProbe * i;
    if (far > most) return std::nullopt;
    if (!pixel_at(ink, nearest(from + far * along))) return far - kProbe / 2;
  }
}

/// Across the stroke at one of its spots.
struct Girth {
  double width = 0;
  double offset = 0;  ///< of the middle from the spot, along the normal
  Vector2 normal;
};

double median(std::vector<double> values) {
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Shaper {
 public:
  Shaper(const Bitmap& ink, const Route& route) : ink_(ink), route_(route) {}

  Stroke run() {
    measure();
    Stroke stroke;
    stroke.chain = chain();
    stroke.shift = shift();
    base_ = typical_width();
    if (widths_.empty()) {
      stroke.pieces = {{stroke.chain.steps.size(), pen(base_)}};
    } else {
      cut_pieces(stroke);
    }
    return stroke;
  }

 private:
  [[nodiscard]] const std::vector<Spot>& spots() const { return route_.spots; }

  static std::int32_t pen(double width) {
    return std::max(1, static_cast<std::int32_t>(std::floor(2 * width + 0.5)));
  }

  [[nodiscard]] Chain chain() const {
    Chain chain;
    chain.origin = spots().front().at;
    chain.closed = route_.closed && spots().size() > 2;
    const std::size_t n = spots().size();
    for (std::size_t i = 1; i < n + (chain.closed ? 1 : 0); ++i) {
      const Point a = spots()[i - 1].at;
      const Point b = spots()[i % n].at;
      for (Step s = 0; s < 8; ++s) {
        const Point move = step_delta(s, YAxis::down);
        if (a.x + move.x == b.x && a.y + move.y == b.y) {
          chain.steps.push_back(s);
        }
      }
    }
    return chain;
  }

  [[nodiscard]] std::optional<Girth> girth(std::size_t i) const {
    const Spot& spot = spots()[i];
    if (spot.square == 0) return std::nullopt;
    const double radius = radius_of(spot);
    const auto reach = static_cast<std::size_t>(std::max(3.0, 1.5 * radius));
    const std::size_t first = i > reach ? i - reach : 0;
    const std::size_t end = std::min(spots().size(), i + reach + 1);
    const Vector2 along =
        direction_of(std::span(spots()).subspan(first, end - first));
    if (dot(along, along) == 0) return std::nullopt;
    const Vector2 normal{-along.y, along.x};
    const Vector2 at = to_vector(spot.at);
    const auto right = way_out(ink_, at, normal, 2 * radius + 2);
    const auto left = way_out(ink_, at, -1 * normal, 2 * radius + 2);
    if (!right || !left) return std::nullopt;
    // Beside a spur or a junction the way out is long on one side.
    const double width = std::min(*left + *right, 2 * radius + 1.5);
    return Girth{width, (*right - *left) / 2, normal};
  }

  void measure() {
    if (spots().size() < 2) return;
    for (std::size_t i = 0; i < spots().size(); ++i) {
      const auto found = girth(i);
      if (!found) continue;
      girths_.push_back(*found);
      widths_.push_back(found->width);
      places_.push_back(i);
    }
  }

  /// The dots of a spot reach to the middle of paper, less half a pixel.
  [[nodiscard]] double typical_width() const {
    if (!widths_.empty()) return median(widths_);
    double radius = 0.5;
    for (const Spot& spot : spots()) {
      if (spot.square > 0) radius = std::max(radius, radius_of(spot));
    }
    return 2 * radius;
  }

  /// The shift (a, b) for which a normal_x + b normal_y is nearest to the
  /// offsets, in half pixels. Least squares, drawn to 0.
  [[nodiscard]] Point shift() const {
    double xx = 0.05 * static_cast<double>(girths_.size()) + 1;
    double yy = xx;
    double xy = 0;
    double xo = 0;
    double yo = 0;
    for (const Girth& g : girths_) {
      const double offset = std::clamp(g.offset, -1.0, 1.0);
      xx += g.normal.x * g.normal.x;
      xy += g.normal.x * g.normal.y;
      yy += g.normal.y * g.normal.y;
      xo += g.normal.x * offset;
      yo += g.normal.y * offset;
    }
    const double area = xx * yy - xy * xy;
    const auto halves = [](double v) {
      return std::clamp(static_cast<std::int32_t>(std::floor(2 * v + 0.5)), -1,
                        1);
    };
    return {halves((xo * yy - yo * xy) / area),
            halves((yo * xx - xo * xy) / area)};
  }

  /// The widths without what is shorter than half of them.
  [[nodiscard]] std::vector<double> smoothed() const {
    const auto reach = static_cast<std::size_t>(std::max(2.0, base_ / 2));
    std::vector<double> smooth(widths_.size());
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      const std::size_t first = i > reach ? i - reach : 0;
      const std::size_t end = std::min(widths_.size(), i + reach + 1);
      smooth[i] = median({widths_.begin() + static_cast<std::ptrdiff_t>(first),
                          widths_.begin() + static_cast<std::ptrdiff_t>(end)});
    }
    return smooth;
  }

  /// A blot on a line is about as long as it is wide; the line goes through.
  void level_blots(std::vector<double>& widths) const {
    for (std::size_t i = 0; i < widths.size();) {
      std::size_t end = i;
      double widest = 0;
      for (; end < widths.size() && widths[end] > base_ + kWidthSlack; ++end) {
        widest = std::max(widest, widths[end]);
      }
      if (end > i && static_cast<double>(end - i) <= 1.5 * widest) {
        std::fill(widths.begin() + static_cast<std::ptrdiff_t>(i),
                  widths.begin() + static_cast<std::ptrdiff_t>(end), base_);
      }
      i = end + 1;
    }
  }

  /// Greedy: a piece goes on while one width serves all of it.
  void cut_pieces(Stroke& stroke) const {
    std::vector<double> widths = smoothed();
    level_blots(widths);
    const std::size_t steps = stroke.chain.steps.size();
    std::size_t used = 0;
    for (std::size_t i = 0; i < widths.size();) {
      double low = widths[i];
      double high = widths[i];
      std::size_t end = i;
      while (end < widths.size()) {
        const double l = std::min(low, widths[end]);
        const double h = std::max(high, widths[end]);
        if (h - l > 2 * kWidthSlack) break;
        low = l;
        high = h;
        ++end;
      }
      const double width =
          median({widths.begin() + static_cast<std::ptrdiff_t>(i),
                  widths.begin() + static_cast<std::ptrdiff_t>(end)});
      const bool last = end == widths.size();
      const std::size_t to = last ? steps : std::min(places_[end], steps);
      // A piece without steps would be a dot.
      if (to > used || last) {
        stroke.pieces.push_back(
            {to - used,
             pen(std::clamp(width, high - kWidthSlack, low + kWidthSlack))});
        used = to;
      }
      i = end;
    }
    if (stroke.pieces.size() > 1 && stroke.pieces.back().steps == 0) {
      stroke.pieces.pop_back();
    }
  }

  const Bitmap& ink_;
  const Route& route_;
  std::vector<Girth> girths_;
  std::vector<double> widths_;       ///< of girths_
  std::vector<std::size_t> places_;  ///< of girths_: index of the spot
  double base_ = 0;
};

/// One end of a route; spots are counted from there.
class Tip {
 public:
  Tip(const Bitmap& ink, std::vector<Spot>& spots, double width)
      : ink_(ink), spots_(spots), width_(width) {}

  /// Works on the last spots.
  void fit() {
    const std::size_t n = spots_.size();
    const std::size_t kept = n - bent();
    const auto reach = static_cast<std::size_t>(std::max(6.0, 2 * width_));
    const std::size_t first = kept > reach ? kept - reach : 0;
    const Vector2 along =
        direction_of(std::span(spots_).subspan(first, kept - first));
    if (dot(along, along) == 0) return;
    const Point from = spots_[kept - 1].at;
    const auto far = reach_of(to_vector(from), along);
    if (!far) return;
    std::vector<Spot> tail;
    if (*far > width_ / 2) {
      append_line(tail, from,
                  nearest(to_vector(from) + (*far - width_ / 2) * along));
    }
    for (const Spot& spot : tail) {
      if (!pixel_at(ink_, spot.at)) return;
    }
    spots_.resize(kept);
    spots_.insert(spots_.end(), tail.begin(), tail.end());
  }

 private:
  [[nodiscard]] const Spot& back(std::size_t i) const {
    return spots_[spots_.size() - 1 - i];
  }

  /// How many spots lie within the ink around one behind them.
  [[nodiscard]] std::size_t bent() const {
    const std::size_t most = (spots_.size() - 1) / 2;
    std::size_t count = 0;
    const Vector2 tip = to_vector(back(0).at);
    for (std::size_t i = 1; i <= most && back(i).square > 0; ++i) {
      const double apart = length(to_vector(back(i).at) - tip);
      if (apart > 3 * width_ + 4) break;
      if (radius_of(back(i)) >= kTipShare * apart) count = i;
    }
    return count;
  }

  /// How far the ink goes ahead: the middle of three ways side by side.
  [[nodiscard]] std::optional<double> reach_of(Vector2 from,
                                               Vector2 along) const {
    const Vector2 side{-along.y, along.x};
    std::vector<double> ways;
    for (const double part : {-0.25, 0.0, 0.25}) {
      const auto way =
          way_out(ink_, from + (part * width_) * side, along, 3 * width_ + 4);
      if (!way) return std::nullopt;
      ways.push_back(*way);
    }
    return median(ways);
  }

  const Bitmap& ink_;
  std::vector<Spot>& spots_;
  double width_;
};

double usual_width(const Route& route) {
  std::vector<double> widths;
  for (const Spot& spot : route.spots) {
    if (spot.square > 0) widths.push_back(2 * radius_of(spot) + 0.25);
  }
  return widths.empty() ? 1 : median(widths);
}

}  // namespace

void fit_ends(const Bitmap& ink, Route& route) {
  if (route.closed || route.spots.size() < 2) return;
  const double width = usual_width(route);
  if (route.free_to) Tip(ink, route.spots, width).fit();
  if (!route.free_from) return;
  std::ranges::reverse(route.spots);
  Tip(ink, route.spots, width).fit();
  std::ranges::reverse(route.spots);
}

Stroke shape_of(const Bitmap& ink, const Route& route) {
  return Shaper(ink, route).run();
}

}  // namespace unstep::trace
