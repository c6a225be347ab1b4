#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "unstep/grid.h"
#include "unstep/result.h"

/// Forward interpolation: a segment or an arc becomes unit steps, or
/// increments per period. docs/algorithms.md describes every method, its
/// source and its measured deviation.
///
///     auto line = Interpolator::line(Method::device, {7, 3});
///     if (!line) return line.error();
///     for (Tick t = line->next(); t.kind != Tick::Kind::done; t =
///     line->next())
///       if (t.kind == Tick::Kind::step) move(t.step);
///
///     std::array<Step, 64> steps;  // the same, many segments at a time
///     auto drawn = interpolate(Method::device, segments, steps);
///
/// All methods start at (0, 0), y up. Deltas are any int32, INT32_MIN too;
/// arcs have limits of their own (Interpolator::arc).
namespace unstep {

/// The systems of the source documents. The tag of each is in method_info().
enum class Method : std::uint8_t {
  device,           ///< A1: self-counting evaluation function, SU 1089551
  gate_level,       ///< A3: the same as a net of its numbered elements
  rate_multiplier,  ///< B: binary rate multiplier per axis, frame of 2^n
  evaluation,       ///< C: classic evaluation function, 4-connected
  evaluation8,      ///< C with diagonal steps
  circular,         ///< D1: circular evaluation function
  increments,       ///< D2: code increments per period, shrinking step
  cordic,           ///< D3: digit by digit, Volder's form
  meggitt,          ///< D3: digit by digit, Meggitt's form
  rom,              ///< D4: table and correction between the nodes
  general,          ///< D5: sin and cos from any source, per period
};

struct MethodInfo {
  Method method;
  std::string_view name;         ///< as on the command line, "rate-multiplier"
  std::string_view tag;          ///< section of the source, "A1"
  std::string_view description;  ///< one line
  bool lines;
  bool arcs;
  bool increments;  ///< ticks are increments per period, not unit steps
};

/// Every method, in the order of the enum.
[[nodiscard]] std::span<const MethodInfo> methods();
[[nodiscard]] const MethodInfo& method_info(Method method);
[[nodiscard]] std::optional<Method> find_method(std::string_view name);

/// What one pulse of the clock (or one period) brings.
struct Tick {
  enum class Kind : std::uint8_t {
    done,       ///< the end was reached before; stays so
    idle,       ///< a clock pulse without a move
    step,       ///< one unit step; an odd code is diagonal
    increment,  ///< (dx, dy) of a whole period
  };
  Kind kind = Kind::done;
  Step step = 0;
  std::int32_t dx = 0;  ///< the move, for step and increment
  std::int32_t dy = 0;
  friend bool operator==(const Tick&, const Tick&) = default;
};

/// Table of D4: values at the nodes, or differences of neighbouring values.
enum class RomForm : std::uint8_t { values, differences };
/// Correction between the nodes of D4.
enum class RomCorrection : std::uint8_t { linear, parabolic, cubic };
/// Where D5 takes sin and cos from.
enum class SineSource : std::uint8_t { cordic, meggitt, rom };

/// Limits of InterpolatorOptions, checked where the option matters.
inline constexpr int kMaxRateBits = 32;
inline constexpr int kMinWordLength = 8;
inline constexpr int kMaxWordLength = 52;
inline constexpr int kMinRomBits = 4;
inline constexpr int kMaxRomBits = 10;
inline constexpr std::int64_t kMaxPeriodLength = std::int64_t{1} << 30;

/// 0 (or the default) lets the method choose from the segment or arc.
struct InterpolatorOptions {
  /// Vk, grid units per second, > 0, and Tk, seconds, > 0: `increments`,
  /// `general` and the feed of `circular`. Vk * Tk in [2^-10, 2^30] units.
  double feed = 16.0;
  double period = 1.0;
  int rate_bits = 0;    ///< n of B: 1..32, deltas < 2^n; 4 is the document's
  int word_length = 0;  ///< n of D3 and of D4's values: 8..52 digits
  int rom_bits = 0;     ///< D4: table step 2^-s rad, s in 4..10
  RomForm rom_form = RomForm::values;
  RomCorrection rom_correction = RomCorrection::cubic;
  SineSource source = SineSource::cordic;  ///< of D5
  /// H0 of D2, a power of two, 1..2^20; 0: about Vk * Tk / 4.
  std::int32_t first_step = 0;
  bool combined = false;  ///< D1: diagonal steps where they are nearer
};

/// A named register of a method, for tables.
struct Register {
  std::string_view name;
  std::int64_t value = 0;
  friend bool operator==(const Register&, const Register&) = default;
};
inline constexpr std::size_t kMaxRegisters = 8;

/// One running interpolation. A plain value: O(1) state, no heap, copyable.
/// The last move always ends on the exact end point.
class Interpolator {
 public:
  /// A straight line from (0, 0). (0, 0) itself is done at once.
  /// unsupported if the method draws no lines, out_of_range for an option.
  static Result<Interpolator> line(Method method, Segment segment,
                                   const InterpolatorOptions& options = {});

  /// A circular arc. |centre.x|, |centre.y| <= kMaxCoord, not both 0; the end
  /// may be off the circle by one unit of radius. end == (0, 0) is the full
  /// circle. unsupported if the method draws no arcs; out_of_range naming the
  /// number; invalid_argument if the end is not on the circle.
  static Result<Interpolator> arc(Method method, const Arc& arc,
                                  const InterpolatorOptions& options = {});

  /// The next tick; constant time but for D2 (logarithmic in H0) and the
  /// difference table of D4.
  Tick next();

  /// Ticks until `out` is full or the end is reached; how many were written.
  /// `done` itself is not written.
  std::size_t fill(std::span<Tick> out);

  /// The registers after the last tick; how many were written.
  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  friend struct InterpolatorAccess;
  Interpolator() = default;
  static constexpr std::size_t kStateBytes = 320;
  alignas(16) std::array<std::byte, kStateBytes> state_{};
};

/// Steps of the segment: |dx| + |dy|, or the larger for diagonal methods.
/// At most 2^32. For the methods that make steps of lines by counting alone:
/// device, gate_level, evaluation, evaluation8.
[[nodiscard]] std::uint64_t step_count(Method method, Segment segment);

/// Bulk form: the steps of all segments one after another, idle ticks left
/// out; equal to what next() gives, much faster for device, evaluation and
/// evaluation8. Returns the steps written. limit_exceeded if `out` is too
/// short, unsupported for methods that make increments or no lines; `out` is
/// then unspecified.
Result<std::size_t> interpolate(Method method,
                                std::span<const Segment> segments,
                                std::span<Step> out,
                                const InterpolatorOptions& options = {});

struct StepOptions {
  /// Which lines: evaluation8 (8-connected), evaluation or device
  /// (4-connected). Arcs are drawn by `circular`, with diagonal steps if the
  /// lines have them.
  Method lines = Method::evaluation8;
  /// The distance of the points of the new grid, in grid units of the drawing.
  double grid = 1.0;
  std::uint64_t max_steps = std::uint64_t{1} << 32;  ///< in all
};

/// The paths of a drawing as chains, path by path, the drawing's own chains
/// left out. Vertices are rounded to the nearest point of the new grid first;
/// canvas and coordinates are in it. Drawn by Method::device with grid 1 and
/// scale 1, the segments of DeviceReverse give the chain that the device
/// draws. invalid_argument for another method or a grid that is not > 0,
/// out_of_range if a point leaves the coordinate range, limit_exceeded for more
/// steps than allowed.
Result<Drawing> step_paths(const Drawing& drawing, const StepOptions& options);

/// The plain per-step loop of A1, the reference of the bulk form and of the
/// benchmarks. REQUIRES: out.size() >= step_count(Method::device, segment).
std::size_t device_steps_reference(Segment segment, std::span<Step> out);

/// Whether the invariant of a digital straight segment holds: all that
/// interpolate() asks of values from elsewhere. invalid_argument with the
/// reason.
Status validate(const DigitalSegment& segment);

/// Bulk form for digital straight segments: the steps of all of them one after
/// another, by the closed form of DigitalSegment, for any valid values.
/// Returns the steps written. invalid_argument naming the segment's index if
/// one is not valid, limit_exceeded if `out` is too short; nothing is written
/// then. `out` beyond the steps is unspecified.
Result<std::size_t> interpolate(std::span<const DigitalSegment> segments,
                                std::span<Step> out);

/// The plain loop, an addition and a comparison per step: the reference of the
/// form above. REQUIRES: validate(segment), out.size() >= segment.n.
std::size_t digital_segment_steps_reference(const DigitalSegment& segment,
                                            std::span<Step> out);

/// Word length of linear digit-by-digit interpolation: the digits of the
/// largest increment, Vk * Tk / dz. 10 m/min, 10 ms, 1 um: 11. SEEDS D3.
/// REQUIRES: all > 0, in units that cancel (metres, seconds).
[[nodiscard]] int word_length_linear(double feed, double period, double dz);

/// Word length of circular interpolation: dz / Rmax ~ 2^-n. 10 m, 1 um: 24.
[[nodiscard]] int word_length_circular(double radius_max, double dz);

/// Nodes of a quarter circle whose chords are 2^chord_bits dz long.
/// 10 m, 1 um, 12: 3835. D4.
[[nodiscard]] std::int64_t rom_nodes(double radius, double dz, int chord_bits);

/// Bytes of a table of `nodes` values (or differences) of sin and cos, in
/// words of `word_bits`; 3835 values of 25 bits: 23963. A difference is
/// shorter by the address bits: `address_bits` is not used for values. D4.
[[nodiscard]] std::int64_t rom_bytes(std::int64_t nodes, int word_bits,
                                     RomForm form, int address_bits);

/// The largest table step for a linear correction with error <= delta, |f''|
/// <= 1: sqrt(8 delta). D4.
[[nodiscard]] double rom_linear_step(double delta);

/// Counters 1 (X) and 2 (Y), adder 3 (F) and trigger 11 of SU 1089551: both
/// modes of the device of 1984 on one register set, first quadrant.
///
/// Range: while X >= 1 and Y >= 1, -X <= F <= Y - 1 holds in forward mode (a
/// step along x needs F < 0, so F + Y <= Y - 1; along y F >= 0, so F - X >=
/// -X); once X or Y is 0, F changes no more or by the other counter's 0. In
/// reverse mode an accepted step leaves -X <= F <= Y and a breaking one |F| <=
/// X + Y. Counters up to 2^32 therefore keep |F| < 2^34: no overflow.
struct DeviceRegisters {
  enum class Axis : std::uint8_t { none, x, y };

  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t f = 0;
  bool forward = false;  ///< trigger 11

  /// Loads (xk, yk) >= 0 and pulses bus 20.
  constexpr void start(std::int64_t xk, std::int64_t yk) {
    x = xk;
    y = yk;
    f = yk - xk;
    forward = (x | y) != 0;
    if (!forward) f = 0;
  }

  /// Forward mode: one pulse of generator 10. The axis that moved.
  constexpr Axis clock() {
    if (!forward) return Axis::none;
    const bool along_x = f < 0;
    if (along_x) {
      --x;
      f += y;
    } else {
      --y;
      f -= x;
    }
    forward = (x | y) != 0;
    return along_x ? Axis::x : Axis::y;
  }

  /// Reverse mode: a unit step arrives. True if it breaks the segment: then
  /// (x, y) is the segment, this step included, and clear() must follow.
  /// REQUIRES: !forward.
  constexpr bool accept(Axis axis) {
    if (axis == Axis::x) {
      const bool breaks = f > 0;
      ++x;
      f += y;
      return breaks;
    }
    const bool breaks = f < 0;
    ++y;
    f -= x;
    return breaks;
  }

  constexpr void clear() { *this = {}; }
  [[nodiscard]] constexpr DeviceRegisters registers() const { return *this; }
  friend bool operator==(const DeviceRegisters&,
                         const DeviceRegisters&) = default;
};

/// A3: the device as a clocked net. Counters and adder are held bit by bit
/// and change by ripple carry; every other element is a signal computed from
/// the wires that docs/algorithms.md lists. Same calls as DeviceRegisters.
class GateNet {
 public:
  using Axis = DeviceRegisters::Axis;

  /// Outputs of the elements during the last pulse; trigger and AND 19 after.
  struct Signals {
    bool and4 = false, and5 = false, or6 = false, or7 = false, or8 = false,
         and9 = false, and12 = true, or13 = true, not14 = false, and15 = false,
         and16 = false, or17 = false, and18 = false, and19 = true;
    bool trigger11 = false;  ///< during the pulse
  };

  void start(std::int64_t xk, std::int64_t yk);
  Axis clock();
  bool accept(Axis axis);
  void clear();

  [[nodiscard]] DeviceRegisters registers() const;
  [[nodiscard]] const Signals& signals() const { return signals_; }

 private:
  void pulse(bool generator, bool x_input, bool y_input);

  /// Counters hold 0..2^32, the adder |F| < 2^34, so 36 bits with sign do.
  static constexpr int kBits = 36;
  std::uint64_t counter1_ = 0;
  std::uint64_t counter2_ = 0;
  std::uint64_t adder3_ = 0;  ///< two's complement in kBits
  bool trigger_ = false;
  Signals signals_;
};

}  // namespace unstep
