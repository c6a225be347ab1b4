#include "codec/chain_model.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "codec/context.h"

namespace unstep::codec {

ChainModel::ChainModel(int table_bits)
    : slots_(table_bits),
      mixer_({64, 512, 1024}, kInitialWeights),
      visits_(table_bits) {}

void ChainModel::begin(const ChainHead& head) {
  closed_ = head.closed;
  four_ = head.connectivity == Connectivity::four;
  track_.begin(head.origin, 0);
  dss_ = DssState(four_ ? 4 : 8);
  visits_.mark(track_.position());
}

/// The way home of a closed chain that is near it, else 0.
std::uint64_t ChainModel::home() const {
  constexpr std::int32_t kNear = 15;
  const Point here = track_.position();
  const Point way{track_.origin().x - here.x, track_.origin().y - here.y};
  if (!closed_ || track_.steps() < 3 || std::abs(way.x) > kNear ||
      std::abs(way.y) > kNear) {
    return 0;
  }
  const Point ahead = track_.in_frame(way);
  return static_cast<std::uint64_t>((ahead.x + 32) << 7 | (ahead.y + 32) << 1 |
                                    (track_.direction() & 1));
}

/// The way on of a chain that is not near home. Closed chains often begin at
/// their topmost point and never go above it.
std::uint64_t ChainModel::rows_below() const {
  const std::uint64_t recent = track_.history(4);
  if (!closed_) return recent << 3 | track_.direction();
  const auto below = static_cast<std::uint64_t>(
      std::clamp(std::int64_t{track_.origin().y} - track_.position().y + 1,
                 std::int64_t{0}, std::int64_t{3}));
  return (recent & 0x1ff) << 5 | below << 3 | track_.direction();
}

void ChainModel::ask_slots() {
  const std::uint64_t base =
      (closed_ ? 1U : 0U) | (four_ ? 2U : 0U) | (track_.direction() & 1U) << 2;
  const auto history = [this](unsigned turns) { return track_.history(turns); };
  const auto run = [this](std::size_t k, std::uint32_t limit) {
    return track_.run(k, limit);
  };
  const std::uint64_t bends = track_.bends();
  const ChainVisits::Rings rings =
      visits_.around(track_.position(), track_.direction());
  const std::uint64_t ahead = (rings.two & 0x1f) | (rings.two >> 12) << 5;
  const std::uint64_t near = rings.one | ahead << 8;
  const std::uint64_t all = rings.one | std::uint64_t{rings.two} << 8 |
                            std::uint64_t{rings.three} << 24;
  const std::uint64_t verdict =
      dss_.verdict(four_ ? track_.direction() / 2 : track_.direction());
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
  slots_.ask(
      11, mix(track_.chord(16), mix(track_.bulge(16) << 9 | history(3), base)));
  slots_.ask(
      12, mix(track_.chord(32), mix(track_.bulge(32) << 9 | history(3), base)));
  slots_.ask(13, mix(level << 3 | guess, mix(history(2), base)));
  slots_.ask(14, way_home != 0 ? mix(way_home, mix(history(1), base + 8))
                               : mix(rows_below(), base));
  next_selectors_ = {
      std::min<std::size_t>(std::bit_width(track_.run(0, 255)), 7) * 8,
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
  track_.advance(turn);
  dss_.push(four_ ? track_.direction() / 2 : track_.direction());
  visits_.mark(track_.position());
}

}  // namespace unstep::codec
