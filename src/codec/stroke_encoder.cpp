#include <algorithm>
#include <bit>
#include <memory>
#include <unordered_map>
#include <utility>

#include "codec/stroke_coder.h"
#include "codec/stroke_scan.h"
#include "codec/stroke_warm_start.h"
#include "codec/word_finder.h"
#include "entropy/arithmetic_encoder.h"

namespace unstep::codec {
namespace {

/// Words that follow the one before within so many units stand in its line.
constexpr std::int64_t kLineGap = 64;
constexpr std::int64_t kLineRise = 24;
/// A path alone is a word if it comes so often and all together have so many
/// elements. A dot is better told after what was drawn last.
constexpr std::uint32_t kOften = 3;
constexpr std::uint64_t kElements = 8;
constexpr int kMostUnitBits = 3;

class EncoderSide {
 public:
  explicit EncoderSide(std::span<const Path> paths) : paths_(paths) {
    find_frame();
    find_items();
  }

  entropy::ArithmeticEncoder& coder() { return coder_; }
  [[nodiscard]] const StrokeFrame& frame() const { return frame_; }
  const StrokeItem& item() { return items_[next_++]; }
  [[nodiscard]] const Path& path(std::uint64_t i) const {
    return paths_[static_cast<std::size_t>(i)];
  }
  void add(Path&& /*path*/) {}
  [[nodiscard]] static bool damaged() { return false; }

 private:
  void find_frame() {
    std::uint32_t bits = 0;
    const auto see = [&](std::int32_t v) {
      bits |= static_cast<std::uint32_t>(v);
      return v;
    };
    for (const Path& path : paths_) {
      for (const Path::Element& element : path.elements) {
        (void)changed(element, see);
        frame_.arcs |= element.kind == Path::Kind::arc;
      }
    }
    frame_.unit_bits = std::min(std::countr_zero(bits), kMostUnitBits);
  }

  void find_items() {
    const std::vector<PathGroup> groups = find_groups(paths_);
    const VertexBox page = box_of(paths_);
    // The layout of words is for places on a page.
    const bool words = page.left >= 0 && page.top >= 0;
    std::unordered_map<std::uint32_t, std::uint32_t> known;
    VertexBox before{0, 0, 0, 0};
    for (const PathGroup& group : groups) {
      const auto paths = paths_.subspan(static_cast<std::size_t>(group.first),
                                        static_cast<std::size_t>(group.count));
      const bool word = words && group.times > 1 &&
                        (group.count > 1 ||
                         (group.times >= kOften &&
                          group.times * paths[0].elements.size() >= kElements));
      if (!word) {
        items_.insert(items_.end(), static_cast<std::size_t>(group.count), {});
        continue;
      }
      StrokeItem item;
      item.count = group.count;
      item.word = true;
      const auto found = known.try_emplace(
          group.kind, static_cast<std::uint32_t>(known.size()));
      item.refers = !found.second;
      item.reference = found.first->second;
      const VertexBox box = box_of(paths);
      const std::int64_t unit = 1 << frame_.unit_bits;
      item.new_line = box.left < before.right - 2 * unit ||
                      box.left > before.right + kLineGap * unit ||
                      std::abs(box.bottom - before.bottom) > kLineRise * unit;
      before = box;
      items_.push_back(item);
    }
  }

  std::span<const Path> paths_;
  StrokeFrame frame_;
  std::vector<StrokeItem> items_;
  std::size_t next_ = 0;
  entropy::ArithmeticEncoder coder_;
};

}  // namespace

Result<EncodedBlock> encode_strokes(std::span<const Path> paths,
                                    stroke_warm::Table start,
                                    const BlockProgress& progress) {
  std::uint64_t elements = 0;
  for (const Path& path : paths) elements += path.elements.size();
  EncoderSide side(paths);
  const auto models = std::make_unique<StrokeModels>();
  if (!paths.empty()) stroke_warm::learn(start, *models);
  StrokeScan<EncoderSide> scan(side, *models, paths.size(), elements);
  const Status status = scan.run(progress);
  if (!status) return status.error();
  const std::uint8_t table =
      start.empty() ? stroke_warm::kNoTable : stroke_warm::kTableId;
  return EncodedBlock{{kCoderStrokes, kStrokeRevision, table},
                      side.coder().finish()};
}

Result<EncodedBlock> encode_strokes(std::span<const Path> paths,
                                    const BlockProgress& progress) {
  const bool large = paths.size() > stroke_warm::kLarge;
  return encode_strokes(
      paths, large ? stroke_warm::Table{} : stroke_warm::kTable, progress);
}

}  // namespace unstep::codec
