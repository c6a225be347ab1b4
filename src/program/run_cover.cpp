#include "program/run_cover.h"

#include <algorithm>

#include "program/gallop.h"
#include "program/line_fit.h"

namespace unstep {
namespace {

class Cover {
 public:
  Cover(const Polyline& run, const CoverOptions& options)
      : run_(run), options_(options) {}

  void make(std::vector<CoverPiece>& pieces) {
    pieces.clear();
    const std::size_t end = run_.size() - 1;
    std::size_t at = 0;
    while (at < end) {
      const std::size_t line = reach(at);
      CoverPiece piece{line, false, {}};
      if (options_.arcs && line < end) find_arc(at, line, piece);
      pieces.push_back(piece);
      at = piece.last;
    }
  }

 private:
  /// Asked for the same vertex twice when lines are weighed against an arc.
  std::size_t reach(std::size_t from) {
    if (known_from_[0] == from) return known_reach_[0];
    if (known_from_[1] == from) return known_reach_[1];
    known_from_[1] = known_from_[0];
    known_reach_[1] = known_reach_[0];
    known_from_[0] = from;
    known_reach_[0] = line_reach(run_, from, options_.tolerance);
    return known_reach_[0];
  }

  void find_arc(std::size_t at, std::size_t line, CoverPiece& piece) {
    const std::size_t end = run_.size() - 1;
    FittedArc best;
    const auto fits = [&](std::size_t last) {
      if (last < at + 2 || !flat(at, last)) return false;
      const auto arc = fit_arc(run_, at, last, options_.arc);
      if (arc) best = *arc;
      return arc.has_value();
    };
    // Just beyond the line rounding may hide an arc that shows farther on.
    std::size_t first = std::max(line + 1, at + 2);
    if (first > end) return;
    if (!fits(first)) {
      first = std::min(end, line + (line - at) / 2 + 1);
      if (!fits(first)) return;
    }
    std::size_t last = gallop(first, end, fits);
    if (options_.arc.rules.by_radius && last < end) {
      const FittedArc small = best;
      const auto large = beyond_half_turn(run_, at, last, small);
      if (large && fits(*large)) {
        last = gallop(*large, end, fits);
      } else {
        best = small;
      }
    }
    if (lines_for(at, last) <= options_.arc_cost) return;
    // `best` is of the last that fitted, which is what was found.
    piece = {last, true, best};
  }

  /// True if all from `first` to `last` are at one height.
  [[nodiscard]] bool flat(std::size_t first, std::size_t last) {
    if (first < flat_begin_ || first > flat_end_) {
      flat_begin_ = flat_end_ = first;
    }
    while (flat_end_ < last &&
           run_.vertex[flat_end_ + 1].z == run_.vertex[flat_end_].z &&
           run_.written[flat_end_ + 1].z == run_.written[flat_end_].z) {
      ++flat_end_;
    }
    return flat_end_ >= last;
  }

  /// How many lines it takes to come as far, the last one in part.
  double lines_for(std::size_t at, std::size_t last) {
    double lines = 0;
    while (at < last) {
      const std::size_t next = reach(at);
      if (next > last) {
        return lines +
               static_cast<double>(last - at) / static_cast<double>(next - at);
      }
      lines += 1;
      if (lines > options_.arc_cost) return lines;
      at = next;
    }
    return lines;
  }

  const Polyline& run_;
  const CoverOptions& options_;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::size_t known_from_[2] = {kNone, kNone};
  std::size_t known_reach_[2] = {0, 0};
  std::size_t flat_begin_ = 0;
  std::size_t flat_end_ = 0;
};

}  // namespace

void cover_run(const Polyline& run, const CoverOptions& options,
               std::vector<CoverPiece>& pieces) {
  Cover(run, options).make(pieces);
}

}  // namespace unstep
