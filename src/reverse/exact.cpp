#include <algorithm>
#include <new>
#include <string>

#include "reverse/fast_recogniser.h"
#include "reverse/segment_recogniser.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

using reverse::FastRecogniser;
using reverse::fits;
using reverse::SegmentRecogniser;

/// The streaming form is the reference itself and the connectivity.
struct State {
  explicit State(Connectivity of) : connectivity(of), open(of) {}
  Connectivity connectivity;
  SegmentRecogniser open;
};

template <std::size_t size>
State& state_in(std::array<std::byte, size>& bytes) {
  static_assert(sizeof(State) <= size);
  return *std::launder(reinterpret_cast<State*>(bytes.data()));
}

template <std::size_t size>
const State& state_in(const std::array<std::byte, size>& bytes) {
  return *std::launder(reinterpret_cast<const State*>(bytes.data()));
}

/// Nothing, or the step that is no code of the connectivity.
Status check_steps(const Chain& chain) {
  const bool four = chain.connectivity == Connectivity::four;
  const std::uint64_t forbidden =
      std::uint64_t{0x0101010101010101} * (four ? 0xF9 : 0xF8);
  const std::vector<Step>& steps = chain.steps;
  std::size_t i = 0;
  while (steps.size() - i >= 8 &&
         (reverse::load_letters(steps.data() + i) & forbidden) == 0)
    i += 8;
  while (i < steps.size() && fits(steps[i], chain.connectivity)) ++i;
  if (i == steps.size()) return {};
  return Error{ErrorCode::invalid_argument,
               "step " + std::to_string(i) + " has code " +
                   std::to_string(steps[i]) +
                   (four ? ", not 0, 2, 4 or 6" : ", not 0 to 7")};
}

/// Greedy segmentation that goes round a closed chain, past its last step.
class Walk {
 public:
  explicit Walk(const Chain& chain)
      : connectivity_(chain.connectivity),
        steps_(chain.steps),
        fast_(chain.connectivity) {}

  /// The longest segment of at most `most` steps from step `at`, past the last
  /// step to the first. REQUIRES: at < size(), 1 <= most.
  [[nodiscard]] DigitalSegment segment(std::size_t at, std::size_t most) const {
    const std::size_t left = steps_.size() - at;
    const reverse::SegmentState state =
        fast_.longest(steps_.subspan(at, std::min(most, left)));
    if (most <= left || state.n < left) return state.segment();
    SegmentRecogniser recogniser(connectivity_);
    std::size_t next = at;
    for (std::size_t n = 0; n < most && recogniser.push(steps_[next]); ++n)
      if (++next == steps_.size()) next = 0;
    return recogniser.state().segment();
  }

  [[nodiscard]] std::size_t size() const { return steps_.size(); }

 private:
  Connectivity connectivity_;
  std::span<const Step> steps_;
  FastRecogniser fast_;
};

std::vector<DigitalSegment> open_segments(const Walk& walk) {
  std::vector<DigitalSegment> segments;
  for (std::size_t at = 0; at < walk.size(); at += segments.back().n)
    segments.push_back(walk.segment(at, walk.size() - at));
  return segments;
}

/// Where to cut the laps of a closed chain: segments from..to of a walk.
struct Cut {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// The fewest segments that cover a lap, of all starts in the walk. `starts`
/// has the start of every segment and the end of the last.
Cut fewest(const std::vector<std::size_t>& starts, std::size_t lap) {
  Cut best{0, starts.size()};
  std::size_t to = 0;
  for (std::size_t from = 0; from < starts.size(); ++from) {
    while (to < starts.size() && starts[to] - starts[from] < lap) ++to;
    if (to == starts.size()) break;
    if (to - from < best.to - best.from) best = {from, to};
  }
  return best;
}

/// Goes round until a segment starts where one of the lap before started:
/// from there on all laps are alike, and no start gives fewer segments than
/// the laps of a repeating walk (docs/algorithms.md). Rarely a walk repeats
/// only after many laps; then the best start of the first kLaps is at most one
/// segment above the least.
DigitalSegments closed_segments(const Walk& walk) {
  constexpr std::size_t kLaps = 8;
  const std::size_t lap = walk.size();
  std::vector<DigitalSegment> segments;
  std::vector<std::size_t> starts{0};
  std::size_t before = 0;  // the first start not a lap behind
  bool repeats = false;
  while (!repeats && starts.back() < kLaps * lap) {
    segments.push_back(walk.segment(starts.back() % lap, lap));
    starts.push_back(starts.back() + segments.back().n);
    while (starts.back() - starts[before] > lap) ++before;
    repeats = starts.back() - starts[before] == lap;
  }
  const Cut cut =
      repeats ? Cut{before, starts.size() - 1} : fewest(starts, lap);

  DigitalSegments result;
  result.start = starts[cut.from] % lap;
  const auto at = [&](std::size_t i) {
    return segments.begin() + static_cast<std::ptrdiff_t>(i);
  };
  result.segments.assign(at(cut.from), at(cut.to));
  // The last segment may reach into the first.
  const std::size_t last = starts[cut.to - 1];
  const std::size_t room = starts[cut.from] + lap - last;
  if (room < result.segments.back().n)
    result.segments.back() = walk.segment(last % lap, room);
  return result;
}

}  // namespace

ExactReverse::ExactReverse(Connectivity connectivity) {
  new (state_.data()) State(connectivity);
}

Pushed ExactReverse::push(Step step, DigitalSegment& closed) {
  State& state = state_in(state_);
  if (!fits(step, state.connectivity)) return Pushed::refused;
  if (state.open.push(step)) return Pushed::open;
  closed = state.open.state().segment();
  state.open = SegmentRecogniser(state.connectivity);
  state.open.push(step);
  return Pushed::segment;
}

DigitalSegment ExactReverse::open() const {
  return state_in(state_).open.state().segment();
}

bool ExactReverse::finish(DigitalSegment& closed) {
  State& state = state_in(state_);
  if (state.open.state().n == 0) return false;
  closed = state.open.state().segment();
  state.open = SegmentRecogniser(state.connectivity);
  return true;
}

Result<DigitalSegments> reverse_exact(const Chain& chain) {
  const Status checked = check_steps(chain);
  if (!checked) return checked.error();
  const Walk walk(chain);
  if (!chain.closed || chain.steps.empty())
    return DigitalSegments{0, open_segments(walk)};
  return closed_segments(walk);
}

}  // namespace unstep
