#include <algorithm>

#include "codec/block_coder.h"
#include "codec/chain_scan.h"
#include "codec/checksum.h"
#include "entropy/arithmetic_encoder.h"
#include "unstep/reverse.h"

namespace unstep::codec {
namespace {

using Segments = std::vector<DigitalSegment>;

/// Shorter chains, and shorter segments, are not worth the trial: eight bytes
/// of parameters against contexts that know straight lines.
constexpr std::size_t kFewSteps = 1024;
constexpr std::size_t kShortSegment = 128;

ChainHead head_of(const Chain& chain, YAxis axis) {
  const std::int32_t y = chain.origin.y;
  return {{chain.origin.x, axis == YAxis::up ? y : -y},
          chain.connectivity,
          chain.closed,
          chain.steps.size()};
}

/// The segments of a chain if they are long, else none.
Segments long_segments(const Chain& chain) {
  Segments segments;
  if (chain.steps.size() < kFewSteps) return segments;
  ExactReverse exact(chain.connectivity);
  DigitalSegment segment;
  for (std::size_t k = 0; k < chain.steps.size(); ++k) {
    if (exact.push(chain.steps[k], segment) == Pushed::segment) {
      segments.push_back(segment);
      // Given up at once where segments are short.
      if (segments.size() * kShortSegment > k + 16 * kShortSegment) return {};
    }
  }
  if (exact.finish(segment)) segments.push_back(segment);
  if (segments.size() * kShortSegment > chain.steps.size()) segments.clear();
  return segments;
}

/// Measures what a chain costs either way, apart from the others, with models
/// that go on from chain to chain.
class Trial {
 public:
  /// The segments if they are cheaper than the steps, else none.
  Segments choose(const Chain& chain, YAxis axis) {
    Segments segments = long_segments(chain);
    if (segments.empty()) return segments;
    entropy::ArithmeticEncoder by_segments;
    Step last = 0;
    for (const DigitalSegment& segment : segments) {
      segments_.code(by_segments, segment, last,
                     chain.connectivity == Connectivity::four);
      last = last_step(segment);
    }
    const std::size_t bytes = by_segments.finish().size();
    entropy::ArithmeticEncoder by_steps;
    steps_.begin(head_of(chain, axis));
    for (Step step : chain.steps) {
      steps_.code(by_steps, step);
      if (by_steps.size() > bytes) return segments;
    }
    return {};
  }

 private:
  SegmentModel segments_;
  ChainModel steps_{ChainHeadModel::table_bits(0)};
};

class EncoderSide {
 public:
  EncoderSide(std::span<const Chain> chains, YAxis axis)
      : chains_(chains), axis_(axis), segments_(chains.size()) {
    const auto is_long = [](const Chain& chain) {
      return chain.steps.size() >= kFewSteps;
    };
    if (std::ranges::none_of(chains, is_long)) return;
    Trial trial;
    for (std::size_t i = 0; i < chains.size(); ++i) {
      segments_[i] = trial.choose(chains[i], axis);
    }
  }

  entropy::ArithmeticEncoder& coder() { return coder_; }
  [[nodiscard]] StartFrame frame() const {
    StartFrame frame;
    for (const Chain& chain : chains_) frame.add(chain.origin.x);
    return frame;
  }
  [[nodiscard]] ChainHead head(std::uint64_t i) const {
    return head_of(chains_[static_cast<std::size_t>(i)], axis_);
  }
  [[nodiscard]] Step step(std::uint64_t i, std::uint64_t k) const {
    return chains_[static_cast<std::size_t>(i)]
        .steps[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] std::span<const DigitalSegment> segments(
      std::uint64_t i) const {
    return segments_[static_cast<std::size_t>(i)];
  }
  void begin(const ChainHead& /*head*/) {}
  void push(Step /*step*/) {}
  void push_segment(const DigitalSegment& /*segment*/) {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  std::span<const Chain> chains_;
  YAxis axis_;
  std::vector<Segments> segments_;
  entropy::ArithmeticEncoder coder_;
};

}  // namespace

Result<EncodedBlock> encode_chains(std::span<const Chain> chains, YAxis axis,
                                   const BlockProgress& progress) {
  const Result<ChainSurvey> survey = survey_chains(chains, axis);
  if (!survey) return survey.error();
  EncoderSide side(chains, axis);
  ChainScan<EncoderSide> scan(side, chains.size(), survey->steps);
  const Status status = scan.run(progress);
  if (!status) return status.error();
  return EncodedBlock{{kCoderChains, kChainRevision, 0}, side.coder().finish()};
}

}  // namespace unstep::codec
