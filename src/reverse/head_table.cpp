#include "reverse/fast_recogniser.h"

namespace unstep::reverse {
namespace {

constexpr HeadState head_of(const SegmentState& state) {
  const auto byte = [](std::uint32_t v) {
    return static_cast<std::uint8_t>(v);
  };
  return {byte(state.a),           byte(state.w),
          byte(state.upper.index), byte(state.upper.ones),
          byte(state.lower.index), byte(state.lower.ones)};
}

/// Every word through the reference. Words that begin with 1 do not occur.
constexpr HeadTable make_heads() {
  HeadTable table{};
  for (std::uint32_t word = 0; word < 1U << kHeadLetters; word += 2) {
    SegmentRecogniser recogniser(Connectivity::eight);
    std::uint32_t n = 0;
    while (n < kHeadLetters) {
      const std::uint32_t letter = word >> n & 1;
      if (!recogniser.push(static_cast<Step>(letter))) break;
      ++n;
      table.state[(1U << n) | (word & ((1U << n) - 1))] =
          head_of(recogniser.state());
    }
    table.length[word] = static_cast<std::uint8_t>(n);
  }
  return table;
}

}  // namespace

constinit const HeadTable kHeads = make_heads();

}  // namespace unstep::reverse
