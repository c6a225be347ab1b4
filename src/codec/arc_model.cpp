#include "codec/arc_model.h"

#include <algorithm>
#include <cmath>

namespace unstep::codec {
namespace {

/// Guesses are made of chords and radii below this, so that products of three
/// numbers fit 63 bits.
constexpr std::int64_t kGuessLimit = std::int64_t{1} << 20;

bool guessable(const Vec& v) { return size_of(v) < kGuessLimit; }

/// The largest r with r * r <= square. REQUIRES: 0 <= square < 2^62.
std::int64_t root(std::int64_t square) {
  std::int64_t r = 0;
  for (std::int64_t bit = std::int64_t{1} << 30; bit > 0; bit >>= 1) {
    if ((r + bit) * (r + bit) <= square) r += bit;
  }
  return r;
}

/// Nearest, halves away from 0. REQUIRES: d != 0, both below 2^62.
std::int64_t rounded(std::int64_t n, std::int64_t d) {
  if (d < 0) {
    n = -n;
    d = -d;
  }
  return n >= 0 ? (n + d / 2) / d : -((-n + d / 2) / d);
}

}  // namespace

/// The side to which the chord leaves the tangent tells the sense.
std::size_t ArcModel::sense_context(const Vec& end, const Vec& tangent) const {
  const Vec e = shortened(end, 30);
  const Vec t = shortened(tangent, 30);
  const std::int64_t cross = t.x * e.y - t.y * e.x;
  const std::size_t side = tangent.zero() ? 0
                           : cross == 0   ? 1
                           : cross > 0    ? 2
                                          : 3;
  return 2 * side + (clockwise_before_ ? 1 : 0);
}

std::int64_t ArcModel::on_bisector(const Vec& end, bool y_first,
                                   std::int64_t first) {
  if (!guessable(end)) return 0;
  const std::int64_t half = end.x * end.x + end.y * end.y;
  const std::int64_t e1 = y_first ? end.y : end.x;
  const std::int64_t e2 = y_first ? end.x : end.y;
  return rounded(half - 2 * first * e1, 2 * e2);
}

/// Of: the middle of the chord, the tangent, the radii remembered (the centre
/// on the side of the sense for less than half a turn), the other side.
std::array<std::int64_t, ArcModel::kGuesses> ArcModel::guess_all(
    const Vec& end, const Vec& tangent, bool clockwise, bool y_first) const {
  std::array<std::int64_t, kGuesses> guesses{};
  if (!guessable(end)) return guesses;
  const std::int64_t square = end.x * end.x + end.y * end.y;
  const std::int64_t middle = (y_first ? end.y : end.x) / 2;
  guesses.fill(middle);
  const Vec t = shortened(tangent, 19);
  const std::int64_t across = 2 * (t.x * end.y - t.y * end.x);
  if (across != 0) {
    // Perpendicular to the tangent and as far from the start as from the end.
    guesses[1] = rounded(square * (y_first ? t.x : -t.y), across);
  }
  // From the chord to the right as its y grows, seen with y down, the centre
  // of a clockwise arc below half a turn: (-y, x) of the chord.
  const std::int64_t normal = y_first ? end.x : -end.y;
  const std::int64_t chord = root(square);
  for (std::size_t i = 0; i < 2 && chord > 0; ++i) {
    const std::int64_t rest = squared_radii_[i] - square / 4;
    if (rest < 0) continue;
    const std::int64_t offset = rounded(root(rest) * normal, chord);
    guesses[2 + i] = middle + (clockwise ? offset : -offset);
    if (i == 0) guesses[4] = middle - (clockwise ? offset : -offset);
  }
  return guesses;
}

void ArcModel::remember(const Vec& centre, bool clockwise) {
  clockwise_before_ = clockwise;
  if (size_of(centre) >= (std::int64_t{1} << 30)) return;
  const std::int64_t square = centre.x * centre.x + centre.y * centre.y;
  if (square == squared_radii_[0]) return;
  squared_radii_ = {square, squared_radii_[0]};
}

}  // namespace unstep::codec
