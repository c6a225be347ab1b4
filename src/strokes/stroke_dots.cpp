#include "strokes/stroke_dots.h"

#include <cstddef>
#include <utility>

#include "strokes/cover.h"
#include "strokes/near_pieces.h"

namespace unstep::strokes {

void drop_dots(std::vector<Piece>& pieces) {
  NearPieces dots;
  for (const Piece& piece : pieces) {
    if (piece.chain.steps.empty()) dots.add(piece.chain.origin);
  }
  dots.offer(pieces, false);
  std::size_t dot = 0;
  std::erase_if(pieces, [&](const Piece& piece) {
    if (!piece.chain.steps.empty()) return false;
    return dots.piece(dot++) != NearPieces::kNobody;
  });
}

Status add_dots(const Bitmap& ink, const Bitmap& drawn, std::int64_t reach,
                std::int32_t scale, std::vector<Piece>& pieces) {
  std::vector<Stroke> found;
  if (Status dotted = dot_missing(ink, drawn, {reach, 1}, {}, found); !dotted) {
    return dotted;
  }
  if (found.empty()) return {};
  NearPieces dots;
  for (const Stroke& dot : found) dots.add(dot.chain.origin);
  dots.offer(pieces);
  // The dots after each piece, and those after all.
  std::vector<std::vector<std::size_t>> after(pieces.size() + 1);
  for (std::size_t k = 0; k < found.size(); ++k) {
    std::size_t i = dots.piece(k);
    if (i == NearPieces::kNobody) {
      i = pieces.size();
    } else {
      while (i + 1 < pieces.size() && pieces[i + 1].group == pieces[i].group) {
        ++i;
      }
    }
    after[i].push_back(k);
  }
  std::vector<Piece> all;
  all.reserve(pieces.size() + found.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    const bool last = i == pieces.size();
    const std::uint32_t group =
        last ? (all.empty() ? 0 : all.back().group + 1) : pieces[i].group;
    if (!last) all.push_back(std::move(pieces[i]));
    for (const std::size_t k : after[i]) {
      Piece piece;
      piece.chain = std::move(found[k].chain);
      piece.width = found[k].pieces.front().width;
      piece.group = group;
      piece.path.origin = {piece.chain.origin.x * scale,
                           piece.chain.origin.y * scale};
      all.push_back(std::move(piece));
    }
  }
  pieces = std::move(all);
  return {};
}

}  // namespace unstep::strokes
