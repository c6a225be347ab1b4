#include <string>

#include "codec/block_coder.h"
#include "codec/program_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {
namespace {

class DecoderSide {
 public:
  explicit DecoderSide(std::span<const std::uint8_t> payload)
      : coder_(payload) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  [[nodiscard]] static ProgramFrame frame() { return {}; }
  [[nodiscard]] static bool is_motion(std::uint64_t /*i*/) { return false; }
  [[nodiscard]] static ProgramLine motion(std::uint64_t /*i*/) { return {}; }
  [[nodiscard]] static std::string_view text(std::uint64_t /*i*/) { return {}; }
  /// The text is not reserved: its size is only a claim.
  void push(const std::string& line) {
    text_ += line;
    text_ += '\n';
  }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  entropy::ArithmeticDecoder coder_;
  std::string text_;
};

}  // namespace

Result<std::string> decode_program(const CoderName& name,
                                   std::span<const std::uint8_t> payload,
                                   std::uint64_t lines, std::uint64_t bytes,
                                   const BlockProgress& progress) {
  if (name != CoderName{kCoderProgram, kProgramRevision, 0}) {
    return unknown_coder("program", name);
  }
  DecoderSide side(payload);
  ProgramScan<DecoderSide> scan(side, lines, bytes);
  const Status status = scan.run(progress);
  if (!status) return status.error();
  if (!side.coder().finished()) {
    return Error{ErrorCode::corrupt, "program payload has unused bytes"};
  }
  return side.take();
}

}  // namespace unstep::codec
