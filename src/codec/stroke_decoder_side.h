#pragma once

#include <utility>
#include <vector>

#include "codec/stroke_scan.h"
#include "entropy/arithmetic_decoder.h"

namespace unstep::codec {

/// The decoder's side of StrokeScan.
class StrokeDecoderSide {
 public:
  explicit StrokeDecoderSide(std::span<const std::uint8_t> payload)
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

}  // namespace unstep::codec
