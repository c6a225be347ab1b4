#include <bit>
#include <utility>
#include <vector>

#include "trace/active_words.h"
#include "trace/neighbourhood.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using trace::ActiveWords;
using trace::WordRing;

/// Z. Guo, R. W. Hall, "Parallel thinning with two-subiteration algorithms",
/// Comm. ACM 32 (1989), algorithm A1: a pixel goes if it is simple, if it is no
/// end (both ways of pairing the neighbours have 2 or 3 pairs with ink, one at
/// least not 4) and if it is on the side of this half: the south or east
/// border, then the north or west one. They prove, by Ronse's criteria, that
/// all such pixels can go at once without a change of topology.
std::uint64_t guo_hall(const WordRing& p, bool second) {
  const std::uint64_t pairs_a[4] = {p.nw | p.n, p.ne | p.e, p.se | p.s,
                                    p.sw | p.w};
  const std::uint64_t pairs_b[4] = {p.n | p.ne, p.e | p.se, p.s | p.sw,
                                    p.w | p.nw};
  const std::uint64_t two =
      trace::at_least_two(pairs_a[0], pairs_a[1], pairs_a[2], pairs_a[3]) &
      trace::at_least_two(pairs_b[0], pairs_b[1], pairs_b[2], pairs_b[3]);
  const std::uint64_t four = pairs_a[0] & pairs_a[1] & pairs_a[2] & pairs_a[3] &
                             pairs_b[0] & pairs_b[1] & pairs_b[2] & pairs_b[3];
  const std::uint64_t inside =
      second ? (p.s | p.sw | ~p.nw) & p.w : (p.n | p.ne | ~p.se) & p.e;
  return trace::simple_pixels(p) & two & ~four & ~inside;
}

class Thinner {
 public:
  Thinner(Bitmap& ink, const Progress& progress)
      : ink_(ink),
        progress_(progress),
        words_(ink.words_per_row()),
        rows_(static_cast<std::size_t>(ink.height())),
        active_(words_, rows_),
        changed_{ActiveWords(words_, rows_), ActiveWords(words_, rows_)} {}

  Status run() {
    total_ = ink_.ink();
    activate_ink();
    // A word has nothing to lose if nothing around it has changed since the
    // same half was done before.
    int idle = 0;
    for (std::uint64_t half = 0; idle < 2; ++half) {
      idle = peel(half % 2 == 1) ? 0 : idle + 1;
      if (progress_ && !progress_(removed_, total_)) {
        return Error{ErrorCode::cancelled, "cancelled"};
      }
      if (half > 0) active_.set_around(changed_[0], changed_[1]);
    }
    thin_corners();
    if (progress_ && !progress_(total_, total_)) {
      return Error{ErrorCode::cancelled, "cancelled"};
    }
    return {};
  }

 private:
  struct Removal {
    std::size_t word = 0;
    std::uint64_t pixels = 0;
  };

  void activate_ink() {
    for (std::size_t y = 0; y < rows_; ++y) {
      const auto row = ink_.row(static_cast<std::int32_t>(y));
      for (std::size_t w = 0; w < words_; ++w) {
        if (row[w] != 0) active_.set(y, w);
      }
    }
  }

  /// One half of an iteration. Pixels are taken off a row once the row below
  /// has been looked at, so that all are judged by what was there before.
  bool peel(bool second) {
    ActiveWords& changed = changed_[second ? 1 : 0];
    changed.clear();
    bool any = false;
    std::vector<Removal> above;
    std::vector<Removal> here;
    for (std::size_t y = 0; y < rows_; ++y) {
      here.clear();
      const auto row = static_cast<std::int32_t>(y);
      active_.for_each(y, words_, [&](std::size_t word) {
        const std::uint64_t ink = ink_.row(row)[word];
        if (ink == 0) return;
        const std::uint64_t gone =
            ink & guo_hall(trace::ring_of(ink_, row, word), second);
        if (gone == 0) return;
        here.push_back({word, gone});
        changed.set(y, word);
      });
      any = any || !here.empty();
      if (y > 0) remove(y - 1, above);
      std::swap(above, here);
    }
    if (rows_ > 0) remove(rows_ - 1, above);
    return any;
  }

  void remove(std::size_t y, const std::vector<Removal>& removals) {
    const auto row = ink_.row(static_cast<std::int32_t>(y));
    for (const Removal& removal : removals) {
      row[removal.word] &= ~removal.pixels;
      removed_ += static_cast<std::uint64_t>(std::popcount(removal.pixels));
    }
  }

  /// One pixel after the other, so that a simple one may always go: what is
  /// left are ends and pixels that hold something together.
  void thin_corners() {
    for (bool again = true; again;) {
      again = false;
      for (std::int32_t y = 0; y < ink_.height(); ++y) {
        for (std::size_t w = 0; w < words_; ++w) {
          const std::uint64_t ink = ink_.row(y)[w];
          if (ink == 0) continue;
          const WordRing ring = trace::ring_of(ink_, y, w);
          std::uint64_t doubtful =
              ink & trace::simple_pixels(ring) & trace::inner_pixels(ring);
          again = again || doubtful != 0;
          for (; doubtful != 0;) {
            const int at = std::countl_zero(doubtful);
            doubtful &= ~(std::uint64_t{1} << (63 - at));
            thin_corner({static_cast<std::int32_t>(w * 64) + at, y});
          }
        }
      }
    }
  }

  void thin_corner(Point at) {
    const unsigned ring = trace::ring_of(ink_, at);
    if (trace::is_simple(ring) && std::popcount(ring) >= 2) {
      ink_.set(at.x, at.y, false);
    }
  }

  Bitmap& ink_;
  const Progress& progress_;
  std::size_t words_;
  std::size_t rows_;
  std::uint64_t total_ = 0;
  std::uint64_t removed_ = 0;
  ActiveWords active_;
  ActiveWords changed_[2];  ///< by the last first and second half
};

}  // namespace

Status thin(Bitmap& ink, const Progress& progress) {
  return Thinner(ink, progress).run();
}

}  // namespace unstep
