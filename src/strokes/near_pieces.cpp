#include "strokes/near_pieces.h"

#include <cmath>

namespace unstep::strokes {
namespace {

/// Beyond the pen: two pixels, and as much for a line that left its chain.
constexpr std::int32_t kAround = 6;

}  // namespace

void NearPieces::add(Point at) {
  cells_[key(at.x >> 3, at.y >> 3)].push_back(pixels_.size());
  pixels_.push_back({at});
}

void NearPieces::offer(const std::vector<Piece>& pieces, bool dots) {
  if (empty()) return;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (!dots && piece.chain.steps.empty()) continue;
    Point at = piece.chain.origin;
    offer(at, i, piece.width);
    for (const Step step : piece.chain.steps) {
      const Point move = step_delta(step, YAxis::down);
      at = {at.x + move.x, at.y + move.y};
      offer(at, i, piece.width);
    }
  }
}

/// Shows the pixels around a point of a piece's chain that piece.
void NearPieces::offer(Point at, std::size_t piece, std::int32_t width) {
  const std::int32_t reach = width / 4 + kAround;
  for (std::int32_t y = (at.y - reach) >> 3; y <= (at.y + reach) >> 3; ++y) {
    for (std::int32_t x = (at.x - reach) >> 3; x <= (at.x + reach) >> 3; ++x) {
      const auto cell = cells_.find(key(x, y));
      if (cell == cells_.end()) continue;
      for (const std::size_t i : cell->second) {
        Pixel& pixel = pixels_[i];
        const double far =
            std::hypot(pixel.at.x - at.x, pixel.at.y - at.y) - width / 4.0;
        if (far > kAround || (pixel.piece != kNobody && far >= pixel.far)) {
          continue;
        }
        pixel.piece = piece;
        pixel.far = far;
      }
    }
  }
}

}  // namespace unstep::strokes
