#include "codec/program_history.h"

#include <algorithm>

#include "codec/context.h"

namespace unstep::codec {
namespace {

std::uint64_t word(std::int64_t value) {
  return static_cast<std::uint64_t>(value);
}

std::uint64_t vector_hash(const ProgramMotion& a, const ProgramMotion& b) {
  std::uint64_t hash = mix(a.words, b.words);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    hash = mix(hash, word(a.delta(axis)));
    hash = mix(hash, word(b.delta(axis)));
  }
  return hash;
}

std::uint64_t place_hash(
    const std::array<std::int64_t, kProgramAxisWords>& at) {
  return mix(word(at[0]), word(at[1]));
}

std::size_t slot(std::uint64_t hash, int bits) {
  return static_cast<std::size_t>(hash * kGolden >> (64 - bits));
}

}  // namespace

ProgramHistory::ProgramHistory() {
  vectors_.heads.resize(std::size_t{1} << kHeadBits);
  places_.heads.resize(std::size_t{1} << kHeadBits);
  visits_.resize(std::size_t{1} << kHeadBits);
}

ProgramGuess ProgramHistory::guess(const Match& match) const {
  if (match.length == 0) return {};
  return {&motion(match.at), match.length};
}

const ProgramMotion* ProgramHistory::left_here() const {
  return visit_ > 0 && remembers(visit_) ? &motion(visit_) : nullptr;
}

const ProgramMotion* ProgramHistory::led_here() const {
  return visit_ > 0 && remembers(visit_ - 1) ? &motion(visit_ - 1) : nullptr;
}

void ProgramHistory::follow(Match& match, bool foretold, std::uint64_t hash) {
  if (match.length > 0) {
    match.length = foretold ? std::min(match.length + 1, 1000U) : 0;
    ++match.at;
    if (!remembers(match.at)) match.length = 0;
  }
  std::uint64_t& head = match.heads[slot(hash, kHeadBits)];
  if (match.length == 0 && head > 0 && remembers(head)) {
    match.at = head;
    match.length = 1;
  }
  head = end_;
}

void ProgramHistory::push(const ProgramMotion& motion) {
  const ProgramMotion last = before(1);
  const ProgramGuess vectors = by_vectors();
  const ProgramGuess places = by_places();
  const bool same_vector = vectors.next != nullptr &&
                           vectors.next->delta(0) == motion.delta(0) &&
                           vectors.next->delta(1) == motion.delta(1) &&
                           vectors.next->delta(2) == motion.delta(2);
  const bool same_place = places.next != nullptr &&
                          places.next->to[0] == motion.to[0] &&
                          places.next->to[1] == motion.to[1];
  if (end_ < kSize) {
    motions_.push_back(motion);
  } else {
    motions_[static_cast<std::size_t>(end_ % kSize)] = motion;
  }
  ++end_;
  at_ = motion.to;
  if (motion.motion == 0) home_ = motion.to;
  follow(vectors_, same_vector, vector_hash(last, motion));
  follow(places_, same_place,
         mix(place_hash(motion.from), place_hash(motion.to)));
  std::uint64_t& visit = visits_[slot(place_hash(motion.to), kHeadBits)];
  visit_ = visit;
  const ProgramMotion* led = led_here();
  if (led == nullptr || led->to[0] != motion.to[0] ||
      led->to[1] != motion.to[1]) {
    visit_ = 0;
  }
  visit = end_;
}

}  // namespace unstep::codec
