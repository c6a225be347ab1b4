#include "strokes/cover.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <queue>
#include <utility>

#include "grid/row_distances.h"
#include "trace/neighbourhood.h"

namespace unstep::strokes {
namespace {

using trace::Spot;

/// What strokes are freed from: of what is farther than two pixels only what is
/// too small to see is left.
constexpr std::array<Missing, 2> kPasses{{{5, 1}, {4, 4}}};

/// Pixels first..last of a word's row, as bits of word w.
std::uint64_t run_mask(std::int64_t first, std::int64_t last, std::int64_t w) {
  const std::int64_t from = std::max<std::int64_t>(first - 64 * w, 0);
  const std::int64_t to = std::min<std::int64_t>(last - 64 * w, 63);
  if (from > to) return 0;
  return (~std::uint64_t{0} >> from) & (~std::uint64_t{0} << (63 - to));
}

/// Ink whose squared distance from what is drawn is above `near`.
Result<Bitmap> missing_ink(const Bitmap& ink, const Bitmap& drawn,
                           std::int64_t near) {
  Result<Bitmap> missing = Bitmap::create(ink.width(), ink.height());
  if (!missing) return missing;
  RowDistances distances(drawn, RowDistances::To::ink);
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    const auto inked = ink.row(y);
    const auto covered = drawn.row(y);
    std::span<const std::int64_t> squares;
    for (std::size_t w = 0; w < inked.size(); ++w) {
      std::uint64_t left = inked[w] & ~covered[w];
      if (left != 0 && squares.empty()) squares = distances.row(y);
      while (left != 0) {
        const int bit = std::countl_zero(left);
        left &= ~(std::uint64_t{1} << (63 - bit));
        const std::size_t x = w * 64 + static_cast<std::size_t>(bit);
        if (squares[x] > near) {
          missing->set(static_cast<std::int32_t>(x), y, true);
        }
      }
    }
  }
  return missing;
}

class Coverer {
 public:
  Coverer(Bitmap& missing, const std::vector<Spot>& spots, const Missing& what)
      : missing_(missing),
        what_(what),
        rows_(static_cast<std::size_t>(missing.height())),
        spots_(spots) {
    for (std::int32_t y = 0; y < missing.height(); ++y) {
      rows_[static_cast<std::size_t>(y)] =
          std::ranges::any_of(missing.row(y), [](auto w) { return w != 0; });
    }
  }

  void run(std::vector<Stroke>& strokes) {
    std::priority_queue<Candidate> queue;
    for (std::size_t i = 0; i < spots_.size(); ++i) {
      const std::uint64_t gain = count(spots_[i]);
      if (gain >= what_.least) queue.push({gain, i});
    }
    while (!queue.empty()) {
      Candidate best = queue.top();
      queue.pop();
      const std::uint64_t gain = count(spots_[best.spot]);
      if (gain == best.gain) {
        strokes.push_back(dot(spots_[best.spot]));
        for_each_run(spots_[best.spot],
                     std::sqrt(static_cast<double>(what_.near)),
                     [](std::uint64_t& word, auto m) { word &= ~m; });
      } else if (gain >= what_.least) {
        queue.push({gain, best.spot});
      }
    }
  }

 private:
  /// What is missing only ever gets less, so an old gain is never too small.
  struct Candidate {
    std::uint64_t gain = 0;
    std::size_t spot = 0;
    friend bool operator<(const Candidate& a, const Candidate& b) {
      return a.gain != b.gain ? a.gain < b.gain : a.spot > b.spot;
    }
  };

  static Stroke dot(const Spot& spot) {
    Stroke stroke;
    stroke.chain.origin = spot.at;
    const double width = 2 * trace::radius_of(spot);
    stroke.pieces = {{0, std::max(1, static_cast<std::int32_t>(2 * width))}};
    return stroke;
  }

  /// use(word, mask) for the words of the rows with missing ink in the disc.
  template <class Use>
  void for_each_run(const Spot& spot, double margin, Use use) {
    const double radius = trace::radius_of(spot) + margin;
    const auto high = static_cast<std::int32_t>(radius);
    const std::int32_t first = std::max(spot.at.y - high, 0);
    const std::int32_t last = std::min(spot.at.y + high, missing_.height() - 1);
    for (std::int32_t y = first; y <= last; ++y) {
      if (!rows_[static_cast<std::size_t>(y)]) continue;
      const double dy = y - spot.at.y;
      const auto half = static_cast<std::int64_t>(
          std::sqrt(std::max(0.0, radius * radius - dy * dy)));
      const std::int64_t left = std::max<std::int64_t>(spot.at.x - half, 0);
      const std::int64_t right =
          std::min<std::int64_t>(spot.at.x + half, missing_.width() - 1);
      const auto words = missing_.row(y);
      for (std::int64_t w = left / 64; w <= right / 64; ++w) {
        use(words[static_cast<std::size_t>(w)], run_mask(left, right, w));
      }
    }
  }

  std::uint64_t count(const Spot& spot) {
    std::uint64_t sum = 0;
    for_each_run(spot, 0, [&](std::uint64_t& word, std::uint64_t mask) {
      sum += static_cast<std::uint64_t>(std::popcount(word & mask));
    });
    return sum;
  }

  Bitmap& missing_;
  Missing what_;
  std::vector<bool> rows_;  ///< rows with missing ink
  const std::vector<Spot>& spots_;
};

/// The missing pixels as places for dots.
void add_missing(const Bitmap& ink, const Bitmap& missing,
                 std::vector<Spot>& spots) {
  RowDistances distances(ink, RowDistances::To::paper);
  for (std::int32_t y = 0; y < missing.height(); ++y) {
    std::span<const std::int64_t> squares;
    const auto words = missing.row(y);
    for (std::size_t w = 0; w < words.size(); ++w) {
      std::uint64_t left = words[w];
      if (left != 0 && squares.empty()) squares = distances.row(y);
      while (left != 0) {
        const int bit = std::countl_zero(left);
        left &= ~(std::uint64_t{1} << (63 - bit));
        const auto x = static_cast<std::int32_t>(w * 64) + bit;
        spots.push_back({{x, y}, squares[static_cast<std::size_t>(x)]});
      }
    }
  }
}

}  // namespace

Status dot_missing(const Bitmap& ink, const Bitmap& drawn, const Missing& what,
                   std::vector<Spot> spots, std::vector<Stroke>& dots) {
  Result<Bitmap> missing = missing_ink(ink, drawn, what.near);
  if (!missing) return missing.error();
  if (missing->ink() == 0) return {};
  add_missing(ink, *missing, spots);
  Coverer(*missing, spots, what).run(dots);
  return {};
}

Status cover_missing(const Bitmap& ink, const std::vector<Spot>& spots,
                     std::vector<Stroke>& strokes) {
  const Canvas canvas{ink.width(), ink.height(), YAxis::down};
  for (const Missing& what : kPasses) {
    const Result<Drawing> drawing = stroke_paths(strokes, canvas, {{0, 1}});
    if (!drawing) return drawing.error();
    const Result<Bitmap> drawn = render_paths(*drawing);
    if (!drawn) return drawn.error();
    Status dotted = dot_missing(ink, *drawn, what, spots, strokes);
    if (!dotted) return dotted;
  }
  return {};
}

}  // namespace unstep::strokes
