#include <algorithm>
#include <string_view>

#include "codec/block_coder.h"
#include "codec/program_scan.h"
#include "entropy/arithmetic_encoder.h"

namespace unstep::codec {
namespace {

class EncoderSide {
 public:
  explicit EncoderSide(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      lines_.push_back(text.substr(0, end));
      text.remove_prefix(end + 1);
    }
    for (const std::string_view line : lines_) {
      const std::optional<ProgramLine> motion = parse_line(line);
      if (!motion) continue;
      frame_.words |= motion->words;
      for (std::size_t word = 0; word < kProgramWords; ++word) {
        int& decimals = frame_.decimals[program_group(word)];
        decimals = std::max(decimals, decimals_of(motion->value[word]));
      }
    }
  }

  [[nodiscard]] std::uint64_t count() const { return lines_.size(); }
  entropy::ArithmeticEncoder& coder() { return coder_; }
  [[nodiscard]] ProgramFrame frame() const { return frame_; }
  bool is_motion(std::uint64_t i) {
    motion_ = parse_line(lines_[static_cast<std::size_t>(i)]);
    return motion_.has_value();
  }
  [[nodiscard]] ProgramLine motion(std::uint64_t /*i*/) const {
    return *motion_;
  }
  [[nodiscard]] std::string_view text(std::uint64_t i) const {
    return lines_[static_cast<std::size_t>(i)];
  }
  void push(const std::string& /*line*/) {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  std::vector<std::string_view> lines_;
  std::optional<ProgramLine> motion_;  ///< of the line asked for last
  ProgramFrame frame_;
  entropy::ArithmeticEncoder coder_;
};

}  // namespace

Result<EncodedBlock> encode_program(std::string_view text,
                                    const BlockProgress& progress) {
  if (!text.empty() && text.back() != '\n') {
    return Error{ErrorCode::invalid_argument,
                 "a program whose last line does not end"};
  }
  EncoderSide side(text);
  ProgramScan<EncoderSide> scan(side, side.count(), text.size());
  const Status status = scan.run(progress);
  if (!status) return status.error();
  return EncodedBlock{{kCoderProgram, kProgramRevision, 0},
                      side.coder().finish()};
}

}  // namespace unstep::codec
