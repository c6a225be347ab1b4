#include <memory>
#include <utility>

#include "codec/path_checksum.h"
#include "codec/stroke_coder.h"
#include "codec/stroke_decoder_side.h"
#include "codec/stroke_warm_start.h"

namespace unstep::codec {
Result<std::vector<Path>> decode_strokes(const CoderName& name,
                                         std::span<const std::uint8_t> payload,
                                         std::uint64_t count,
                                         std::uint64_t elements,
                                         const BlockProgress& progress) {
  const bool warm = name.table == stroke_warm::kTableId;
  if (name.revision != kStrokeRevision ||
      (!warm && name.table != stroke_warm::kNoTable)) {
    return unknown_coder("path", name);
  }
  StrokeDecoderSide side(payload);
  const auto models = std::make_unique<StrokeModels>();
  if (count > 0 && warm) stroke_warm::learn(stroke_warm::kTable, *models);
  StrokeScan<StrokeDecoderSide> scan(side, *models, count, elements);
  const Status status = scan.run(progress);
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
