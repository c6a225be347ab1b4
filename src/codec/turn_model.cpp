#include "codec/turn_model.h"

#include <algorithm>
#include <cstdlib>

#include "codec/context.h"
#include "codec/patch.h"
#include "codec/warm_start.h"

namespace unstep::codec {
namespace {

constexpr unsigned kSight = 12;  ///< how far look() sees, in points

/// How many fewer bits of slots the contexts with few values get.
constexpr std::array<int, TurnModel::kContexts> kFewer{3, 1, 0, 0, 0, 0, 0, 0,
                                                       0, 3, 0, 0, 0, 2, 1};

}  // namespace

std::uint64_t TurnModel::memory(int table_bits) {
  std::uint64_t bytes = (std::uint64_t{1} << 20);  // gates, match, weights
  for (const int fewer : kFewer) {
    bytes += sizeof(Slot) << (table_bits - fewer);
  }
  return bytes;
}

TurnModel::TurnModel(const CrackMap& cracks, int table_bits)
    : cracks_(cracks),
      gates_(std::size_t{1} << kGateBits),
      mixer_({64, 1024, 1024}, warm::kTurnWeights) {
  static_assert(kContexts == warm::kTurnContexts);
  std::size_t size = 0;
  for (std::size_t i = 0; i < kContexts; ++i) {
    bits_[i] = table_bits - kFewer[i];
    first_[i] = size;
    size += std::size_t{1} << bits_[i];
  }
  slots_.resize(size, Slot{{32768, 32768}, {0, 0}, 0});
  for (std::size_t i = 0; i < kContexts; ++i) {
    warm::for_each(i, [&](const warm::Record& record) {
      slots_[first_[i] + (record.index >> (kMaxTableBits - bits_[i]))] = {
          record.p, record.n, record.check};
    });
  }
}

void TurnModel::begin(CrackMap::Address point, bool ink) {
  direction_ = 0;
  point_ = point + cracks_.step(0);
  ink_ = ink;
  history_ = 0;
  runs_ = {};
  turns_ = {};
  steps_ = 1;
  here_ = {1, 0, 0};
  trail_[0] = {0, 0, 0};
  trail_[1] = here_;
  dss_.reset();
  dss_.push(0);
}

void TurnModel::advance(Turn turn) {
  match_.push(turn);
  history_ = history_ << 2 | turn;
  if (turn == kStraight) {
    ++runs_[0];
  } else {
    runs_ = {0, runs_[0], runs_[1], runs_[2]};
    turns_ = {turn, turns_[0], turns_[1]};
  }
  direction_ = turned(direction_, turn);
  dss_.push(direction_);
  const auto d = static_cast<std::size_t>(direction_);
  here_.area += std::int64_t{here_.y} * kQuarterDx[d] -
                std::int64_t{here_.x} * kQuarterDy[d];
  here_.x += kQuarterDx[d];
  here_.y += kQuarterDy[d];
  point_ += cracks_.step(direction_);
  ++steps_;
  trail_[steps_ % trail_.size()] = here_;
}

TurnModel::Sight TurnModel::look(int side) const {
  const CrackMap::Address out = cracks_.step((direction_ + side) & 3);
  const CrackMap::Address on = cracks_.crack(direction_);
  CrackMap::Address p = point_ - cracks_.step(direction_) + on;
  for (unsigned distance = 1; distance <= kSight; ++distance) {
    p += out;
    if (cracks_.test(p) != 0) return {distance, shape(p - on)};
  }
  return {};
}

unsigned TurnModel::shape(CrackMap::Address point) const {
  const CrackMap::Address on = cracks_.crack(direction_);
  const CrackMap::Address right = cracks_.crack((direction_ + 1) & 3);
  const CrackMap::Address left = cracks_.crack((direction_ + 3) & 3);
  unsigned bits = 0;
  for (int i = 0; i < 2; ++i) {
    point += cracks_.step(direction_);
    bits = bits << 3 | cracks_.test(point + on) << 2 |
           cracks_.test(point + right) << 1 | cracks_.test(point + left);
  }
  return bits;
}

void TurnModel::set_context(std::size_t i, std::uint64_t value) {
  const std::uint64_t hash = (value + i) * kGolden;
  Slot* slot = &slots_[first_[i] + (hash >> (64 - bits_[i]))];
  __builtin_prefetch(slot, 1);
  next_[i] = slot;
  checks_[i] = static_cast<std::uint16_t>(hash >> 8 & 0xfff);
}

entropy::Counter& TurnModel::find_gate() {
  around_ = patch::at(cracks_, point_, direction_);
  const std::uint64_t recent = history_ & 0xffffff;  // 12 turns
  const std::uint64_t hash = mix(around_ & patch::kNear, recent) * kGolden;
  return gates_[hash >> (64 - kGateBits)];
}

void TurnModel::look_around() {
  const auto known = [&](unsigned place) {
    return static_cast<unsigned>(around_ >> place) & 1U;
  };
  const unsigned at_point = known(patch::along(0, 0)) |
                            known(patch::across(0, 0)) << 1 |
                            known(patch::across(0, -1)) << 2;
  const std::uint64_t base = at_point << 1 | (ink_ ? 1U : 0U);
  const auto history = [&](unsigned turns) {
    return history_ & ((std::uint64_t{1} << (2 * turns)) - 1);
  };
  // The last n steps as a chord, in the frame of the current direction.
  const auto trail = [&](std::uint32_t n) -> const Trail& {
    return trail_[(steps_ - n) % trail_.size()];
  };
  const auto chord = [&](std::uint32_t n) -> std::uint64_t {
    if (steps_ < n) return 0;
    std::int64_t dx = here_.x - trail(n).x;
    std::int64_t dy = here_.y - trail(n).y;
    for (Quarter q = 0; q < direction_; ++q) {
      const std::int64_t t = dx;
      dx = dy;
      dy = -t;
    }
    return static_cast<std::uint64_t>((dx + 128) << 9 | (dy + 128));
  };
  // Doubled area between the last n steps and their chord (patent's F).
  const auto bulge = [&](std::uint32_t n) -> unsigned {
    if (steps_ < n) return 0;
    const Trail& t = trail(n);
    const std::int64_t dx = here_.x - t.x;
    const std::int64_t dy = here_.y - t.y;
    return quantise_area(here_.area - t.area -
                         (std::int64_t{t.y} * dx - std::int64_t{t.x} * dy));
  };
  const auto run = [&](std::size_t k, std::uint32_t limit) {
    return std::uint64_t{std::min(runs_[k], limit)};
  };
  const Sight right = look(1);
  const Sight left = look(3);
  const std::uint64_t bends = std::uint64_t{turns_[0]} |
                              std::uint64_t{turns_[1]} << 2 |
                              std::uint64_t{turns_[2]} << 4;

  const std::uint64_t verdict = dss_.verdict(direction_);
  const unsigned level = match_.confidence();
  const unsigned guess = level > 0 ? match_.prediction() : 3;
  set_context(0, mix(history(6), base));
  set_context(1, mix(history(12), base));
  set_context(2, mix(history(18), base));
  set_context(3, mix(run(0, 255) << 8 | run(1, 255), mix(bends & 15, base)));
  set_context(4, mix(around_ & patch::kNear, mix(history(4), base)));
  set_context(5, mix(around_ & patch::kAll, mix(history(1), base)));
  set_context(6, mix(right.distance << 6 | right.shape, mix(history(4), base)));
  set_context(7, mix(left.distance << 6 | left.shape,
                     mix(chord(16) << 6 | history(3), base)));
  set_context(8,
              mix(right.distance << 6 | right.shape,
                  mix(left.distance << 6 | left.shape, mix(history(3), base))));
  set_context(9, mix(level << 2 | guess, mix(history(2), base)));
  set_context(10, mix((run(0, 127) << 7 | run(1, 127)) << 7 | run(2, 127),
                      mix(run(3, 127), base)));
  set_context(11, mix(chord(32), mix(history(4) << 5 | bulge(32), base)));
  set_context(12, mix(chord(64) * 4096 + chord(8), mix(bulge(64), base)));
  set_context(13, mix(verdict, mix(history(4), base)));
  set_context(
      14, mix(verdict << 8 | dss_.previous_length(), mix(history(2), base)));
  next_selectors_ = {
      std::min(right.distance, 7U) * 2 + (left.distance > 0 ? 16U : 0U),
      static_cast<std::size_t>(history(4)) * 2,
      (level * 4 + guess) * 2 + at_point * 64};
}

void TurnModel::learn() {
  for (const Node node : {kBends, kToRight}) {
    if (pending_[node] == Pending::none) continue;
    const bool bit = pending_[node] == Pending::one;
    pending_[node] = Pending::none;
    mixer_.update(bit, node);
    Counters& counters = counters_[node];
    entropy::move_all(counters.p, counters.rate, bit);
    for (std::size_t i = 0; i < kContexts; ++i) {
      Slot& slot = *active_[i];
      slot.p[node] = counters.p[i];
      slot.n[node] = static_cast<std::uint8_t>(
          slot.n[node] + (slot.n[node] != entropy::Counter::kLimit ? 1 : 0));
    }
  }
}

void TurnModel::recall() {
  active_ = next_;
  selectors_ = next_selectors_;
  for (std::size_t i = 0; i < kContexts; ++i) {
    Slot& slot = *active_[i];
    if (slot.check != checks_[i]) slot = {{32768, 32768}, {0, 0}, checks_[i]};
  }
}

int TurnModel::probability(Node node) {
  Counters& counters = counters_[node];
  auto& inputs = mixer_.inputs(node);
  alignas(16) std::array<std::int16_t, 16> trust{};
  for (std::size_t i = 0; i < kContexts; ++i) {
    const Slot& slot = *active_[i];
    counters.p[i] = slot.p[node];
    counters.rate[i] = entropy::detail::kRates[slot.n[node]];
    trust[i] = kTrust[slot.n[node]];
    inputs[i] = static_cast<std::int16_t>(entropy::stretch(slot.p[node]));
  }
  inputs[kContexts] = 77;
  entropy::lean_all(counters.p, trust, inputs.data() + 16);
  const int x = mixer_.mix(
      {selectors_[0] + node, selectors_[1] + node, selectors_[2] + node}, node);
  return std::clamp(entropy::squash(x), 1, 65535);
}

}  // namespace unstep::codec
