#include "strokes/stroke_repeat.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "grid/chain_end.h"

namespace unstep::strokes {
namespace {

/// Larger groups are no letters.
constexpr std::size_t kMostPieces = 24;
/// Earlier groups that are tried, the most used first.
constexpr std::size_t kTries = 48;
/// How far pens may differ, half pixels.
constexpr std::int32_t kPenSlack = 1;

std::int32_t distance(Point a, Point b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }

/// An earlier group that others may be like.
struct Pattern {
  std::size_t first = 0;  ///< of its pieces
  std::uint32_t uses = 1;
  std::int32_t drop = 0;  ///< of its lowest vertex below the line
};

struct Ends {
  Point begin;
  Point end;
};

class Repeater {
 public:
  Repeater(std::vector<Piece>& pieces, const Rational& tolerance,
           std::int32_t scale)
      : pieces_(pieces), check_(tolerance, scale), scale_(scale) {
    // The largest whole number of path units within the tolerance.
    reach_ = static_cast<std::int32_t>(std::uint64_t{tolerance.numerator} *
                                       static_cast<std::uint64_t>(scale) /
                                       tolerance.denominator);
    for (const Piece& piece : pieces) {
      const Point end = chain_end(piece.chain, YAxis::down);
      ends_.push_back(
          {{piece.chain.origin.x * scale, piece.chain.origin.y * scale},
           {end.x * scale, end.y * scale}});
    }
  }

  void run() {
    for (std::size_t first = 0; first < pieces_.size();) {
      std::size_t end = first + 1;
      while (end < pieces_.size() &&
             pieces_[end].group == pieces_[first].group) {
        ++end;
      }
      if (end - first <= kMostPieces) match(first, end - first);
      first = end;
    }
  }

 private:
  using Key = std::vector<std::uint32_t>;

  [[nodiscard]] Key key_of(std::size_t first, std::size_t count) const {
    Key key;
    for (std::size_t i = first; i < first + count; ++i) {
      key.push_back(pieces_[i].chain.closed          ? 2
                    : pieces_[i].chain.steps.empty() ? 1
                                                     : 0);
    }
    return key;
  }

  void match(std::size_t first, std::size_t count) {
    std::vector<Pattern>& known = patterns_[key_of(first, count)];
    std::size_t tries = 0;
    for (std::size_t k = 0; k < known.size() && tries < kTries; ++k) {
      const std::optional<Point> move = fit(known[k], first, count, tries);
      if (!move) continue;
      take(known[k], first, count, *move);
      base_ = lowest(first, count) - known[k].drop;
      ++known[k].uses;
      for (; k > 0 && known[k].uses > known[k - 1].uses; --k) {
        std::swap(known[k], known[k - 1]);
      }
      return;
    }
    const std::int32_t low = lowest(first, count);
    // A new line begins where a group stands apart from the one before.
    if (std::abs(low - base_) > 12 * scale_) base_ = low;
    known.push_back({first, 1, low - base_});
  }

  [[nodiscard]] std::int32_t lowest(std::size_t first,
                                    std::size_t count) const {
    std::int32_t low = INT32_MIN;
    for (std::size_t i = first; i < first + count; ++i) {
      low =
          std::max({low, pieces_[i].path.origin.y, end_of(pieces_[i].path).y});
    }
    return low;
  }

  /// How a pattern is moved to stand for the group, if it may.
  std::optional<Point> fit(const Pattern& pattern, std::size_t first,
                           std::size_t count, std::size_t& tries) {
    const Point about = ends_[first].begin - pieces_[pattern.first].path.origin;
    if (!roughly(pattern, first, count, about)) return std::nullopt;
    ++tries;
    std::vector<Point> moves;
    for (std::int32_t dy = -reach_; dy <= reach_; ++dy) {
      for (std::int32_t dx = -reach_; dx <= reach_; ++dx) {
        moves.push_back(about + Point{dx, dy});
      }
    }
    const std::int32_t low = lowest(pattern.first, count) - pattern.drop;
    std::ranges::sort(moves, [&](Point a, Point b) {
      const auto value = [&](Point p) {
        const Point d = p - about;
        return std::tuple(std::abs(low + p.y - base_) > reach_
                              ? std::abs(d.y)
                              : std::abs(low + p.y - base_),
                          d.x * d.x + d.y * d.y, p.y, p.x);
      };
      return value(a) < value(b);
    });
    for (const Point move : moves) {
      if (exactly(pattern, first, count, move)) return move;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool roughly(const Pattern& pattern, std::size_t first,
                             std::size_t count, Point move) const {
    for (std::size_t i = 0; i < count; ++i) {
      const Piece& a = pieces_[pattern.first + i];
      const Piece& b = pieces_[first + i];
      if (std::abs(a.width - b.width) > kPenSlack) return false;
      if (a.chain.closed) {
        const auto size = static_cast<std::int64_t>(a.chain.steps.size());
        const auto other = static_cast<std::int64_t>(b.chain.steps.size());
        if (std::abs(size - other) > 4 + 4 * reach_ / scale_) return false;
        continue;
      }
      if (distance(a.path.origin + move, ends_[first + i].begin) > 2 * reach_ ||
          distance(end_of(a.path) + move, ends_[first + i].end) > 2 * reach_) {
        return false;
      }
    }
    return true;
  }

  bool exactly(const Pattern& pattern, std::size_t first, std::size_t count,
               Point move) {
    const auto near = [&](Point a, Point b) {
      const Point d = a + move - b;
      return std::int64_t{d.x} * d.x + std::int64_t{d.y} * d.y <=
             std::int64_t{reach_} * reach_;
    };
    for (std::size_t i = 0; i < count; ++i) {
      const Piece& a = pieces_[pattern.first + i];
      if (a.chain.closed) continue;
      if (!near(a.path.origin, ends_[first + i].begin) ||
          !near(end_of(a.path), ends_[first + i].end)) {
        return false;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      Path path = pieces_[pattern.first + i].path;
      path.origin = path.origin + move;
      if (!check_.within(pieces_[first + i].chain, path)) return false;
    }
    return true;
  }

  void take(const Pattern& pattern, std::size_t first, std::size_t count,
            Point move) {
    for (std::size_t i = 0; i < count; ++i) {
      Piece& from = pieces_[pattern.first + i];
      Piece& to = pieces_[first + i];
      keep_own(to);
      to.path = from.path;
      to.path.origin = from.path.origin + move;
      to.width = from.width;
      to.shift = from.shift;
      to.repeated = from.repeated = true;
    }
  }

  std::vector<Piece>& pieces_;
  PathCheck check_;
  std::int32_t scale_;
  std::int32_t reach_ = 0;
  std::vector<Ends> ends_;                        ///< of the chains, path units
  std::map<Key, std::vector<Pattern>> patterns_;  ///< the most used first
  std::int32_t base_ = 0;  ///< the line on which letters stand
};

}  // namespace

void repeat_groups(std::vector<Piece>& pieces, const Rational& tolerance,
                   std::int32_t scale) {
  Repeater(pieces, tolerance, scale).run();
}

}  // namespace unstep::strokes
