#include "strokes/pen_set.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "grid/chain_end.h"

namespace unstep::strokes {
namespace {

bool above(Point a, Point b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); }

void turn(Stroke& stroke, Point end) {
  stroke.chain.origin = end;
  std::ranges::reverse(stroke.chain.steps);
  for (Step& step : stroke.chain.steps) step ^= 4;
  std::ranges::reverse(stroke.pieces);
}

}  // namespace

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

void sort_down(std::vector<Stroke>& strokes) {
  for (Stroke& stroke : strokes) {
    if (stroke.chain.closed) continue;
    const Point end = chain_end(stroke.chain, YAxis::down);
    if (above(end, stroke.chain.origin)) turn(stroke, end);
  }
  std::ranges::stable_sort(strokes, [](const Stroke& a, const Stroke& b) {
    return above(a.chain.origin, b.chain.origin);
  });
}

}  // namespace unstep::strokes
