#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "unstep/formats.h"
#include "unstep/interpolate.h"
#include "unstep/program.h"
#include "unstep/result.h"

/// Streams of step and direction words: made from programs, written, read and
/// turned back into programs. docs/steps.md has the formats.
///
///     StepStream stream = *make_steps(program, {.step = 100'000});
///     Result<std::string> csv = write_steps(stream, StepFormat::csv);
///     Result<Program> same = reverse_steps(stream, {});
namespace unstep {

inline constexpr std::size_t kMaxStepAxes = 3;

/// What the motors do at one pulse: of axis a (x, y, z), bit 2a says that it
/// steps and bit 2a + 1 that it does so backwards. Never 0; bit 2a + 1 only
/// together with bit 2a.
using StepWord = std::uint8_t;

[[nodiscard]] constexpr bool is_step_word(unsigned word, int axes) {
  return word != 0 && word >> (2 * axes) == 0 &&
         (word >> 1 & ~word & 0x15U) == 0;
}

/// -1, 0 or 1.
[[nodiscard]] constexpr int step_of(StepWord word, std::size_t axis) {
  const unsigned bits = unsigned{word} >> (2 * axis) & 3U;
  return bits == 0 ? 0 : bits == 1 ? 1 : -1;
}

struct StepHead {
  int axes = 2;                 ///< 2 or 3
  std::int64_t step = 100'000;  ///< length of a step in 1e-7 mm, 1 .. 2^40
  std::uint32_t clock = 0;      ///< ticks per second; 0: not timed
  std::array<std::int32_t, kMaxStepAxes> origin{};  ///< steps, |x| < 2^30
  friend bool operator==(const StepHead&, const StepHead&) = default;
};

/// Pulses that follow each other, all of rapids or none.
struct StepRun {
  bool rapid = false;
  std::vector<StepWord> words;
  /// Timed: ticks from the pulse before to this one, at least 1 each.
  std::vector<std::uint32_t> waits;
  friend bool operator==(const StepRun&, const StepRun&) = default;
};

struct StepStream {
  StepHead head;
  std::vector<StepRun> runs;
  friend bool operator==(const StepStream&, const StepStream&) = default;
};

/// Speed and acceleration. A move's speed is its feed, reached and left by a
/// constant acceleration along the path. At a corner the speed is such that an
/// arc that cuts it by `corner` would need no more than the acceleration; the
/// speed before short moves is what can still be braked (look-ahead).
struct StepTiming {
  std::uint32_t clock = 1'000'000;  ///< ticks per second
  double feed = 1000;               ///< mm/min, where the program has none
  double rapid = 5000;              ///< mm/min
  double acceleration = 500;        ///< mm/s^2; 0: no limit
  double corner = 0.01;             ///< mm
};

struct StepMakeOptions {
  std::int64_t step = 100'000;  ///< 1e-7 mm
  int axes = 2;                 ///< 2: z is left out
  /// Where the machine is before the first motion, in steps.
  std::array<std::int32_t, kMaxStepAxes> origin{};
  /// Of lines of 2 axes: any that makes unit steps of lines. Arcs are drawn by
  /// Method::circular, with diagonal steps if the lines are of evaluation8.
  /// With 3 axes what does not move z is drawn so by evaluation8; else the axis
  /// with most steps steps always, the others when they are nearest to the
  /// line, and arcs are chords of half a step.
  Method method = Method::evaluation8;
  InterpolatorOptions interpolator;
  bool timed = false;
  StepTiming timing;
  /// Motions whose start is not known are taken as they seem.
  bool skip_unknown = false;
  std::uint64_t max_steps = std::uint64_t{1} << 32;
};

/// Takes runs in order; a long one comes in parts of at most 2^20 pulses.
using StepSink = std::function<Status(const StepRun& run)>;

/// The steps of a program's motions, piece by piece. Vertices are rounded to
/// whole steps. invalid_argument for the options, out_of_range beyond 2^30
/// steps, unsupported for text of unknown effect, limit_exceeded.
Status make_steps(const Program& program, const StepMakeOptions& options,
                  const StepSink& sink);

/// The head of the steps that make_steps makes.
[[nodiscard]] StepHead step_head(const StepMakeOptions& options);

/// All at once; neighbouring runs of one kind are one.
Result<StepStream> make_steps(const Program& program,
                              const StepMakeOptions& options);

enum class StepFormat : std::uint8_t { binary, csv, vcd, raw };

/// Writes a stream run by run.
class StepWriter {
 public:
  /// `head` as of make_steps.
  static Result<StepWriter> create(StepFormat format, const StepHead& head,
                                   ByteSink sink);
  ~StepWriter();
  StepWriter(StepWriter&&) noexcept;
  StepWriter& operator=(StepWriter&&) noexcept;

  /// invalid_argument for words or waits that the head does not allow.
  Status add(const StepRun& run);
  Status finish();

  struct Impl;

 private:
  explicit StepWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

Result<std::string> write_steps(const StepStream& stream, StepFormat format);

struct StepReadOptions {
  /// Of raw bytes, and of VCD and CSV that do not say: axes and step.
  StepHead head;
  std::uint64_t max_steps = std::uint64_t{1} << 30;  ///< one byte each, timed 5
};

/// Errors name byte or line. Steps of CSV and VCD need not come from unstep:
/// docs/steps.md says what is understood.
Result<StepStream> read_steps(std::string_view bytes, StepFormat format,
                              const StepReadOptions& options);

/// Which format these bytes are, by content; raw if none.
[[nodiscard]] StepFormat recognise_steps(std::string_view bytes);

struct StepReverseOptions {
  /// Exact: the program makes the same steps by this method (evaluation8,
  /// evaluation or device; 3 axes have one method).
  Method method = Method::evaluation8;
  bool arcs = true;
  double feed = 1000;  ///< mm/min, of streams that are not timed
};

/// Reverse interpolation of a recorded stream: the longest lines and, where z
/// rests, arcs, one after the other, that make_steps draws with exactly these
/// steps. invalid_argument for words that are none or another method.
Result<Program> reverse_steps(const StepStream& stream,
                              const StepReverseOptions& options);

/// The lines and arcs of a program as the payload that firmware draws step by
/// step (src/firmware/unstep_steps.h; docs/format.md, "Device profile"): the
/// steps of make_steps with 2 axes and evaluation8. Of the options only step,
/// origin, skip_unknown and max_steps count. Lines and radii of 2^15 steps and
/// more become lines that make the same steps; out_of_range for motions of more
/// than 2^26.
Result<std::string> write_device_profile(const Program& program,
                                         const StepMakeOptions& options);

/// Its steps, as the firmware's decoder makes them. `head`: what the payload
/// does not say.
Result<StepStream> read_device_profile(std::string_view bytes,
                                       const StepReadOptions& options);

}  // namespace unstep
