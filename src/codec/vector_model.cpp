#include "codec/vector_model.h"

#include <algorithm>

#include "codec/context.h"

namespace unstep::codec {
namespace {

constexpr int kReach = 20;           ///< how near a near vertex is
constexpr std::int64_t kFar = 1600;  ///< what a parallel line may cost at most
constexpr int kUnknown = 99;         ///< a fine angle of no vector
constexpr int kNoTurn = 14;          ///< stands for the turns before a path

/// 2 / N for every input of a context, 12 fractional bits.
constexpr std::array<VectorModel::Decisions::Weights, 1> make_initial() {
  VectorModel::Decisions::Weights weights{};
  for (std::size_t i = 0; i < 2 * VectorModel::kContexts; ++i) {
    weights[i] = 4096 * 14 / 10 / VectorModel::kContexts;
  }
  return {weights};
}
constexpr auto kInitial = make_initial();

std::uint64_t word(const Vec& v) {
  return static_cast<std::uint64_t>(v.x) << 32 ^
         static_cast<std::uint64_t>(v.y);
}

int clamped(int v, int limit) { return std::clamp(v, -limit, limit); }

/// b turned on by the angle from a to b; only its direction means something.
Vec continued(const Vec& a, const Vec& b) {
  const Vec u = shortened(a, 15);
  const Vec v = shortened(b, 15);
  const Vec square{v.x * v.x - v.y * v.y, 2 * v.x * v.y};  // below 2^31
  return shortened(
      {square.x * u.x + square.y * u.y, square.y * u.x - square.x * u.y}, 24);
}

/// 0..8 and the side, from a distance in eighths.
int eighths_class(std::int64_t distance) {
  constexpr std::array<std::int64_t, 8> kSteps{2, 4, 8, 12, 20, 32, 64, 128};
  const std::int64_t size = std::abs(distance);
  int level = 0;
  for (const std::int64_t step : kSteps) level += size >= step ? 1 : 0;
  return distance < 0 ? level : 16 + level;
}

}  // namespace

VectorModel::VectorModel(int table_bits, const VertexMemory& vertices)
    : vertices_(vertices),
      decisions_{Decisions(table_bits, kInitial),
                 Decisions(table_bits, kInitial),
                 Decisions(table_bits, kInitial)} {}

void VectorModel::begin() {
  before_ = {};
  turns_.fill(kNoTurn);
  match_.begin();
}

int VectorModel::relative(const Vec& v) const {
  if (v.zero()) return kNoDirection;
  return (direction_of(v) - before_direction() + kDirections) % kDirections;
}

int VectorModel::relative_fine(const Vec& v) const {
  if (v.zero()) return kUnknown;
  const int d = before_direction();
  const int base = d / 7 * 48 + (d % 7 == 0 ? 0 : (d % 7 - 1) * 8);
  const int angle = (fine_angle(v) - base + 192) % 192;
  return clamped(angle >= 100 ? angle - 192 : angle, 40);
}

void VectorModel::look_around(const VectorPlace& place) {
  arc_ = place.arc;
  stage_ = static_cast<std::uint32_t>(
      8 * (place.closed ? std::min<std::uint64_t>(place.left, 7) : 0) +
      std::min<std::uint64_t>(place.index, 7));
  bend_ = {};
  if (!place.tangent.zero()) {
    bend_ = shortened(place.tangent, 24);
  } else if (!before_[0].zero() && !before_[1].zero()) {
    bend_ = continued(before_[1], before_[0]);
  }
  const VertexMemory::Vertex& here = vertices_[place.vertex];
  std::int32_t nearest = VertexMemory::kNone;
  std::int64_t best = kReach * kReach + 1;
  vertices_.for_near(here.at, [&](std::int32_t id) {
    if (id == place.vertex || id == here.previous) return;
    const Vec d = vertices_[id].at - here.at;
    const std::int64_t distance = d.x * d.x + d.y * d.y;
    if (distance >= best) return;
    best = distance;
    nearest = id;
  });
  backward_ = forward_ = offset_ = {};
  near_ = 0;
  if (nearest == VertexMemory::kNone) return;
  const VertexMemory::Vertex& v = vertices_[nearest];
  if (v.previous != VertexMemory::kNone) {
    backward_ = vertices_[v.previous].at - v.at;
  }
  if (v.next != VertexMemory::kNone && v.next != place.vertex) {
    forward_ = vertices_[v.next].at - v.at;
  }
  offset_ = v.at - here.at;
  near_ = 1 + static_cast<int>(std::min<std::int64_t>(5, size_of(offset_) / 3));
}

void VectorModel::set_turn_contexts(const VectorPlace& place) {
  const Vec match = match_.expected();
  const int level = match_.length() == 0
                        ? 0
                        : 1 + static_cast<int>(std::min(match_.length(), 3U));
  const int d1 = before_[0].zero() ? kNoDirection : before_direction();
  const int slope = d1 == kNoDirection ? 7 : d1 % 7;
  const int l1 = length_class(size_of(before_[0]));
  const int l2 = length_class(size_of(before_[1]));
  const int left =
      place.closed ? static_cast<int>(std::min<std::uint64_t>(place.left, 5))
                   : 6;
  const int index = static_cast<int>(std::min<std::uint64_t>(place.index, 3));
  const int back = relative(backward_);
  const int guess = relative(match);
  const int home = relative(place.home);
  const int bend = relative_fine(bend_);
  int fine = kUnknown;
  if (!before_[0].zero() && !before_[1].zero()) {
    fine = (fine_angle(before_[0]) - fine_angle(before_[1]) + 288) % 192 - 96;
  }
  const int inside = before_[0].zero() ? 48 : fine_angle(before_[0]) % 48;
  decisions_[kTurn].set_contexts(
      {0, joined(1, slope, turns_[0]), joined(2, l1, turns_[0]),
       joined(3, l1, l2, slope), joined(4, turns_[0], turns_[1], l1 / 2),
       joined(5, d1, l1 / 2), joined(6, back, near_),
       joined(7, back, relative(forward_), length_class(size_of(backward_)),
              l1),
       joined(8, guess, level, slope), joined(9, left, index, home),
       joined(10, home, left, length_class(size_of(place.home)), l1),
       mix(word(before_[0]), 11), mix(word(before_[0]), word(before_[1])),
       joined(13, turns_[0], turns_[1], turns_[2], slope),
       joined(14, bend, l1 / 2),
       joined(15, relative_fine(backward_), bend >> 2),
       joined(16, inside, clamped(fine, 24)),
       joined(17, direction_of(offset_), d1, near_)});
  turn_selector_ = static_cast<std::uint32_t>(back + 32 * level);
}

/// Of the lines at near vertices, the nearest that goes the same way.
void VectorModel::find_parallel(const VectorPlace& place) {
  parallel_ = {};
  const VertexMemory::Vertex& here = vertices_[place.vertex];
  std::int64_t best = kFar + 1;
  const auto consider = [&](std::int32_t id, std::int32_t other, int kind) {
    if (other == VertexMemory::kNone) return;
    if (id == here.previous && other == place.vertex) return;
    if (other == place.vertex && kind == 1) return;
    const Vec move = vertices_[other].at - vertices_[id].at;
    if (move.zero()) return;
    const int apart =
        (direction_of(move) - direction_ + kDirections) % kDirections;
    if (apart > 1 && apart < kDirections - 1) return;
    const Vec d = vertices_[id].at - here.at;
    const std::int64_t cost = 2 * (d.x * d.x + d.y * d.y) +
                              (apart == 0 ? 0 : 60) + (kind == 1 ? 0 : 10);
    if (cost >= best) return;
    best = cost;
    parallel_ = {move, kind};
  };
  vertices_.for_near(here.at, [&](std::int32_t id) {
    if (id == place.vertex) return;
    consider(id, vertices_[id].previous, 1);
    consider(id, vertices_[id].next, 2);
  });
}

void VectorModel::set_length_contexts(const VectorPlace& place, int turn) {
  const Vec match = match_.expected();
  const int level = match_.length() == 0
                        ? 0
                        : 1 + static_cast<int>(std::min(match_.length(), 3U));
  const std::int64_t s1 = size_of(before_[0]);
  const std::int64_t s2 = size_of(before_[1]);
  const std::int64_t home_size = size_of(place.home);
  const std::int64_t parallel_size = size_of(parallel_.move);
  const int l1 = length_class(s1);
  const int left =
      place.closed ? static_cast<int>(std::min<std::uint64_t>(place.left, 5))
                   : 6;
  const int index = static_cast<int>(std::min<std::uint64_t>(place.index, 3));
  const int home = (relative(place.home) - turn + kDirections) % kDirections;
  const int back = relative(backward_);
  const int side = length_class(parallel_size);
  const auto number = [](std::int64_t v) {
    return static_cast<std::uint64_t>(v);
  };
  const int kind = parallel_.kind;
  decisions_[kLength].set_contexts(
      {0, joined(1, turn, l1), joined(2, turn, l1, length_class(s2)),
       joined(3, turn, direction_ % 7, l1),
       joined(4, turns_[0], turn, l1, length_class(s2)),
       joined(5, direction_, l1 / 2), joined(6, side, kind),
       joined(7, side, l1, turn, kind),
       mix(number(size_of(match)) << 8 | joined(0, level),
           turn == relative(match) ? 8 : 9),
       joined(9, left, length_class(home_size), std::min(home, 2)),
       joined(10, left, index, l1), mix(word(before_[0]), joined(11, turn)),
       mix(number(s1), number(s2) << 8 | static_cast<unsigned>(turn)),
       mix(number(s2), joined(13, l1)),
       mix(number(parallel_size), joined(14, kind, direction_ % 7)),
       mix(number(size_of(backward_)), joined(15, near_, turn == back ? 1 : 0)),
       mix(number(home_size), joined(16, left, home)),
       joined(17, turn, back, length_class(size_of(backward_)))});
  expected_length_ = kind > 0 ? parallel_size : level > 0 ? size_of(match) : s1;
  length_selector_ = kind > 0 ? 256 : 0;
}

VectorModel::Expected VectorModel::expected_minor(const Vec& v) const {
  if (v.zero()) return {};
  const Vec r = turned_back(shortened(v, 24), direction_ / 7);
  std::int64_t major = std::max<std::int64_t>(r.x, 0);
  std::int64_t minor = std::max<std::int64_t>(r.y, 0);
  if (direction_ % 7 > 3) std::swap(major, minor);
  if (major == 0 || minor > 2 * major) return {};
  return {length_ * 8 * minor / major, true};  // below 2^32 2^3 2^24
}

void VectorModel::set_minor_expectations(const VectorPlace& place) {
  guesses_[kStraight] = expected_minor(before_[0]);
  guesses_[kBend] = expected_minor(bend_);
  guesses_[kParallel] = expected_minor(parallel_.move);
  guesses_[kMatch] = expected_minor(match_.expected());
  guesses_[kHome] = expected_minor(place.home);
  guesses_[kBackward] = expected_minor(backward_);
  guesses_[kSecond] = expected_minor(before_[1]);
}

void VectorModel::set_minor_contexts(const VectorPlace& place, int turn,
                                     std::int64_t middle, int width,
                                     std::uint32_t prefix) {
  const auto guess = [&](Guess which) {
    const Expected& e = guesses_[which];
    return e.known ? eighths_class(e.value - (middle * 8 + 4)) : 31;
  };
  const int straight = guess(kStraight);
  const int bend = guess(kBend);
  const int side = guess(kParallel);
  const int home = guess(kHome);
  const int back = guess(kBackward);
  const int second = guess(kSecond);
  const int level = static_cast<int>(std::min(match_.length(), 4U));
  const int kind = parallel_.kind;
  const int slope = direction_ % 7;
  const int l1 = length_class(size_of(before_[0]));
  const int left =
      place.closed ? static_cast<int>(std::min<std::uint64_t>(place.left, 5))
                   : 6;
  const int size = static_cast<int>(std::min<std::int64_t>(length_, 31));
  const auto length = static_cast<std::uint64_t>(length_);
  decisions_[kMinor].set_contexts(
      {0, joined(1, size, slope),
       joined(2, size, static_cast<int>(std::min(prefix, 63U)), turn),
       joined(3, straight, bend), joined(4, straight, turn, width),
       joined(5, bend, l1, width), joined(6, side, kind, width),
       joined(7, side, back, width), joined(8, guess(kMatch), level),
       joined(9, home, left), joined(10, side, bend, straight),
       mix(word(before_[0]), joined(11, turn, size)),
       mix(length, joined(12, static_cast<int>(prefix), slope)),
       joined(13, second, straight, width), joined(14, side, home, level, left),
       joined(15, second, length_class(size_of(before_[1]))),
       joined(16, turns_[0], turn, size), joined(17, back, near_)});
  minor_selector_ = 768 + static_cast<std::uint32_t>(side + 32 * level);
}

void VectorModel::advance(const Vec& v, int turn) {
  match_.push(v);
  const bool first = before_[0].zero();
  turns_ = {first ? kNoTurn : turn, turns_[0], turns_[1]};
  before_ = {v, before_[0], before_[1]};
}

}  // namespace unstep::codec
