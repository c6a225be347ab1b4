#include "codec/edge_forecast.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "codec/context.h"

namespace unstep::codec {
namespace {

constexpr int kLongest = 48;  ///< of the lines that are counted one by one

/// Lines of one length, the larger of dx and dy: all lengths are as likely, and
/// there are the more directions the longer a line is.
constexpr std::uint64_t line_weight(int length) {
  return 40'000U / static_cast<unsigned>(length);
}

/// Of the lengths up to each one.
constexpr std::array<std::uint64_t, kLongest + 1> make_sums() {
  std::array<std::uint64_t, kLongest + 1> sums{};
  for (int l = 1; l <= kLongest; ++l) {
    const auto at = static_cast<std::size_t>(l);
    sums[at] = sums[at - 1] + line_weight(l);
  }
  return sums;
}
constexpr auto kSums = make_sums();

/// Of a <= length <= b.
std::uint64_t lengths(int a, int b) {
  return kSums[static_cast<std::size_t>(b)] -
         kSums[static_cast<std::size_t>(a - 1)];
}

/// Longer lines, by slopes of 1 / 65536.
std::uint64_t long_weight(int dy) {
  return dy <= kLongest ? 87'000U : 87'000U * 48U / static_cast<unsigned>(dy);
}

int floor_of(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

/// floor(n y / of) for one y after the other, as an interpolator draws a line:
/// a division each would be most of the work.
class Quotients {
 public:
  Quotients(int n, int of, int y)
      : of_(of),
        value_(floor_of(n * y, of)),
        rest_(n * y - value_ * of),
        whole_(floor_of(n, of)),
        part_(n - whole_ * of) {}

  [[nodiscard]] int value() const { return value_; }
  void next() {
    value_ += whole_;
    rest_ += part_;
    const bool over = rest_ >= of_;
    value_ += over ? 1 : 0;
    rest_ -= over ? of_ : 0;
  }

 private:
  int of_;
  int value_;
  int rest_;   ///< 0 <= rest < of
  int whole_;  ///< what a step adds
  int part_;
};

std::int64_t fixed(int n, int of) {
  return std::clamp<std::int64_t>(std::int64_t{n} * 65536 / of, -65536, 65536);
}

/// Columns from one pixel to another; more than that no line of any slope here
/// goes.
int apart(int from, int to) { return std::clamp(to - from, -4000, 4000); }

/// Of 65536.
int odds(std::uint64_t part, std::uint64_t rest) {
  part >>= 14;
  rest >>= 14;
  return static_cast<int>(
      std::clamp<std::uint64_t>(part * 65536 / (part + rest + 1), 60, 65476));
}

}  // namespace

void SlopeRange::from(int dx, int dy) {
  const int n = 2 * dx - 1;
  if (n * low_of <= low * 2 * dy) return;
  low = n;
  low_of = 2 * dy;
}

void SlopeRange::up_to(int dx, int dy) {
  const int n = 2 * dx + 1;
  if (n * high_of >= high * 2 * dy) return;
  high = n;
  high_of = 2 * dy;
}

bool SlopeRange::holds(int dx, int dy) const {
  return low * dy <= dx * low_of && high * dy >= dx * high_of;
}

std::uint64_t SlopeRange::weight(int dy) const {
  if (low * high_of > high * low_of) return 0;
  std::uint64_t sum =
      long_weight(dy) * static_cast<std::uint64_t>(fixed(high, high_of) -
                                                   fixed(low, low_of)) >>
      16;
  Quotients least(-low, low_of, dy);
  Quotients most(high, high_of, dy);
  for (int y = dy; y <= kLongest; ++y, least.next(), most.next()) {
    const int a = std::max(-least.value(), -kLongest);
    const int b = std::min(most.value(), kLongest);
    if (a > b) continue;
    const int steep = std::min(b, y) - std::max(a, -y) + 1;
    if (steep > 0) sum += static_cast<unsigned>(steep) * line_weight(y);
    if (b > y) sum += lengths(std::max(a, y + 1), b);
    if (a < -y) sum += lengths(std::max(-b, y + 1), -a);
  }
  return sum;
}

std::uint64_t SlopeWeights::of(const SlopeRange& range, int dy) {
  // 15, 9, 15, 9 and 8 bits; the least bound is -8003, and dy is not 0.
  constexpr int kLeast = -8192;
  std::uint64_t key = 0;
  for (const auto& [value, bits] :
       {std::pair{range.low - kLeast, 15}, std::pair{range.low_of, 9},
        std::pair{range.high - kLeast, 15}, std::pair{range.high_of, 9},
        std::pair{dy, 8}}) {
    key = key << bits | static_cast<unsigned>(value);
  }
  Known& known = known_[key * kGolden >> (64 - kBits)];
  if (known.key != key) known = {key, range.weight(dy)};
  return known.weight;
}

void EdgeForecast::begin(bool ink) {
  ink_ = ink;
  direction_ = 0;
  down_ = 0;
  column_ = 1;
  moved_ = 1;
  begin_edge();
}

void EdgeForecast::begin_edge() {
  anchors_.clear();
  row_ = 0;
  chance_ = std::uint64_t{1} << 30;
}

void EdgeForecast::step(int direction) {
  direction_ = direction;
  if (direction == 0 || direction == 2) {
    column_ += 1 - direction;
    ++moved_;
    return;
  }
  moved_ = 0;
  if (direction == down_) {
    reach_row();
  } else {
    // The edge turned back: its end is a vertex.
    down_ = direction;
    x_ = pixel(direction);
    begin_edge();
  }
}

/// The edge is known in one more row.
void EdgeForecast::reach_row() {
  anchors_.push_back({x_, row_, chance_, 0, {}});
  ++row_;
  x_ = pixel(down_);
  std::uint64_t all = 0;
  std::uint64_t vertex = 0;
  for (Anchor& anchor : anchors_) {
    const int dy = row_ - anchor.row;
    const int dx = apart(anchor.x, x_);
    anchor.slopes.from(dx, dy);
    anchor.slopes.up_to(dx, dy);
    anchor.weight =
        dy <= kOldest ? anchor.chance * weights_.of(anchor.slopes, dy) : 0;
    all += anchor.weight;
    if (anchor.weight == 0 || !anchor.slopes.holds(dx, dy)) continue;
    const int length = std::max(dy, std::abs(dx));
    vertex += anchor.chance *
              (length <= kLongest
                   ? line_weight(length)
                   : long_weight(dy) / (50U * static_cast<unsigned>(length)));
  }
  std::erase_if(anchors_, [](const Anchor& a) { return a.weight == 0; });
  if (anchors_.size() > kMostAnchors) forget_one();
  chance_ = (vertex >> 24) + (all >> 34) + 1;
  scale(all);
}

void EdgeForecast::forget_one() {
  anchors_.erase(std::min_element(
      anchors_.begin(), anchors_.end(),
      [](const Anchor& a, const Anchor& b) { return a.weight < b.weight; }));
}

/// Keeps the chances in range; only their ratios count.
void EdgeForecast::scale(std::uint64_t all) {
  if (all == 0) {
    chance_ = std::uint64_t{1} << 30;
    return;
  }
  int up = 0;
  while (all << up < std::uint64_t{1} << 50) up += 2;
  while (up <= 0 && all >> -up > std::uint64_t{1} << 54) up -= 2;
  const auto scaled = [up](std::uint64_t v) {
    return up >= 0 ? v << up : v >> -up;
  };
  chance_ = scaled(chance_);
  for (Anchor& anchor : anchors_) {
    anchor.chance = scaled(anchor.chance);
    anchor.weight = scaled(anchor.weight);
  }
}

/// What the lines from an anchor say of the next row, seen from pixel x of it.
void EdgeForecast::add(Ahead& ahead, const Anchor& anchor, int x) {
  const int dy = row_ + 1 - anchor.row;
  const int dx = apart(anchor.x, x);
  SlopeRange here = anchor.slopes;
  here.from(dx, dy);
  here.up_to(dx, dy);
  ahead.here += anchor.chance * weights_.of(here, dy);
  if (!beside() || direction_ == 0) {
    SlopeRange east = anchor.slopes;
    east.from(dx + 1, dy);
    ahead.east += anchor.chance * weights_.of(east, dy);
  }
  if (!beside() || direction_ == 2) {
    SlopeRange west = anchor.slopes;
    west.up_to(dx - 1, dy);
    ahead.west += anchor.chance * weights_.of(west, dy);
  }
}

void EdgeForecast::look() {
  bends_ = right_ = 32768;
  age_ = 0;
  vertex_ = 0;
  place_ = 0;
  if (down_ == 0) return;
  const int x = pixel(down_);
  Ahead ahead;
  std::uint64_t all = 0;
  const Anchor* likeliest = nullptr;
  for (const Anchor& anchor : anchors_) {
    add(ahead, anchor, x);
    all += anchor.weight;
    if (likeliest == nullptr || anchor.weight > likeliest->weight) {
      likeliest = &anchor;
    }
  }
  add(ahead, {x_, row_, chance_, 0, {}}, x);
  // From a vertex the contour may as well turn back.
  static const std::uint64_t kAny = SlopeRange{}.weight(1);
  const std::uint64_t back = chance_ * (kAny / 2);
  vertex_ =
      static_cast<unsigned>((back >> 8) * 255 / (((back + all) >> 8) + 1));
  if (!beside()) {
    bends_ = odds(ahead.east + ahead.west + back, ahead.here);
    const std::uint64_t east = ahead.east + back / 2;
    const std::uint64_t west = ahead.west + back / 2;
    right_ = down_ == 3 ? odds(east, west) : odds(west, east);
  } else {
    bends_ = odds(ahead.here + back / 8,
                  (direction_ == 0 ? ahead.east : ahead.west) + back / 2);
    right_ = (direction_ == 0) == (down_ == 1) ? odds(ahead.here, back / 8)
                                               : odds(back / 8, ahead.here);
  }
  int moved = 0;
  if (likeliest != nullptr) {
    age_ = row_ - likeliest->row;
    moved = std::clamp(x_ - likeliest->x, -127, 127);
  }
  place_ = static_cast<std::uint64_t>(std::min(age_, 63)) << 14 |
           static_cast<std::uint64_t>(moved & 255) << 6 |
           static_cast<std::uint64_t>(std::min(moved_, 15)) << 2 |
           (!beside()         ? 0U
            : direction_ == 0 ? 1U
                              : 2U);
}

}  // namespace unstep::codec
