#include "codec/program_predictors.h"

#include <algorithm>
#include <cstdlib>

#include "grid/wide_product.h"

namespace unstep::codec {
namespace {

/// Products of three such numbers stay below 2^126.
constexpr std::int64_t kSmall = std::int64_t{1} << 40;

struct Plane {
  std::int64_t x = 0;
  std::int64_t y = 0;
  [[nodiscard]] bool zero() const { return x == 0 && y == 0; }
  [[nodiscard]] bool small() const {
    return std::abs(x) < kSmall && std::abs(y) < kSmall;
  }
};

/// The nearest whole number, halves away from 0. REQUIRES: b != 0.
Int128 quotient(Int128 a, Int128 b) {
  const Int128 half = (b < 0 ? -b : b) / 2;
  return (a + (a < 0 ? -half : half)) / b;
}

std::int64_t kept(Int128 value) {
  constexpr Int128 kMost = kMaxProgramNumber;
  return static_cast<std::int64_t>(std::clamp(value, -kMost, kMost));
}

/// b turned on by the turn from a to b, and as much longer.
Plane continued(Plane a, Plane b) {
  if (a.zero() || !a.small() || !b.small()) return b;
  const Int128 square_x = Int128{b.x} * b.x - Int128{b.y} * b.y;
  const Int128 square_y = 2 * Int128{b.x} * b.y;
  const Int128 size = Int128{a.x} * a.x + Int128{a.y} * a.y;
  const Plane to{kept(quotient(square_x * a.x + square_y * a.y, size)),
                 kept(quotient(square_y * a.x - square_x * a.y, size))};
  return to;
}

Plane move_of(const ProgramMotion& motion) {
  return {motion.delta(0), motion.delta(1)};
}

/// y of a vector along `direction` whose x is `x`.
std::int64_t along(Plane direction, std::int64_t x, std::int64_t otherwise) {
  if (direction.x == 0 || !direction.small() || std::abs(x) >= kSmall) {
    return otherwise;
  }
  return kept(quotient(Int128{x} * direction.y, direction.x));
}

bool is_arc(const ProgramMotion& motion) { return motion.motion >= 2; }

/// The centre of an earlier arc from the start of this motion.
std::int64_t centre_from_here(const ProgramContext& context,
                              const ProgramMotion& arc, std::size_t axis) {
  return arc.from[axis] + arc.value[kWordI + axis] - context.motion.from[axis];
}

/// The way in which a motion ends.
Plane end_direction(const ProgramMotion& motion) {
  if (!is_arc(motion)) return move_of(motion);
  const Plane from_centre{motion.delta(0) - motion.value[kWordI],
                          motion.delta(1) - motion.value[kWordJ]};
  return motion.motion == 2 ? Plane{from_centre.y, -from_centre.x}
                            : Plane{-from_centre.y, from_centre.x};
}

/// The centre of an arc to `end` that goes on in the direction.
Plane tangent_centre(Plane direction, Plane end) {
  const Plane normal{-direction.y, direction.x};
  if (!normal.small() || !end.small()) return {};
  const Int128 twice =
      2 * (Int128{normal.x} * end.x + Int128{normal.y} * end.y);
  if (twice == 0) return {};
  const Int128 square = Int128{end.x} * end.x + Int128{end.y} * end.y;
  return {kept(quotient(square * normal.x, twice)),
          kept(quotient(square * normal.y, twice))};
}

/// The other coordinate of a centre on the line between the ends.
std::int64_t on_bisector(Plane end, std::int64_t known, bool know_x) {
  const std::int64_t along_known = know_x ? end.x : end.y;
  const std::int64_t along_other = know_x ? end.y : end.x;
  if (along_other == 0 || !end.small() || std::abs(known) >= kSmall) return 0;
  const Int128 square = Int128{end.x} * end.x + Int128{end.y} * end.y;
  return kept(quotient(square - 2 * Int128{known} * along_known,
                       2 * Int128{along_other}));
}

/// E for the length of this move, as for the one before.
std::int64_t extruded(const ProgramContext& context) {
  const auto length = [](const ProgramMotion& motion) -> Int128 {
    UInt128 square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t d = motion.delta(axis);
      if (std::abs(d) >= kSmall) return 0;
      square += static_cast<UInt128>(Int128{d} * d);
    }
    return floor_root(square);
  };
  const ProgramMotion& before = context.history.before(1);
  const Int128 last = length(before);
  if (last == 0 || std::abs(before.delta(kWordE)) >= kSmall) return 0;
  return kept(quotient(length(context.motion) * before.delta(kWordE), last));
}

/// The next of the moves if they grow evenly: a line and a parabola through
/// the last eight by least squares.
std::int64_t by_line(const AxisTrail& trail) {
  constexpr std::array<std::int64_t, 8> kWeights{14, 11, 8, 5, 2, -1, -4, -7};
  Int128 sum = 0;
  for (std::size_t i = 0; i < 8; ++i)
    sum += Int128{kWeights[i]} * trail.moves[i];
  return kept(quotient(sum, 28));
}
std::int64_t by_parabola(const AxisTrail& trail) {
  constexpr std::array<std::int64_t, 8> kWeights{63,  27,  1,  -15,
                                                 -21, -17, -3, 21};
  Int128 sum = 0;
  for (std::size_t i = 0; i < 8; ++i)
    sum += Int128{kWeights[i]} * trail.moves[i];
  return kept(quotient(sum, 56));
}

/// What the trail alone says: the first five predictors.
void extrapolate(const AxisTrail& trail, ProgramPredictions& out) {
  const auto& m = trail.moves;
  out[0] = 0;
  out[1] = m[0];
  out[2] = kept(2 * Int128{m[0]} - m[1]);
  out[3] = kept(3 * Int128{m[0]} - 3 * Int128{m[1]} + m[2]);
  out[4] = by_line(trail);
  out[5] = by_parabola(trail);
}

}  // namespace

ProgramPredictions predict_axis(const ProgramContext& context, std::size_t axis,
                                const AxisTrail& trail) {
  const ProgramHistory& history = context.history;
  const std::int64_t at = context.motion.from[axis];
  ProgramPredictions out{};
  extrapolate(trail, out);
  const ProgramMotion& last = history.before(1);
  const Plane turned = continued(move_of(history.before(2)), move_of(last));
  const std::int64_t dx = context.motion.delta(0);
  if (axis == 0) {
    out[6] = turned.x;
    out[7] = -trail.moves[0];
  } else if (axis == 1) {
    out[6] = along(turned, dx, turned.y);
    out[7] = along(move_of(last), dx, last.delta(1));
  } else if (axis == kWordE) {
    out[6] = extruded(context);
    out[7] = -trail.moves[0];
  } else {
    out[6] = kept(4 * Int128{trail.moves[0]} - 6 * Int128{trail.moves[1]} +
                  4 * Int128{trail.moves[2]} - trail.moves[3]);
    out[7] = -trail.moves[0];
  }
  const ProgramGuess vectors = history.by_vectors();
  const ProgramGuess places = history.by_places();
  const ProgramMotion* left = history.left_here();
  const ProgramMotion* led = history.led_here();
  out[8] = vectors.next != nullptr ? vectors.next->delta(axis) : out[1];
  out[9] = places.next != nullptr ? places.next->to[axis] - at : out[2];
  out[10] = left != nullptr ? left->to[axis] - at : out[4];
  out[11] = led != nullptr ? led->from[axis] - at : out[3];
  out[12] = history.home()[axis] - at;
  out[13] =
      axis == 1 ? turned.y : kept(-Int128{trail.moves[0]} - trail.moves[1]);
  return out;
}

ProgramPredictions predict_centre(const ProgramContext& context,
                                  std::size_t word, bool other_known,
                                  const AxisTrail& trail) {
  const ProgramHistory& history = context.history;
  const std::size_t axis = word - kWordI;
  const ProgramMotion& motion = context.motion;
  const Plane end = move_of(motion);
  ProgramPredictions out{};
  out[0] = trail.moves[0];
  out[1] = axis == 0 ? end.x / 2 : end.y / 2;
  const Plane tangent = tangent_centre(end_direction(history.before(1)), end);
  out[2] = axis == 0 ? tangent.x : tangent.y;
  out[3] = other_known
               ? on_bisector(end, motion.value[axis == 0 ? kWordJ : kWordI],
                             axis == 1)
               : out[2];
  // The centres of the last arcs.
  std::size_t found = 4;
  for (std::size_t back = 1; back <= 8 && found < 8; ++back) {
    const ProgramMotion& before = history.before(back);
    if (is_arc(before)) out[found++] = centre_from_here(context, before, axis);
  }
  for (; found < 8; ++found) out[found] = out[2];
  const ProgramGuess vectors = history.by_vectors();
  const ProgramGuess places = history.by_places();
  const ProgramMotion* left = history.left_here();
  const ProgramMotion* led = history.led_here();
  const auto guessed = [&](const ProgramMotion* arc, bool relative,
                           std::int64_t otherwise) {
    if (arc == nullptr || !is_arc(*arc)) return otherwise;
    return relative ? arc->value[word] : centre_from_here(context, *arc, axis);
  };
  out[8] = guessed(vectors.next, true, out[3]);
  out[9] = guessed(places.next, false, out[3]);
  out[10] = guessed(left, false, out[2]);
  out[11] = guessed(led, false, out[2]);
  out[12] = trail.moves[1];
  out[13] = -trail.moves[0];
  return out;
}

ProgramPredictions predict_word(const ProgramContext& context, std::size_t word,
                                const AxisTrail& trail) {
  const ProgramHistory& history = context.history;
  ProgramPredictions out{};
  const auto& m = trail.moves;
  out[0] = m[0];
  out[1] = kept(2 * Int128{m[0]} - m[1]);
  out[2] = m[1];
  out[3] = m[2];
  out[4] = m[3];
  out[5] = 0;
  out[6] = by_line(trail);
  out[7] = kept(m[0] + (Int128{m[0]} - m[4]) / 4);
  const auto guessed = [word](const ProgramMotion* other,
                              std::int64_t otherwise) {
    return other != nullptr && other->has(word) ? other->value[word]
                                                : otherwise;
  };
  out[8] = guessed(history.by_vectors().next, out[0]);
  out[9] = guessed(history.by_places().next, out[1]);
  out[10] = guessed(history.left_here(), out[0]);
  out[11] = guessed(history.led_here(), out[2]);
  out[12] = m[4];
  out[13] = kept(3 * Int128{m[0]} - 3 * Int128{m[1]} + m[2]);
  return out;
}

}  // namespace unstep::codec
