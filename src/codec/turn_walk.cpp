#include "codec/turn_walk.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "codec/context.h"

namespace unstep::codec {
namespace {

constexpr unsigned kFar = 40;  ///< how far gaps() sees, in points
constexpr int kSight = 12;     ///< and look()

}  // namespace

template <bool kAll>
void TurnWalk<kAll>::begin(CrackMap::Address point, CrackMap::Address flipped,
                           bool ink) {
  direction_ = 0;
  point_ = point + cracks_.step(0);
  flipped_ = flipped + cracks_.flipped_step(0);
  ink_ = ink;
  history_ = 0;
  runs_ = 0;
  bends_ = 0;
  steps_ = 1;
  here_ = {1, 0, 0};
  trail_[0] = {0, 0, 0};
  trail_[1] = here_;
  if constexpr (kAll) {
    dss_.reset();
    dss_.push(0);
    curve_.begin();
    gaps_ = gaps(point, flipped, 0);
    curve_.step(0, 1, 0, gaps_);
  }
}

template <bool kAll>
void TurnWalk<kAll>::move_on(Turn turn) {
  history_ = history_ << 2 | turn;
  if (turn == kStraight) {
    runs_ += (runs_ & 255) != 255 ? 1U : 0U;
  } else {
    runs_ <<= 8;
    bends_ = bends_ << 2 | turn;
  }
  direction_ = turned(direction_, turn);
  const auto d = static_cast<std::size_t>(direction_);
  here_.area += std::int64_t{here_.y} * kQuarterDx[d] -
                std::int64_t{here_.x} * kQuarterDy[d];
  here_.x += kQuarterDx[d];
  here_.y += kQuarterDy[d];
  if constexpr (kAll) {
    dss_.push(direction_);
    gaps_ = gaps(point_, flipped_, direction_);
    curve_.step(direction_, here_.x, here_.y, gaps_);
  }
  point_ += cracks_.step(direction_);
  flipped_ += cracks_.flipped_step(direction_);
  ++steps_;
  trail_[steps_ % trail_.size()] = here_;
}

template <bool kAll>
entropy::Counter& TurnWalk<kAll>::gate() {
  const std::uint64_t hash = mix(around_ & patch::kNear, history(12)) * kGolden;
  return gates_[hash >> (64 - kGateBits)];
}

/// The nearest cracks parallel to the one that leaves a point.
template <bool kAll>
CurveFit::Gaps TurnWalk<kAll>::gaps(CrackMap::Address point,
                                    CrackMap::Address flipped,
                                    Quarter direction) const {
  // The crack's bit in the plane where those beside it are its neighbours.
  const CrackMap::Address bit =
      (direction & 1) != 0 ? point + cracks_.crack(direction)
      : direction == 0     ? flipped
                           : flipped + cracks_.flipped_step(2);
  const std::uint64_t after = cracks_.window(bit + 1) >> (64 - kFar);
  const std::uint64_t before =
      cracks_.window(bit - CrackMap::Address{kFar}) >> (64 - kFar);
  return {after != 0 ? static_cast<int>(kFar) + 1 -
                           static_cast<int>(std::bit_width(after))
                     : 0,
          before != 0 ? 1 + std::countr_zero(before) : 0};
}

/// The nearest crack parallel to the one just walked, on one side.
template <bool kAll>
typename TurnWalk<kAll>::Sight TurnWalk<kAll>::look(bool right) const {
  const bool greater = right == (direction_ == 0 || direction_ == 3);
  const int distance = gaps_[greater ? 0 : 1];
  if (distance == 0 || distance > kSight) return {};
  const Quarter side = (direction_ + (right ? 1 : 3)) & 3;
  return {static_cast<unsigned>(distance),
          shape(point_ + CrackMap::Address{distance} * cracks_.step(side))};
}

/// Where the curve goes, on the axis along which most of the last steps went.
template <bool kAll>
CurveFit::Forecast TurnWalk<kAll>::forecast() const {
  const Trail& t = trail(std::min(steps_, 16U));
  const std::size_t axis =
      std::abs(here_.x - t.x) >= std::abs(here_.y - t.y) ? 0 : 1;
  return curve_.forecast(axis, direction_, here_.x, here_.y,
                         gaps(point_, flipped_, curve_.heading(axis)));
}

template <bool kAll>
unsigned TurnWalk<kAll>::shape(CrackMap::Address point) const {
  const CrackMap::Address on = cracks_.crack(direction_);
  const CrackMap::Address right = cracks_.crack((direction_ + 1) & 3);
  const CrackMap::Address left = cracks_.crack((direction_ + 3) & 3);
  const CrackMap::Address next = point + cracks_.step(direction_);
  return cracks_.test(point + on) << 5 | cracks_.test(point + right) << 4 |
         cracks_.test(point + left) << 3 | cracks_.test(next + on) << 2 |
         cracks_.test(next + right) << 1 | cracks_.test(next + left);
}

/// The last n steps as a chord, in the frame of the current direction: 18 bits.
template <bool kAll>
std::uint64_t TurnWalk<kAll>::chord(std::uint32_t n) const {
  if (steps_ < n) return 0;
  const std::int32_t dx = here_.x - trail(n).x;
  const std::int32_t dy = here_.y - trail(n).y;
  const auto d = static_cast<std::size_t>(direction_);
  const std::int32_t c = kQuarterDx[d];
  const std::int32_t s = kQuarterDy[d];
  return static_cast<std::uint64_t>((dx * c + dy * s + 128) << 9 |
                                    (dy * c - dx * s + 128));
}

/// Doubled area between the last n steps and their chord (patent's F).
template <bool kAll>
unsigned TurnWalk<kAll>::bulge(std::uint32_t n) const {
  if (steps_ < n) return 0;
  const Trail& t = trail(n);
  const std::int64_t dx = here_.x - t.x;
  const std::int64_t dy = here_.y - t.y;
  return quantise_area(here_.area - t.area -
                       (std::int64_t{t.y} * dx - std::int64_t{t.x} * dy));
}

template class TurnWalk<true>;
template class TurnWalk<false>;

}  // namespace unstep::codec
