#include <cstddef>
#include <string>
#include <utility>

#include "formats/raster_sink.h"

namespace unstep {
namespace {

/// Raw PBM (P4); pages follow each other without anything between, as pbm(5)
/// allows.
class PbmSink final : public RasterSink {
 public:
  Status add_page(const Bitmap& ink, const PageInfo& info,
                  std::vector<std::string>& notes) override {
    const std::string header = "P4\n" + std::to_string(ink.width()) + " " +
                               std::to_string(ink.height()) + "\n";
    const std::size_t row = (static_cast<std::size_t>(ink.width()) + 7) / 8;
    const std::size_t size = row * static_cast<std::size_t>(ink.height());
    if (bytes_.empty()) bytes_.reserve(header.size() + size);
    bytes_.insert(bytes_.end(), header.begin(), header.end());
    std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    for (std::int32_t y = 0; y < ink.height(); ++y, at += row) {
      ink.get_row_bytes(y, std::span(bytes_).subspan(at, row), false);
    }
    if (info.resolution.known()) notes.emplace_back("PBM has no resolution");
    if (!info.name.empty()) notes.emplace_back("PBM has no page name");
    if (!info.metadata.empty()) {
      std::string keys;
      for (const auto& [key, value] : info.metadata) keys += " " + key;
      notes.emplace_back("PBM has no metadata, not written:" + keys);
    }
    return {};
  }

  Result<std::vector<std::uint8_t>> finish() override {
    return std::move(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

SinkResult create_pbm_sink() {
  return std::unique_ptr<RasterSink>(std::make_unique<PbmSink>());
}

}  // namespace unstep
