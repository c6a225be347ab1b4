#include <memory>
#include <utility>

#include "codec/path_checksum.h"
#include "codec/stroke_coder.h"
#include "codec/stroke_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {
namespace {

class DecoderSide {
 public:
  explicit DecoderSide(std::span<const std::uint8_t> payload)
      : coder_(payload) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  [[nodiscard]] static StrokeFrame frame() { return {}; }
  [[nodiscard]] static StrokeItem item() { return {}; }
  [[nodiscard]] const Path& path(std::uint64_t i) const {
    return i < paths_.size() ? paths_[static_cast<std::size_t>(i)] : unknown_;
  }
  void add(Path&& path) { paths_.push_back(std::move(path)); }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }

  [[nodiscard]] std::vector<Path> take() { return std::move(paths_); }

 private:
  entropy::ArithmeticDecoder coder_;
  std::vector<Path> paths_;
  Path unknown_;
};

}  // namespace

Result<std::vector<Path>> decode_strokes(std::span<const std::uint8_t> payload,
                                         std::uint64_t count,
                                         std::uint64_t elements,
                                         const BlockProgress& progress) {
  DecoderSide side(payload);
  const auto scan = std::make_unique<StrokeScan<DecoderSide>>();
  const Status status = scan->run(side, count, elements, progress);
  if (!status) return status.error();
  if (!side.coder().finished()) {
    return Error{ErrorCode::corrupt, "path payload has unused bytes"};
  }
  std::vector<Path> paths = side.take();
  if (const auto valid = survey_paths(paths, {}); !valid) {
    return Error{ErrorCode::corrupt, valid.error().message};
  }
  return paths;
}

}  // namespace unstep::codec
