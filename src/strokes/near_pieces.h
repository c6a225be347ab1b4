#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "strokes/stroke_piece.h"
#include "unstep/grid.h"

namespace unstep::strokes {

/// Pixels, and of each the piece whose pen comes nearest to it, if one comes
/// within six pixels.
class NearPieces {
 public:
  static constexpr std::size_t kNobody = SIZE_MAX;

  void add(Point at);
  [[nodiscard]] bool empty() const { return pixels_.empty(); }
  [[nodiscard]] std::size_t size() const { return pixels_.size(); }

  /// Shows the pixels all pieces, or only those of lines.
  void offer(const std::vector<Piece>& pieces, bool dots = true);

  /// The piece of pixel i, or kNobody.
  [[nodiscard]] std::size_t piece(std::size_t i) const {
    return pixels_[i].piece;
  }

 private:
  struct Pixel {
    Point at;
    std::size_t piece = kNobody;
    double far = 0;
  };
  static std::uint64_t key(std::int32_t x, std::int32_t y) {
    return std::uint64_t{static_cast<std::uint32_t>(y)} << 32 |
           static_cast<std::uint32_t>(x);
  }
  void offer(Point at, std::size_t piece, std::int32_t width);

  std::vector<Pixel> pixels_;
  /// Of 8 x 8 pixels each.
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

}  // namespace unstep::strokes
