#include "strokes/pen_set.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace unstep::strokes {

void share_pens(std::vector<Stroke>& strokes) {
  std::map<std::int32_t, std::uint64_t> steps;
  for (const Stroke& stroke : strokes) {
    for (const Stroke::Piece& piece : stroke.pieces) {
      // A dot counts a little.
      steps[piece.width] += piece.steps + 1;
    }
  }
  std::vector<std::pair<std::uint64_t, std::int32_t>> by_steps;
  for (const auto& [width, count] : steps) by_steps.push_back({count, width});
  std::ranges::sort(by_steps, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::map<std::int32_t, std::int32_t> pens;
  for (const auto& [count, width] : by_steps) {
    if (pens.contains(width)) continue;
    const std::int32_t slack = std::clamp(width / 4, 1, 4);
    for (auto& near : steps) {
      if (std::abs(near.first - width) <= slack) {
        pens.try_emplace(near.first, width);
      }
    }
  }
  for (Stroke& stroke : strokes) {
    std::vector<Stroke::Piece> pieces;
    for (const Stroke::Piece& piece : stroke.pieces) {
      const std::int32_t width = pens.at(piece.width);
      if (!pieces.empty() && pieces.back().width == width) {
        pieces.back().steps += piece.steps;
      } else {
        pieces.push_back({piece.steps, width});
      }
    }
    stroke.pieces = std::move(pieces);
  }
}

}  // namespace unstep::strokes
