#include "codec/chain_model.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "codec/context.h"

namespace unstep::codec {
namespace {

/// Stands for the turns before the first step.
constexpr std::uint64_t kNoHistory = 0x4924924924924924ULL;

}  // namespace

ChainModel::ChainModel(int table_bits)
    : slots_(table_bits),
      mixer_({64, 512, 1024}, kInitialWeights),
      visits_(table_bits) {}

void ChainModel::begin(const ChainHead& head) {
  origin_ = head.origin;
  closed_ = head.closed;
  four_ = head.connectivity == Connectivity::four;
  direction_ = 0;
  history_ = kNoHistory;
  runs_ = {};
  bends_ = {};
  steps_ = 0;
  here_ = {head.origin, 0};
  trail_[0] = here_;
  dss_ = DssState(four_ ? 4 : 8);
  visits_.mark(here_.at);
}

/// The last steps as a vector, in the frame of the current quarter.
std::uint64_t ChainModel::chord(std::uint32_t steps) const {
  if (steps_ < steps) return 0;
  const Point from = trail_[(steps_ - steps) % trail_.size()].at;
  std::int32_t dx = here_.at.x - from.x;
  std::int32_t dy = here_.at.y - from.y;
  for (unsigned q = 0; q < direction_ / 2U; ++q) {
    const std::int32_t t = dx;
    dx = dy;
    dy = -t;
  }
  return static_cast<std::uint64_t>((dx + 128) << 9 | (dy + 128) << 1 |
                                    (direction_ & 1));
}

/// Doubled area between the last steps and their chord (F of SU 1089551).
unsigned ChainModel::bulge(std::uint32_t steps) const {
  if (steps_ < steps) return 0;
  const Trail& from = trail_[(steps_ - steps) % trail_.size()];
  const std::int64_t dx = std::int64_t{here_.at.x} - from.at.x;
  const std::int64_t dy = std::int64_t{here_.at.y} - from.at.y;
  const std::int64_t x = std::int64_t{from.at.x} - origin_.x;
  const std::int64_t y = std::int64_t{from.at.y} - origin_.y;
  return quantise_area(static_cast<std::int64_t>(here_.area - from.area) -
                       (y * dx - x * dy));
}

/// The way home of a closed chain that is near it, else 0.
std::uint64_t ChainModel::home() const {
  constexpr std::int32_t kNear = 15;
  std::int32_t dx = origin_.x - here_.at.x;
  std::int32_t dy = origin_.y - here_.at.y;
  if (!closed_ || steps_ < 3 || std::abs(dx) > kNear || std::abs(dy) > kNear) {
    return 0;
  }
  for (unsigned q = 0; q < direction_ / 2U; ++q) {
    const std::int32_t t = dx;
    dx = dy;
    dy = -t;
  }
  return static_cast<std::uint64_t>((dx + 32) << 7 | (dy + 32) << 1 |
                                    (direction_ & 1));
}

/// The way on of a chain that is not near home. Closed chains often begin at
/// their topmost point and never go above it.
std::uint64_t ChainModel::rows_below() const {
  const std::uint64_t recent = history_ & 0xfff;
  if (!closed_) return recent << 3 | direction_;
  const auto below = static_cast<std::uint64_t>(
      std::clamp(std::int64_t{origin_.y} - here_.at.y + 1, std::int64_t{0},
                 std::int64_t{3}));
  return (recent & 0x1ff) << 5 | below << 3 | direction_;
}

void ChainModel::ask_slots() {
  const std::uint64_t base =
      (closed_ ? 1U : 0U) | (four_ ? 2U : 0U) | (direction_ & 1U) << 2;
  const auto history = [&](unsigned turns) {
    return history_ & ((std::uint64_t{1} << (3 * turns)) - 1);
  };
  const auto run = [&](std::size_t k, std::uint32_t limit) {
    return std::uint64_t{std::min(runs_[k], limit)};
  };
  const std::uint64_t bends =
      bends_[0] | std::uint64_t{bends_[1]} << 3 | std::uint64_t{bends_[2]} << 6;
  const ChainVisits::Rings rings = visits_.around(here_.at, direction_);
  const std::uint64_t ahead = (rings.two & 0x1f) | (rings.two >> 12) << 5;
  const std::uint64_t near = rings.one | ahead << 8;
  const std::uint64_t all = rings.one | std::uint64_t{rings.two} << 8 |
                            std::uint64_t{rings.three} << 24;
  const std::uint64_t verdict =
      dss_.verdict(four_ ? direction_ / 2 : direction_);
  const unsigned level = match_.confidence();
  const unsigned guess = level > 0 ? match_.prediction() : 0;
  const std::uint64_t way_home = home();

  slots_.ask(0, mix(history(1), base));
  slots_.ask(1, mix(history(3), base));
  slots_.ask(2, mix(history(5), base));
  slots_.ask(3, mix(history(8), base));
  slots_.ask(4, mix(history(12), base));
  slots_.ask(5, mix(run(0, 255) << 8 | run(1, 255), mix(bends & 63, base)));
  slots_.ask(6, mix((run(0, 127) << 7 | run(1, 127)) << 14 | run(2, 127) << 7 |
                        run(3, 127),
                    mix(bends, base)));
  slots_.ask(7, mix(near, mix(history(2), base)));
  slots_.ask(8, mix(all, mix(history(1), base)));
  slots_.ask(9,
             mix(verdict << 8 | dss_.previous_length(), mix(history(2), base)));
  slots_.ask(10, mix(verdict, mix(history(4), base)));
  slots_.ask(11, mix(chord(16), mix(bulge(16) << 9 | history(3), base)));
  slots_.ask(12, mix(chord(32), mix(bulge(32) << 9 | history(3), base)));
  slots_.ask(13, mix(level << 3 | guess, mix(history(2), base)));
  slots_.ask(14, way_home != 0 ? mix(way_home, mix(history(1), base + 8))
                               : mix(rows_below(), base));
  next_selectors_ = {
      std::min<std::size_t>(std::bit_width(runs_[0]), 7) * 8,
      static_cast<std::size_t>(history(2)) * 8,
      (level * 8 + guess) * 8 + (rings.one != 0 && ahead != 0 ? 512U : 0U)};
}

/// Learns the decisions of before; those to come see what was asked for.
void ChainModel::learn_last() {
  slots_.learn(
      [this](bool bit, std::size_t lane) { mixer_.update(bit, lane); });
  slots_.recall();
  selectors_ = next_selectors_;
}

int ChainModel::probability(Node node) {
  auto& inputs = mixer_.inputs(slots_.lane());
  slots_.predict(node, inputs);
  const int x = mixer_.mix(
      {selectors_[0] + node, selectors_[1] + node, selectors_[2] + node},
      slots_.lane());
  return std::clamp(entropy::squash(x), 4, 65532);
}

void ChainModel::advance(unsigned turn) {
  match_.push(turn);
  history_ = history_ << 3 | turn;
  if (turn == 0) {
    ++runs_[0];
  } else {
    runs_ = {0, runs_[0], runs_[1], runs_[2]};
    bends_ = {static_cast<std::uint8_t>(turn), bends_[0], bends_[1]};
  }
  direction_ = static_cast<Step>((direction_ + turn) & 7U);
  dss_.push(four_ ? direction_ / 2 : direction_);
  const Point move = step_delta(direction_);
  here_.area += static_cast<std::uint64_t>(
      (std::int64_t{here_.at.y} - origin_.y) * move.x -
      (std::int64_t{here_.at.x} - origin_.x) * move.y);
  here_.at.x += move.x;
  here_.at.y += move.y;
  trail_[++steps_ % trail_.size()] = here_;
  visits_.mark(here_.at);
}

}  // namespace unstep::codec
