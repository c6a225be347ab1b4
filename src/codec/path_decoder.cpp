#include <algorithm>
#include <string>
#include <utility>

#include "codec/block_coder.h"
#include "codec/path_scan.h"
#include "codec/stroke_coder.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {
namespace {

class DecoderSide {
 public:
  explicit DecoderSide(std::span<const std::uint8_t> payload)
      : coder_(payload) {}

  entropy::ArithmeticDecoder& coder() { return coder_; }
  [[nodiscard]] static PathFrame frame() { return {}; }
  [[nodiscard]] static PathHead head(std::uint64_t /*i*/) { return {}; }
  [[nodiscard]] static Path::Element element(std::uint64_t /*i*/,
                                             std::uint64_t /*k*/) {
    return {};
  }
  /// Elements are not reserved: their number is only a claim.
  void begin(const PathHead& head) {
    paths_.push_back({head.origin, head.closed, head.width, {}});
    turn_ = head.turn;
  }
  void push(const Path::Element& element) {
    paths_.back().elements.push_back(element);
  }
  /// Gives the path its own origin back.
  void end() {
    Path& path = paths_.back();
    const auto n = static_cast<std::int64_t>(path.elements.size());
    const std::int64_t first = turn_ < 0 ? n + turn_ : turn_;
    if (first == 0 || n == 0) return;
    for (std::int64_t i = 0; i < first; ++i) {
      const Path::Element& element = path.elements[static_cast<std::size_t>(i)];
      const bool arc = element.kind == Path::Kind::arc;
      path.origin.x += arc ? element.arc.end.x : element.segment.dx;
      path.origin.y += arc ? element.arc.end.y : element.segment.dy;
    }
    std::rotate(path.elements.begin(), path.elements.begin() + first,
                path.elements.end());
  }
  [[nodiscard]] bool damaged() const { return coder_.overrun(); }

  [[nodiscard]] std::vector<Path> take() { return std::move(paths_); }

 private:
  entropy::ArithmeticDecoder coder_;
  std::vector<Path> paths_;
  std::int64_t turn_ = 0;
};

}  // namespace

Result<std::vector<Path>> decode_paths(const CoderName& name,
                                       std::span<const std::uint8_t> payload,
                                       std::uint64_t count,
                                       std::uint64_t elements,
                                       const BlockProgress& progress) {
  if (name.coder == kCoderStrokes) {
    return decode_strokes(name, payload, count, elements, progress);
  }
  if (name != CoderName{kCoderPaths, kPathRevision, path_warm::kTableId}) {
    return unknown_coder("path", name);
  }
  DecoderSide side(payload);
  PathScan<DecoderSide> scan(side, count, elements);
  const Status status = scan.run(progress);
  if (!status) return status.error();
  if (!side.coder().finished()) {
    return Error{ErrorCode::corrupt, "path payload has unused bytes"};
  }
  return side.take();
}

}  // namespace unstep::codec
