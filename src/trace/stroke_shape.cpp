#include "trace/stroke_shape.h"

#include <algorithm>
#include <array>
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
constexpr double kTipShare = 0.58;

/// A stroke shorter than this share of its width is a dot.
constexpr double kDotShare = 0.3;

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

  /// From about a hundred places.
  double usual_width() {
    measure(1 + spots().size() / 100);
    return typical_width();
  }

  Stroke run() {
    measure(1);
    Stroke stroke;
    stroke.chain = chain();
    if (spots().size() == 1 && spots()[0].square > 0) return dotted(stroke);
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
    double widest = 0;
    for (std::size_t k = first; k < end; ++k) {
      widest = std::max(widest, radius_of(spots()[k]));
    }
    const double width = std::min(*left + *right, 2 * widest + 1);
    return Girth{width, (*right - *left) / 2, normal};
  }

  void measure(std::size_t every) {
    if (spots().size() < 2) return;
    for (std::size_t i = 0; i < spots().size(); i += every) {
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

  /// A circle of about the same reach all around.
  [[nodiscard]] Stroke dotted(Stroke stroke) const {
    constexpr std::array<Vector2, 8> kAround{{{1, 0},
                                              {0.6, 0.8},
                                              {0, 1},
                                              {-0.6, 0.8},
                                              {-1, 0},
                                              {-0.6, -0.8},
                                              {0, -1},
                                              {0.6, -0.8}}};
    const Spot& spot = spots()[0];
    const double most = radius_of(spot) + 2;
    double sum = 0;
    Vector2 lean;
    for (const Vector2& way : kAround) {
      const double far =
          way_out(ink_, to_vector(spot.at), way, most).value_or(most);
      sum += far;
      lean = lean + far * way;
    }
    // A circle beside its centre by d reaches d cos farther: squares of the
    // cosines add up to 3.44 along x, 4.56 along y.
    stroke.shift = {half_pixels(lean.x / 3.44), half_pixels(lean.y / 4.56)};
    stroke.pieces = {{0, pen(sum / kAround.size() * 2)}};
    return stroke;
  }

  static std::int32_t half_pixels(double v) {
    return std::clamp(static_cast<std::int32_t>(std::floor(2 * v + 0.5)), -1,
                      1);
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
    return {half_pixels((xo * yy - yo * xy) / area),
            half_pixels((yo * xx - xo * xy) / area)};
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

  /// Works on the last spots: drops what is bent and goes on as the line did,
  /// on a circle if it was on one, until the pen's tip is at the ink's end.
  void fit() {
    const std::size_t n = spots_.size();
    const std::size_t kept = n - bent();
    const auto reach = static_cast<std::size_t>(std::max(12.0, 3 * width_));
    const std::size_t first = kept > reach ? kept - reach : 0;
    const std::span<const Spot> behind =
        std::span(spots_).subspan(first, kept - first);
    Heading heading = heading_of(behind);
    if (dot(heading.along, heading.along) == 0) return;
    const Vector2 at = centred(to_vector(spots_[kept - 1].at), heading.along);
    go_on(heading, at, kept);
  }

 private:
  /// Where a line goes at its end and how it turns in each step.
  struct Heading {
    Vector2 along;
    double bend = 0;
  };

  /// Lays the end anew, after the spots that are kept.
  void go_on(Heading heading, Vector2 at, std::size_t kept) {
    append_line(tail_, spots_[kept - 1].at, nearest(at));
    for (int i = 0; i < static_cast<int>(3 * width_) + 4; ++i) {
      const double far = free_way(at, heading.along);
      if (far <= 0) break;
      at = at + std::min(far, 1.0) * heading.along;
      append_line(tail_, tail_.empty() ? spots_[kept - 1].at : tail_.back().at,
                  nearest(at));
      heading.along =
          unit(heading.along +
               heading.bend * Vector2{-heading.along.y, heading.along.x});
    }
    for (const Spot& spot : tail_) {
      if (!pixel_at(ink_, spot.at)) return;
    }
    spots_.resize(kept);
    spots_.insert(spots_.end(), tail_.begin(), tail_.end());
  }

  /// Halfway between the edges on both sides, where these are near.
  [[nodiscard]] Vector2 centred(Vector2 at, Vector2 along) const {
    const Vector2 side{-along.y, along.x};
    const auto right = way_out(ink_, at, side, width_ + 1);
    const auto left = way_out(ink_, at, -1 * side, width_ + 1);
    if (!right || !left || *right + *left > width_ + 3) return at;
    return at + ((*right - *left) / 2) * side;
  }

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

  [[nodiscard]] Heading heading_of(std::span<const Spot> behind) const {
    const std::size_t half = behind.size() / 2;
    if (half < 6) return {direction_of(behind), 0};
    const Vector2 early = direction_of(behind.first(half));
    const Vector2 late = direction_of(behind.last(half));
    const double apart =
        length(to_vector(behind.back().at) - to_vector(behind.front().at)) / 2;
    if (apart < 2) return {late, 0};
    // No tighter than the width allows; less than a pixel's doubt is straight.
    double bend = cross(early, late) / apart;
    if (std::abs(bend) > 0.6 / width_ || std::abs(bend) * apart * apart < 2.5) {
      return {direction_of(behind), 0};
    }
    return {unit(late + (bend * apart / 2) * Vector2{-late.y, late.x}), bend};
  }

  /// How far a round tip could go on before it leaves the ink: the middle of
  /// what seven ways side by side say.
  [[nodiscard]] double free_way(Vector2 from, Vector2 along) const {
    const Vector2 side{-along.y, along.x};
    const double most = 3 * width_ + 4;
    std::vector<double> ways;
    for (int i = -3; i <= 3; ++i) {
      const double part = 0.12 * i;
      const double way =
          way_out(ink_, from + (part * width_) * side, along, most)
              .value_or(most);
      ways.push_back(way - width_ * std::sqrt(0.25 - part * part));
    }
    return median(ways);
  }

  const Bitmap& ink_;
  std::vector<Spot>& spots_;
  std::vector<Spot> tail_;
  double width_;
};

}  // namespace

void fit_ends(const Bitmap& ink, Route& route) {
  if (route.closed || route.spots.size() < 2) return;
  const double width = Shaper(ink, route).usual_width();
  if (route.free_to) Tip(ink, route.spots, width).fit();
  if (!route.free_from) return;
  if (route.free_to &&
      static_cast<double>(route.spots.size()) <= kDotShare * width) {
    route.spots = {route.spots[route.spots.size() / 2]};
    return;
  }
  std::ranges::reverse(route.spots);
  Tip(ink, route.spots, width).fit();
  std::ranges::reverse(route.spots);
}

Stroke shape_of(const Bitmap& ink, const Route& route) {
  return Shaper(ink, route).run();
}

}  // namespace unstep::trace
