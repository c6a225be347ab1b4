#include "codec/block_coder.h"
#include "codec/chain_scan.h"
#include "codec/checksum.h"
#include "entropy/arithmetic_encoder.h"

namespace unstep::codec {
namespace {

class EncoderSide {
 public:
  EncoderSide(std::span<const Chain> chains, YAxis axis)
      : chains_(chains), axis_(axis) {}

  entropy::ArithmeticEncoder& coder() { return coder_; }
  [[nodiscard]] StartFrame frame() const {
    StartFrame frame;
    for (const Chain& chain : chains_) frame.add(chain.origin.x);
    return frame;
  }
  [[nodiscard]] ChainHead head(std::uint64_t i) const {
    const Chain& chain = chains_[static_cast<std::size_t>(i)];
    const std::int32_t y = chain.origin.y;
    return {{chain.origin.x, axis_ == YAxis::up ? y : -y},
            chain.connectivity,
            chain.closed,
            chain.steps.size()};
  }
  [[nodiscard]] Step step(std::uint64_t i, std::uint64_t k) const {
    return chains_[static_cast<std::size_t>(i)]
        .steps[static_cast<std::size_t>(k)];
  }
  void begin(const ChainHead& /*head*/) {}
  void push(Step /*step*/) {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  std::span<const Chain> chains_;
  YAxis axis_;
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
