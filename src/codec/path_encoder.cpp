#include <algorithm>

#include "codec/block_coder.h"
#include "codec/path_checksum.h"
#include "codec/path_scan.h"
#include "entropy/arithmetic_encoder.h"

namespace unstep::codec {
namespace {

class EncoderSide {
 public:
  explicit EncoderSide(std::span<const Path> paths) : paths_(paths) {}

  entropy::ArithmeticEncoder& coder() { return coder_; }
  [[nodiscard]] PathFrame frame() const {
    PathFrame frame;
    for (const Path& path : paths_) {
      frame.starts.add(path.origin.x);
      frame.arcs |=
          std::ranges::any_of(path.elements, [](const Path::Element& element) {
            return element.kind == Path::Kind::arc;
          });
    }
    return frame;
  }
  [[nodiscard]] PathHead head(std::uint64_t i) const {
    const Path& path = paths_[static_cast<std::size_t>(i)];
    return {path.origin, path.closed, path.width, path.elements.size()};
  }
  [[nodiscard]] Path::Element element(std::uint64_t i, std::uint64_t k) const {
    return paths_[static_cast<std::size_t>(i)]
        .elements[static_cast<std::size_t>(k)];
  }
  void begin(const PathHead& /*head*/) {}
  void push(const Path::Element& /*element*/) {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  std::span<const Path> paths_;
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
  return EncodedBlock{{kCoderPaths, kPathRevision, 0}, side.coder().finish()};
}

}  // namespace unstep::codec
