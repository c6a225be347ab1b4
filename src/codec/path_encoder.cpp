#include <algorithm>

#include "codec/block_coder.h"
#include "codec/path_checksum.h"
#include "codec/path_scan.h"
#include "codec/stroke_coder.h"
#include "entropy/arithmetic_encoder.h"

namespace unstep::codec {
namespace {

/// A vertex by the number of elements before it.
struct Topmost {
  Point at;
  std::size_t index = 0;
};

/// Where a path is coded from.
Topmost topmost(const Path& path) {
  Topmost best{path.origin, 0};
  Point at = path.origin;
  for (std::size_t i = 0; path.closed && i + 1 < path.elements.size(); ++i) {
    const Path::Element& element = path.elements[i];
    const bool arc = element.kind == Path::Kind::arc;
    at.x += arc ? element.arc.end.x : element.segment.dx;
    at.y += arc ? element.arc.end.y : element.segment.dy;
    if (at.y < best.at.y || (at.y == best.at.y && at.x < best.at.x)) {
      best = {at, i + 1};
    }
  }
  return best;
}

bool have_pens(std::span<const Path> paths) {
  return std::any_of(paths.begin(), paths.end(),
                     [](const Path& path) { return path.width > 0; });
}

class EncoderSide {
 public:
  explicit EncoderSide(std::span<const Path> paths) : paths_(paths) {}

  entropy::ArithmeticEncoder& coder() { return coder_; }
  [[nodiscard]] PathFrame frame() const {
    PathFrame frame;
    for (const Path& path : paths_) {
      frame.starts.add(topmost(path).at.x);
      frame.arcs |=
          std::ranges::any_of(path.elements, [](const Path::Element& element) {
            return element.kind == Path::Kind::arc;
          });
    }
    return frame;
  }
  PathHead head(std::uint64_t i) {
    const Path& path = paths_[static_cast<std::size_t>(i)];
    const Topmost top = topmost(path);
    first_ = top.index;
    const std::size_t n = path.elements.size();
    const auto ahead = static_cast<std::int64_t>(n - first_);
    const auto back = static_cast<std::int64_t>(first_);
    return {top.at, path.closed, path.width, n,
            first_ == 0     ? 0
            : ahead <= back ? ahead
                            : -back};
  }
  [[nodiscard]] Path::Element element(std::uint64_t i, std::uint64_t k) const {
    const Path& path = paths_[static_cast<std::size_t>(i)];
    const std::size_t n = path.elements.size();
    const std::size_t at = first_ + static_cast<std::size_t>(k);
    return path.elements[at < n ? at : at - n];
  }
  void begin(const PathHead& /*head*/) {}
  void push(const Path::Element& /*element*/) {}
  void end() {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  std::span<const Path> paths_;
  std::size_t first_ = 0;  ///< element of the path that is coded first
  entropy::ArithmeticEncoder coder_;
};

}  // namespace

Result<EncodedBlock> encode_paths(std::span<const Path> paths,
                                  const BlockProgress& progress) {
  const Result<PathSurvey> survey = survey_paths(paths, {});
  if (!survey) return survey.error();
  EncoderSide side(paths);
  PathScan<EncoderSide> scan(side, paths.size(), survey->elements);
  const Status status = scan.run(progress);
  if (!status) return status.error();
  EncodedBlock block{{kCoderPaths, kPathRevision, path_warm::kTableId},
                     side.coder().finish()};
  if (!have_pens(paths)) return block;
  Result<EncodedBlock> strokes = encode_strokes(paths, progress);
  if (!strokes || strokes->payload.size() < block.payload.size()) {
    return strokes;
  }
  return block;
}

}  // namespace unstep::codec
