#include <string>
#include <utility>

#include "codec/block_coder.h"
#include "codec/chain_scan.h"
#include "entropy/arithmetic_decoder.h"
#include "unstep/interpolate.h"

namespace unstep::codec {
namespace {

class DecoderSide {
 public:
  DecoderSide(std::span<const std::uint8_t> payload, YAxis axis)
      : coder_(payload), axis_(axis) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  [[nodiscard]] static StartFrame frame() { return {}; }
  [[nodiscard]] static ChainHead head(std::uint64_t /*i*/) { return {}; }
  [[nodiscard]] static Step step(std::uint64_t /*i*/, std::uint64_t /*k*/) {
    return 0;
  }
  /// Steps are not reserved: their number is only a claim.
  void begin(const ChainHead& head) {
    const std::int32_t y = head.origin.y;
    chains_.push_back({{head.origin.x, axis_ == YAxis::up ? y : -y},
                       head.connectivity,
                       head.closed,
                       {}});
  }
  [[nodiscard]] static std::span<const DigitalSegment> segments(
      std::uint64_t /*i*/) {
    return {};
  }
  void push(Step step) { chains_.back().steps.push_back(step); }
  /// The model holds what interpolate() asks for.
  void push_segment(const DigitalSegment& segment) {
    std::vector<Step>& steps = chains_.back().steps;
    const std::size_t before = steps.size();
    steps.resize(before + segment.n);
    (void)interpolate({&segment, 1}, std::span(steps).subspan(before));
  }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }

  [[nodiscard]] std::vector<Chain> take() { return std::move(chains_); }

 private:
  entropy::ArithmeticDecoder coder_;
  YAxis axis_;
  std::vector<Chain> chains_;
};

}  // namespace

Result<std::vector<Chain>> decode_chains(const CoderName& name,
                                         std::span<const std::uint8_t> payload,
                                         std::uint64_t count,
                                         std::uint64_t steps, YAxis axis,
                                         const BlockProgress& progress) {
  if (name != CoderName{kCoderChains, kChainRevision, 0}) {
    return unknown_coder("chain", name);
  }
  DecoderSide side(payload, axis);
  ChainScan<DecoderSide> scan(side, count, steps);
  const Status status = scan.run(progress);
  if (!status) return status.error();
  if (!side.coder().finished()) {
    return Error{ErrorCode::corrupt, "chain payload has unused bytes"};
  }
  return side.take();
}

}  // namespace unstep::codec
